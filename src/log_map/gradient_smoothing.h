// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_GRADIENT_SMOOTHING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_GRADIENT_SMOOTHING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Smooths the squared distance maps of a logarithmic map, through the vectors that Log_map_fit
// computes from them. Each vector is the same linear function of the maps, apart from a constant.
// Smoothing the vectors therefore has the same result as smoothing every map by the same weights.
//
// In a step, each vertex gets the mean of its value and of the weighted mean of its neighbors, with
// mean value weights (Floater 2003). The weights are positive, so that no step amplifies an error.
// They reproduce linear functions of the plane: exact vectors in the plane do not change. In the
// plane, the weighted mean of the squared distances from any source is the squared distance of the
// vertex plus a number that does not depend on the source. It cancels between base point and
// stencil.
//
// A vertex is not smoothed if it is the base point, if it is on the boundary, if a neighbor is
// outside the map, or if the map is discontinuous along one of its edges. On a cloud, a surfel
// without neighbors in a sector of 3 radians is on the boundary.
//
// vertices   the vertices inside the map
// distances  #vertices inside the map: from the base point
// vectors    #vertices inside the map: are changed
//
// O(number of steps times number of edges inside the map).
CGAL_GEODESIC_PROCESSING_EXPORT
void smooth_gradients(const Surface_arrays& triangles, const std::vector<Index>& vertices,
                      const std::vector<double>& distances, std::size_t number_of_steps,
                      std::vector<Vec2>& vectors);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_GRADIENT_SMOOTHING_H
