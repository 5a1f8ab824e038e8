// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Departure_finder.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "distances/Window_goal.h"
#include "distances/Window_propagator.h"
#include "distances/directions.h"
#include "distances/follow_line.h"
#include "distances/window_chains.h"
#include "mesh/degenerate_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

Window_state make_departure_state(std::shared_ptr<const Surface_arrays> triangles)
{
  triangles = without_degenerate_triangles(std::move(triangles));
  const auto is_pseudo_source = find_pseudo_sources(*triangles);
  return {std::move(triangles), is_pseudo_source};
}

// The maximum distance is updated after this number of steps and one step for each location.
constexpr std::size_t steps_between_updates = 64;
constexpr std::size_t steps_between_callbacks = 4096;

} // namespace

Departure_finder::Departure_finder(std::shared_ptr<const Surface_arrays> triangles,
                                   std::vector<Surface_location> to)
    : m_state(make_departure_state(std::move(triangles))), m_to(std::move(to))
{
  const Surface_arrays& t = *m_state.triangles;
  for(std::size_t i = 0; i < m_to.size(); ++i)
    if(vertex_of(t, m_to[i]) == none)
      for(const Index triangle : triangles_at(t, m_to[i]))
      {
        const auto barycentric = *barycentric_in(t, triangle, m_to[i]);
        m_targets.push_back({i, {triangle, none, barycentric, barycentric, 0.}});
      }
}

std::vector<Polar_departure>
Departure_finder::operator()(const Surface_location& from,
                             const std::function<bool(double)>& callback)
{
  const Surface_arrays& t = *m_state.triangles;
  std::vector<Source_piece> pieces;
  for(const Target& target : m_targets)
    pieces.push_back(target.piece);
  Window_goal goal(m_state.triangles);
  goal.find_each(pieces);

  m_state.clear();
  m_state.min_offset = 0.;
  m_state.max_distance = infinity;
  Window_propagator propagator(m_state, &goal);
  propagator.start({{{from}, 0., 0}});
  // The known distances are lengths of paths, so no shortest path is longer than their maximum.
  const auto limit_distance = [&]
  {
    std::vector<double> distance(m_to.size(), infinity);
    for(std::size_t k = 0; k < m_targets.size(); ++k)
    {
      const Source_piece& piece = m_targets[k].piece;
      double& shortest = distance[m_targets[k].number];
      shortest = std::min(shortest, goal.meetings()[k].distance);
      for(Index corner = 3 * piece.triangle; corner < 3 * piece.triangle + 3; ++corner)
        shortest = std::min(shortest,
                            m_state.vertices[t.corner[corner]].distance +
                                distance_in_triangle(t, piece.triangle,
                                                     barycentric_at_corner(corner), piece.begin));
    }
    for(std::size_t i = 0; i < m_to.size(); ++i)
      if(const Index vertex = vertex_of(t, m_to[i]); vertex != none)
        distance[i] = m_state.vertices[vertex].distance;
    const double farthest = *std::max_element(distance.begin(), distance.end());
    m_state.max_distance = std::min(m_state.max_distance, farthest * (1. + round_off_tolerance));
  };
  std::size_t next_update = 0;
  for(std::size_t step = 0; !m_state.queue.empty(); ++step)
  {
    if(callback && step % steps_between_callbacks == 0 &&
       !callback(double(m_state.reached.size()) / double(m_state.vertices.size())))
      throw Cancelled();
    propagator.step();
    if(!m_to.empty() && step >= next_update)
    {
      limit_distance();
      next_update = step + steps_between_updates + m_to.size();
    }
  }

  std::vector<Polar_departure> result(m_to.size());
  for(std::size_t i = 0; i < m_to.size(); ++i)
    if(const Index vertex = vertex_of(t, m_to[i]); vertex != none)
      result[i] = departure_of_vertex(vertex);
  for(std::size_t k = 0; k < m_targets.size(); ++k)
  {
    const Polar_departure found = departure_of_target(m_targets[k].piece, goal.meetings()[k]);
    Polar_departure& shortest = result[m_targets[k].number];
    if(found.length < shortest.length)
      shortest = found;
  }
  return result;
}

