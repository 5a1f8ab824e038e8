// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "distances/Window_propagator.h"
#include "distances/obstacles.h"
#include "mesh/degenerate_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Window_propagation::Window_propagation(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(without_degenerate_triangles(std::move(triangles))),
      m_state(m_triangles, find_pseudo_sources(*m_triangles))
{
  const Distance_error error = distance_error_of_thin_triangles(*m_triangles);
  m_max_excess = error.excess;
  m_max_shortfall = error.shortfall;
}

void Window_propagation::check_speeds(const Front_limits& limits)
{
  if(limits.slowness && !uniform_slowness(*limits.slowness))
    throw Unsupported_surface_error("The method Exact admits one speed and obstacles only.");
}

bool Window_propagation::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  check_speeds(limits);
  set_obstacles(limits.slowness.get());
  std::vector<Surface_location> targets;
  for(const Surface_location& target : limits.targets)
    targets.push_back(outside_obstacles(target));
  m_state.clear();
  m_state.set_tolerance(limits.relative_tolerance);
  m_state.min_offset = infinity;
  for(const Front_source& source : sources)
    m_state.min_offset = std::min(m_state.min_offset, source.offset / m_slowness);
  m_state.max_distance = limits.maximum_distance / m_slowness - m_state.min_offset;
  Window_propagator propagator(m_state);
  m_sources = limits.slowness ? outside_obstacles(sources) : sources;
  propagator.start(m_sources);

  const auto remove_far_vertices = [&]
  {
    limit_to_targets(targets);
    const auto is_too_far = [&](Index vertex)
    {
      if(m_state.vertices[vertex].distance <= m_state.max_distance)
        return false;
      m_state.vertices[vertex] = Window_state::Vertex{};
      if(!m_state.is_exact())
        m_state.upper[vertex] = infinity;
      return true;
    };
    m_state.reached.erase(
        std::remove_if(m_state.reached.begin(), m_state.reached.end(), is_too_far),
        m_state.reached.end());
  };
  // The distances of the waiting windows are at least the first key minus the length of an edge.
  const auto interrupt = [&]
  {
    m_state.max_distance =
        std::min(m_state.max_distance, m_state.queue.smallest_key() - m_state.max_edge_length);
    remove_far_vertices();
  };
  const auto should_continue = [&]
  {
    try
    {
      return limits.callback(
          std::min(1., double(m_state.reached.size()) / double(m_state.vertices.size())));
    }
    catch(...)
    {
      interrupt();
      throw;
    }
  };

  std::size_t next_target_check = 0; // a number of visits
  for(std::size_t number_of_visits = 0; !m_state.queue.empty(); ++number_of_visits)
  {
    if(limits.callback && number_of_visits % 4096 == 0 && !should_continue())
    {
      interrupt();
      return false;
    }
    if(propagator.step() && !targets.empty() && number_of_visits >= next_target_check)
    {
      limit_to_targets(targets);
      next_target_check = number_of_visits + std::max<std::size_t>(64, targets.size());
    }
  }
  remove_far_vertices();
  return true;
}

// Removes the obstacles from the surface of the state, if they differ from those of the last query.
void Window_propagation::set_obstacles(const std::vector<double>* slowness)
{
  if(slowness ? *slowness == m_slowness_map : m_slowness_map.empty())
    return;
  const auto triangles = slowness ? without_obstacles(*m_triangles, *slowness) : m_triangles;
  m_state = Window_state(triangles, find_pseudo_sources(*triangles));
  m_reverse_search.search.reset();
  m_slowness = slowness ? *uniform_slowness(*slowness) : 1.;
  m_slowness_map = slowness ? *slowness : std::vector<double>();
}

Surface_location Window_propagation::outside_obstacles(const Surface_location& location) const
{
  return m_slowness_map.empty()
             ? location
             : internal::outside_obstacles(*m_triangles, *m_state.triangles, location);
}

// Converts the locations of sources, and their offsets to those for slowness 1.
std::vector<Front_source>
Window_propagation::outside_obstacles(const std::vector<Front_source>& sources) const
{
  std::vector<Front_source> result = sources;
  for(Front_source& source : result)
  {
    source.offset /= m_slowness;
    for(Surface_location& location : source.polyline)
      location = outside_obstacles(location);
  }
  return result;
}

bool Window_propagation::is_inside_obstacle(const Surface_location& location) const
{
  return !m_slowness_map.empty() && location.triangle != none &&
         vertex_of(*m_triangles, location) == none && m_slowness_map[location.triangle] == infinity;
}

// Decreases the maximum distance to the largest distance of the targets, once all of them are
// reached.
void Window_propagation::limit_to_targets(const std::vector<Surface_location>& targets)
{
  const Surface_arrays& t = *m_state.triangles;
  double farthest = targets.empty() ? infinity : -infinity;
  for(const Surface_location& target : targets)
    if(target.triangle == none)
      farthest = std::max(farthest, m_state.vertices[target.vertex].distance);
    else
      for(Index k = 0; k < 3; ++k)
        farthest = std::max(farthest,
                            m_state.vertices[t.corner[3 * target.triangle + k]].distance +
                                distance_in_triangle(t, target.triangle, barycentric_at_corner(k),
                                                     target.barycentric));
  m_state.max_distance =
      std::min(m_state.max_distance, farthest + round_off_tolerance * std::abs(farthest));
}

Index Window_propagation::predecessor(Index v) const
{
  const Surface_arrays& t = *m_state.triangles;
  const Window_state::Vertex& vertex = m_state.vertices[v];
  if(vertex.corner == none)
    return none;
  const Index next = t.corner[next_halfedge(vertex.corner)],
              previous = t.corner[previous_halfedge(vertex.corner)];
  // Prefers the edge with the smaller angle to the direction, if its end is closer to the source.
  const Vec2 direction_from_next = rotated_back(corner_angle(t, vertex.corner), vertex.direction);
  const bool is_next = vertex.direction[0] >= direction_from_next[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(m_state.vertices[candidate].distance < vertex.distance &&
       m_state.vertices[candidate].source == vertex.source)
      return candidate;
  return none;
}

} // namespace CGAL::Geodesic_processing::internal
