// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_FIT_QUADRIC_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_FIT_QUADRIC_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The height c_0 + c_1 u + c_2 v + c_3 u^2 / 2 + c_4 u v + c_5 v^2 / 2 over a plane, all seen from an
// origin and in units of a length.
struct Quadric
{
  Vec3 x, y, plane_normal; // the axes of u and v, and the normal of the plane
  double length_unit = 0.; // the length; zero where there is no quadric
  std::array<double, 6> coefficients = {};

  // Of unit length, at the origin.
  Vec3 normal() const
  {
    return internal::unit(plane_normal - coefficients[1] * x - coefficients[2] * y);
  }
};

// The quadric over the plane of some points that is nearest to them in the sense of least squares (Cazals
// and Pouget 2005, degree 2); the smallest coefficients where points leave some open.  None where all points
// coincide with the origin.  O(#points).
CGAL_GEODESIC_PROCESSING_EXPORT
Quadric fit_quadric(const Vec3& origin, const std::vector<Vec3>& points);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_FIT_QUADRIC_H
