// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact_predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

Epick::Point_3 to_point(const Vec3& p) { return {p[0], p[1], p[2]}; }

Epick::Triangle_3 to_triangle(const std::array<Vec3, 3>& p)
{
  return {to_point(p[0]), to_point(p[1]), to_point(p[2])};
}

} // namespace

int orientation(const Vec2& p, const Vec2& q, const Vec2& r)
{
  return Epick().orientation_2_object()({p[0], p[1]}, {q[0], q[1]}, {r[0], r[1]});
}

bool is_degenerate(const std::array<Vec3, 3>& triangle)
{
  return collinear(to_point(triangle[0]), to_point(triangle[1]), to_point(triangle[2]));
}

bool triangles_intersect(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q)
{
  return do_intersect(to_triangle(p), to_triangle(q));
}

bool triangle_intersects_segment(const std::array<Vec3, 3>& triangle,
                                 const std::array<Vec3, 2>& segment)
{
  return do_intersect(to_triangle(triangle),
                      Epick::Segment_3(to_point(segment[0]), to_point(segment[1])));
}

bool is_folded_flat(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s)
{
  const Epick::Point_3 a = to_point(p), b = to_point(q), c = to_point(r), d = to_point(s);
  return coplanar(a, b, c, d) && coplanar_orientation(a, b, c, d) == POSITIVE;
}

} // namespace CGAL::Geodesic_processing::internal
