// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_CURVATURE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_CURVATURE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The curvature tensor of a site by its eigenvalues, in the domain's scale, and its eigenvectors:
// positive where the surface is convex seen from where the normals point.
struct Curvature
{
  double min_curvature = 0., max_curvature = 0.;
  Vec3 min_direction = {0., 0., 0.}, max_direction = {0., 0., 0.}; // unit vectors, or zero
};

// #sites: on a mesh the mean over a geodesic ball of the normal cycles of its edges (Cohen-Steiner
// and Morvan 2003); on a cloud that of the surface of second order fitted to the ball's surfels
// (Cazals and Pouget 2005).  The ball has this radius, or one of three mean lengths around each site
// when it is 0; on a cloud it grows until it has surfels enough.  Zeros where there is no surface.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Curvature> curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                  double radius, unsigned threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_CURVATURE_H
