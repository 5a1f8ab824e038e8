// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ESTIMATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ESTIMATION_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Estimated_surfels
{
  std::vector<Vec3> normals;        // #points
  std::vector<double> radii;        // #points
  std::vector<std::size_t> removed; // outliers: their radius is 0 and their normal (0, 0, 1)
};

// Estimates normals and radii of points, and removes outliers.
//
// number_of_neighbors  at least 6
// outlier_percentage   percentage of the points to remove: those with the largest mean squared
//                      distance to their neighbors
// callback             called with 0 between the steps; an exception that it throws cancels the
//                      computation
//
// Normals are estimated by estimate_normals() and oriented. Radii are those of make_cloud().
//
// Throws Invalid_argument_error if a coordinate is not finite, the number of neighbors is below 6,
// or the percentage is not in [0, 100]. Throws Unsupported_surface_error if the number of
// remaining points does not exceed the number of neighbors. O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Estimated_surfels estimate_surfels(const std::vector<Vec3>& points, unsigned number_of_neighbors,
                                   double outlier_percentage, unsigned number_of_threads = 1,
                                   const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ESTIMATION_H
