// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_loop.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "paths/triangle_strip.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the same loop, cut open at another location.
std::vector<Surface_location> cut_open_at(const std::vector<Surface_location>& loop,
                                          std::size_t index)
{
  std::vector<Surface_location> result(loop.begin() + index, loop.end() - 1);
  result.insert(result.end(), loop.begin(), loop.begin() + index + 1);
  return result;
}

// Returns the index of the location in the middle of a loop that is cut open.
std::size_t middle(const Surface_arrays& t, const std::vector<Surface_location>& loop)
{
  std::vector<double> position(loop.size(), 0.);
  for(std::size_t i = 1; i < loop.size(); ++i)
    position[i] = position[i - 1] + path_length(t, {loop[i - 1], loop[i]});
  const auto after =
      std::lower_bound(position.begin() + 1, position.end() - 2, 0.5 * position.back());
  return std::size_t(after - position.begin());
}

// Returns a loop that ends at its first location.
std::vector<Surface_location> closed(std::vector<Surface_location> loop)
{
  if(!loop.empty())
    loop.push_back(loop.front());
  return loop;
}

// An annulus of triangles: the edges that a loop crosses.
class Annulus
{
public:
  // Removes pairs of crossings of the same edge in opposite directions. If no crossing remains, the
  // annulus is empty.
  Annulus(const Surface_arrays& t, const std::vector<Index>& crossed_halfedges) : t(t)
  {
    Strip strip;
    for(const Index h : crossed_halfedges)
      strip.append(t, h);
    auto begin = strip.halfedges.begin(), end = strip.halfedges.end();
    while(end - begin >= 2 && t.twin[*begin] == end[-1])
    {
      ++begin;
      --end;
    }
    if(begin == end)
      return;
    m_edge = *begin;
    m_strip.triangle = t.twin[m_edge] / 3;
    m_strip.halfedges.assign(begin + 1, end);
  }

  bool is_empty() const { return m_edge == none; }

  // Returns a loop in the annulus whose shortening with its first location fixed is the shortest
  // loop in the annulus.
  std::vector<Surface_location> shortest_loop()
  {
    double fraction = straight_fraction();
    length(fraction);
    // The length is a convex function. Without a bend, it is the square root of a quadratic one.
    if(m_touches_vertex)
      fraction = searched_fraction();
    // A fraction this close to an end is that end up to the precision of the search.
    if(fraction < 2. * precision)
      fraction = 0.;
    if(fraction > 1. - 2. * precision)
      fraction = 1.;
    std::vector<Surface_location> result = {location(m_edge, fraction)};
    for(const Index h : m_strip.halfedges)
      result.push_back(location(h, 0.5));
    result.push_back(result.front());
    return result;
  }

private:
  static constexpr double precision = 1e-10; // of a fraction of the first edge

  // Returns the fraction of the first edge at which the straight segment to its image in the
  // unfolded annulus is shortest.
  double straight_fraction()
  {
    const Surface_location begin = canonical(t, location(m_edge, 0.));
    m_unfolded.unfold(t, m_strip, begin, begin);
    const Vec2 segment = m_unfolded.end;
    m_unfolded.unfold(t, m_strip, begin, canonical(t, location(m_edge, 1.)));
    const Index entered = t.twin[m_edge];
    const auto corners = unfolded(t, m_strip.triangle);
    const Vec2 edge = corners[entered % 3] - corners[next_halfedge(entered) % 3],
               change = m_unfolded.end - segment - edge;
    const double square = dot(change, change);
    return square > 0. ? std::clamp(-dot(segment, change) / square, 0., 1.) : 0.5;
  }

  // Returns the fraction of the first edge at which the shortest loop crosses it.
  double searched_fraction()
  {
    // Golden section search. If the loop touches vertices, a low precision is enough, because the
    // loop is then shortened with one of them fixed.
    constexpr double ratio = 0.61803398874989484820, low_precision = 1e-2;
    double begin = 0., end = 1., left = 1. - ratio, right = ratio;
    double left_length = length(left), right_length = length(right);
    while(end - begin > (m_touches_vertex ? low_precision : precision))
      if(left_length <= right_length)
      {
        end = right;
        right = left;
        right_length = left_length;
        left = end - ratio * (end - begin);
        left_length = length(left);
      }
      else
      {
        begin = left;
        left = right;
        left_length = right_length;
        right = begin + ratio * (end - begin);
        right_length = length(right);
      }
    return left_length <= right_length ? left : right;
  }

  static Surface_location location(Index h, double fraction)
  {
    Surface_location result;
    result.triangle = h / 3;
    result.barycentric = barycentric_on_halfedge(h, fraction);
    return result;
  }

  // Returns the length of the shortest loop that crosses the first edge at this fraction of it.
  double length(double fraction)
  {
    const Surface_location base = canonical(t, location(m_edge, fraction));
    m_unfolded.unfold(t, m_strip, base, base);
    Vec2 last = {0., 0.};
    double result = 0.;
    const std::vector<Bend>& bends = m_funnel.find_bends(t, m_strip, m_unfolded);
    m_touches_vertex = !bends.empty();
    for(const Bend& bend : bends)
    {
      const Vec2 next =
          bend.is_left ? m_unfolded.left[bend.strip_index] : m_unfolded.right[bend.strip_index];
      result += norm(next - last);
      last = next;
    }
    return result + norm(m_unfolded.end - last);
  }

  const Surface_arrays& t;
  Index m_edge = none;
  Strip m_strip; // from the first edge to itself
  Unfolded_strip m_unfolded;
  Funnel m_funnel;
  bool m_touches_vertex = false; // the loop whose length was computed last
};

} // namespace

Locally_shortest_path shorten_loop(const Surface_arrays& t, const Homotopy& homotopy,
                                   const std::vector<Surface_location>& loop)
{
  if(!loop.empty())
  {
    const auto crossed = crossed_halfedges(t, closed(loop));
    if(crossed && homotopy.is_contractible(*crossed))
      return {{loop.front()}, 0., {}};
  }
  return shorten_noncontractible_loop(t, loop);
}

Locally_shortest_path shorten_noncontractible_loop(const Surface_arrays& t,
                                                   const std::vector<Surface_location>& loop)
{
  bool is_geodesic;
  Locally_shortest_path result = shorten_closed_geodesic(t, closed(loop), is_geodesic);
  // A loop that is only one point cannot be shortened.
  while(!is_geodesic && result.locations.size() > 2)
  {
    // The loop touches no vertex but its first location.
    Locally_shortest_path next = result;
    if(const auto crossed = crossed_halfedges(t, result.locations);
       crossed && result.touched_vertices.empty())
    {
      Annulus annulus(t, *crossed);
      if(!annulus.is_empty())
        next = shorten_closed_geodesic(t, annulus.shortest_loop(), is_geodesic);
    }
    if(!(next.length < result.length) && !is_geodesic)
      next = shorten_closed_geodesic(t, cut_open_at(result.locations, middle(t, result.locations)),
                                     is_geodesic);
    if(!(next.length < result.length) && !is_geodesic)
      return result;
    result = std::move(next);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
