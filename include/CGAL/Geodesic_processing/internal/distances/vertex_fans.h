// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The edges and triangles around each vertex, as a front reads them.
//
// The data of a vertex is contiguous, because a front visits vertices in random order and spends
// more time on memory access than on arithmetic.
struct Vertex_fans
{
  // An edge incident to the vertex, and the triangle between it and the next edge of the fan.
  struct Fan_edge
  {
    enum Flag : Index
    {
      has_triangle = 1,         // otherwise it is the last edge of its fan
      is_repeated = 2,          // first edge of a closed fan, stored at both ends
      is_obtuse_split = 4,      // the triangle's corner at `vertex` is obtuse and split
      is_next_obtuse_split = 8, // the same for the corner at the next edge's `vertex`
      is_curved = 16,           // first edge of an interior vertex whose angle sum is not 2 pi
    };
    Index vertex; // at the far end
    Index flags;
    double length;
    Vec2 opening; // (cos, sin) of the triangle's angle at the center vertex
  };
  // One half of a split obtuse corner (Kimmel and Sethian 1998, section 3). The triangles behind
  // the opposite edge are unfolded into the plane of the triangle until a vertex splits the obtuse
  // angle into two acute ones. Each half is a virtual triangle that contains the corner. It is
  // stored at both ends of its base.
  struct Split
  {
    Index corner;   // the obtuse corner
    Index target;   // the vertex of that corner
    Index along;    // the other end of the base
    Index neighbor; // the end of the base that is adjacent to the target
    double base;    // length of the base
    Vec2 apex;      // position of the corner; the base runs along the first axis
  };

  // The begins of the edges, the splits and the one-ring of a vertex, as in CSR format.
  struct Offsets
  {
    Index edge, split, ring;
  };

  std::vector<Offsets> begin; // #vertices + 1
  // Each fan is in counterclockwise order; a closed fan ends with a copy of its first edge.
  std::vector<Fan_edge> edges;
  std::vector<Split> splits;
};

// Computes the fans of all vertices in O(#triangles) time. If `with_splits`, obtuse corners of
// meshes are split; at most 20 triangles are unfolded for each corner.
CGAL_GEODESIC_PROCESSING_EXPORT Vertex_fans build_vertex_fans(const Surface_arrays& triangles,
                                                              bool with_splits);

// Returns build_vertex_fans(), computed once as long as any user holds the result. The triangles
// must not change afterwards. Thread-safe.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Vertex_fans> shared_vertex_fans(const Surface_arrays& triangles,
                                                      bool with_splits);

// The position of a triangle in the fan of one of its vertices.
struct Fan_position
{
  Index edge; // fan edge before the triangle
  Index ring; // position in Surface_arrays::ring
};

// Returns the position of the triangle of a corner around the vertex of that corner; O(degree).
inline Fan_position fan_position(const Surface_arrays& triangles, const Vertex_fans& fans,
                                 Index vertex, Index corner)
{
  Fan_position position = {fans.begin[vertex].edge, fans.begin[vertex].ring};
  for(; triangles.ring[position.ring] != corner; ++position.ring, ++position.edge)
    if(!(fans.edges[position.edge + 1].flags & Vertex_fans::Fan_edge::has_triangle))
      ++position.edge;
  return position;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_VERTEX_FANS_H
