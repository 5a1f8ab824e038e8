// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Scaled coordinates: a caller's point is origin + scale * ours; scale is a power of two.
struct Frame
{
  std::array<double, 3> origin = {0., 0., 0.};
  double scale = 1.;
};

// The frame in which the points' bounding box has its centre at the origin and half its longest
// extent in [1, 2): then squares of coordinates neither overflow nor underflow.
// Throws Invalid_argument_error when a coordinate is not finite or the extent overflows.
CGAL_GEODESIC_PROCESSING_EXPORT
Frame unit_frame(const std::vector<std::array<double, 3>>& points);

CGAL_GEODESIC_PROCESSING_EXPORT
void to_frame(std::vector<std::array<double, 3>>& points, const Frame& frame);

// The indices of points, whose coordinates lie in [-2, 2], along a Morton curve; ties by index.
// O(n) by radix sort.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> morton_order(const std::vector<std::array<double, 3>>& points);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_MORTON_ORDER_H
