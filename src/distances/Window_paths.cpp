// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>
#include "core/unfold.h"
#include "distances/Reverse_window_search.h"
#include "distances/Window_propagator.h"
#include "distances/directions.h"
#include "distances/follow_line.h"
#include "distances/window_chains.h"
#include "paths/shorten_geodesic.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// Distances and paths of the exact method at any location, by a reverse search or from the arrivals
// that vertices store.

namespace CGAL::Geodesic_processing::internal {

namespace {

// Paths whose distance from each other is everywhere below this fraction of their length are the
// same.
constexpr double path_tolerance = 1e-6;

// Returns whether consecutive locations of a path are not in a common triangle, due to round-off
// errors.
bool is_disconnected(const Surface_arrays& t, const std::vector<Surface_location>& path)
{
  return std::adjacent_find(path.begin(), path.end(),
                            [&](const Surface_location& p, const Surface_location& q)
                            { return common_triangle(t, p, q) == none; }) != path.end();
}

// Returns whether all points of a path are within `width` of the other path.
bool is_along(const Surface_arrays& t, const std::vector<Surface_location>& path,
              const std::vector<Surface_location>& other, double width)
{
  const auto is_close = [&](const Surface_location& location)
  {
    for(const Index triangle : triangles_at(t, location))
    {
      const auto corners = unfolded(t, triangle);
      const Vec2 p = unfolded_point(corners, *barycentric_in(t, triangle, location));
      bool has_previous = false, is_inside = false;
      Vec2 previous = {0., 0.};
      for(const Surface_location& other_location : other)
      {
        const auto barycentric = barycentric_in(t, triangle, other_location);
        if(barycentric)
        {
          const Vec2 q = unfolded_point(corners, *barycentric);
          if(norm(p - closest_point_on_segment(p, has_previous ? previous : q, q, is_inside)) <=
             width)
            return true;
          previous = q;
        }
        has_previous = barycentric.has_value();
      }
    }
    return false;
  };
  return std::all_of(path.begin(), path.end(), is_close);
}

// Appends the path of a meeting, from the start of the reverse search to the source, and returns
// its length.
double append_meeting(const Window_state& reverse, const Window_state& forward,
                      const Meeting& meeting, std::vector<Surface_location>& path)
{
  const Surface_arrays& t = *forward.triangles;
  double length = 0.;
  if(meeting.vertex == none)
  {
    path.push_back(canonical(t, meeting.location));
    length += append_line(
        reverse, {meeting.location, meeting.direction, meeting.length, meeting.origin}, path);
  }
  else
    path.push_back(vertex_location(t, meeting.vertex));
  if(const Index origin = meeting.vertex == none ? meeting.origin : meeting.vertex;
     origin < forward.vertices.size())
    length += append_chain(reverse, origin, path);
  std::reverse(path.begin(), path.end());
  if(meeting.vertex != none)
    length += append_chain(forward, meeting.vertex, path);
  return length;
}

// Returns the distance of a point piece by the corners of its triangle and by the sources in it.
double distance_in_source_triangle(const Window_state& windows, const Source_piece& point)
{
  const Surface_arrays& t = *windows.triangles;
  const auto corners = unfolded(t, point.triangle);
  const Vec2 p = unfolded_point(corners, point.begin);
  double result = infinity;
  for(Index k = 0; k < 3; ++k)
    result = std::min(result, windows.vertices[t.corner[3 * point.triangle + k]].distance +
                                  norm(p - corners[k]));
  const auto& pieces = windows.pieces_by_triangle;
  bool is_inside = false;
  for(auto i = std::lower_bound(pieces.begin(), pieces.end(), std::pair(point.triangle, Index(0)));
      i != pieces.end() && i->first == point.triangle; ++i)
  {
    const Source_piece& piece = windows.source_pieces[i->second];
    result = std::min(result,
                      piece.offset + norm(p - closest_point_on_segment(
                                                  p, unfolded_point(corners, piece.begin),
                                                  unfolded_point(corners, piece.end), is_inside)));
  }
  return result;
}

} // namespace

double Window_propagation::distance(const Surface_location& location) const
{
  const auto [lower, upper] = unscaled_bounds(location);
  return m_state.is_exact() ? scaled(lower) : 0.5 * (scaled(lower) + scaled(upper));
}

Distance_bounds Window_propagation::bounds(const Surface_location& location) const
{
  const auto [lower, upper] = unscaled_bounds(location);
  return {scaled(without_excess(lower)), scaled(with_shortfall(upper))};
}

Distance_bounds Window_propagation::unscaled_bounds(const Surface_location& query) const
{
  const Surface_location location = outside_obstacles(query);
  if(const Index vertex = vertex_of(*m_state.triangles, location); vertex != none)
    return {m_state.vertices[vertex].distance, m_state.upper_bound(vertex)};
  if(is_inside_obstacle(location))
    return {};
  const std::lock_guard lock(m_reverse_search.mutex);
  // The lower bounds of the vertices bound the search, and give a lower bound.
  const Meeting& meeting = reverse_search().find_shortest(m_state, location);
  if(!(meeting.distance <= m_state.max_distance))
    return {};
  const double error = meeting.vertex == none ? 0.
                                              : m_state.upper_bound(meeting.vertex) -
                                                    m_state.vertices[meeting.vertex].distance;
  return {meeting.distance, meeting.distance + error};
}

// Throws if the last query had a relative tolerance.
void Window_propagation::require_exact() const
{
  if(!m_state.is_exact())
    throw Unsupported_surface_error(
        "This query requires distances with a relative tolerance of 0.");
}

Reverse_window_search& Window_propagation::reverse_search() const
{
  if(!m_reverse_search.search)
    m_reverse_search.search =
        std::make_shared<Reverse_window_search>(m_state.triangles, m_state.is_pseudo_source);
  return *m_reverse_search.search;
}

std::vector<double>
Window_propagation::distances(const std::vector<Surface_location>& queries) const
{
  const Surface_arrays& t = *m_state.triangles;
  std::vector<double> result(queries.size(), infinity);
  if(!m_state.is_exact())
  {
    std::transform(queries.begin(), queries.end(), result.begin(),
                   [&](const Surface_location& location) { return distance(location); });
    return result;
  }
  std::vector<Source_piece> pieces; // the locations, in each of their triangles
  std::vector<std::size_t> query_of_piece;
  for(std::size_t i = 0; i < queries.size(); ++i)
  {
    const Surface_location location = outside_obstacles(queries[i]);
    if(const Index vertex = vertex_of(t, location); vertex != none)
      result[i] = m_state.vertices[vertex].distance;
    else if(!is_inside_obstacle(location))
      for(const Index triangle : triangles_at(t, location))
      {
        const auto barycentric = *barycentric_in(t, triangle, location);
        pieces.push_back({triangle, none, barycentric, barycentric, 0.});
        query_of_piece.push_back(i);
        result[i] = std::min(result[i], distance_in_source_triangle(m_state, pieces.back()));
      }
  }
  Window_goal goal(m_state.triangles);
  goal.find_each(pieces);
  Window_state state(m_state.triangles, m_state.is_pseudo_source);
  state.min_offset = m_state.min_offset;
  state.max_distance = m_state.max_distance;
  Window_propagator propagator(state, &goal);
  propagator.start(m_sources);
  while(!pieces.empty() && !state.queue.empty())
    propagator.step();
  for(std::size_t i = 0; i < pieces.size(); ++i)
    result[query_of_piece[i]] = std::min(result[query_of_piece[i]], goal.meetings()[i].distance);
  for(double& distance : result)
    distance =
        distance <= m_state.max_distance ? m_slowness * (distance + m_state.min_offset) : infinity;
  return result;
}

Bounded_path Window_propagation::path(const Surface_location& query) const
{
  const Surface_arrays& t = *m_state.triangles;
  const Surface_location from = outside_obstacles(query);
  if(is_inside_obstacle(from))
    return {};
  if(!m_state.is_exact())
    return path_along_edges(from);
  std::vector<Surface_location> path;
  double length = 0.;
  if(const Index vertex = vertex_of(t, from); vertex == none)
  {
    const std::lock_guard lock(m_reverse_search.mutex);
    Reverse_window_search& reverse_search = this->reverse_search();
    const Meeting& meeting = reverse_search.find_shortest(m_state, from);
    if(meeting.distance == infinity || meeting.distance > m_state.max_distance)
      return {};
    length = append_meeting(reverse_search.state(), m_state, meeting, path);
  }
  else if(m_state.vertices[vertex].distance < infinity)
  {
    path.push_back(vertex_location(t, vertex));
    length = append_chain(m_state, vertex, path);
  }
  else
    return {};
  return shortened(path, length);
}

// Returns the locally shortest path that shortens the path along the predecessors.
Bounded_path Window_propagation::path_along_edges(const Surface_location& from) const
{
  const double bound = unscaled_bounds(from).lower;
  if(bound == infinity)
    return {};
  // The distance contains the offset of a source, which is not part of the length.
  double max_offset = m_state.min_offset;
  for(const Front_source& source : m_sources)
    max_offset = std::max(max_offset, source.offset);
  const double lower = without_excess(bound - (max_offset - m_state.min_offset));
  return {path_to_sources(
              *m_state.triangles, from, m_sources,
              [&](Index i) { return distance(i) / m_slowness; },
              [&](Index i) { return predecessor(i); }, [&](Index i) { return source(i); }),
          lower};
}

Bounded_path Window_propagation::path_between(const Surface_location& from,
                                              const Surface_location& to, double max_length,
                                              const std::function<bool(double)>& callback)
{
  set_obstacles(nullptr);
  m_state.clear();
  m_state.set_tolerance(0.);
  m_state.min_offset = 0.;
  m_state.max_distance = infinity;
  m_sources = {{{to}, 0., 0}};
  Window_propagator(m_state).start(m_sources);
  const std::lock_guard lock(m_reverse_search.mutex);
  Reverse_window_search& reverse_search = this->reverse_search();
  const Meeting& meeting = reverse_search.find_between(m_state, to, from, max_length, callback);
  if(!(meeting.distance < max_length * (1. - round_off_tolerance)))
    return {{}, without_excess(max_length * (1. - 2. * round_off_tolerance))};
  std::vector<Surface_location> path;
  const double length = append_meeting(reverse_search.state(), m_state, meeting, path);
  return shortened(path, length);
}

// Shortens a path of straight lines, which shortens only gaps at round-off errors. Returns an empty
// path if it is disconnected or longer than expected.
Bounded_path Window_propagation::shortened(const std::vector<Surface_location>& path,
                                           double length) const
{
  Bounded_path result = {{}, without_excess(length * (1. - 2. * round_off_tolerance))};
  if(is_disconnected(*m_state.triangles, path))
    return result;
  Locally_shortest_path shortest = shorten_geodesic(*m_state.triangles, path);
  if(shortest.length <= length + 1e-9 * (length + m_state.max_edge_length * round_off_tolerance))
    result.locations = std::move(shortest.locations);
  return result;
}

std::vector<std::vector<Surface_location>> Window_propagation::paths(const Surface_location& query,
                                                                     double tolerance) const
{
  require_exact();
  const Surface_location from = outside_obstacles(query);
  if(is_inside_obstacle(from))
    return {};
  const Surface_arrays& t = *m_state.triangles;
  const std::lock_guard lock(m_reverse_search.mutex);
  Reverse_window_search& reverse_search = this->reverse_search();
  const Index start_vertex = vertex_of(t, from);
  const double shortest = start_vertex == none
                              ? reverse_search.find_shortest(m_state, from).distance
                              : m_state.vertices[start_vertex].distance;
  if(shortest == infinity || shortest > m_state.max_distance)
    return {};
  const double max_length = shortest * (1. + std::max(tolerance, round_off_tolerance));
  reverse_search.find_all(m_state, from, max_length);

  std::vector<std::vector<Surface_location>> candidates;
  for(const Index vertex : reverse_search.state().reached)
    if(m_state.vertices[vertex].distance < infinity && m_state.vertices[vertex].corner == none &&
       reverse_search.state().vertices[vertex].distance + m_state.vertices[vertex].distance <=
           max_length)
      reverse_search.collect_paths(vertex, {vertex_location(t, vertex)}, candidates);
  for(const Meeting& meeting : reverse_search.meetings())
  {
    std::vector<Surface_location> path = {canonical(t, meeting.location)};
    append_line(reverse_search.state(),
                {meeting.location, meeting.direction, meeting.length, meeting.origin}, path);
    reverse_search.collect_paths(meeting.origin, path, candidates);
  }

  std::vector<std::vector<Surface_location>> result;
  for(std::vector<Surface_location>& path : candidates)
  {
    std::reverse(path.begin(), path.end());
    if(is_disconnected(t, path))
      continue;
    path = shorten_geodesic(t, path).locations;
    const double width = path_tolerance * path_length(t, path);
    if(std::none_of(result.begin(), result.end(),
                    [&](const std::vector<Surface_location>& other)
                    { return is_along(t, path, other, width) && is_along(t, other, path, width); }))
      result.push_back(std::move(path));
  }
  return result;
}

Departure Window_propagation::departure(const Surface_location& to) const
{
  require_exact();
  const Surface_arrays& t = *m_state.triangles;
  const std::vector<Surface_location> path = this->path(to).locations;
  Departure result;
  if(path.empty())
    return result;
  result.from = result.next = path.back();
  result.length = path_length(t, path);
  if(path.size() == 1)
    return result;
  result.next = path[path.size() - 2];
  const Index triangle = common_triangle(t, path.back(), result.next);
  const auto corners = unfolded(t, triangle);
  const auto barycentric = *barycentric_in(t, triangle, path.back());
  const Vec2 direction = unfolded_point(corners, *barycentric_in(t, triangle, result.next)) -
                         unfolded_point(corners, barycentric);
  result.from = {triangle, none, barycentric};
  result.angle = std::atan2(direction[1], direction[0]);
  result.polar_angle = polar_angle_at(t, result.from, direction);
  return result;
}

double Window_propagation::polar_angle_of_departure(Index vertex) const
{
  require_exact();
  const auto comes_from_vertex = [&]
  {
    return m_state.vertices[vertex].origin < m_state.vertices.size() &&
           m_state.vertices[vertex].corner != none;
  };
  while(comes_from_vertex() && m_state.vertices[m_state.vertices[vertex].origin].corner != none)
    vertex = m_state.vertices[vertex].origin;
  if(m_state.vertices[vertex].corner == none)
    return 0.;
  const Window_arrival& arrival = m_state.vertices[vertex];
  const auto corners = unfolded(*m_state.triangles, arrival.corner / 3);
  const Vec2 from = corners[arrival.corner % 3];
  const Line line = {arrival.corner / 3, from,
                     from +
                         line_length(m_state, arrival) *
                             rotated(arrival.direction, edge_direction(corners, arrival.corner))};
  if(const auto end = source_point(m_state, arrival.origin))
    if(const auto found = follow_line(*m_state.triangles, line, *end))
      return polar_angle_at(
          *m_state.triangles,
          {found->triangle, none, *barycentric_in(*m_state.triangles, found->triangle, *end)},
          found->from - found->target);
  return departure(vertex_location(*m_state.triangles, vertex)).polar_angle;
}

} // namespace CGAL::Geodesic_processing::internal
