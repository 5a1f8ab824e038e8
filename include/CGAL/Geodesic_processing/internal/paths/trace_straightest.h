// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_STRAIGHTEST_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_STRAIGHTEST_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Why a straightest path ended.
enum class Straightest_path_end
{
  length,    // it has the length asked for
  boundary,  // it met a border, or a border site that it cannot pass straight on
  degenerate // it crossed ten thousand triangles without getting on
};

struct Straightest_path
{
  std::vector<Surface_location>
      locations;      // as in Locally_shortest_path; the last one in the triangle of `angle`
  double length = 0.; // reached, in the domain's scale
  double angle = 0.;  // direction at the end, from side 0 of the last triangle
  Straightest_path_end end = Straightest_path_end::length;
};

// The path that leaves a location in a direction and goes straight on for a length: the exponential
// map.  Triangles are unfolded one after the other; a site that the path hits is left with equal
// angles on both sides (Polthier and Schmies 1998).  A border site is passed when there is
// an angle of at least pi on one side, and then left at exactly pi on it.
//
// from    on a mesh, in a triangle (as vertex_location() makes it of a site)
// angle   of the direction in the plane of that triangle, counterclockwise from its side 0; where
//         it points out of the triangle, from a corner or a side, the neighbours are unfolded into
//         that plane, the nearer way round
// length  finite and not negative, in the domain's scale
//
// Throws Invalid_argument_error when the angle or the length is not so.  The cost is proportional
// to the triangles crossed.
CGAL_GEODESIC_PROCESSING_EXPORT
Straightest_path trace_straightest(const Surface_arrays& triangles, const Surface_location& from,
                                   double angle, double length);

// The same in a direction of space, which is projected to the plane of the location's triangle; at
// a site to that of the triangle, of those that hold the projection, whose plane is the nearest.
// Throws Invalid_argument_error also when the projection vanishes, or at a site without triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
Straightest_path trace_straightest_in_space(const Surface_arrays& triangles,
                                            const Surface_location& from,
                                            const std::array<double, 3>& direction, double length);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRACE_STRAIGHTEST_H
