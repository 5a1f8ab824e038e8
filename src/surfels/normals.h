// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_NORMALS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_NORMALS_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Unit normals of the nearest quadrics of points and so many neighbours.  Equal points have one normal;
// where only two are different, or none can be told from its neighbours, it is (0, 0, 1).
//
// Oriented ones look to one side along minimum spanning trees of all neighbours, in which those are
// near whose normals differ little (Hoppe and others 1992); in each part the highest point looks up.
//
// Throws Invalid_argument_error when a coordinate is not finite or the extent overflows.  O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec3> estimate_normals(const std::vector<Vec3>& points, unsigned number_of_neighbors,
                                   bool is_oriented, unsigned threads = 1);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_NORMALS_H
