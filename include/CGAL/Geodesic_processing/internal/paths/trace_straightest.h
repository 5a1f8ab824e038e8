// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_STRAIGHTEST_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_STRAIGHTEST_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The reason why a straightest path ended.
enum class Straightest_path_end
{
  length,    // it has the requested length
  boundary,  // it reached a boundary edge, or a boundary vertex that it cannot pass
  degenerate // it crossed 10^4 triangles without becoming longer, or 10^6 + 10 #triangles in all
};

struct Straightest_path
{
  std::vector<Surface_location> locations; // as in Locally_shortest_path
  double length = 0.;                      // of the path, in the scale of the surface arrays
  double angle = 0.; // direction at the end, counterclockwise from halfedge 0 of the triangle of
                     //   the last location
  Straightest_path_end end = Straightest_path_end::length;
};

// Traces the straightest geodesic from a location in a direction (Polthier and Schmies 1998). Its
// endpoint is the exponential map.
//
// Triangles are unfolded one after the other. If the path hits a vertex, it continues with equal
// angles on both sides. It passes a boundary vertex if the angle on one side is at least pi, and
// continues with an angle of exactly pi on that side.
//
// from    on a mesh; a location in a triangle, such as the result of vertex_location()
// angle   the direction in the plane of that triangle, counterclockwise from halfedge 0. If it
//         points out of the triangle, the adjacent triangles are unfolded to that plane.
// length  finite and not negative, in the scale of the surface arrays
//
// Throws Invalid_argument_error if the angle is not finite or the length is invalid. Throws
// Unsupported_surface_error on a cloud. Linear in the number of triangles that the path crosses.
CGAL_GEODESIC_PROCESSING_EXPORT
Straightest_path trace_straightest(const Surface_arrays& triangles, const Surface_location& from,
                                   double angle, double length);

// Traces the straightest geodesic from a location in a direction in space. The direction is
// projected to the plane of the location's triangle. At a vertex, the triangle that contains the
// projected direction is used. If several do, it is the one to whose plane the direction is
// closest.
//
// Also throws Invalid_argument_error if the direction is zero, not finite or normal to the surface.
// The location must not be an isolated vertex.
CGAL_GEODESIC_PROCESSING_EXPORT
Straightest_path trace_straightest_in_space(const Surface_arrays& triangles,
                                            const Surface_location& from,
                                            const std::array<double, 3>& direction, double length);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_STRAIGHTEST_H
