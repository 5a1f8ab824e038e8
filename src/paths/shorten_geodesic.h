// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_GEODESIC_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_GEODESIC_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A site that a path runs through, and the angles of the surface on both sides of the path there:
// infinite on a side where a border is.
struct Touched_vertex
{
  std::size_t location_index; // in the path's locations
  double left_angle, right_angle;
};

struct Locally_shortest_path
{
  std::vector<Surface_location>
      locations;      // never empty, no point twice in a row, consecutive ones in a
                      //   common triangle; crossed sides with one zero coordinate
  double length = 0.; // in the domain's scale
  std::vector<Touched_vertex> touched_vertices; // in order, without the ends
};

// Pulls a path taut: the result joins the same ends, is not longer, and is locally shortest:
// straight in the triangles that it crosses, with an angle of at least pi on both sides of every
// site that it touches.  It is the shortest of all that cross the same strip of triangles, but not
// always the shortest of all: it stays on the side of every hill on which the path was.
//
// path  not empty; consecutive locations lie in a common triangle (of a mesh), anywhere in it.
//       Coordinates below 1e-14 count as zero.
//
// The strip of triangles is unfolded and its shortest path found by a funnel (Lee and Preparata
// 1984); where an angle is below pi, the strip is led around the site on that side (Xin and Wang
// 2007), and the part between the neighbouring touched sites is pulled taut again.  Each turn
// shortens the path, so that it ends.  Corners that gain less than rounding stay: angles short of
// pi by up to 1e-7, and more at sites nearer to each other than some hundred roundings of the
// path's length, which glue() keeps apart.  The cost is proportional to the strip, times the turns
// near each place; nothing of the size of the mesh is touched.
//
// Throws Invalid_argument_error when the path is empty or two consecutive locations lie in no
// common triangle, Unsupported_surface_error on a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
Locally_shortest_path shorten_geodesic(const Surface_arrays& triangles,
                                       const std::vector<Surface_location>& path);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_GEODESIC_H
