// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

using Spatial = std::array<double, 3>;

inline Spatial operator+(const Spatial& p, const Spatial& q)
{
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
inline Spatial operator-(const Spatial& p, const Spatial& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Spatial operator*(double factor, const Spatial& p)
{
  return {factor * p[0], factor * p[1], factor * p[2]};
}
inline double dot(const Spatial& p, const Spatial& q)
{
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
inline Spatial cross(const Spatial& p, const Spatial& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
inline double norm(const Spatial& p) { return std::sqrt(dot(p, p)); }

// The unit vector along p, or zero where p is.
inline Spatial unit(const Spatial& p)
{
  const double size = norm(p);
  return size > 0. ? (1. / size) * p : p;
}

// Two unit vectors that make a positively oriented orthonormal frame with the unit vector n, and
// depend on n alone (Duff and others 2017, "Building an orthonormal basis, revisited").
inline std::pair<Spatial, Spatial> tangent_frame(const Spatial& n)
{
  const double sign = std::copysign(1., n[2]);
  const double a = -1. / (sign + n[2]), b = n[0] * n[1] * a;
  return {{1. + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
          {b, sign + n[1] * n[1] * a, -n[1]}};
}

// Barycentric coordinates of the point of a triangle with area that is nearest to p.
inline std::array<double, 3> nearest_in_triangle(const Spatial& a, const Spatial& b,
                                                 const Spatial& c, const Spatial& p)
{
  const Spatial ab = b - a, ac = c - a, normal = cross(ab, ac);
  const double square = dot(normal, normal);
  const double v = dot(cross(p - a, ac), normal) / square,
               w = dot(cross(ab, p - a), normal) / square;
  if(v >= 0. && w >= 0. && v + w <= 1.)
    return {1. - v - w, v, w};
  // Outside: the nearest point on a side.
  const std::array<Spatial, 3> corners = {a, b, c};
  std::array<double, 3> result{};
  double least = std::numeric_limits<double>::infinity();
  for(int k = 0; k < 3; ++k)
  {
    const Spatial side = corners[(k + 1) % 3] - corners[k];
    const double share = std::clamp(dot(p - corners[k], side) / dot(side, side), 0., 1.);
    const double distance = norm(p - corners[k] - share * side);
    if(distance < least)
    {
      least = distance;
      result = {0., 0., 0.};
      result[k] = 1. - share;
      result[(k + 1) % 3] = share;
    }
  }
  return result;
}

// Of the least angle of a triangle.
inline double largest_cosine(const Spatial& a, const Spatial& b, const Spatial& c)
{
  const Spatial u = unit(b - a), v = unit(c - b), w = unit(a - c);
  return std::max({-dot(u, v), -dot(v, w), -dot(w, u)});
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_H
