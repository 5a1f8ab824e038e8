// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EXACT_PREDICATES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EXACT_PREDICATES_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>

// Exact predicates of points with double coordinates. They have a source of their own, because
// CGAL's kernel takes seconds to compile.

namespace CGAL::Geodesic_processing::internal {

// Returns 1 if the triangle p, q, r is counterclockwise, -1 if it is clockwise and 0 if the points
// are collinear.
CGAL_GEODESIC_PROCESSING_EXPORT
int orientation(const Vec2& p, const Vec2& q, const Vec2& r);

// Returns true if the points of a triangle lie on one line.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_degenerate(const std::array<Vec3, 3>& triangle);

// Returns true if two closed triangles have a common point. They must not be degenerate.
CGAL_GEODESIC_PROCESSING_EXPORT
bool triangles_intersect(const std::array<Vec3, 3>& p, const std::array<Vec3, 3>& q);

// Returns true if a closed triangle, which must not be degenerate, and a closed segment have a
// common point.
CGAL_GEODESIC_PROCESSING_EXPORT
bool triangle_intersects_segment(const std::array<Vec3, 3>& triangle,
                                 const std::array<Vec3, 2>& segment);

// Returns true if the triangles p, q, r and p, q, s are coplanar and on the same side of p, q. The
// points p, q and r must not be collinear.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_folded_flat(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_EXACT_PREDICATES_H
