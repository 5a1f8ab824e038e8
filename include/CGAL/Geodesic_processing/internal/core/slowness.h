// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SLOWNESS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SLOWNESS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Computes 1 / speed. A speed of zero, which is an obstacle, yields infinity. Throws
// Invalid_argument_error if a speed is negative or not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> slowness_of(std::vector<double> speed);

// Computes for each triangle the mean of the slowness of its three vertices.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> mean_over_corners(const Surface_arrays& triangles,
                                      const std::vector<double>& vertex_slowness);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_SLOWNESS_H
