// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FEATURE_SAMPLING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FEATURE_SAMPLING_H

#include "remeshing/Refined_surface.h"

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns an upper bound of the number of samples that the user's spacing (3 #triangles of the
// coarse mesh, or empty) requires along features. Interior feature edges count twice, once for each
// halfedge. Throws `Invalid_argument_error` if the result exceeds `max_number_of_vertices`. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_requested_on_features(const Refined_surface& surface,
                                         const std::vector<double>& requested_spacing);

// Returns the distance between adjacent samples along each halfedge: 3 #triangles of the refined
// mesh, in its scale. It is zero for halfedges that are no features. Otherwise it is the requested
// spacing. If this is empty or zero, it is `default_spacing` divided by the smaller slowness of the
// two incident triangles. Both parameters are in the scale of the coarse mesh. O(n).
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<double> feature_spacing(const Refined_surface& surface, double default_spacing,
                                    const std::vector<double>& requested_spacing);

// A mesh with more vertices may have more than 2^31 halfedges: six per vertex.
inline constexpr std::size_t max_number_of_vertices = (std::size_t(1) << 31) / 6;

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_FEATURE_SAMPLING_H
