// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FEATURE_POLYLINES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FEATURE_POLYLINES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Places on curves that run along sides of a mesh, about a spacing apart: at the corners, where
// curves meet or end or turn by more than 60 degrees, and between them at equal steps.  Of turns
// within half of the spacing the sharpest is a corner.  On a closed curve there are at least three.
// O(n log n).
//
// spacing: #sides, twins alike: along each, in the domain's scale, finite; 0 off the curves
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> sample_feature_polylines(const Surface_arrays& triangles,
                                                       const std::vector<double>& spacing);

// #sides: those at the border, and those at which the surface bends by at least so many degrees.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<bool> boundary_and_sharp_halfedges(const Surface_arrays& triangles,
                                               double angle = 360.);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FEATURE_POLYLINES_H
