// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_OUTLINE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_OUTLINE_H

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A closed polygon in the plane: side i runs from corner i to corner i+1, the last one to the first.
using Outline = std::vector<Vec2>;

// Whether three points turn left, computed exactly.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_left_turn(const Vec2& p, const Vec2& q, const Vec2& r);

// Two sides of an outline that meet elsewhere than neighbours do in the corner between them, or nothing when
// there are none: then the outline is a simple polygon.  Exact.  A sweep: O(n log n) and the pairs of sides that
// share an abscissa.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<std::pair<std::size_t, std::size_t>> find_self_intersection(const Outline& outline);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_OUTLINE_H
