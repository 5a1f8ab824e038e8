// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PLANAR_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PLANAR_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

constexpr double pi = 3.14159265358979323846;

// Points and vectors in the plane of an unfolded triangle.
using Planar = std::array<double, 2>;

inline Planar operator+(const Planar& p, const Planar& q) { return {p[0] + q[0], p[1] + q[1]}; }
inline Planar operator-(const Planar& p, const Planar& q) { return {p[0] - q[0], p[1] - q[1]}; }
inline Planar operator*(double factor, const Planar& p) { return {factor * p[0], factor * p[1]}; }
inline double dot(const Planar& p, const Planar& q) { return p[0] * q[0] + p[1] * q[1]; }
inline double cross(const Planar& p, const Planar& q) { return p[0] * q[1] - p[1] * q[0]; }
inline double norm(const Planar& p) { return std::sqrt(dot(p, p)); }

// Products of vectors as complex numbers: turned(p, q) turns p by the angle of the unit vector q,
// turned_back(p, q) by the opposite angle.
inline Planar turned(const Planar& p, const Planar& q)
{
  return {p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0]};
}
inline Planar turned_back(const Planar& p, const Planar& q)
{
  return {p[0] * q[0] + p[1] * q[1], p[1] * q[0] - p[0] * q[1]};
}

// The unit vector at the angle between two sides of a triangle, seen from either.  A triangle without
// area gets 0 or pi.
inline Planar angle_between(double a, double b, double opposite)
{
  const double product = 2. * a * b;
  if(product <= 0.)
    return {1., 0.};
  // 1 - cosine, from differences: well conditioned also at needles.
  const double versine = std::clamp((opposite - (a - b)) * (opposite + (a - b)) / product, 0., 2.);
  return {1. - versine, std::sqrt(versine * (2. - versine))};
}

// The same at a corner, seen from the side that leaves it.
inline Planar corner_angle(const Glued_triangles& triangles, Index corner)
{
  return angle_between(triangles.length[corner], triangles.length[previous_side(corner)],
                       triangles.length[next_side(corner)]);
}

// Where the third corner lies when side `side` runs from the origin along the first axis.
inline Planar apex(const Glued_triangles& triangles, Index side)
{
  return triangles.length[previous_side(side)] * corner_angle(triangles, side);
}

// The point of the segment from p to q that is nearest to x, and whether it lies between its ends.
inline Planar foot(const Planar& x, const Planar& p, const Planar& q, bool& inside)
{
  const Planar segment = q - p;
  const double square = dot(segment, segment);
  const double share = square > 0. ? dot(x - p, segment) / square : 0.;
  inside = share > 0. && share < 1.;
  return p + std::clamp(share, 0., 1.) * segment;
}

// A straight front that passes a base, which runs from the origin along the first axis, and rises along it
// by this part of its length, in (-1, 1): how much later than to the origin it comes to a place behind.
struct Straight_front
{
  double gain = infinity; // where it does not come through the base
  bool is_nearer_to_end = false;

  Straight_front(double base, double rise, const Planar& place)
  {
    // The rise is the cosine between the base and the front's way.
    const double across = std::sqrt((1. - rise) * (1. + rise));
    const double crossing = place[0] * across - place[1] * rise; // times `across`
    if(crossing < 0. || crossing > base * across)
      return;
    gain = rise * place[0] + across * place[1];
    is_nearer_to_end = 2. * crossing >= base * across;
  }
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PLANAR_H
