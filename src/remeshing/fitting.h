// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FITTING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FITTING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A coarse mesh over a fine one: a point for each cell of sites, in the coordinates of the sites.
struct Coarse_mesh
{
  std::vector<Vec3> points;                    // #cells
  std::vector<std::array<Index, 3>> triangles; // of cells
};

// Of each cell the site that is farther than `most` from the triangles around the cell's point, and
// farthest of these.
// labels: #sites, the cell of each, or none where it does not matter.  O(n) where cells have few
// triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> far_vertices(const Surface_arrays& fine, const std::vector<Index>& labels,
                                const Coarse_mesh& coarse, double max_distance);

// Moves points that are not fixed, by at most so much, such that sites are near to the triangles, in
// the sense of least squares: a site counts by the area around it.  Two steps, and more in which angles of less than
// 42 degrees get no smaller.
CGAL_GEODESIC_PROCESSING_EXPORT
void fit(const Surface_arrays& fine, const std::vector<Index>& labels,
         const std::vector<bool>& is_fixed, Coarse_mesh& coarse, double max_distance = infinity,
         int angle_preserving_steps = 0);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FITTING_H
