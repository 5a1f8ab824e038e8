// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_CENTROIDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_CENTROIDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the mass of each triangle (#triangles): twice its area times the density s^4 for slowness
// s. With this density, the sizes of the cells are proportional to 1 / s, as if lengths were travel
// times (Gersho 1979). Obstacles and triangles without area have mass zero. O(n).
// slowness: as in Front_limits, or null
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> triangle_masses(const Surface_arrays& triangles,
                                    const std::vector<double>* slowness = nullptr);

// A step towards the centroid of each cell.
struct Centroid_step
{
  double factor = 1.;                          // fraction of the distance; 1 reaches the centroid
  const std::vector<Vec3>* momentum = nullptr; // #cells: added to the step, in the arrays' scale
};

// Returns the point of each cell that is closest to its centroid (Lloyd 1982), or to the end of
// `step`; the sample of the cell if the cell has no area. A triangle with vertices of several cells
// is split along the bisectors of their samples in space. Results are canonical locations. O(n).
//
// masses: #triangles, see triangle_masses(); labels: #vertices, the cell of each, or none;
// samples: #cells; slowness: as in Front_limits, or null; no sample moves onto an obstacle
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location>
centroids(const Surface_arrays& triangles, const std::vector<double>& masses,
          const std::vector<Index>& labels, const std::vector<Surface_location>& samples,
          const std::vector<double>* slowness = nullptr, const Centroid_step& step = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_CENTROIDS_H
