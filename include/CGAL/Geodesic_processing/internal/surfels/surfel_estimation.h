// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ESTIMATION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ESTIMATION_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

struct Estimated_surfels
{
  std::vector<Vec3> normals;        // #points
  std::vector<double> radii;        // #points
  std::vector<std::size_t> removed; // outliers, which have no radius
};

// Normals of the nearest quadrics of so many neighbours, oriented along a minimum spanning tree, and radii as
// make_cloud() sets them; without the given percentage of points, those farthest from their
// neighbours in the mean of squares.
//
// Throws Invalid_argument_error when a coordinate is not finite or a number makes no sense, and
// Unsupported_surface_error when there are fewer points than neighbours.  O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Estimated_surfels estimate_surfels(const std::vector<Vec3>& points, unsigned number_of_neighbors,
                                   double outlier_percentage, unsigned threads = 1);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_SURFEL_ESTIMATION_H
