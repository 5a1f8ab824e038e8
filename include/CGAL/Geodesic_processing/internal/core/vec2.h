// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC2_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC2_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

constexpr double pi = 3.14159265358979323846;

// Points and vectors in the plane of an unfolded triangle.
using Vec2 = std::array<double, 2>;

inline Vec2 operator+(const Vec2& p, const Vec2& q) { return {p[0] + q[0], p[1] + q[1]}; }
inline Vec2 operator-(const Vec2& p, const Vec2& q) { return {p[0] - q[0], p[1] - q[1]}; }
inline Vec2 operator*(double factor, const Vec2& p) { return {factor * p[0], factor * p[1]}; }
inline double dot(const Vec2& p, const Vec2& q) { return p[0] * q[0] + p[1] * q[1]; }
inline double cross(const Vec2& p, const Vec2& q) { return p[0] * q[1] - p[1] * q[0]; }
inline double norm(const Vec2& p) { return std::sqrt(dot(p, p)); }

// Products of vectors as complex numbers: turned(p, q) turns p by the angle of the unit vector q,
// rotated_back(p, q) by the opposite angle.
inline Vec2 rotated(const Vec2& p, const Vec2& q)
{
  return {p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0]};
}
inline Vec2 rotated_back(const Vec2& p, const Vec2& q)
{
  return {p[0] * q[0] + p[1] * q[1], p[1] * q[0] - p[0] * q[1]};
}

// The unit vector at the angle between two sides of a triangle, seen from either.  A triangle without
// area gets 0 or pi.
inline Vec2 angle_between(double a, double b, double opposite)
{
  const double product = 2. * a * b;
  if(product <= 0.)
    return {1., 0.};
  // 1 - cosine, from differences: well conditioned also at needles.
  const double versine = std::clamp((opposite - (a - b)) * (opposite + (a - b)) / product, 0., 2.);
  return {1. - versine, std::sqrt(versine * (2. - versine))};
}

// The same at a corner, seen from the side that leaves it.
inline Vec2 corner_angle(const Surface_arrays& triangles, Index corner)
{
  return angle_between(triangles.length[corner], triangles.length[previous_halfedge(corner)],
                       triangles.length[next_halfedge(corner)]);
}

// Where the third corner lies when side `side` runs from the origin along the first axis.
inline Vec2 apex(const Surface_arrays& triangles, Index h)
{
  return triangles.length[previous_halfedge(h)] * corner_angle(triangles, h);
}

// The point of the segment from p to q that is nearest to x, and whether it lies between its ends.
inline Vec2 closest_point_on_segment(const Vec2& x, const Vec2& p, const Vec2& q, bool& is_inside)
{
  const Vec2 segment = q - p;
  const double squared_length = dot(segment, segment);
  const double fraction = squared_length > 0. ? dot(x - p, segment) / squared_length : 0.;
  is_inside = fraction > 0. && fraction < 1.;
  return p + std::clamp(fraction, 0., 1.) * segment;
}

// A straight front that passes a base, which runs from the origin along the first axis, and rises along it
// by this part of its length, in (-1, 1): how much later than to the origin it comes to a place behind.
struct Straight_front
{
  double delay = infinity; // where it does not come through the base
  bool is_closer_to_end = false;

  Straight_front(double base, double slope, const Vec2& point)
  {
    // The rise is the cosine between the base and the front's way.
    const double sine = std::sqrt((1. - slope) * (1. + slope));
    const double intersection = point[0] * sine - point[1] * slope; // times `across`
    if(intersection < 0. || intersection > base * sine)
      return;
    delay = slope * point[0] + sine * point[1];
    is_closer_to_end = 2. * intersection >= base * sine;
  }
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC2_H
