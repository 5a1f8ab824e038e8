// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_TO_SOURCES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_TO_SOURCES_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>

#include <functional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A path made as short as it gets nearby: pulled taut on a mesh, smoothed on a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Location> shortened(const Glued_triangles& triangles,
                                const std::vector<Location>& path);

// The shortened path from a location to the nearest source: on a mesh traced down the distances, on
// a cloud along predecessors.  Empty when no source can be reached.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Location> path_to_sources(const Glued_triangles& triangles, const Location& from,
                                      const std::vector<Source>& sources,
                                      const std::function<double(Index)>& distance,
                                      const std::function<Index(Index)>& predecessor,
                                      const std::function<Index(Index)>& source);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATH_TO_SOURCES_H
