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

// Triangles of points in space, glued where two of them share an edge, whose edges can be flipped.
class CGAL_GEODESIC_PROCESSING_EXPORT Flippable_triangles
{
public:
  // triangles: counterclockwise; an edge of more than two of them glues none
  Flippable_triangles(std::size_t number_of_points,
                      const std::vector<std::array<Index, 3>>& triangles);

  const std::vector<Index>& corner() const { return m_corner; }
  const std::vector<Index>& twin() const { return m_twin; }
  // Whether an edge joins the end of a side to another point.
  bool is_adjacent(Index h, Index point) const;
  // Whether the surface bends little at a side, and would so at the one that takes its place; or, however it
  // bends, hardly changes, as one of the triangles is a needle along the other.
  bool is_flat(const std::vector<Vec3>& points, Index h) const;
  // Of x y z and y x w makes x w z and w y z, which lie where these did.
  void flip(Index h);

private:
  std::vector<Index> m_corner, m_twin;
};

// Flips edges of a surface in space where that makes the least angle of their two triangles larger
// (Lawson 1977), so that it ends; not where the surface bends by 25 degrees, before or after, but for needles, and
// not to an edge that is there already: the surface stays as it is.
// triangles: of points, counterclockwise, a manifold; is_kept: #points: edges between two such stay
CGAL_GEODESIC_PROCESSING_EXPORT
void flip_to_larger_angles(const std::vector<Vec3>& points, const std::vector<bool>& is_kept,
                           std::vector<std::array<Index, 3>>& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FLIPS_H
