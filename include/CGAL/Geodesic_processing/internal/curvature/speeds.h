// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_SPEEDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_SPEEDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <memory>
#include <vector>

// What speeds are made of: numbers that do not change when the surface is scaled.

namespace CGAL::Geodesic_processing::internal {

// #sites: the sum of the sizes of the principal curvatures, which curvatures() finds with this radius,
// in units of 1 / sqrt(area of the surface).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> total_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                     double radius, unsigned threads);

// The same of their sum, which is twice the mean curvature: negative where the surface bends towards its
// normals.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> doubled_mean_curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                            double radius, unsigned threads);

// That of a sphere: 4 sqrt(pi).
inline constexpr double sphere_total_curvature = 7.0898154036220641;

// #sites: the mean over the star of the sizes of the gradients in its triangles, in units of the largest
// one; zeros when there is none.  The square of a size is the sum of those of the channels.
// channels: each #sites.  Throws Invalid_argument_error when a value is not finite.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> relative_gradient_norms(const Surface_arrays& triangles,
                                            std::vector<std::vector<double>> channels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_SPEEDS_H
