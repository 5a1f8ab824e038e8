// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FEATURE_POLYLINES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FEATURE_POLYLINES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Samples feature polylines, which are sets of edges of a mesh, at distances of about `spacing`.
// Samples are placed at vertices in which not exactly two feature edges meet, at corners, and
// between them at equal steps. A corner is a vertex at which the polyline turns by more than 60
// degrees. Of corners closer than half of the spacing only the sharpest counts. A closed polyline
// gets at least three samples. Samples whose point is also that of the previous one, on the other
// side of a crack of zero width, are moved by a quarter of a step. O(n log n).
//
// spacing: #halfedges, the same for twins: the distance of samples along each feature edge, in
// scaled units, finite; 0 for all other edges
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> sample_feature_polylines(const Surface_arrays& triangles,
                                                       const std::vector<double>& spacing);

// Returns for each halfedge whether it is on the boundary or sharp: the dihedral angle between the
// normals of its triangles is at least `angle` degrees. By default only boundary edges are
// returned.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<bool> boundary_and_sharp_halfedges(const Surface_arrays& triangles,
                                               double angle = 360.);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_FEATURE_POLYLINES_H
