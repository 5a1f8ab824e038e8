// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_UNIFORM_REFINEMENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_UNIFORM_REFINEMENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

namespace CGAL::Geodesic_processing::internal {

// The same surface with each triangle divided in four by the middles of its sides: distances on it are
// the same.  Triangle f becomes 4f + k at its corner k, with corners in the same order, and 4f + 3 in
// the middle, the same turned by half; sites keep their numbers, the middles follow.  Without
// coordinates and without arcs; the scale is half.  O(n), on a cloud O(n log n).
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_arrays refined(const Surface_arrays& triangles);

// Where a location in a triangle lies then.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location refined(const Surface_location& location);

// The same function, linear in each triangle: #sites of the coarse triangles to those of the fine ones.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector refined(const Surface_arrays& coarse, const Surface_arrays& fine, const Vector& function);

// The field's means over the triangles that one was divided into.
CGAL_GEODESIC_PROCESSING_EXPORT
Field coarsened(const Field& fine);

// Masses at sites of the coarse triangles, those of a middle in equal parts at the ends of its side: the
// integral of each function that is linear in coarse triangles is the same.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector coarsened(const Surface_arrays& coarse, const Surface_arrays& fine, const Vector& masses);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_UNIFORM_REFINEMENT_H
