// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_UNFOLD_HOLE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_UNFOLD_HOLE_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/mesh/triangulate_hole.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Unfolds a boundary cycle to a polygon in the plane that preserves the lengths of its edges and
// the angles between them (Peyre and Cohen, Geodesic Remeshing Using Front Propagation, 2003,
// section 3.2). If the polygon does not close, the missing angle and then the gap are distributed
// in proportion to the lengths. The boundary of a planar hole is preserved up to round-off errors.
// Returns an empty vector if an edge has no length or if the boundary encloses no area. O(n).
//
// points: at least three, counterclockwise around the hole
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::array<double, 2>>
unfold_boundary(const std::vector<std::array<double, 3>>& points);

// Triangulates a hole by the constrained Delaunay triangulation of its unfolded boundary. Returns
// an empty vector if the unfolded boundary intersects itself, or if the triangles would be
// degenerate in space or have an existing edge. O(n log n) for typical boundaries of n edges.
CGAL_GEODESIC_PROCESSING_EXPORT
Hole_triangles triangulate_unfolded_hole(const Hole_boundary& hole);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_UNFOLD_HOLE_H
