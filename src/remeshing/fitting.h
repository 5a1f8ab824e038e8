// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FITTING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FITTING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A coarse approximation of a mesh, with one point for each cell of vertices of the fine mesh.
// Points are in the coordinates of the fine mesh.
struct Coarse_mesh
{
  std::vector<Vec3> points;                    // #cells
  std::vector<std::array<Index, 3>> triangles; // cells at the corners
};

// Returns for each cell the vertex that is farthest from the coarse triangles around the point of
// the cell. Cells in which this distance is at most `max_distance` are omitted.
// labels: #vertices, the cell of each; vertices with label none are ignored
// O(n) if points have few incident triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> far_vertices(const Surface_arrays& fine, const std::vector<Index>& labels,
                                const Coarse_mesh& coarse, double max_distance);

// Moves the points that are not fixed to reduce the squared distances of the fine vertices from the
// coarse mesh. Vertices are weighted by their incident area. A point moves by at most
// `max_distance`. The first two steps are unconstrained. In the further `angle_preserving_steps`,
// angles below 42 degrees do not decrease.
// is_fixed: #cells. O(n) for each step.
CGAL_GEODESIC_PROCESSING_EXPORT
void fit(const Surface_arrays& fine, const std::vector<Index>& labels,
         const std::vector<bool>& is_fixed, Coarse_mesh& coarse, double max_distance = infinity,
         int angle_preserving_steps = 0);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FITTING_H
