// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_RECONSTRUCTION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_RECONSTRUCTION_H

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

namespace CGAL::Geodesic_processing::internal {

// Computes a mesh that interpolates the surfels of a clean cloud, by CGAL's advancing front
// (Cohen-Steiner and Da 2004). Its vertices are the vertices of the cloud.
//
// Only Delaunay triangles whose circumradius is at most `max_circumradius_ratio` times the smallest
// radius of their corners, and whose normal is compatible with the surfels, are used. Small gaps
// are closed afterwards. Each component is oriented by the majority of the normals. Copies of
// surfels, and surfels without a triangle, become isolated vertices.
//
// Throws Unsupported_surface_error if the cloud is noisy, so that the surface would have too many
// components. O(n log n + n c) for c components.
CGAL_GEODESIC_PROCESSING_EXPORT
Mesh_arrays reconstruct_surface(const Surfel_arrays& surfels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_RECONSTRUCTION_H
