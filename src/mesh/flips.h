// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FLIPS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FLIPS_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Triangles of points in space, connected at edges that have exactly two of them, whose edges can
// be flipped.
class CGAL_GEODESIC_PROCESSING_EXPORT Flippable_triangles
{
public:
  // triangles: counterclockwise. Edges of more than two triangles are boundary edges.
  Flippable_triangles(std::size_t number_of_points,
                      const std::vector<std::array<Index, 3>>& triangles);

  const std::vector<Index>& corner() const { return m_corner; }
  const std::vector<Index>& twin() const { return m_twin; }
  // Returns whether an edge joins the source of a halfedge to a point.
  bool is_adjacent(Index h, Index point) const;
  // Returns whether an edge can be flipped without a large change of the surface. The dihedral
  // angles at the edge and at the flipped edge must be small, or one of the two triangles must be a
  // needle along the other.
  bool is_flat(const std::vector<Vec3>& points, Index h) const;
  // Replaces the triangles xyz and yxw by xwz and wyz, in the same two positions of the arrays.
  void flip(Index h);

private:
  std::vector<Index> m_corner, m_twin;
};

// Flips edges as long as this increases the smallest angle of the two incident triangles (Lawson
// 1977). An edge is kept if the surface bends by more than 26 degrees at it before or after the
// flip (except for needles), or if the flipped edge exists already.
//
// triangles: indices of points, counterclockwise, a manifold
// kept_edges: pairs of points, the smaller index first, in increasing order
CGAL_GEODESIC_PROCESSING_EXPORT
void flip_to_larger_angles(const std::vector<Vec3>& points,
                           const std::vector<std::array<Index, 2>>& kept_edges,
                           std::vector<std::array<Index, 3>>& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FLIPS_H
