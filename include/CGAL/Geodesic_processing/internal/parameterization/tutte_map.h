// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TUTTE_MAP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TUTTE_MAP_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the boundary cycles, each as a sequence of halfedges; the longest cycle is the first.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::vector<Index>> boundary_loops(const Surface_arrays& triangles);

// Throws Unsupported_surface_error unless the surface is a topological disk, possibly with holes:
// connected, with boundary and of genus zero. Isolated vertices are ignored.
CGAL_GEODESIC_PROCESSING_EXPORT
void check_is_disk(const Surface_arrays& triangles);

// Computes Tutte's map of a disk. The longest boundary cycle is mapped to a circle and each other
// vertex to the mean of its neighbors. Each hole is filled by one additional vertex. In exact
// arithmetic no triangle is inverted.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Vec2> tutte_map(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PARAMETERIZATION_TUTTE_MAP_H
