// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_NORMALS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_NORMALS_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Estimates unit normals (#points): the normals of quadrics that are fitted to each point and its
// `number_of_neighbors` nearest points. Coincident points have the same normal. The normal is (0,
// 0, 1) if there are at most two distinct points, or if no quadric can be fitted.
//
// If `is_oriented`, the orientation is propagated along a minimum spanning tree of the neighbor
// graph (Hoppe and others 1992). The cost of an edge is 1 - |cosine| of its normals. In each
// component, the point with the largest z coordinate has a normal with nonnegative z.
//
// The calling thread calls `callback` with 0 from time to time. An exception that it throws cancels
// the computation.
//
// Throws Invalid_argument_error if a coordinate is not finite or the extent overflows. O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec3> estimate_normals(const std::vector<Vec3>& points, unsigned number_of_neighbors,
                                   bool is_oriented, unsigned number_of_threads = 1,
                                   const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_NORMALS_H
