// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_INDEX_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_INDEX_H

#include <cstdint>
#include <limits>

namespace CGAL::Geodesic_processing::internal {

// The index of a vertex, surfel, triangle, corner or halfedge.
using Index = std::uint32_t;

inline constexpr Index none = static_cast<Index>(-1);
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Triangle f has the corners 3f, 3f+1, 3f+2 and the halfedges of the same indices. The halfedge
// 3f+k runs from corner 3f+k to the next corner of the triangle.
constexpr Index next_halfedge(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr Index previous_halfedge(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_INDEX_H
