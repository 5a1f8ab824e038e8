// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include "core/edges.h"
#include "core/prefetch.h"
#include "core/unfold.h"
#include "distances/front_relaxation.h"
#include "distances/front_updates.h"
#include "distances/obstacles.h"
#include "mesh/Intrinsic_triangulation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Prefetches the triangles around a vertex, whose one-ring has been prefetched.
void prefetch_triangles(const Front_state& front, Index vertex)
{
  const Surface_arrays& t = *front.triangles;
  const Vec2* const angles = front.corner_angles ? front.corner_angles->data() : nullptr;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    prefetch(t.corner.data() + t.ring[i]);
    prefetch(t.length.data() + t.ring[i]);
    if(angles)
      prefetch(angles + t.ring[i]);
  }
}

// Prefetches the stored fan of a vertex. Four cache lines hold the edges of a vertex of degree 6,
// and two hold most splits. The addresses may be beyond the end of an array, which pointer
// arithmetic does not admit.
void prefetch_fan(const Vertex_fans& fans, Index vertex)
{
  const auto prefetch_lines = [](const void* begin, std::size_t index, std::size_t size, int count)
  {
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(begin) + index * size;
    for(int line = 0; line < count; ++line)
      prefetch(reinterpret_cast<const void*>(address + 64 * line));
  };
  const Vertex_fans::Offsets begin = fans.begin[vertex];
  prefetch_lines(fans.edges.data(), begin.edge, sizeof(Vertex_fans::Edge), 4);
  if(begin.split != fans.begin[vertex + 1].split)
    prefetch_lines(fans.splits.data(), begin.split, sizeof(Obtuse_splits::Half), 2);
}

// Prefetches the split corners that are seen from a vertex, whose views have been prefetched.
void prefetch_splits(const Obtuse_splits& s, Index vertex)
{
  for(Index i = s.begin[vertex]; i < s.begin[vertex + 1]; ++i)
    prefetch(&s.splits[s.views[i].split()]);
}

// Prefetches the data that propagation from the front of the queue reads. One of its children in
// the heap is mostly the next front, so their one-rings are prefetched, too.
void prefetch_next(const Front_state& front)
{
  const Surface_arrays& t = *front.triangles;
  const Index vertex = front.queue.front().vertex;
  if(front.known_distance)
    prefetch(front.known_distance->data() + vertex);
  if(t.is_cloud()) // many triangles, few of which are read
    return prefetch(t.ring.data() + t.ring_begin[vertex]);
  if(front.is_planar() && front.fans)
    return prefetch_fan(*front.fans, vertex);
  const Obtuse_splits* const splits =
      front.is_planar() && !front.splits->splits.empty() ? front.splits.get() : nullptr;
  prefetch_triangles(front, vertex);
  if(front.has_directions())
  {
    prefetch(&front.directions[vertex]);
    if(front.point_source && front.is_on_surface(vertex))
      prefetch(&front.surface->point[vertex]);
  }
  if(splits)
    prefetch_splits(*splits, vertex);
  front.queue.for_each_child_of_front(
      [&](Index child)
      {
        prefetch(t.ring.data() + t.ring_begin[child]);
        if(splits)
          prefetch(splits->views.data() + splits->begin[child]);
      });
}

// Returns the location in the triangles on which the front propagates.
Surface_location located(const Front_state& front, const Surface_location& location)
{
  return front.triangles == front.surface ? location
                                          : front.intrinsic_triangulation->locate(location);
}

// Returns the vertices of the targets, each with the length of the longest edge of its triangles.
// If the front is farther than the distance of a vertex by this length, no triangle can decrease
// it.
std::vector<std::pair<Index, double>>
finalization_delays(const Front_state& front, const std::vector<Surface_location>& targets)
{
  const Surface_arrays& t = *front.triangles;
  std::vector<std::pair<Index, double>> result;
  for(const Surface_location& location : targets)
  {
    const Surface_location target = located(front, location);
    for(int k = 0; k < (target.triangle == none ? 1 : 3); ++k)
    {
      const Index vertex =
          target.triangle == none ? target.vertex : t.corner[3 * target.triangle + k];
      double max_edge_length = 0.;
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
        for(const Index h : {t.ring[i], next_halfedge(t.ring[i]), previous_halfedge(t.ring[i])})
          max_edge_length = std::max(max_edge_length, t.length[h]);
      result.emplace_back(vertex, max_edge_length);
    }
  }
  return result;
}

