// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_UNTANGLING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_UNTANGLING_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <vector>

// Maps to the plane that are sound but for a few places.

namespace CGAL::Geodesic_processing::internal {

// Mirrors an image of which more area is face down than up.
CGAL_GEODESIC_PROCESSING_EXPORT
void orient_positively(const Surface_arrays& triangles, std::vector<Vec2>& image);

// Turns triangles back that are turned round: a few rings about them are moved to where their symmetric Dirichlet
// energy is least, all else stays; with four rings first, then with eight.  Where more than a thousand triangles would
// have to move at a place, or three thousand in all with as many rings, or cannot be turned back, they stay as they
// are.  Nothing is done on a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
void untangle(const Surface_arrays& triangles, std::vector<Vec2>& image);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_UNTANGLING_H
