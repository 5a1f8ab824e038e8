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

// Triangles cut into four, again and again.  A level adds the midpoints of the sides of the one before it,
// in the order in which its triangles first name them: the vertices of a level come before all others.
//
// Triangle f has the children 4f+0..2, of which 4f+k keeps corner k at its corner k, and the middle one
// 4f+3, whose corner k lies across from it:
//
//               2
//              / \                child 0 = (0, m0, m2), child 1 = (m0, 1, m1), child 2 = (m2, m1, 2),
//            m2 - m1              child 3 = (m1, m2, m0)
//            / \ / \              .
//           0 - m0 - 1
struct Subdivision
{
  struct Level
  {
    Index number_of_vertices = 0;
    std::vector<Triangle> triangles;
    std::vector<Index> twin;     // 3 #triangles: the opposite side, or none on the border
    std::vector<Index> midpoint; // 3 #triangles: of each side, a vertex of the next level
  };
  std::vector<Level> levels; // the coarsest first; only the last has no midpoints
  std::vector<std::array<Index, 2>>
      parents; // #vertices: ends of the edge that each is the midpoint of;
               //   of the coarsest level itself, twice

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

// The vertex opposite to a side in its triangle.
inline Index opposite_vertex(const Subdivision::Level& level, Index h)
{
  return source_vertex(level, previous_halfedge(h));
}

// True for one of a side and its twin.
inline bool is_edge_representative(const Subdivision::Level& level, Index h)
{
  return level.twin[h] == none || h < level.twin[h];
}

// Whether a half-edge structure can hold it: a vertex with triangles all around has no others.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_halfedge_mesh(const Subdivision::Level& level);

// Cuts triangles `times` times.  O(size of the result), 60 bytes for each of its triangles.
//
// Throws Invalid_argument_error when a triangle names a vertex twice, or one that there is not, when two
// vertices are joined by two edges or an edge has more than two triangles or two of unlike orientation, and
// when there would be more than 2^31 sides.
CGAL_GEODESIC_PROCESSING_EXPORT
Subdivision subdivide(const std::vector<Triangle>& triangles, Index number_of_vertices,
                      unsigned times);

// Adds a level.  Throws Invalid_argument_error when it would have more than 2^31 sides.
CGAL_GEODESIC_PROCESSING_EXPORT
void subdivide(Subdivision& subdivision);

// A place in a triangle of the coarsest level: the shares of its corners times a common denominator, so
// that sums and comparisons are exact.
struct Coarse_location
{
  Index triangle = none;                     // none of a vertex that no triangle names
  std::array<Index, 3> coordinates{0, 0, 0}; // their sum is the denominator
};

// #vertices: where each lies, in the first triangle that it belongs to.  The denominator is 2^times.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Coarse_location> coarse_locations(const Subdivision& subdivision);

// The quads of the second scheme of the paper (Peyré and Cohen 2003, figure 19): each triangle is cut into
// three quads, corner k, the middle of side k, the centre, the middle of side k-1; these then into four, again and
// again, child k at corner k.
struct Quad_subdivision
{
  std::vector<std::vector<Quad>> levels;  // the first holds the three quads of each triangle
  std::vector<Index> number_of_vertices;  // of each level, with those of the triangles
  std::vector<Coarse_location> locations; // #vertices
  std::vector<std::vector<Index>>
      parents; // #vertices: those of whose level each is the centre: of a side two,
               //   of a triangle three, of a quad four; of others none
};

// levels: one at least; errors as those of subdivide().  The denominator is 6 * 4^(levels - 1), which must be
// below 2^32.
CGAL_GEODESIC_PROCESSING_EXPORT
Quad_subdivision subdivide_into_quads(const std::vector<Triangle>& triangles,
                                      Index number_of_vertices, unsigned levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_SUBDIVISION_H
