// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_relaxation.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/edges.h"
#include "core/unfold.h"
#include "mesh/Intrinsic_triangulation.h"

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Tolerance for an angle sum of 2 pi. The errors of single precision coordinates are smaller.
constexpr double flat_angle_tolerance = 1e-6;

// Returns whether the triangle at a position of the one-ring is the last one of its fan. If the fan
// is closed, the first triangle follows it.
bool ends_fan(const Surface_arrays& t, Index vertex, Index position)
{
  return position + 1 == t.ring_begin[vertex + 1] ||
         next_corner_ccw(t, t.ring[position]) != t.ring[position + 1];
}

// Returns whether the angle sum of a closed fan of a vertex is not 2 pi.
bool is_curved(const Front_state& front, Index vertex)
{
  const Surface_arrays& t = *front.triangles;
  Vec2 total_turn = {1., 0.};
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    total_turn = rotated(total_turn, corner_angle(front, t.ring[i]));
    if(!ends_fan(t, vertex, i))
      continue;
    if(next_corner_ccw(t, t.ring[i]) != none &&
       std::abs(total_turn[0] - 1.) + std::abs(total_turn[1]) > flat_angle_tolerance)
      return true;
    total_turn = {1., 0.};
  }
  return false;
}

// Calls visit(corner, is_left) for each edge that leaves a vertex of a mesh; see
// relax_along_edge(). In each fan, the edges are in counterclockwise order.
template <typename Visitor>
void for_each_fan_edge(const Surface_arrays& t, Index vertex, const Visitor& visit)
{
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    visit(t.ring[i], false);
    if(ends_fan(t, vertex, i) && next_corner_ccw(t, t.ring[i]) == none)
      visit(t.ring[i], true);
  }
}

Index far_vertex(const Surface_arrays& t, Index corner, bool is_left)
{
  return t.corner[is_left ? previous_halfedge(corner) : next_halfedge(corner)];
}

} // namespace

bool needs_invalidation(const Front_state& front, Index vertex, double correction)
{
  const Surface_arrays& t = *front.triangles;
  return correction > invalidation_ratio * t.length[t.ring[t.ring_begin[vertex]]] ||
         !is_curved(front, vertex);
}

bool may_improve_neighbors(const Front_state& front, Index vertex)
{
  if(front.kind == Front_kind::dijkstra || (front.has_directions() && !front.is_circular()))
    return true;
  const Surface_arrays& t = *front.triangles;
  const double distance = front.vertices[vertex].distance;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    for(const bool is_left : {false, true})
      if(const Index end = far_vertex(t, t.ring[i], is_left);
         front.improves(end, distance) && distance < front.vertices[end].distance)
        return true;
  return false;
}

void invalidate_descendants(Front_state& front)
{
  const Surface_arrays& t = *front.triangles;
  if(!can_invalidate(front))
    return front.corrected_vertices.clear();
  std::vector<Index> invalidated;
  const auto invalidate_around = [&](Index from)
  {
    for_each_fan_edge(t, from,
                      [&](Index corner, bool is_left)
                      {
                        const Index v = far_vertex(t, corner, is_left);
                        Front_vertex& vertex = front.vertices[v];
                        if(vertex.distance == infinity || (vertex.state & source_flag) ||
                           vertex.corner == none ||
                           (t.corner[next_halfedge(vertex.corner)] != from &&
                            t.corner[previous_halfedge(vertex.corner)] != from))
                          return;
                        vertex.distance = infinity;
                        vertex.state &= ~(final_flag | arrival_flags);
                        invalidated.push_back(v);
                      });
  };
  for(const Index vertex : front.corrected_vertices)
    invalidate_around(vertex);
  front.corrected_vertices.clear();
  for(std::size_t i = 0; i < invalidated.size(); ++i)
    invalidate_around(invalidated[i]);
  front.number_invalidated += invalidated.size();
  for(const Index vertex : invalidated)
    for_each_fan_edge(t, vertex,
                      [&](Index corner, bool is_left)
                      {
                        const Index end = far_vertex(t, corner, is_left);
                        if(front.vertices[end].state & final_flag)
                          front.queue.push(end, front.vertices[end].distance);
                      });
}

