// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/distances/obtuse_splits.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// An edge that leaves a vertex, and the triangle between it and the next edge.
struct Fan_edge
{
  Index vertex; // at the far end
  Index corner; // of the triangle, at the vertex that the edge leaves; none if there is no triangle
  double length;
};

// Writes the edges that leave a vertex, in the order of its one-ring, and returns their end.
// Triangles of the one-ring that follow each other mostly share an edge. If one shares none with
// the next triangle, an edge without a triangle follows; so there are at most two edges per
// triangle. The first edge of a closed fan is written at both ends.
inline Fan_edge* read_fan_edges(const Surface_arrays& t, Index vertex, Fan_edge* end)
{
  const Index* const ring_end = t.ring.data() + t.ring_begin[vertex + 1];
  for(const Index* corner = t.ring.data() + t.ring_begin[vertex]; corner != ring_end;)
  {
    const Index previous = previous_halfedge(*corner), left = t.corner[previous];
    *end++ = {t.corner[next_halfedge(*corner)], *corner, t.length[*corner]};
    ++corner;
    if(corner == ring_end || t.corner[next_halfedge(*corner)] != left)
      *end++ = {left, none, t.length[previous]};
  }
  return end;
}

// What a planar front reads around each vertex of a surface, stored contiguously, for many queries.
struct Vertex_fans
{
  // A Fan_edge with all that a front computes from it.
  class Edge
  {
  public:
    Edge() = default;
    Edge(const Fan_edge& edge, const Surface_arrays& triangles, const Obtuse_splits& splits);

    Index vertex; // at the far end
    double length;
    Vec2 opening; // (cos, sin) of the angle of the corner

    bool has_triangle() const { return m_code != none; }
    Index triangle() const { return m_code / 4; }
    // Returns whether the corner of the triangle at the far end of this edge, or of the next edge,
    // is obtuse and split.
    bool is_split() const { return (m_code & 1) != 0; }
    bool is_next_split() const { return (m_code & 2) != 0; }

  private:
    Index m_code; // there are less than 2^30 triangles
  };
  struct Offsets
  {
    Index edge, split;
  };

  std::vector<Offsets> begin; // #vertices + 1: of the edges and split corners of each vertex
  std::vector<Edge> edges;    // in the order of read_fan_edges()
  std::vector<Obtuse_splits::Half> splits; // in the order of Obtuse_splits::views
};

// Returns the fans of all vertices of a mesh. O(#triangles).
CGAL_GEODESIC_PROCESSING_EXPORT Vertex_fans build_vertex_fans(const Surface_arrays& triangles,
                                                              const Obtuse_splits& splits);

// Returns build_vertex_fans(), computed once as long as any user holds the result. The triangles
// must not change afterwards. Thread-safe.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& triangles);

// Returns (cos, sin) of the angle of each corner, for many circular fronts. It is computed once as
// long as any user holds the result. The triangles must not change afterwards. Thread-safe.
// O(#triangles).
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const std::vector<Vec2>> shared_corner_angles(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
