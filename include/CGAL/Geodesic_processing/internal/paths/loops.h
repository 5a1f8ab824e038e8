// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_LOOPS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_LOOPS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Closed curves on a mesh. Consecutive locations, also the last and the first one, lie in a common
// triangle.
using Loop = std::vector<Surface_location>;

// Returns the loop through canonical locations. If two consecutive ones have no common triangle, a
// path of a Path_finder joins them. Returns no location if they are not connected. Throws
// Invalid_argument_error if there is no location.
CGAL_GEODESIC_PROCESSING_EXPORT
Loop join_loop(const std::shared_ptr<const Surface_arrays>& triangles,
               const std::vector<Surface_location>& locations);

// Replaces each loop by the result of shorten_loop(), whose last location is the first one.
CGAL_GEODESIC_PROCESSING_EXPORT
void shorten_loops(const Surface_arrays& triangles, std::vector<Loop>& loops);
// As shorten_loops(), for loops that are not contractible.
CGAL_GEODESIC_PROCESSING_EXPORT
void shorten_noncontractible_loops(const Surface_arrays& triangles, std::vector<Loop>& loops);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_LOOPS_H
