// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_SPEEDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_SPEEDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <memory>
#include <vector>

// Scale-invariant values of vertices from which speed functions are computed.

namespace CGAL::Geodesic_processing::internal {

// Returns |min_curvature| + |max_curvature| of each vertex (#vertices), as curvatures() computes
// them with this radius, times the square root of the surface's area.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> total_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                     double radius, unsigned number_of_threads);

// Returns min_curvature + max_curvature of each vertex, which is twice the mean curvature, times
// the square root of the surface's area. Negative if the surface bends towards its normals.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> doubled_mean_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                            double radius, unsigned number_of_threads);

// The total curvature of a sphere: 4 sqrt(pi).
inline constexpr double sphere_total_curvature = 7.0898154036220641;

// Returns for each vertex (#vertices) the area-weighted mean of the gradient norms of its
// triangles, divided by the largest of these means; 0 if all are 0. The squared norm of a triangle
// is the sum over the channels. channels: #vertices values each. Throws Invalid_argument_error if
// a value is not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> relative_gradient_norms(const Surface_arrays& triangles,
                                            std::vector<std::vector<double>> channels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_SPEEDS_H
