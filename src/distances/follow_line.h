// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FOLLOW_LINE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FOLLOW_LINE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A segment that begins in a triangle, in the layout of this triangle (unfolded()).
struct Line
{
  Index triangle;
  Vec2 from, target;
};

// Follows a segment through the triangles of a mesh to its end, which is known as a location.
// Returns the segment in the layout of its last triangle, or nothing if it misses the location by
// more than 1e-6 of an edge. If the segment passes within 1e-6 of a vertex, both sides of the
// vertex are tried. `crossings` receives the points on the crossed edges, unless it is null.
// O(#crossed triangles).
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<Line> follow_line(const Surface_arrays& triangles, const Line& line,
                                const Surface_location& end,
                                std::vector<Surface_location>* crossings = nullptr);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_FOLLOW_LINE_H
