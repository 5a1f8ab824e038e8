// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_TO_SOURCES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_TO_SOURCES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Shortens a path locally: by shorten_geodesic() on a mesh, by shorten_on_cloud() on a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> shorten_path(const Surface_arrays& triangles,
                                           const std::vector<Surface_location>& path);

// Computes the path from a location to the closest source of a distance field. On a mesh, the path
// is traced by Descent; on a cloud, it follows the predecessors. It is then shortened; if the
// slowness differs, quicken_path() reduces its travel time on a mesh instead. Returns an empty path
// if no source can be reached.
//
// sources      those of the field
// distance     returns the distance of a vertex; infinite if it is not reached
// predecessor  returns the previous vertex on the path from the source, or `none` (clouds only)
// source       returns the index of the source of a vertex (clouds only)
// slowness     #triangles, or null if it is the same everywhere
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> path_to_sources(const Surface_arrays& triangles,
                                              const Surface_location& from,
                                              const std::vector<Front_source>& sources,
                                              const std::function<double(Index)>& distance,
                                              const std::function<Index(Index)>& predecessor,
                                              const std::function<Index(Index)>& source,
                                              const std::vector<double>* slowness = nullptr);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_TO_SOURCES_H
