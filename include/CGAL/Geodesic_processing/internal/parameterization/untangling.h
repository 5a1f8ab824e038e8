// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_UNTANGLING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_UNTANGLING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <vector>

// Repairs maps to the plane that have few inverted triangles.

namespace CGAL::Geodesic_processing::internal {

// Reflects an image in which inverted triangles have more area than the others.
CGAL_GEODESIC_PROCESSING_EXPORT
void orient_positively(const Surface_arrays& triangles, std::vector<Vec2>& image);

// Moves vertices of inverted triangles and of rings around them to make all triangles positive.
// The rest of the map is fixed, and the symmetric Dirichlet energy of the moved part is minimized.
// The rings are 4, and 8 if that fails.
//
// A connected region of more than 1,000 triangles is not changed, nor are regions beyond 3,000
// triangles in total, nor those that cannot be repaired. On a cloud nothing is changed.
CGAL_GEODESIC_PROCESSING_EXPORT
void untangle(const Surface_arrays& triangles, std::vector<Vec2>& image);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_UNTANGLING_H
