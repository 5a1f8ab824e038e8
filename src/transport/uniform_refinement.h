// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_UNIFORM_REFINEMENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_UNIFORM_REFINEMENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the midpoint vertex of each halfedge, numbered from number_of_vertices() on. On a cloud,
// all halfedges with the same ends have one midpoint. O(n), on a cloud O(n log n).
std::vector<Index> edge_midpoints(const Surface_arrays& triangles);

// Returns the same surface after uniform refinement (1-to-4). Geodesic distances do not change.
// Triangle f becomes 4f + k at its corner k, and 4f + 3 in the center. The corners keep their
// order; the center triangle is rotated by 180 degrees. A vertex keeps its index, and the midpoints
// follow. The result has no coordinates and no graph, and half the scale. O(n), on a cloud O(n log
// n).
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_arrays refined(const Surface_arrays& triangles);

// Returns the same location on the refined surface.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location refined(const Surface_location& location);

// Returns the same function on the refined surface: from #vertices of `coarse` to #vertices of
// `fine`.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector refined(const Surface_arrays& coarse, const Surface_arrays& fine, const Vector& function);

// Returns the mean over the four children of each triangle.
CGAL_GEODESIC_PROCESSING_EXPORT
Field coarsened(const Field& fine);

// Distributes the mass of each midpoint to the two ends of its edge in equal parts. The integral of
// every function that is linear in the coarse triangles is preserved.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector coarsened(const Surface_arrays& coarse, const Surface_arrays& fine, const Vector& masses);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_UNIFORM_REFINEMENT_H