// Selects what a Euclidean front propagates on. With speeds it is straight and needs the triangles
// of the surface, because a speed is constant in each of them.
void select_triangles(Front_state& front)
{
  if(front.slowness && !front.splits && !front.fans)
    front.splits = shared_obtuse_splits(*front.surface);
  front.triangles = front.intrinsic_triangulation && !front.slowness
                        ? front.intrinsic_triangulation->triangles()
                        : front.surface;
}

// Returns the distance at a location through a corner of its triangle of the surface.
double distance_by_corners(const Front_state& front, const Surface_location& location)
{
  const Surface_arrays& t = *front.surface;
  double result = infinity;
  for(int k = 0; k < 3; ++k)
  {
    const Index corner = 3 * location.triangle + k;
    result = std::min(result, front.vertices[t.corner[corner]].distance +
                                  distance_in_triangle(t, location.triangle, location.barycentric,
                                                       barycentric_at_corner(corner)));
  }
  return result;
}

// Returns the edges of the proximity graph of a cloud between different components of triangles.
// Returns a graph without vertices if there are none.
Proximity_graph edges_between_components(const Surface_arrays& t)
{
  Proximity_graph result;
  const auto [component, number_of_components] = triangle_components(t);
  if(number_of_components == 1)
    return result;
  result.begin.push_back(0);
  for(Index v = 0; v < t.number_of_vertices(); ++v)
  {
    for(Index i = t.graph.begin[v]; i < t.graph.begin[v + 1]; ++i)
      if(component[v] != component[t.graph.target[i]])
        result.target.push_back(t.graph.target[i]);
    result.begin.push_back(static_cast<Index>(result.target.size()));
  }
  return result.target.empty() ? Proximity_graph() : result;
}

// Returns the adjacent vertex through which the path along edges is shortest, of those that are
// closer to the source, or none.
Index nearest_predecessor(const Front_state& front, Index v)
{
  Index result = none;
  double min_distance = infinity;
  for_each_edge(*front.surface, nullptr, v,
                [&](Index neighbor, double length)
                {
                  const double distance = front.vertices[neighbor].distance;
                  if(distance < front.vertices[v].distance && distance + length < min_distance &&
                     front.sources[neighbor] == front.sources[v])
                  {
                    min_distance = distance + length;
                    result = neighbor;
                  }
                });
  return result;
}

} // namespace

Front::Front(std::shared_ptr<const Surface_arrays> triangles, Front_kind kind,
             Bisected_edges bisected)
{
  Front_state& front = m_state;
  front.kind = kind;
  front.surface = front.triangles = std::move(triangles);
  const Surface_arrays& t = *front.surface;
  if(kind == Front_kind::planar)
    front.splits = shared_obtuse_splits(t);
  if(kind == Front_kind::euclidean && t.is_cloud())
    front.component_edges = std::make_shared<const Proximity_graph>(edges_between_components(t));
  else if(kind == Front_kind::euclidean)
  {
    // Circular fronts are inaccurate and slow on needles and caps.
    front.intrinsic_triangulation = shared_intrinsic_triangulation(t, bisected);
    if(front.intrinsic_triangulation->is_empty())
      front.intrinsic_triangulation = nullptr;
    else
      front.triangles = front.intrinsic_triangulation->triangles();
  }
  const std::size_t n = front.triangles->number_of_vertices();
  front.vertices.resize(n);
  front.sources.resize(n, none);
  front.queue = Vertex_queue(n);
  // Memory that is reserved is not used before a vertex is reached. Growing would leave unused parts.
  front.reached.reserve(n);
  if(kind == Front_kind::euclidean)
    front.directions.resize(n);
}

