// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_relaxation.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/edges.h"
#include "mesh/Intrinsic_triangulation.h"

namespace CGAL::Geodesic_processing::internal {

bool may_improve_neighbors(const Front_state& front, Index vertex)
{
  if(!front.fans)
    return true;
  const double distance = front.vertices[vertex].distance;
  for(Index i = front.fans->begin[vertex].edge; i < front.fans->begin[vertex + 1].edge; ++i)
    if(const Index end = front.fans->edges[i].vertex;
       front.improves(end, distance) && distance < front.vertices[end].distance)
      return true;
  return false;
}

void invalidate_descendants(Front_state& front)
{
  const Surface_arrays& t = *front.triangles;
  const Vertex_fans& s = *front.fans;
  if(!can_invalidate(front))
    return front.corrected_vertices.clear();
  std::vector<Index> invalidated;
  const auto invalidate_around = [&](Index from)
  {
    for(Index i = s.begin[from].edge; i < s.begin[from + 1].edge; ++i)
    {
      const Index v = s.edges[i].vertex;
      Front_vertex& vertex = front.vertices[v];
      if(vertex.distance == infinity || (vertex.state & source_flag) || vertex.corner == none ||
         (t.corner[next_halfedge(vertex.corner)] != from &&
          t.corner[previous_halfedge(vertex.corner)] != from))
        continue;
      vertex.distance = infinity;
      vertex.state &= ~(final_flag | arrival_flags);
      invalidated.push_back(v);
    }
  };
  for(const Index vertex : front.corrected_vertices)
    invalidate_around(vertex);
  front.corrected_vertices.clear();
  for(std::size_t i = 0; i < invalidated.size(); ++i)
    invalidate_around(invalidated[i]);
  front.number_invalidated += invalidated.size();
  for(const Index vertex : invalidated)
    for(Index i = s.begin[vertex].edge; i < s.begin[vertex + 1].edge; ++i)
      if(const Index end = s.edges[i].vertex; front.vertices[end].state & final_flag)
        front.queue.push(end, front.vertices[end].distance);
}

void relax_along_edge(Front_state& front, Index vertex, const Fan_position& position, Index flags)
{
  const Surface_arrays& t = *front.triangles;
  const Vertex_fans::Fan_edge& edge = front.fans->edges[position.edge];
  const double distance = front.vertices[vertex].distance + edge.length;
  if(!(distance <= front.vertices[edge.vertex].distance))
    return;
  // In the triangle to the right of the edge, the edge leaves the corner of the far end. Therefore
  // the direction to the source is the first axis. At the boundary only the triangle to its left
  // exists, in which the edge arrives at that corner.
  Arrival arrival = {distance, {1., 0.}, none, flags, flags & tentative_flag ? edge.length : 0.};
  const bool has_before = position.edge > front.fans->begin[vertex].edge &&
                          ((&edge)[-1].flags & Vertex_fans::Fan_edge::has_triangle);
  if(has_before)
    arrival.corner = previous_halfedge(t.ring[position.ring - 1]);
  else if(const Index corner = t.ring[position.ring]; t.twin[corner] != none)
    arrival.corner = t.twin[corner];
  else
  {
    arrival.corner = next_halfedge(corner);
    arrival.direction = corner_angle(t, arrival.corner);
  }
  relax(front, edge.vertex, arrival, front.sources[vertex]);
}

void relax_all_edges(Front_state& front, Index vertex, Index flags)
{
  Fan_position position = {front.fans->begin[vertex].edge, front.fans->begin[vertex].ring};
  for(; position.edge < front.fans->begin[vertex + 1].edge; ++position.edge)
  {
    relax_along_edge(front, vertex, position, flags);
    if(front.fans->edges[position.edge].flags & Vertex_fans::Fan_edge::has_triangle)
      ++position.ring;
  }
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
