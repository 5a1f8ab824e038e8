// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_ON_CLOUD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_ON_CLOUD_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Shortens a path on a surfel cloud on its local triangles. The endpoints are fixed. The result
// is not longer than the path. If no shorter path is found, the path itself is returned. This can
// happen because edges of the proximity graph are chords of the curved surface.
//
// path  consecutive locations are joined by a graph edge or lie in a common triangle
//
// Algorithm: A manifold patch is selected greedily, by decreasing weight, from the overlapping
// triangles in the 6-ring of the path. On this mesh, a path is computed by Path_finder and
// shortened by shorten_geodesic(). This is repeated around the new path until it converges, at
// most eight times.
//
// Complexity: a few thousand triangles are processed per hundred vertices of the path.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> shorten_on_cloud(const Surface_arrays& cloud,
                                               const std::vector<Surface_location>& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_ON_CLOUD_H