bool Front::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  const auto finish = [this]
  {
    const std::vector<Index> often_corrected = collect_final_vertices();
    if(m_state.has_directions() && !m_state.surface->is_cloud())
      bound_by_edges(m_state, often_corrected);
  };
  begin_query(limits);
  if(m_state.unit == 1.)
    initialize(m_state, sources);
  else
  {
    std::vector<Front_source> own_sources = sources;
    for(Front_source& source : own_sources)
      source.offset /= m_state.unit;
    initialize(m_state, own_sources);
  }
  bool is_finished = false;
  try
  {
    is_finished = propagate(limits);
  }
  catch(...) // by the callback
  {
    finish();
    throw;
  }
  finish();
  return is_finished;
}

// Clears the results of the last query and stores the limits of the next one.
void Front::begin_query(const Front_limits& limits)
{
  Front_state& front = m_state;
  for(std::vector<Index>* const reached : {&front.reached, &front.reached_midpoints})
  {
    for(const Index vertex : *reached)
    {
      front.vertices[vertex] = Front_vertex{};
      front.sources[vertex] = none;
    }
    reached->clear();
  }
  front.queue.clear();
  front.corrected_vertices.clear();
  front.number_invalidated = 0;
  if(limits.slowness != m_slowness)
  {
    m_slowness = limits.slowness;
    m_constant_slowness = constant_slowness(m_slowness.get());
  }
  front.unit = m_constant_slowness.value_or(1.);
  front.slowness = m_constant_slowness ? nullptr : m_slowness;
  front.max_distance = limits.maximum_distance / front.unit;
  if(front.unit * front.max_distance > limits.maximum_distance)
    front.max_distance = std::nextafter(front.max_distance, 0.);
  front.known_distance = limits.known_distance;
  front.improves_known_distance = true;
  if(front.kind == Front_kind::euclidean)
    select_triangles(front);
  store_geometry();
}

// After some queries, stores what they compute around each vertex.
void Front::store_geometry()
{
  Front_state& front = m_state;
  const Surface_arrays& t = *front.triangles;
  // Larger surfaces need the memory.
  constexpr std::size_t max_vertices = 4000000;
  if(t.is_cloud() || t.number_of_vertices() == 0 || t.number_of_vertices() > max_vertices)
    return;
  const std::size_t visits_per_vertex = m_number_of_visits / t.number_of_vertices();
  try
  {
    // Building the fans takes as long as two queries on the whole surface, and 340 bytes per
    // vertex. It saves 15 % (a grid of a million vertices) to 35 % (scans of 35,000 vertices) of
    // later queries.
    if(front.is_planar() && !front.fans && visits_per_vertex >= 4)
    {
      front.fans = shared_vertex_fans(t);
      front.splits = nullptr; // the fans contain them
    }
    // The angles take a third of a query, and 100 bytes per vertex. They save 5 % (the grid) to
    // 20 % (the scans) of later queries. Unless they are prefetched, loading them takes longer than
    // computing them.
    if(has_prefetch && front.is_circular() && !front.corner_angles && visits_per_vertex >= 2)
      front.corner_angles = shared_corner_angles(t);
  }
  catch(const std::bad_alloc&)
  {
    // Queries do not need them.
  }
}

// Makes the vertices final in the order of their distances, until the queue is empty, the targets
// are final, or the callback cancels the query. Returns false if cancelled.
bool Front::propagate(const Front_limits& limits)
{
  Front_state& front = m_state;
  // If most vertices are targets, the front hardly ends earlier, and their delays take a third of the
  // query.
  const bool has_targets =
      !limits.targets.empty() && limits.targets.size() <= front.triangles->number_of_vertices() / 2;
  std::vector<std::pair<Index, double>> targets;
  if(has_targets)
    targets = finalization_delays(front, limits.targets);
  for(std::size_t number_of_visits = 0; !front.queue.empty(); ++number_of_visits)
  {
    const Vertex_queue::Entry entry = front.queue.front();
    // Tentative vertices are delayed. Therefore a later vertex may be closer than this one, and
    // the query continues.
    const double distance = front.vertices[entry.vertex].distance;
    if(distance > front.max_distance || distance == infinity)
    {
      front.queue.pop();
      continue;
    }
    while(!targets.empty() &&
          front.vertices[targets.back().first].distance + targets.back().second < entry.key)
      targets.pop_back();
    if(has_targets && targets.empty())
      break;
    if(limits.callback && number_of_visits % 4096 == 0 &&
       !limits.callback(std::min(1., double(number_of_visits) / double(front.vertices.size()))))
      return false;
    front.queue.pop();
    ++m_number_of_visits;
    // The next vertex is mostly known: its data is loaded while the current one propagates.
    if(!front.queue.empty())
      prefetch_next(front);
    Front_vertex& vertex = front.vertices[entry.vertex];
    vertex.state |= final_flag;
    vertex.distance = std::max(vertex.distance, straight_bound(front, entry.vertex));
    propagate_from(entry.vertex);
  }
  return true;
}

