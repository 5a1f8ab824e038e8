// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_TRIANGULATE_POLYGON_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_TRIANGULATE_POLYGON_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Triangulates a polygon, which may be concave, nonplanar or self-intersecting. Returns k - 2
// triangles of positions in `corners`. A quadrilateral is divided by its shorter diagonal if both
// diagonals are inside.
//
// corners: k >= 3 points
// Ear clipping, O(k^2): about one second for 10,000 corners.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::array<Index, 3>>
triangulate_polygon(const std::vector<std::array<double, 3>>& corners);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_TRIANGULATE_POLYGON_H
