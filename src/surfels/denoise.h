// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DENOISE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DENOISE_H

#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Below this level surfels are taken as they are.  Exact ones of a torus or an ellipsoid, a thousand,
// rise over each other by 0.5 % of their spacing in the median; 300 of an ellipsoid of axes 1, 0.5 and
// 0.3 by 1.8 %.
constexpr double significant_noise_level = 0.02;

// The median over the surfels of how far a neighbour rises over the mean of the two normals, in
// spacings: about the standard deviation of the positions.  Zero on planes and spheres.
//
// points   #surfels, finite; normals  #surfels, of any positive length
//
// Throws as build_surfel_arrays().
CGAL_GEODESIC_PROCESSING_EXPORT
double noise_level(const std::vector<Vec3>& points, std::vector<Vec3> normals,
                   unsigned threads = 1);

// Moves surfels along their normals to the surface that they suggest, and turns them.
//
// At each surfel planes and surfaces of second order are fitted to the heights and the slopes of
// the surfels within a radius, weighted by the variances of both, which are those that fits to the
// 24 nearest leave; at radii from 2.8 to 33 spacings.  Beyond the second order a surface is taken to
// go on as a sphere or a cylinder that bends as the fit of the radius before does.  Of all these the
// one with the least variance is taken whose height and slopes at the surfel agree with those of
// larger variance (Lepski 1991): so a radius grows until the surface bends in another way.  What is
// farther from the fit of the radius before than noise can be does not count, nor do surfels whose
// normals do not agree: edges stay.  Far from the surfel eight others count as one.
//
// Throws as build_surfel_arrays().  O(n log n); 30 to 60 microseconds per surfel and thread: most on spheres,
// where all radii count.
CGAL_GEODESIC_PROCESSING_EXPORT
void denoise(std::vector<Vec3>& points, std::vector<Vec3>& normals, unsigned threads = 1);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_DENOISE_H
