// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_LOCATIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_LOCATIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

// Locations of paths on a mesh. A location is canonical if it is in a triangle, unless its vertex
// has no triangle, and if each coordinate is zero or above 1e-14. Zero coordinates then tell
// whether it is at a vertex, on an edge or inside a triangle.

namespace CGAL::Geodesic_processing::internal {

// Returns the canonical form of a location: sets coordinates of at most 1e-14 to zero and rescales
// the others.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location canonical(const Surface_arrays& triangles, const Surface_location& location);

// Checks a location given by a user and returns its canonical form. Coordinates may be off by
// round-off errors of up to 1e-6. Throws Invalid_argument_error if a coordinate is below -1e-6 or
// not a number, or if the sum of the coordinates is not one.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location checked(const Surface_arrays& triangles, const Surface_location& location);

// Returns the position of a location in scaled coordinates.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> scaled_coordinates(const Surface_arrays& triangles,
                                         const Surface_location& location);

// Returns the position of a location in the coordinates of the caller.
CGAL_GEODESIC_PROCESSING_EXPORT
std::array<double, 3> coordinates(const Surface_arrays& triangles,
                                  const Surface_location& location);

// Returns the canonical location of a vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location vertex_location(const Surface_arrays& triangles, Index vertex);

// Returns the corner or vertex at which a canonical location is, or the halfedge of its triangle
// that contains it in its interior. If there is none, returns none.
CGAL_GEODESIC_PROCESSING_EXPORT
Index corner_of(const Surface_location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
Index vertex_of(const Surface_arrays& triangles, const Surface_location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
Index halfedge_of(const Surface_location& location);

// Returns the barycentric coordinates of a canonical location in a triangle if the triangle
// contains it.
CGAL_GEODESIC_PROCESSING_EXPORT
std::optional<std::array<double, 3>> barycentric_in(const Surface_arrays& triangles, Index triangle,
                                                    const Surface_location& location);

// Returns the triangles that contain a canonical location: all triangles of a vertex, one or two
// triangles of an edge, otherwise one triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> triangles_at(const Surface_arrays& triangles, const Surface_location& location);

// Returns one of these triangles, or none for a vertex without triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
Index triangle_at(const Surface_arrays& triangles, const Surface_location& location);

// Returns a triangle that contains both canonical locations, or none.
CGAL_GEODESIC_PROCESSING_EXPORT
Index common_triangle(const Surface_arrays& triangles, const Surface_location& p,
                      const Surface_location& q);

// Returns whether two canonical locations are the same point of the surface.
CGAL_GEODESIC_PROCESSING_EXPORT
bool is_same_point(const Surface_arrays& triangles, const Surface_location& p,
                   const Surface_location& q);

// Returns the distance of two points with scaled coordinates minus round-off errors: a lower bound
// of the length of all paths between them.
inline double straight_distance(const Vec3& p, const Vec3& q)
{
  // The relative round-off error of the distance of two points is below 4 epsilon. The coordinates
  // are of order one.
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  return std::max(0., norm(p - q) * (1. - 4. * epsilon) - 16. * epsilon);
}

// The same for two locations.
CGAL_GEODESIC_PROCESSING_EXPORT
double straight_distance(const Surface_arrays& triangles, const Surface_location& p,
                         const Surface_location& q);

// Returns the length of the polyline with these vertices in space, in scaled units.
CGAL_GEODESIC_PROCESSING_EXPORT
double polyline_length(const Surface_arrays& triangles, const std::vector<Surface_location>& path);

// Returns the length of a path on the surface, in scaled units. Throws Invalid_argument_error if
// two consecutive locations are in no common triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
double path_length(const Surface_arrays& triangles, const std::vector<Surface_location>& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_PATH_LOCATIONS_H
