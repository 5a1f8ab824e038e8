// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>

#include "core/unfold.h"

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

Singular_values singular_values(const std::array<double, 3>& lengths,
                                const std::array<Vec2, 3>& image)
{
  const Vec2 p = image[1] - image[0], q = image[2] - image[0];
  const Vec2 s = {lengths[0], 0.}, t = third_corner(lengths[0], lengths[2], lengths[1]);
  const double area = cross(p, q), source_area = 0.5 * s[0] * t[1];
  if(area == 0.)
    return {infinity, infinity, false, source_area};
  // The matrix of the map, in the plane of the triangle: columns (a, c) and (b, d).
  const double a = (s[0] * q[1] - t[0] * p[1]) / area, b = (t[0] * p[0] - s[0] * q[0]) / area;
  const double c = (s[1] * q[1] - t[1] * p[1]) / area, d = (t[1] * p[0] - s[1] * q[0]) / area;
  // A linear map is the sum of a scaled rotation and a scaled reflection.
  const double rotation_part = 0.5 * std::hypot(a + d, c - b),
               reflection_part = 0.5 * std::hypot(a - d, c + b);
  return {rotation_part + reflection_part, std::abs(rotation_part - reflection_part), area < 0.,
          source_area};
}

} // namespace CGAL::Geodesic_processing::internal
