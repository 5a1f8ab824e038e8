// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Reverse_window_search.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "distances/Window_propagator.h"
#include "distances/window_chains.h"

#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// If all points of a circle have the same distance to a source, the number of paths is unbounded.
constexpr std::size_t max_paths = 64;

} // namespace

Reverse_window_search::Reverse_window_search(
    std::shared_ptr<const Surface_arrays> triangles,
    std::shared_ptr<const std::vector<bool>> is_pseudo_source)
    : m_state(triangles, std::move(is_pseudo_source)), m_goal(triangles)
{}

const Meeting& Reverse_window_search::find_shortest(const Window_state& forward,
                                                    const Surface_location& from)
{
  m_goal.find_shortest(forward);
  propagate_back(from);
  return m_goal.meeting();
}

const Meeting& Reverse_window_search::find_between(const Window_state& initialized,
                                                   const Surface_location& source,
                                                   const Surface_location& from, double max_length,
                                                   const std::function<bool(double)>& callback)
{
  m_goal.find_between(initialized, source, max_length);
  propagate_back(from, callback);
  return m_goal.meeting();
}

void Reverse_window_search::find_all(const Window_state& forward, const Surface_location& from,
                                     double max_length)
{
  m_goal.find_all(forward, max_length);
  propagate_back(from);
}

void Reverse_window_search::propagate_back(const Surface_location& from,
                                           const std::function<bool(double)>& callback)
{
  constexpr std::size_t steps_per_call = 4096; // about a millisecond
  const Surface_arrays& t = *m_state.triangles;
  m_state.clear();
  m_state.max_distance = infinity;
  const Index vertex = vertex_of(t, from);
  // A location inside a triangle is the first source piece.
  const Index origin = vertex != none ? vertex : Index(m_state.vertices.size());
  for(const Index triangle : triangles_at(t, from))
    m_goal.meet_sources(triangle,
                        unfolded_point(unfolded(t, triangle), *barycentric_in(t, triangle, from)),
                        0., origin);
  m_state.min_offset = 0.;
  Window_propagator propagator(m_state, &m_goal);
  propagator.start({{{from}, 0., 0}});
  for(std::size_t step = 0; !m_state.queue.empty(); ++step)
  {
    if(callback && step % steps_per_call == 0)
      callback(0.);
    m_state.max_distance = m_goal.meeting().distance * (1. + round_off_tolerance);
    propagator.step();
  }
}

void Reverse_window_search::collect_paths(Index vertex, const std::vector<Surface_location>& path,
                                          std::vector<std::vector<Surface_location>>& paths) const
{
  if(paths.size() == max_paths)
    return;
  if(vertex >= m_state.vertices.size() || m_state.vertices[vertex].corner == none)
    return paths.push_back(path);
  for(const Window_arrival& arrival : m_goal.arrivals(vertex))
  {
    std::vector<Surface_location> extended_path = path;
    append_arrival(m_state, arrival, extended_path);
    collect_paths(arrival.origin, extended_path, paths);
  }
}

} // namespace CGAL::Geodesic_processing::internal
