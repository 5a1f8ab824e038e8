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

// A closed polygon in the plane. Edge i runs from corner i to corner i+1, the last edge to the
// first corner.
using Outline = std::vector<Vec2>;

// Returns whether three points make a left turn, computed exactly.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_left_turn(const Vec2& p, const Vec2& q, const Vec2& r);

// Returns two edges of an outline that intersect, not counting the common corner of consecutive
// edges. If there are none, the outline is a simple polygon. Exact. A sweep along the x-axis:
// O(n log n) plus the number of pairs of edges with overlapping x-ranges.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<std::pair<std::size_t, std::size_t>> find_self_intersection(const Outline& outline);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_OUTLINE_H
