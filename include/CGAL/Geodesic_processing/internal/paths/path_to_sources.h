// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_TO_SOURCES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_TO_SOURCES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A path made as short as it gets nearby: pulled taut on a mesh, smoothed on a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> shorten_path(const Surface_arrays& triangles,
                                           const std::vector<Surface_location>& path);

// The shortened path from a location to the nearest source: on a mesh traced down the distances, on
// a cloud along predecessors.  Empty when no source can be reached.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> path_to_sources(const Surface_arrays& triangles,
                                              const Surface_location& from,
                                              const std::vector<Front_source>& sources,
                                              const std::function<double(Index)>& distance,
                                              const std::function<Index(Index)>& predecessor,
                                              const std::function<Index(Index)>& source);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_PATH_TO_SOURCES_H
