// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_LOOP_BASIS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_LOOP_BASIS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Computes loops along edges that are a basis of the first homology group with integer
// coefficients.
//
// Each component of genus g with b boundary cycles has 2 g + max(b - 1, 0) loops. Components are
// joined across edges. The tree of shortest paths along edges from one vertex leaves a spanning
// tree of triangles whose crossed edges close the longest loops. The exterior of the boundary is
// one more triangle. The edges in neither tree close the loops of the basis: the shortest basis of
// loops that pass through that vertex (Erickson and Whittlesey 2005). The part of a loop that is
// passed in both directions is removed.
//
// Consecutive locations, also the last and the first one, lie in a common triangle. If several
// edges join two vertices, the midpoint of the edge is a location of the loop, too. Loops are in
// the order of the length through the vertex.
//
// Throws Unsupported_surface_error on a cloud. O(n log n + output size)
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::vector<Surface_location>> loop_basis(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_LOOP_BASIS_H
