// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_CURVATURE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_CURVATURE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The principal curvatures of a vertex, in the unit of the arrays, and the principal directions.
// Curvature is positive if the surface is convex: if it bends away from the normal, as a sphere
// with outward normals.
struct Curvature
{
  double min_curvature = 0., max_curvature = 0.;
  Vec3 min_direction = {0., 0., 0.}, max_direction = {0., 0., 0.}; // unit vectors, or 0
};

// Returns the curvature of each vertex (#vertices). On a mesh: the mean curvature tensor over a
// geodesic ball, from the normal cycles of its edges (Cohen-Steiner and Morvan 2003). On a cloud:
// that of a quadric fitted to the surfels of the ball (Cazals and Pouget 2005).
//
// radius: of the balls; if 0, three times the mean edge length at each vertex. On a cloud the
// radius is multiplied by 1.5, at most four times, until the ball has 12 surfels. The curvature is
// 0 at isolated vertices, and if the ball has too few surfels. Takes O(#vertices k log k) time for
// k vertices per ball. The results do not depend on the number of threads.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Curvature> curvatures(const std::shared_ptr<const Surface_arrays>& triangles,
                                  double radius, unsigned number_of_threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CURVATURE_CURVATURE_H
