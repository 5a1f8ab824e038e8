// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>

#include "core/unfold.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns a power of two near a length, or 1 if the length is zero or not finite.
double unit_of(double length)
{
  return length > 0. && std::isfinite(length) ? std::ldexp(1., std::ilogb(length)) : 1.;
}

} // namespace

Singular_values singular_values(const std::array<double, 3>& lengths,
                                const std::array<Vec2, 3>& image)
{
  Vec2 p = image[1] - image[0], q = image[2] - image[0];
  // In these units, areas neither overflow nor underflow.
  const double unit = unit_of((std::max)({lengths[0], lengths[1], lengths[2]}));
  const double image_unit =
      unit_of((std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(q[0]), std::abs(q[1])}));
  p = {p[0] / image_unit, p[1] / image_unit};
  q = {q[0] / image_unit, q[1] / image_unit};
  const double base = lengths[0] / unit;
  const Vec2 apex = third_corner(base, lengths[2] / unit, lengths[1] / unit);
  const double image_area = cross(p, q), area = unit * (unit * (0.5 * base * apex[1]));
  if(image_area == 0.)
    return {infinity, infinity, false, area};
  // The matrix of the map, in the plane of the triangle: columns (a, c) and (b, d).
  const double a = (base * q[1] - apex[0] * p[1]) / image_area;
  const double b = (apex[0] * p[0] - base * q[0]) / image_area;
  const double c = -apex[1] * p[1] / image_area, d = apex[1] * p[0] / image_area;
  // A linear map is the sum of a scaled rotation and a scaled reflection.
  const double rotation_part = 0.5 * std::hypot(a + d, c - b),
               reflection_part = 0.5 * std::hypot(a - d, c + b);
  const double factor = unit / image_unit;
  return {factor * (rotation_part + reflection_part),
          factor * std::abs(rotation_part - reflection_part), image_area < 0., area};
}

} // namespace CGAL::Geodesic_processing::internal
