// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_POLYGONS_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_POLYGONS_H

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include "triangulations.h"

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::test {

using internal::cross;
using internal::dot;
using internal::operator+;
using internal::operator-;
using internal::operator*;

// Returns the part of a convex polygon that is closer to p than to q.
inline std::vector<Point> clip_to_bisector(const std::vector<Point>& polygon, const Point& p,
                                           const Point& q)
{
  const auto excess = [&](const Point& x) { return dot(x - p, x - p) - dot(x - q, x - q); };
  std::vector<Point> result;
  for(std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if(excess(a) <= 0.)
      result.push_back(a);
    if((excess(a) < 0.) != (excess(b) < 0.))
      result.push_back(a + (excess(a) / (excess(a) - excess(b))) * (b - a));
  }
  return result;
}

inline Point centroid(const std::vector<Point>& polygon)
{
  Point moment = {0., 0., 0.};
  double area = 0.;
  for(std::size_t i = 2; i < polygon.size(); ++i)
  {
    const Point &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    const double twice_signed_area = cross(b - a, c - a)[2];
    area += twice_signed_area;
    moment = moment + (twice_signed_area / 3.) * (a + b + c);
  }
  return (1. / area) * moment;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_POLYGONS_H
