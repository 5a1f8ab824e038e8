// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_H

#include <array>
#include <cmath>
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

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPATIAL_H
