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

// Products of vectors as complex numbers: rotated(p, q) rotates p by the angle of the unit vector
// q, rotated_back(p, q) by the opposite angle.
inline Vec2 rotated(const Vec2& p, const Vec2& q)
{
  return {p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0]};
}
inline Vec2 rotated_back(const Vec2& p, const Vec2& q)
{
  return {p[0] * q[0] + p[1] * q[1], p[1] * q[0] - p[0] * q[1]};
}

// Computes the cosine and the sine of the angle between the edges of lengths a and b of a triangle
// whose third edge has the length `opposite`. The angle of a degenerate triangle is 0 or pi.
inline Vec2 angle_between(double a, double b, double opposite)
{
  const double product = 2. * a * b;
  if(product <= 0.)
    return {1., 0.};
  // 1 - cosine, computed from differences: well conditioned also in needles.
  const double versine = std::clamp((opposite - (a - b)) * (opposite + (a - b)) / product, 0., 2.);
  return {1. - versine, std::sqrt(versine * (2. - versine))};
}

// Computes the cosine and the sine of the angle at a corner.
inline Vec2 corner_angle(const Surface_arrays& triangles, Index corner)
{
  return angle_between(triangles.length[corner], triangles.length[previous_halfedge(corner)],
                       triangles.length[next_halfedge(corner)]);
}

// Returns the corner opposite to h if h runs from the origin along the first axis.
inline Vec2 apex(const Surface_arrays& triangles, Index h)
{
  return triangles.length[previous_halfedge(h)] * corner_angle(triangles, h);
}

// Returns the point of the segment from p to q that is closest to x. Sets `is_inside` if it is not
// an end of the segment.
inline Vec2 closest_point_on_segment(const Vec2& x, const Vec2& p, const Vec2& q, bool& is_inside)
{
  const Vec2 segment = q - p;
  const double squared_length = dot(segment, segment);
  const double fraction = squared_length > 0. ? dot(x - p, segment) / squared_length : 0.;
  is_inside = fraction > 0. && fraction < 1.;
  return p + std::clamp(fraction, 0., 1.) * segment;
}

// A straight (planar) wavefront that crosses the base from (0, 0) to (base, 0), with `slope` as the
// derivative of its arrival time along the base, in (-1, 1). Computes its arrival time at a point
// behind the base, relative to the origin.
struct Straight_front
{
  double delay = infinity; // infinity if the ray to the point does not cross the base
  bool is_closer_to_end = false;
  // Whether the ray crosses the base closer to its end than to the origin.

  Straight_front(double base, double slope, const Vec2& point)
  {
    // The slope is the cosine of the angle between the base and the direction of the front.
    const double sine = std::sqrt((1. - slope) * (1. + slope));
    const double intersection = point[0] * sine - point[1] * slope; // times `sine`
    if(intersection < 0. || intersection > base * sine)
      return;
    delay = slope * point[0] + sine * point[1];
    is_closer_to_end = 2. * intersection >= base * sine;
  }
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VEC2_H