void relax_along_edge(Front_state& front, Index corner, bool is_left, Index flags)
{
  const Surface_arrays& t = *front.triangles;
  const Index vertex = t.corner[corner], end = far_vertex(t, corner, is_left);
  const double length = t.length[is_left ? previous_halfedge(corner) : corner],
               distance = front.vertices[vertex].distance + length;
  if(!(distance <= front.vertices[end].distance))
    return;
  // In the triangle to the right of the edge, the edge leaves the corner of the far end. Therefore
  // the direction to the source is the first axis. At the boundary only the triangle to its left
  // exists, in which the edge arrives at that corner.
  Arrival arrival = {distance,
                     {1., 0.},
                     is_left ? previous_halfedge(corner) : t.twin[corner],
                     flags,
                     flags & tentative_flag ? length : 0.};
  if(arrival.corner == none)
  {
    arrival.corner = next_halfedge(corner);
    arrival.direction = corner_angle(front, arrival.corner);
  }
  relax(front, end, arrival, front.sources[vertex]);
}

void relax_all_edges(Front_state& front, Index vertex, Index flags)
{
  for_each_fan_edge(*front.triangles, vertex,
                    [&](Index corner, bool is_left)
                    { relax_along_edge(front, corner, is_left, flags); });
}

void bound_by_edges(Front_state& front, const std::vector<Index>& often_corrected)
{
  const Surface_arrays& surface = *front.surface;
  std::vector<Index> decreased;
  const auto relax_edge = [&](Index from, Index to, double length, bool may_reach)
  {
    Front_vertex& vertex = front.vertices[to];
    const double distance = front.vertices[from].distance + length;
    const bool is_reached = vertex.distance < infinity;
    if(!(distance < vertex.distance) || !(is_reached || may_reach) || distance > front.max_distance)
      return;
    if(!is_reached)
      front.reached.push_back(to);
    vertex.distance = distance;
    // The edge crosses several triangles: the direction is not stored, and any corner is valid.
    vertex.corner = front.triangles->ring[front.triangles->ring_begin[to]];
    vertex.state = reached_flag | final_flag | tentative_flag;
    front.sources[to] = front.sources[from];
    decreased.push_back(to);
  };
  for(const Index v : often_corrected)
    for_each_edge(surface, nullptr, v,
                  [&](Index end, double length) { relax_edge(end, v, length, false); });
  if(front.triangles != front.surface)
  {
    const Intrinsic_triangulation& intrinsic = *front.intrinsic_triangulation;
    const auto relax_removed_edges = [&](Index v)
    {
      if(front.known_distance && !front.improves(v, front.vertices[v].distance))
        return;
      const auto [begin, end] = intrinsic.removed_edges(v);
      for(auto edge = begin; edge != end; ++edge)
        relax_edge(v, edge->vertex, edge->length, front.known_distance != nullptr);
    };
    // Vertices that are reached here are added to the list and not visited.
    const std::size_t number_of_reached = front.reached.size();
    const std::vector<Index>& vertices = intrinsic.vertices_with_removed_edges();
    if(!front.known_distance && vertices.size() < number_of_reached)
      for(const Index v : vertices)
        relax_removed_edges(v);
    else
      for(std::size_t i = 0; i < number_of_reached; ++i)
        relax_removed_edges(front.reached[i]);
  }
  while(!decreased.empty())
  {
    const Index v = decreased.back();
    decreased.pop_back();
    for_each_edge(surface, nullptr, v,
                  [&](Index end, double length) { relax_edge(v, end, length, false); });
  }
}

} // namespace CGAL::Geodesic_processing::internal
