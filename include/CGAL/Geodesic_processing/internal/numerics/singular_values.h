// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SINGULAR_VALUES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SINGULAR_VALUES_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <array>

namespace CGAL::Geodesic_processing::internal {

// How a linear map from the plane to a triangle stretches at the most and at the least.
struct Singular_values
{
  double sigma_1 = 1., sigma_2 = 1.; // infinite both where the image in the plane has no area
  bool is_inverted = false;          // it turns the triangle round
  double area = 0.;                  // of the triangle
};

// lengths  of the triangle's sides, side k from corner k on; image  of its corners in the plane
CGAL_GEODESIC_PROCESSING_EXPORT
Singular_values singular_values(const std::array<double, 3>& lengths,
                                const std::array<Vec2, 3>& image);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SINGULAR_VALUES_H
