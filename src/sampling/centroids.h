// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_CENTROIDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_CENTROIDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// #triangles: what each weighs.  With times in place of lengths cells are to be smaller in proportion to the
// slowness s, and there are as many as a density of s^4 makes of them (Gersho 1979); obstacles weigh
// nothing.  slowness: as in Front_limits, or null.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> triangle_masses(const Surface_arrays& triangles,
                                    const std::vector<double>* slowness = nullptr);

// The place of each cell that is nearest to its centre of mass (Lloyd 1982), or its sample where the
// cell has no area.  A triangle of several cells is divided where their samples are equally far in
// space.  O(n).
//
// masses: of the triangles, as above; labels: #sites, the cell of each or none; samples: #cells;
// slowness: as in Front_limits, or null; way: how far to go to the centre of mass, 1 to go there;
// onward: #cells or none, added to that, in the triangles' scale
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location>
centroids(const Surface_arrays& triangles, const std::vector<double>& masses,
          const std::vector<Index>& labels, const std::vector<Surface_location>& samples,
          const std::vector<double>* slowness = nullptr, double step_factor = 1.,
          const std::vector<Vec3>& momentum = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SAMPLING_CENTROIDS_H
