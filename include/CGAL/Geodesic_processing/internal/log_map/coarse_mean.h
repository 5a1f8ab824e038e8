// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_COARSE_MEAN_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_COARSE_MEAN_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns a vertex or a location with a small weighted sum of squared distances to the locations,
// on a mesh or a cloud.
//
// At most 16 locations are selected by farthest point sampling. For the eight best local minima
// of the sum, the others are replaced by the nearest of them. The candidates are the vertices and
// the selected locations. The result is the candidate with the smallest sum over all locations.
// Distances are those of a Euclidean front.
//
// weights   #locations: positive
// callback  receives the fraction done; if it returns false, Cancelled is thrown
//
// Throws Invalid_argument_error if not all locations are in one component. Takes at most 24
// fronts, each limited to the distance of the farthest location.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location coarse_mean(const std::shared_ptr<const Surface_arrays>& triangles,
                             const std::vector<Surface_location>& locations,
                             const std::vector<double>& weights,
                             const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_COARSE_MEAN_H
