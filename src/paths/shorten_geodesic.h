// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_GEODESIC_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_GEODESIC_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include "paths/triangle_strip.h"

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A vertex that a path passes through, with the total angles of the triangles on the left and on
// the right of the path. If the boundary is on that side, the angle is infinite.
struct Touched_vertex
{
  std::size_t location_index; // in the path's locations
  double left_angle, right_angle;
};

struct Locally_shortest_path
{
  std::vector<Surface_location>
      locations;      // not empty; no two consecutive ones are equal, and they lie in a common
                      //   triangle; points on crossed edges have one zero coordinate
  double length = 0.; // in the scale of the surface arrays
  std::vector<Touched_vertex> touched_vertices; // in order, without the endpoints
};

// Shortens a path on a mesh to a locally shortest one with the same endpoints.
//
// path  not empty; consecutive locations lie in a common triangle. Barycentric coordinates below
//       1e-14 are treated as zero.
//
// The result is not longer than the path. It is straight in the unfolded triangles, and both
// angles at each vertex that it touches are at least pi. It is the shortest path in its strip of
// triangles, but not always the globally shortest path. For example, it does not pass to the other
// side of a hill.
//
// Algorithm: The strip of triangles is unfolded, and the shortest path in it is computed by the
// funnel algorithm (Lee and Preparata 1984). If an angle at a touched vertex is below pi, the
// strip is rerouted around the vertex on that side (Xin and Wang 2007). The path between the
// adjacent touched vertices is then recomputed. The algorithm terminates because each rerouting
// shortens the path.
//
// Tolerance: Corners are kept if cutting them shortens the path by less than round-off errors.
// Their angles are at least pi - 1e-7. Smaller angles are possible if vertices almost coincide:
// closer than some hundred round-off errors of the path's length. build_mesh_arrays() prevents
// this.
//
// Complexity: the length of the strip times the number of reroutings near each of its triangles,
// independent of the size of the mesh.
//
// Throws Invalid_argument_error if the path is empty or two consecutive locations lie in no common
// triangle. Throws Unsupported_surface_error on a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
Locally_shortest_path shorten_geodesic(const Surface_arrays& triangles,
                                       const std::vector<Surface_location>& path);

// Shortens a closed path whose last location is its first one.
//
// As shorten_geodesic() with one location fixed. As long as the path touches a vertex, the fixed
// location is moved to it, and the path is shortened at the previous one. The fixed location at the
// end is the first one of the result; if it is a vertex, it is listed in `touched_vertices`, with
// location index 0.
//
// is_geodesic  receives whether the result is also straight at its first location
CGAL_GEODESIC_PROCESSING_EXPORT
Locally_shortest_path shorten_closed_geodesic(const Surface_arrays& triangles,
                                              const std::vector<Surface_location>& path,
                                              bool& is_geodesic);

// Shortens the shortest path in a strip from a location to itself. As above.
CGAL_GEODESIC_PROCESSING_EXPORT
Locally_shortest_path shorten_closed_geodesic(const Surface_arrays& triangles,
                                              const Surface_location& base, const Strip& strip,
                                              bool& is_geodesic);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_GEODESIC_H
