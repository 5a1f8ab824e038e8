// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SINGULAR_VALUES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SINGULAR_VALUES_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>

namespace CGAL::Geodesic_processing::internal {

// The singular values of the linear map from the image in the plane to the triangle, largest first.
struct Singular_values
{
  double sigma_1 = 1., sigma_2 = 1.; // both infinite if the image has no area
  bool is_inverted = false;          // the image is clockwise
  double area = 0.;                  // area of the triangle (not of its image)
};

// Computes the singular values of the map from a triangle's image to the triangle.
//
// lengths  of the edges: edge k begins at corner k
//
// image    the points of the corners in the plane
CGAL_GEODESIC_PROCESSING_EXPORT
Singular_values singular_values(const std::array<double, 3>& lengths,
                                const std::array<Vec2, 3>& image);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SINGULAR_VALUES_H
