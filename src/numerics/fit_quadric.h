// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_FIT_QUADRIC_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_FIT_QUADRIC_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The height c_0 + c_1 u + c_2 v + c_3 u^2 / 2 + c_4 u v + c_5 v^2 / 2 over a plane through the
// origin. The coordinates u, v and the height are relative to the origin and divided by
// `length_unit`.
struct Quadric
{
  Vec3 x, y, plane_normal; // axes of u and v, and the unit normal of the plane
  double length_unit = 0.; // 0 if there is no quadric
  std::array<double, 6> coefficients = {};

  // Returns the unit normal of the quadric at the origin.
  Vec3 normal() const
  {
    return internal::unit(plane_normal - coefficients[1] * x - coefficients[2] * y);
  }
};

// Fits a quadric over the best-fit plane of the points, by least squares (Cazals and Pouget 2005,
// degree 2). If the points do not determine all coefficients, the solution of minimum norm is
// returned. If all points coincide with the origin, the result is empty. The length unit is the
// maximum distance from the origin. O(#points)
CGAL_GEODESIC_PROCESSING_EXPORT
Quadric fit_quadric(const Vec3& origin, const std::vector<Vec3>& points);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_FIT_QUADRIC_H
