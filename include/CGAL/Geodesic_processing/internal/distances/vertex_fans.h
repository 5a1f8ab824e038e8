// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// An edge that leaves a vertex, and the triangle between it and the next edge.
struct Fan_edge
{
  Index vertex; // at the far end
  Index corner; // of the triangle, at the vertex that the edge leaves; none if there is no triangle
  double length;
  Vec2 opening; // (cos, sin) of the angle of the corner
};

// Writes the edges that leave a vertex, in the order of its one-ring, and returns their end. Triangles
// of the one-ring that follow each other mostly share an edge. If one shares none with the next
// triangle, an edge without a triangle follows; so there are at most two edges per triangle. The first
// edge of a closed fan is written at both ends.
inline Fan_edge* read_fan_edges(const Surface_arrays& t, Index vertex, Fan_edge* end)
{
  const Index *corner = t.ring.data() + t.ring_begin[vertex], *const ring_end =
                                                                  t.ring.data() +
                                                                  t.ring_begin[vertex + 1];
  while(corner != ring_end)
  {
    const Index next = next_halfedge(*corner), previous = previous_halfedge(*corner),
                left = t.corner[previous];
    const double right_length = t.length[*corner], left_length = t.length[previous];
    *end++ = {t.corner[next], *corner, right_length,
              angle_between(right_length, left_length, t.length[next])};
    ++corner;
    if(corner == ring_end || t.corner[next_halfedge(*corner)] != left)
      *end++ = {left, none, left_length, {1., 0.}};
  }
  return end;
}

// The edges that leave each vertex of a surface, stored contiguously, for many fronts.
struct Vertex_fans
{
  std::vector<Index> begin; // #vertices + 1
  std::vector<Fan_edge> edges;
};

// Returns read_fan_edges() of all vertices. O(#triangles).
CGAL_GEODESIC_PROCESSING_EXPORT Vertex_fans build_vertex_fans(const Surface_arrays& triangles);

// Returns build_vertex_fans(), computed once as long as any user holds the result. The triangles
// must not change afterwards. Thread-safe.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
