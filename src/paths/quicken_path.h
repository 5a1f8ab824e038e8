// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_QUICKEN_PATH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_QUICKEN_PATH_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the sum of length times slowness along a path on a mesh. A segment on an edge has the
// smaller slowness of the adjacent triangles. Consecutive locations must be canonical and in a
// common triangle.
//
// slowness  #triangles
CGAL_GEODESIC_PROCESSING_EXPORT
double travel_time(const Surface_arrays& triangles, const std::vector<double>& slowness,
                   const std::vector<Surface_location>& path);

// Reduces the travel time of a path on a mesh whose slowness differs. The endpoints remain.
//
// path  canonical locations; consecutive ones are distinct and in a common triangle
//
// The result is not slower than the path. Its locations are on edges or at vertices, and no
// obstacle is crossed if a path in the neighborhood avoids it.
//
// Algorithm: Each edge of the triangles that share a vertex with a triangle of the path gets
// points at equal distances (Lanthier, Maheshwari and Sack 1997). Dijkstra's algorithm on these
// points and the vertices yields a path, which replaces the path if it is faster. This is repeated
// until no time is saved. Then the points move along their edges, by dynamic programming over a few
// positions of each, with steps that become smaller.
//
// Complexity: O(m log m) time for each repetition if m triangles are near the path.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> quicken_path(const Surface_arrays& triangles,
                                           const std::vector<double>& slowness,
                                           std::vector<Surface_location> path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_QUICKEN_PATH_H
