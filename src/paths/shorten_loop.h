// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_LOOP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_LOOP_H

#include "paths/Homotopy.h"
#include "paths/shorten_geodesic.h"

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Shortens a closed curve on a mesh to a locally shortest one that is freely homotopic to it.
//
// homotopy  of the same triangles
// loop      not empty; consecutive locations, also the last and the first one, lie in a common
//           triangle
//
// The result is not longer than the curve. Its last location is its first one. It is straight in
// the unfolded triangles, and both angles at each vertex that it touches are at least pi; the first
// location is no exception. If the curve is contractible, the result is its first location.
//
// Algorithm: shorten_closed_geodesic() shortens the loop until it is a geodesic, or touches no
// vertex but its first location. In the second case, the shortest loop in the annulus of crossed
// triangles is computed: its length is a convex function of the point at which it crosses an edge,
// and the square of this function is quadratic where the loop touches no vertex. If this loop is
// not shorter, the loop is cut open in its middle, and is shortened again; these loops converge
// linearly (Birkhoff 1917).
//
// Tolerance: as for shorten_geodesic(). Where the loop crosses an edge, the angle of the fixed
// location differs from pi by less than 1e-6.
//
// Throws as shorten_geodesic().
CGAL_GEODESIC_PROCESSING_EXPORT
Locally_shortest_path shorten_loop(const Surface_arrays& triangles, const Homotopy& homotopy,
                                   const std::vector<Surface_location>& loop);

// As shorten_loop(), for a curve that is not contractible.
CGAL_GEODESIC_PROCESSING_EXPORT
Locally_shortest_path shorten_noncontractible_loop(const Surface_arrays& triangles,
                                                   const std::vector<Surface_location>& loop);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SHORTEN_LOOP_H
