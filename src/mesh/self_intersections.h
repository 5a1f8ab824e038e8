// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SELF_INTERSECTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SELF_INTERSECTIONS_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Finds pairs of triangles that intersect, except in vertices and edges that they share, by exact
// predicates. A degenerate triangle forms a pair with itself only. Pairs are sorted and have the
// smaller index first. The search ends if `max_pairs` pairs are found. O(n log n + k) for k pairs
// of intersecting bounding boxes.
//
// corners: #triangles by 3, indices of points
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::array<Index, 2>>
self_intersections(const std::vector<Vec3>& points,
                   const std::vector<std::array<Index, 3>>& corners, std::size_t max_pairs);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_SELF_INTERSECTIONS_H