void Front::propagate_from(Index v)
{
  Front_state& front = m_state;
  front.improves_known_distance =
      !front.known_distance ||
      (front.kind != Front_kind::dijkstra && front.improves(v, front.vertices[v].distance));
  if(!front.improves_known_distance && !may_improve_neighbors(front, v))
    return;
  if(front.kind == Front_kind::dijkstra)
    propagate_along_edges(front, v);
  else if(!front.has_directions())
    propagate_planar(front, v);
  else if(front.triangles->is_cloud())
    propagate_on_cloud(front, v);
  else
    propagate_circular(front, v);
  if(!front.corrected_vertices.empty())
    invalidate_descendants(front);
}

// Resets the vertices that are not final, and moves the inserted ones out of the list of reached
// vertices. Returns those whose corrections may have been refused.
std::vector<Index> Front::collect_final_vertices()
{
  Front_state& front = m_state;
  front.queue.clear();
  const Index number_of_vertices = Index(front.surface->number_of_vertices());
  std::vector<Index> often_corrected;
  std::size_t number_of_final_vertices = 0;
  for(const Index vertex : front.reached)
  {
    const Index state = front.vertices[vertex].state;
    if(!(state & final_flag))
    {
      front.vertices[vertex] = Front_vertex{};
      front.sources[vertex] = none;
    }
    else if(vertex >= number_of_vertices)
      front.reached_midpoints.push_back(vertex);
    else
    {
      front.reached[number_of_final_vertices++] = vertex;
      if(state >= max_corrections_over_budget * correction_unit)
        often_corrected.push_back(vertex);
    }
  }
  front.reached.resize(number_of_final_vertices);
  return often_corrected;
}

Index Front::predecessor(Index v) const
{
  const Front_state& front = m_state;
  const Surface_arrays& t = *front.triangles;
  const Front_vertex& vertex = front.vertices[v];
  if(!(vertex.distance < infinity) || (vertex.state & source_flag) || vertex.corner == none)
    return none;
  if(!front.has_directions() || t.is_cloud())
    return vertex.corner;
  if(front.triangles != front.surface)
    return nearest_predecessor(front, v);
  const Index next = t.corner[next_halfedge(vertex.corner)],
              previous = t.corner[previous_halfedge(vertex.corner)];
  // Prefers the edge with the smaller angle to the direction, if its end is closer to the source.
  const Vec2 direction_from_next =
      rotated_back(corner_angle(t, vertex.corner), front.directions[v]);
  const bool is_next = front.directions[v][0] >= direction_from_next[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(front.vertices[candidate].distance < vertex.distance &&
       front.sources[candidate] == front.sources[v])
      return candidate;
  return none;
}

double Front::distance(const Surface_location& location) const
{
  const Front_state& front = m_state;
  if(const Index vertex = vertex_of(*front.surface, location); vertex != none)
    return distance(vertex);
  // At a point on an edge, the front may arrive through either triangle.
  const Surface_arrays& t = *front.triangles;
  const Surface_location p = located(front, location);
  double result = infinity;
  for(const Index triangle : triangles_at(t, p))
    result = std::min(result, distance_in_front(front, triangle, *barycentric_in(t, triangle, p)));
  if(front.triangles != front.surface)
    result = std::min(result, distance_by_corners(front, location));
  if(front.point_source)
    result = std::max(result, front.min_offset +
                                  straight_distance(scaled_coordinates(*front.surface, location),
                                                    *front.point_source));
  return result <= front.max_distance ? front.unit * result : infinity;
}

} // namespace CGAL::Geodesic_processing::internal
