// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_MDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_MDS_H

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Computes multidimensional scaling of the distances between base points (Zigelman, Kimmel and
// Kiryati 2002). All other vertices are embedded by their squared distances to the base points
// (landmark MDS, de Silva and Tenenbaum 2004). The front runs twice from each base point: for the
// distances between base points, and to add its contribution to all vertices.
//
// Returns an empty vector if the callback cancelled.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> landmark_mds(const Surface_arrays& triangles, Front front,
                               const std::vector<Index>& base_points,
                               const std::function<bool(double)>& callback = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_MDS_H
