// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_ON_CLOUD_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_ON_CLOUD_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Smooths a path on a cloud over the local triangles; the ends stay.  The result is not longer than
// the path: where it would be (arcs are chords, which cut curved surfaces short), the path itself
// is returned.
//
// path  consecutive locations are joined by an arc or lie in a common triangle
//
// Of the overlapping triangles within six rings of the path a surface is chosen, the heaviest
// first, in which no side is used twice; on it the shortest way along sides and hops is pulled
// taut, as on a mesh, and again around the new path until it stays where it is.  The cost is that
// of a few thousand triangles for each hundred sites on the path.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> shorten_on_cloud(const Surface_arrays& cloud,
                                               const std::vector<Surface_location>& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_ON_CLOUD_H
