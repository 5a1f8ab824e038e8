// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_OBSTACLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_OBSTACLES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Obstacles are triangles with infinite slowness.

// Returns the slowness outside of the obstacles if it is the same everywhere, up to round-off
// errors; 1 if there are only obstacles.
//
// slowness: #triangles, positive
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<double> uniform_slowness(const std::vector<double>& slowness);

// Returns the slowness if it is exactly the same in all triangles and none is an obstacle. It is 1
// for null and without triangles.
std::optional<double> constant_slowness(const std::vector<double>* slowness);

// Returns a copy of a mesh without its obstacles.
//
// Vertices and triangles keep their indices. The halfedges of an obstacle have length 0 and no
// twins, the halfedges adjacent to it become boundary, and no ring contains its corners. The copy
// has no points.
CGAL_GEODESIC_PROCESSING_EXPORT
std::shared_ptr<const Surface_arrays> without_obstacles(const Surface_arrays& mesh,
                                                        const std::vector<double>& slowness);

// Returns a canonical location of the mesh as a location of the copy: at a vertex or on an edge of
// an obstacle, in a triangle that is no obstacle, if there is one.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location outside_obstacles(const Surface_arrays& mesh, const Surface_arrays& copy,
                                   const Surface_location& location);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_OBSTACLES_H
