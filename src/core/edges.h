// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EDGES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EDGES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the length of an edge of the proximity graph that leaves a vertex of a cloud.
inline double graph_edge_length(const Surface_arrays& t, Index vertex, Index edge)
{
  return norm(t.point[vertex] - t.point[t.graph.target[edge]]);
}

// Calls visit(target, length) for each edge of the proximity graph that leaves a vertex of a cloud.
// On a mesh there are none.
//
// slowness: #triangles, or null. If given, only edges of length zero are visited, which lead to
// copies of the same surfel: slowness belongs to triangles, and graph edges are in none.
template <typename Visitor>
void for_each_graph_edge(const Surface_arrays& t, const std::vector<double>* slowness, Index vertex,
                         const Visitor& visit)
{
  if(t.is_cloud())
    for(Index i = t.graph.begin[vertex]; i < t.graph.begin[vertex + 1]; ++i)
      if(const double length = graph_edge_length(t, vertex, i); !slowness || length == 0.)
        visit(t.graph.target[i], length);
}

// Calls visit(target, length) for each edge of the surface that leaves a vertex: edges of the
// proximity graph and edges of triangles, times the slowness of the triangle. An edge of two
// triangles is visited twice. Triangles of infinite slowness are skipped.
template <typename Visitor>
void for_each_edge(const Surface_arrays& t, const std::vector<double>* slowness, Index vertex,
                   const Visitor& visit)
{
  for_each_graph_edge(t, slowness, vertex, visit);
  if(t.is_cloud() && !slowness)
    return;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index corner = t.ring[i], previous_h = previous_halfedge(corner);
    const double triangle_slowness = slowness ? (*slowness)[corner / 3] : 1.;
    if(!(triangle_slowness < infinity))
      continue;
    visit(t.corner[next_halfedge(corner)], triangle_slowness * t.length[corner]);
    visit(t.corner[previous_h], triangle_slowness * t.length[previous_h]);
  }
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EDGES_H
