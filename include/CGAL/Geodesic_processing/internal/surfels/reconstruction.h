// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_RECONSTRUCTION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_RECONSTRUCTION_H

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

namespace CGAL::Geodesic_processing::internal {

// A surface through the surfels of a clean cloud, whose vertices are the cloud's sites: CGAL's advancing
// front (Cohen-Steiner and Da 2004) among the Delaunay triangles whose sides join neighbours. Oriented
// as the normals are, in each component. Sites that no triangle takes are isolated; copies are.
// Throws Unsupported_surface_error when the cloud is not clean: noise makes a surface of many parts.
// O(n log n), and O(n) for each part.
CGAL_GEODESIC_PROCESSING_EXPORT
Mesh_arrays reconstruct_surface(const Surfel_arrays& surfels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SURFELS_RECONSTRUCTION_H
