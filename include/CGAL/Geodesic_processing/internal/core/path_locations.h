// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_LOCATIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_LOCATIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <optional>
#include <vector>

// The locations of a path on a mesh.  Those that are "clean" are in a triangle unless their site
// has none, and their coordinates are zero or above 1e-14: then zeros tell on what they lie.

namespace CGAL::Geodesic_processing::internal {

CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location canonical(const Surface_arrays& triangles, const Surface_location& location);

// The same for a location of a user's.
// Throws Invalid_argument_error when coordinates are not finite, clearly negative, or do not sum to
// one; what rounding can do, 1e-6, is mended.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location checked(const Surface_arrays& triangles, const Surface_location& location);

// Where a location lies, in the domain's coordinates.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> scaled_coordinates(const Surface_arrays& triangles,
                                         const Surface_location& location);

// Where a location lies, in the caller's coordinates.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> coordinates(const Surface_arrays& triangles,
                                  const Surface_location& location);

// The site as a clean location.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location vertex_location(const Surface_arrays& triangles, Index vertex);

// The corner, the site at which, or the side inside which a clean location lies, or none.
CGAL_GEODESIC_PROCESSING_EXPORT
Index corner_of(const Surface_location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
Index vertex_of(const Surface_arrays& triangles, const Surface_location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
Index halfedge_of(const Surface_location& location);

// The coordinates of a clean location in a triangle, if that one holds it.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<std::array<double, 3>> barycentric_in(const Surface_arrays& triangles, Index triangle,
                                                    const Surface_location& location);

// The triangles that hold a clean location: all around a site, one or two at a side, else one.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> triangles_at(const Surface_arrays& triangles, const Surface_location& location);

// One of them; none at a site that is in no triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
Index triangle_at(const Surface_arrays& triangles, const Surface_location& location);

// A triangle that holds both clean locations, or none.
CGAL_GEODESIC_PROCESSING_EXPORT
Index common_triangle(const Surface_arrays& triangles, const Surface_location& p,
                      const Surface_location& q);

// Whether two clean locations are the same point of the surface.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_same_point(const Surface_arrays& triangles, const Surface_location& p,
                   const Surface_location& q);

// The length of the polyline through locations, in space.
CGAL_GEODESIC_PROCESSING_EXPORT
double polyline_length(const Surface_arrays& triangles, const std::vector<Surface_location>& path);

// The length of a path whose consecutive locations lie in a common triangle.
// Throws Invalid_argument_error when two do not.
CGAL_GEODESIC_PROCESSING_EXPORT
double path_length(const Surface_arrays& triangles, const std::vector<Surface_location>& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_LOCATIONS_H
