// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HARMONIC_FIELDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HARMONIC_FIELDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// An orthonormal basis of the fields of a mesh that have neither divergence nor rotation: what they
// measure along a side is the same in both of its triangles, and divergence() of them is zero, so that
// none flows through a border.
//
// For each component 2 genus + max(border loops - 1, 0) of them: closed forms across the sides that
// neither a tree of sites nor a cotree of triangles holds (Tong, Alliez, Cohen-Steiner and Desbrun 2006),
// less their gradient part.  Loops of loose fans through pinched sites count as well.
//
// poisson_solver  of the same operators.  Throws Unsupported_surface_error on a cloud, where nothing
// is glued.  One solution and a sweep over all the fields before for each.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Field> harmonic_fields(const Surface_arrays& triangles, const Operators& operators,
                                   const Poisson_solver& poisson_solver);

// How many of them there are.  O(n)
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_of_harmonic_fields(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HARMONIC_FIELDS_H
