// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_DELAUNAY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_DELAUNAY_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

namespace CGAL::Geodesic_processing::internal {

// Adds to all lengths the smallest constant after which in every triangle two sides together exceed
// the third by `slack` (Sharp and Crane 2020, section 4.5); zero where they do already.
CGAL_GEODESIC_PROCESSING_EXPORT
void mollify(Surface_arrays& triangles, double slack);

// Flips sides of a mesh until all are Delaunay: opposite angles sum to at most pi (up to 1e-12), so
// that no cotangent weight is negative.  Corners, twins and lengths change, the stars are not kept.
// Returns the number of flips.  Sides that have one triangle on both hands stay.
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t flip_to_delaunay(Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_INTRINSIC_DELAUNAY_H