// Follows the arrivals from a vertex to the one of the source, and its line.
Polar_departure Departure_finder::departure_of_vertex(Index vertex) const
{
  const Surface_arrays& t = *m_state.triangles;
  const double length = m_state.vertices[vertex].distance;
  if(!(length < infinity))
    return {};
  const Index to = vertex;
  const auto is_source = [&](Index v)
  { return v >= m_state.vertices.size() || m_state.vertices[v].corner == none; };
  if(is_source(vertex))
    return {length, 0.};
  while(!is_source(m_state.vertices[vertex].origin))
    vertex = m_state.vertices[vertex].origin;
  const Window_arrival& arrival = m_state.vertices[vertex];
  const auto corners = unfolded(t, arrival.corner / 3);
  const Vec2 begin = corners[arrival.corner % 3];
  const Vec2 to_source = line_length(m_state, arrival) *
                         rotated(arrival.direction, edge_direction(corners, arrival.corner));
  const Surface_location end = *source_point(m_state, arrival.origin);
  if(const auto line = follow_line(t, {arrival.corner / 3, begin, begin + to_source}, end))
    return {length,
            polar_angle_at(t, {line->triangle, none, *barycentric_in(t, line->triangle, end)},
                           line->from - line->target)};
  std::vector<Surface_location> path = {vertex_location(t, to)};
  append_chain(m_state, to, path);
  return departure_of_path(path, length);
}

// Returns the shortest of three departures: by a line in the triangle of the source, by a corner,
// and by a window.
Polar_departure Departure_finder::departure_of_target(const Source_piece& piece,
                                                      const Meeting& meeting) const
{
  const Surface_arrays& t = *m_state.triangles;
  const auto corners = unfolded(t, piece.triangle);
  const Vec2 p = unfolded_point(corners, piece.begin);
  for(const Source_piece& source : m_state.source_pieces)
    if(source.triangle == piece.triangle)
    {
      const Vec2 line = p - unfolded_point(corners, source.begin);
      return {norm(line), polar_angle_at(t, {piece.triangle, none, source.begin}, line)};
    }
  double by_corner = infinity;
  Index nearest = none;
  for(Index k = 0; k < 3; ++k)
  {
    const Index vertex = t.corner[3 * piece.triangle + k];
    const double length = m_state.vertices[vertex].distance + norm(p - corners[k]);
    if(length < by_corner)
    {
      by_corner = length;
      nearest = 3 * piece.triangle + k;
    }
  }
  if(!(by_corner <= meeting.distance))
    return meeting.distance < infinity ? departure_of_line(piece, meeting) : Polar_departure{};
  if(!(by_corner < infinity))
    return {};
  const Index vertex = t.corner[nearest];
  // At the vertex of the source, the direction is that of the line in this triangle.
  if(m_state.vertices[vertex].corner == none)
    return {by_corner, polar_angle_at(t, {piece.triangle, none, barycentric_at_corner(nearest)},
                                      p - corners[nearest % 3])};
  return {by_corner, departure_of_vertex(vertex).polar_angle};
}

Polar_departure Departure_finder::departure_of_line(const Source_piece& piece,
                                                    const Meeting& meeting) const
{
  const Surface_arrays& t = *m_state.triangles;
  const Index origin = meeting.origin;
  if(origin < m_state.vertices.size() && m_state.vertices[origin].corner != none)
    return {meeting.distance, departure_of_vertex(origin).polar_angle};
  const Surface_location from = canonical(t, {piece.triangle, none, piece.begin});
  const Vec2 p = unfolded_point(unfolded(t, piece.triangle), piece.begin);
  const Surface_location end = *source_point(m_state, origin);
  if(const auto line = follow_line(t, {piece.triangle, p, p + meeting.direction}, end))
    return {meeting.distance,
            polar_angle_at(t, {line->triangle, none, *barycentric_in(t, line->triangle, end)},
                           line->from - line->target)};
  std::vector<Surface_location> path = {from};
  append_line(m_state,
              {{piece.triangle, none, piece.begin}, meeting.direction, meeting.length, origin},
              path);
  return departure_of_path(path, meeting.distance);
}

// Returns the departure of a path to the source.
Polar_departure Departure_finder::departure_of_path(const std::vector<Surface_location>& path,
                                                    double length) const
{
  const Surface_arrays& t = *m_state.triangles;
  if(path.size() < 2)
    return {length, 0.};
  const Surface_location &source = path.back(), &next = path[path.size() - 2];
  const Index triangle = common_triangle(t, source, next);
  if(triangle == none)
    return {length, 0.};
  const auto corners = unfolded(t, triangle);
  const auto barycentric = *barycentric_in(t, triangle, source);
  return {length, polar_angle_at(t, {triangle, none, barycentric},
                                 unfolded_point(corners, *barycentric_in(t, triangle, next)) -
                                     unfolded_point(corners, barycentric))};
}

} // namespace CGAL::Geodesic_processing::internal
