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

  // Returns a location on the first edge, and the strip from it to itself. The shortest path in this
  // strip is the shortest loop in the annulus.
  Surface_location shortest_loop(Strip& strip)
  {
    unfold();
    double fraction = searched_fraction();
    // A fraction this close to an end is that end up to the precision of the search.
    if(fraction < 2. * precision)
      fraction = 0.;
    if(fraction > 1. - 2. * precision)
      fraction = 1.;
    strip = m_strip;
    return location(fraction);
  }

private:
  static constexpr double precision = 1e-10; // of a fraction of the first edge

  Surface_location location(double fraction) const
  {
    Surface_location result;
    result.triangle = m_edge / 3;
    result.barycentric = barycentric_on_halfedge(m_edge, fraction);
    return canonical(t, result);
  }

  // Unfolds the annulus to a strip from the begin of the first edge to its image.
  void unfold()
  {
    const Surface_location begin = location(0.);
    m_unfolded.unfold(t, m_strip, begin, location(1.));
    const Vec2 image_end = m_unfolded.end;
    m_unfolded.unfold(t, m_strip, begin, begin);
    m_image_begin = m_unfolded.end;
    m_image_edge = image_end - m_image_begin;
    const Index entered = t.twin[m_edge];
    const auto corners = unfolded(t, m_strip.triangle);
    m_edge_vector = corners[entered % 3] - corners[next_halfedge(entered) % 3];
    m_fraction = 0.;
  }

  // Returns the fraction of the first edge at which the straight segment to its image is shortest.
  double straight_fraction() const
  {
    const Vec2 change = m_image_edge - m_edge_vector;
    const double square = dot(change, change);
    return square > 0. ? std::clamp(-dot(m_image_begin, change) / square, 0., 1.) : 0.5;
  }

  // Returns the fraction of the first edge at which the shortest loop crosses it.
  //
  // The length of the shortest loop that crosses the edge at a given fraction is a convex function.
  // It is at least the length of the straight segment. Let the loop bend first and last at two
  // given vertices. Then the shortest loop is a straight line from the one to the other if the edge
  // is joined to its image. If this line crosses the edge at the given fraction, it is the minimum.
  double searched_fraction()
  {
    // If the loop touches vertices, a low precision is enough, because the loop is then shortened
    // with one of them fixed.
    constexpr double low_precision = 1e-2;
    double fraction = straight_fraction();
    compute_loop(fraction);
    if(!m_touches_vertex)
      return fraction;
    // At an end, a loop can bend at this end, and then has no derivative.
    if(fraction == 0. || fraction == 1.)
      compute_loop(fraction = 0.5);
    for(double begin = 0., end = 1.;;)
    {
      const double derivative = length_derivative();
      if(derivative == 0.)
        return fraction;
      (derivative > 0. ? end : begin) = fraction;
      const double limit = m_touches_vertex ? low_precision : precision;
      double next = m_touches_vertex ? fraction_between_bends() : straight_fraction();
      if(!(next >= begin && next <= end))
        next = 0.5 * (begin + end);
      if(end - begin <= limit || std::abs(next - fraction) <= limit)
        return next;
      // Each step shortens the interval by at least half of the precision.
      fraction = std::clamp(next, begin + 0.5 * limit, end - 0.5 * limit);
      compute_loop(fraction);
    }
  }

  // Computes the shortest loop that crosses the first edge at this fraction of it.
  void compute_loop(double fraction)
  {
    // The unfolded strips from all points of the edge are translated to each other.
    const Vec2 translation = (m_fraction - fraction) * m_edge_vector;
    for(std::size_t i = 0; i < m_unfolded.left.size(); ++i)
    {
      m_unfolded.left[i] = m_unfolded.left[i] + translation;
      m_unfolded.right[i] = m_unfolded.right[i] + translation;
    }
    m_unfolded.end = m_image_begin + fraction * (m_image_edge - m_edge_vector);
    m_fraction = fraction;
    const std::vector<Bend>& bends = m_funnel.find_bends(t, m_strip, m_unfolded);
    m_touches_vertex = !bends.empty();
    const auto position = [&](const Bend& bend) {
      return bend.is_left ? m_unfolded.left[bend.strip_index] : m_unfolded.right[bend.strip_index];
    };
    m_first_leg = m_touches_vertex ? position(bends.front()) : m_unfolded.end;
    m_last_leg = m_touches_vertex ? m_unfolded.end - position(bends.back()) : m_unfolded.end;
  }

  // Returns a positive multiple of the derivative of the length with respect to the fraction.
  double length_derivative() const
  {
    const double first = norm(m_first_leg), last = norm(m_last_leg);
    return (last > 0. ? dot(m_last_leg, m_image_edge) / last : 0.) -
           (first > 0. ? dot(m_first_leg, m_edge_vector) / first : 0.);
  }

  // Returns the fraction at which a straight line from the last bend to the first one crosses the
  // edge, clamped to [0, 1].
  double fraction_between_bends() const
  {
    const double height_before = std::abs(cross(m_last_leg, m_image_edge)),
                 height_after = std::abs(cross(m_first_leg, m_edge_vector)),
                 square = dot(m_edge_vector, m_edge_vector);
    const double before = -dot(m_last_leg, m_image_edge), after = dot(m_first_leg, m_edge_vector);
    if(!(height_before + height_after > 0.) || !(square > 0.))
      return std::clamp(m_fraction + (square > 0. ? 0.5 * (before + after) / square : 0.), 0., 1.);
    const double change =
        (height_after * before + height_before * after) / ((height_before + height_after) * square);
    return std::clamp(m_fraction + change, 0., 1.);
  }

  const Surface_arrays& t;
  Index m_edge = none;
  Strip m_strip; // from the first edge to itself
  // The unfolded strip. Its first location is the origin and is at this fraction of the first edge.
  Unfolded_strip m_unfolded;
  double m_fraction = 0.;
  Vec2 m_edge_vector = {0., 0.}; // the first edge
  // For a strip from the begin of the first edge: the begin of its image, and the image.
  Vec2 m_image_begin = {0., 0.}, m_image_edge = {0., 0.};
  Funnel m_funnel;
  // The loop that was computed last: its first and its last segment
  Vec2 m_first_leg = {0., 0.}, m_last_leg = {0., 0.};
  bool m_touches_vertex = false;
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
      {
        Strip strip;
        const Surface_location base = annulus.shortest_loop(strip);
        next = shorten_closed_geodesic(t, base, strip, is_geodesic);
      }
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
