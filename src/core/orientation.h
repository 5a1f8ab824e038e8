// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_ORIENTATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_ORIENTATION_H

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

namespace CGAL::Geodesic_processing::internal {

// Returns 1 if the triangle p, q, r is counterclockwise, -1 if it is clockwise and 0 if the points are
// collinear.  Exact.  In a source of its own, because CGAL's kernel takes seconds to compile.
CGAL_GEODESIC_PROCESSING_EXPORT
int orientation(const Vec2& p, const Vec2& q, const Vec2& r);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_ORIENTATION_H
