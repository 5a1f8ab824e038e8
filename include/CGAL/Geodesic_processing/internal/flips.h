// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_FLIPS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_FLIPS_H

#include <CGAL/Geodesic_processing/internal/Glued_triangles.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Flips edges of a surface in space where that makes the least angle of their two triangles larger
// (Lawson 1977), so that it ends; not where the surface bends by 25 degrees, before or after, and not
// to an edge that is there already: the surface stays as it is.
// triangles: of points, counterclockwise, a manifold; is_kept: #points: edges between two such stay
CGAL_GEODESIC_PROCESSING_EXPORT
void flip_to_larger_angles(const std::vector<std::array<double, 3>>& points,
                           const std::vector<bool>& is_kept,
                           std::vector<std::array<Index, 3>>& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_FLIPS_H
