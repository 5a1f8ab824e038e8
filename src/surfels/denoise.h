// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DENOISE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DENOISE_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Clouds with a smaller noise level are not denoised. The noise level of exact samples is not
// zero. It is 0.005 for 1,000 surfels of a torus or an ellipsoid. It is 0.018 for 300 surfels of
// an ellipsoid with the semi-axes 1, 0.5 and 0.3.
constexpr double significant_noise_level = 0.02;

// Estimates the noise level of a cloud: approximately the standard deviation of the positions,
// divided by the spacing. It is the median over the surfels of the median height of their
// neighbors. Heights are measured along the mean of the two normals, so that they are zero on
// planes and spheres.
//
// points   #surfels: finite coordinates
// normals  #surfels: vectors of any positive length
//
// Throws the exceptions of build_surfel_arrays(). O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
double noise_level(const std::vector<Vec3>& points, std::vector<Vec3> normals,
                   unsigned number_of_threads = 1);

// Moves surfels along their normals to an estimate of the surface, and replaces the normals by
// those of the estimate. All normals become unit vectors.
//
// At each surfel, planes and quadrics are fitted to the heights and slopes of the surfels within a
// radius, for radii from 2.8 to 33 spacings. Heights and slopes are weighted by the inverses of
// their variances, which are estimated from the residuals of fits to the 24 nearest surfels. Terms
// above the second order are those of a sphere or cylinder with the curvature of the previous fit.
// The fit with the smallest variance is chosen whose height and slopes at the surfel agree with all
// previous fits (Lepski 1991). So the radius grows until the curvature of the surface changes.
//
// To preserve edges and to reject outliers, a fit ignores surfels with different normals, and
// surfels whose distance to the previous fit exceeds the noise. At large radii, eight surfels are
// replaced by their mean.
//
// Throws the exceptions of build_surfel_arrays(). O(n log n). A surfel takes 30 to 60
// microseconds of one thread; the maximum is reached on spheres, because all radii are used there.
CGAL_GEODESIC_PROCESSING_EXPORT
void denoise(std::vector<Vec3>& points, std::vector<Vec3>& normals, unsigned number_of_threads = 1);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DENOISE_H
