// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_SUBDIVISION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_SUBDIVISION_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

using Triangle = std::array<Index, 3>; // vertices, counterclockwise
using Quad = std::array<Index, 4>;

// Repeated 1-to-4 subdivision of triangles (uniform refinement). Each level adds the midpoints of
// the edges of the previous level, in the order in which its halfedges first refer to them. So the
// vertices of a level are a prefix of those of the next level.
//
// Triangle f has four children. Child 4f+k, for k = 0, 1, 2, keeps corner k of f as its corner k.
// Child 4f+3 is the central one; its corner k is opposite to corner k of f:
//
//               2
//              / \                child 0 = (0, m0, m2), child 1 = (m0, 1, m1),
//            m2 - m1              child 2 = (m2, m1, 2), child 3 = (m1, m2, m0)
//            / \ / \              .
//           0 - m0 - 1
struct Subdivision
{
  struct Level
  {
    Index number_of_vertices = 0;
    std::vector<Triangle> triangles;
    std::vector<Index> twin; // 3 #triangles: the opposite halfedge; none on the boundary
    std::vector<Index>
        midpoint; // 3 #triangles: midpoint of each halfedge, a vertex of the next level
  };
  std::vector<Level> levels; // coarsest first; the last level has no midpoints
  std::vector<std::array<Index, 2>>
      parents; // #vertices: ends of the edge whose midpoint it is; on the coarsest level,
               //   twice the vertex itself

  const Level& finest() const { return levels.back(); }
  Index number_of_vertices() const { return levels.back().number_of_vertices; }
};

inline Index source_vertex(const Subdivision::Level& level, Index h)
{
  return level.triangles[h / 3][h % 3];
}

inline std::array<Index, 2> edge_vertices(const Subdivision::Level& level, Index h)
{
  return {source_vertex(level, h), source_vertex(level, next_halfedge(h))};
}

// Returns the vertex opposite to a halfedge in its triangle.
inline Index opposite_vertex(const Subdivision::Level& level, Index h)
{
  return source_vertex(level, previous_halfedge(h));
}

// Returns true for exactly one halfedge of each edge.
inline bool is_edge_representative(const Subdivision::Level& level, Index h)
{
  return level.twin[h] == none || h < level.twin[h];
}

// Returns true if a halfedge data structure can represent a level: a vertex that is surrounded by a
// closed fan of triangles has no other triangles. Several open fans are admitted. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_halfedge_mesh(const Subdivision::Level& level);

// Subdivides triangles `times` times. O(size of the result); 60 bytes per triangle of the result.
//
// Throws Invalid_argument_error if
// - a triangle refers to a vertex twice, or to one that does not exist,
// - two vertices are connected by two edges,
// - an edge has more than two triangles, or two with inconsistent orientations,
// - the result would have 2^31 halfedges or more.
CGAL_GEODESIC_PROCESSING_EXPORT
Subdivision subdivide(const std::vector<Triangle>& triangles, Index number_of_vertices,
                      unsigned times);

// Adds a level. Throws Invalid_argument_error if it would have 2^31 halfedges or more.
CGAL_GEODESIC_PROCESSING_EXPORT
void subdivide(Subdivision& subdivision);

// A location in a triangle of the coarsest level. The barycentric coordinates are multiplied by a
// common denominator, so that sums and comparisons of integers are exact.
struct Coarse_location
{
  Index triangle = none;                     // none for isolated vertices
  std::array<Index, 3> coordinates{0, 0, 0}; // their sum is the denominator
};

// Returns the location of each vertex (#vertices) in the first triangle of the coarsest level that
// contains it. The denominator is 2^times. O(size of all levels).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Coarse_location> coarse_locations(const Subdivision& subdivision);

// Subdivision of triangles into quads, the second scheme of Peyré and Cohen (2003, figure 19).
// First each triangle is split into three quads. The corners of quad k are: corner k, the midpoint
// of edge k, the centroid, the midpoint of edge k-1. Then each quad is repeatedly split into four;
// child k keeps corner k of its parent as its corner k.
struct Quad_subdivision
{
  std::vector<std::vector<Quad>> levels;  // the first level has three quads per triangle
  std::vector<Index> number_of_vertices;  // of each level, including the vertices of the triangles
  std::vector<Coarse_location> locations; // #vertices
  std::vector<std::vector<Index>>
      parents; // #vertices: the vertices whose centroid it is: two for the midpoint of an edge,
               //   three in a triangle, four in a quad; empty for the input vertices
};

// Subdivides triangles into `levels` levels of quads, at least one. The denominator of the
// locations is 6 * 4^(levels - 1), which must be below 2^32. Throws the exceptions of subdivide(),
// and Invalid_argument_error if `levels` is zero. O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Quad_subdivision subdivide_into_quads(const std::vector<Triangle>& triangles,
                                      Index number_of_vertices, unsigned levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_SUBDIVISION_H
