// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC3_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC3_H

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

using Vec3 = std::array<double, 3>;

inline Vec3 operator+(const Vec3& p, const Vec3& q)
{
  return {p[0] + q[0], p[1] + q[1], p[2] + q[2]};
}
inline Vec3 operator-(const Vec3& p, const Vec3& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline Vec3 operator*(double factor, const Vec3& p)
{
  return {factor * p[0], factor * p[1], factor * p[2]};
}
inline double dot(const Vec3& p, const Vec3& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
inline Vec3 cross(const Vec3& p, const Vec3& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
inline double norm(const Vec3& p) { return std::sqrt(dot(p, p)); }

// Returns p / |p|, or p if it is zero.
inline Vec3 unit(const Vec3& p)
{
  const double length = norm(p);
  return length > 0. ? (1. / length) * p : p;
}

// Computes two unit vectors that form a positively oriented orthonormal frame with the unit vector
// n. They depend on n only (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
inline std::pair<Vec3, Vec3> tangent_frame(const Vec3& n)
{
  const double sign = std::copysign(1., n[2]);
  const double a = -1. / (sign + n[2]), b = n[0] * n[1] * a;
  return {{1. + sign * n[0] * n[0] * a, sign * b, -sign * n[0]},
          {b, sign + n[1] * n[1] * a, -n[1]}};
}

// Computes the barycentric coordinates of the point of triangle abc that is closest to p. The
// triangle must not be degenerate.
inline std::array<double, 3> nearest_in_triangle(const Vec3& a, const Vec3& b, const Vec3& c,
                                                 const Vec3& p)
{
  const Vec3 ab = b - a, ac = c - a, normal = cross(ab, ac);
  const double squared_norm = dot(normal, normal);
  const double v = dot(cross(p - a, ac), normal) / squared_norm,
               w = dot(cross(ab, p - a), normal) / squared_norm;
  if(v >= 0. && w >= 0. && v + w <= 1.)
    return {1. - v - w, v, w};
  // Otherwise the closest point is on the boundary.
  const std::array<Vec3, 3> corners = {a, b, c};
  std::array<double, 3> result{};
  double smallest_distance = std::numeric_limits<double>::infinity();
  for(int k = 0; k < 3; ++k)
  {
    const Vec3 edge = corners[(k + 1) % 3] - corners[k];
    const double fraction = std::clamp(dot(p - corners[k], edge) / dot(edge, edge), 0., 1.);
    const double distance = norm(p - corners[k] - fraction * edge);
    if(distance < smallest_distance)
    {
      smallest_distance = distance;
      result = {0., 0., 0.};
      result[k] = 1. - fraction;
      result[(k + 1) % 3] = fraction;
    }
  }
  return result;
}

// Computes the cosine of the smallest angle of a triangle.
inline double largest_cosine(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 u = unit(b - a), v = unit(c - b), w = unit(a - c);
  return std::max({-dot(u, v), -dot(v, w), -dot(w, u)});
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC3_H
