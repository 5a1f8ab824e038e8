// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HARMONIC_FIELDS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HARMONIC_FIELDS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Computes an orthonormal basis of the harmonic fields of a mesh. They are curl-free: along an
// edge, both adjacent triangles have the same tangential component. Their minus_divergence() is
// zero, which includes that nothing flows through the boundary.
//
// Each component has 2 genus + max(#boundary loops - 1, 0) harmonic fields. A tree of vertices and
// a cotree of triangles leave one edge for each of them (Tong, Alliez, Cohen-Steiner and Desbrun
// 2006). A closed form is constructed from this edge, and its gradient part is subtracted. Loops
// that pass through a nonmanifold vertex count, too.
//
// Each field takes one solution, and two orthogonalizations against all previous fields.
//
// poisson_solver  must be constructed from the same operators
//
// Throws Unsupported_surface_error if the surface is a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Field> harmonic_fields(const Surface_arrays& triangles, const Operators& operators,
                                   const Poisson_solver& poisson_solver);

// Returns the number of these fields; 0 on a cloud. O(n)
CGAL_GEODESIC_PROCESSING_EXPORT
std::size_t number_of_harmonic_fields(const Surface_arrays& triangles);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HARMONIC_FIELDS_H
