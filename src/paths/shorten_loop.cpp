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

// A step that shortens the loop by less than this fraction is slow. One step then costs less than
// the computation of the shortest loop in the annulus, with its 50 funnels.
constexpr double slow_gain = 1e-3;

// Returns the same loop, cut open at another location.
std::vector<Surface_location> cut_open_at(const std::vector<Surface_location>& loop,
                                          std::size_t index)
{
  std::vector<Surface_location> result(loop.begin() + index, loop.end() - 1);
  result.insert(result.end(), loop.begin(), loop.begin() + index + 1);
  return result;
}

// Returns the touched vertex in the middle of a loop that is cut open. If there is none, returns
// the location in the middle.
std::size_t middle(const Surface_arrays& t, const Locally_shortest_path& loop)
{
  const std::size_t size = loop.locations.size();
  std::vector<double> position(size, 0.);
  for(std::size_t i = 1; i < size; ++i)
    position[i] = position[i - 1] + path_length(t, {loop.locations[i - 1], loop.locations[i]});
  const double half = 0.5 * position.back();
  const auto is_closer = [&](std::size_t i, std::size_t j)
  { return std::abs(position[i] - half) < std::abs(position[j] - half); };
  if(loop.touched_vertices.empty())
  {
    std::size_t result = 1;
    for(std::size_t i = 2; i + 1 < size; ++i)
      if(is_closer(i, result))
        result = i;
    return result;
  }
  return std::min_element(loop.touched_vertices.begin(), loop.touched_vertices.end(),
                          [&](const Touched_vertex& v, const Touched_vertex& w)
                          { return is_closer(v.location_index, w.location_index); })
      ->location_index;
}

// Returns a locally shortest loop with the angles at all vertices that it touches.
Locally_shortest_path with_all_touched_vertices(const Surface_arrays& t,
                                                const std::vector<Surface_location>& loop)
{
  // The loop is cut open in the middle of its first segment.
  const Index triangle = common_triangle(t, loop[0], loop[1]);
  const auto begin = *barycentric_in(t, triangle, loop[0]),
             end = *barycentric_in(t, triangle, loop[1]);
  Surface_location base;
  base.triangle = triangle;
  for(int k = 0; k < 3; ++k)
    base.barycentric[k] = 0.5 * (begin[k] + end[k]);
  std::vector<Surface_location> path = {base};
  path.insert(path.end(), loop.begin() + 1, loop.end());
  path.push_back(base);
  Locally_shortest_path result = shorten_geodesic(t, path);
  result.locations.erase(result.locations.begin());
  result.locations.back() = result.locations.front();
  for(Touched_vertex& touched : result.touched_vertices)
    --touched.location_index;
  return result;
}

// An annulus of triangles: the edges that a loop crosses.
class Annulus
{
public:
  // Removes pairs of crossings of the same edge in opposite directions. The loop is not
  // contractible, so that crossings remain.
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
    m_edge = *begin;
    m_strip.triangle = t.twin[m_edge] / 3;
    m_strip.halfedges.assign(begin + 1, end);
  }

  // Returns a loop in the annulus whose shortening with its first location fixed is the shortest
  // loop in the annulus.
  std::vector<Surface_location> shortest_loop()
  {
    // Golden section search.
    constexpr double ratio = 0.61803398874989484820, precision = 1e-10;
    double begin = 0., end = 1., left = 1. - ratio, right = ratio;
    double left_length = length(left), right_length = length(right);
    while(end - begin > precision)
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
    double fraction = left_length <= right_length ? left : right;
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
    for(const Bend& bend : m_funnel.find_bends(t, m_strip, m_unfolded))
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
};

} // namespace

Locally_shortest_path shorten_loop(const Surface_arrays& t, const Homotopy& homotopy,
                                   const std::vector<Surface_location>& loop)
{
  std::vector<Surface_location> closed = loop;
  if(!closed.empty())
    closed.push_back(closed.front());
  path_length(t, closed); // checks the locations
  const auto crossed = crossed_halfedges(t, closed);
  if(!closed.empty() && crossed && homotopy.is_contractible(*crossed))
    closed.resize(1);
  Locally_shortest_path result = shorten_geodesic(t, closed);
  if(result.locations.size() == 1)
    return result;
  for(;;)
  {
    const bool touches_no_vertex =
        result.touched_vertices.empty() && vertex_of(t, result.locations.front()) == none;
    Locally_shortest_path next =
        shorten_geodesic(t, cut_open_at(result.locations, middle(t, result)));
    if(touches_no_vertex && next.touched_vertices.empty() &&
       !(next.length < (1. - slow_gain) * result.length))
    {
      Annulus annulus(t, *crossed_halfedges(t, next.locations));
      Locally_shortest_path shortest = shorten_geodesic(t, annulus.shortest_loop());
      if(shortest.length < next.length)
        next = std::move(shortest);
    }
    if(!(next.length < result.length))
      return with_all_touched_vertices(t, result.locations);
    result = std::move(next);
  }
}

} // namespace CGAL::Geodesic_processing::internal
