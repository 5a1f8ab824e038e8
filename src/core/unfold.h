// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_UNFOLD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_UNFOLD_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <array>
#include <cmath>

// Unfolds triangles into the plane, from their edge lengths only. Lengths that violate the
// triangle inequality yield a flat triangle.

namespace CGAL::Geodesic_processing::internal {

inline Vec2 rotated_left(const Vec2& p) { return {-p[1], p[0]}; }
inline Vec2 rotated_right(const Vec2& p) { return {p[1], -p[0]}; }

// Computes twice the area of a triangle from its edge lengths; zero if they violate the triangle
// inequality. The order of operations is that of Kahan: Heron's formula loses half of the digits
// for needles.
inline double twice_area(double a, double b, double c)
{
  // Sorts by minima and maxima, because branches would be mispredicted.
  const double smaller = std::min(a, b), larger = std::max(a, b);
  a = std::max(larger, c);
  b = std::max(smaller, std::min(larger, c));
  c = std::min(smaller, c);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return product > 0. ? 0.5 * std::sqrt(product) : 0.;
}

// Returns the third corner of a triangle with the base from (0, 0) to (base, 0), at the distances
// `left` and `right` from the first and the second end of the base.
inline Vec2 third_corner(double base, double left, double right)
{
  if(base <= 0.)
    return {0., left};
  return {0.5 * (base + (left - right) * ((left + right) / base)),
          twice_area(base, left, right) / base};
}

// Returns the corners of a triangle: the first at the origin, the second on the first axis.
inline std::array<Vec2, 3> unfolded(const Surface_arrays& t, Index triangle)
{
  const double* l = &t.length[3 * std::size_t(triangle)];
  return {Vec2{0., 0.}, Vec2{l[0], 0.}, third_corner(l[0], l[2], l[1])};
}

inline Vec2 unfolded_point(const std::array<Vec2, 3>& corners, const std::array<double, 3>& b)
{
  return b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2];
}

// Computes the distance between two points of a triangle given by barycentric coordinates.
inline double distance_in_triangle(const Surface_arrays& t, Index triangle,
                                   const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  const auto corners = unfolded(t, triangle);
  return norm((p[1] - q[1]) * corners[1] + (p[2] - q[2]) * corners[2]);
}

// Computes the angle at a corner, in [0, pi]. An edge of length zero is treated as the limit of
// short edges of isosceles triangles: the angles at its two ends are pi/2.
inline double interior_angle(const Surface_arrays& t, Index corner)
{
  const double right = t.length[corner], left = t.length[previous_halfedge(corner)];
  const double opposite = t.length[next_halfedge(corner)];
  const double sine = 2. * twice_area(right, left, opposite);
  const double cosine = right * right + (left - opposite) * (left + opposite);
  return sine == 0. && cosine == 0. ? 1.57079632679489661923 : std::atan2(sine, cosine);
}

// Returns the cosine and the sine of the angle at a corner, as interior_angle() treats edges of length
// zero. The cosine has a small absolute error, and the sine a small relative error, also in needles.
inline Vec2 cosine_and_sine(const Surface_arrays& t, Index corner)
{
  const double right = t.length[corner], left = t.length[previous_halfedge(corner)],
               opposite = t.length[next_halfedge(corner)], product = right * left;
  if(product <= 0.)
    return left + right == opposite ? Vec2{0., 1.} : Vec2{1., 0.};
  const double smaller = std::min(right, left), larger = std::max(right, left);
  // The difference of the two longest edges is exact.
  const double versine = (std::min(opposite, smaller) + (std::max(opposite, smaller) - larger)) *
                         (opposite + (larger - smaller)) / (2. * product);
  return {1. - std::clamp(versine, 0., 2.), twice_area(right, left, opposite) / product};
}

// Returns the next corner of the same vertex in counterclockwise or clockwise order, or none at the
// boundary.
inline Index next_corner_ccw(const Surface_arrays& t, Index corner)
{
  return t.twin[previous_halfedge(corner)];
}
inline Index next_corner_cw(const Surface_arrays& t, Index corner)
{
  const Index twin = t.twin[corner];
  return twin == none ? none : next_halfedge(twin);
}

// Returns the barycentric coordinates of a corner, and of the point of a halfedge at a fraction of
// its length.
inline std::array<double, 3> barycentric_at_corner(Index corner)
{
  std::array<double, 3> b = {0., 0., 0.};
  b[corner % 3] = 1.;
  return b;
}
inline std::array<double, 3> barycentric_on_halfedge(Index h, double fraction)
{
  std::array<double, 3> b = {0., 0., 0.};
  b[h % 3] = 1. - fraction;
  b[next_halfedge(h) % 3] = fraction;
  return b;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_UNFOLD_H
