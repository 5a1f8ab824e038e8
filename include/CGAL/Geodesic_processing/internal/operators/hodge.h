// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

namespace CGAL::Geodesic_processing::internal {

// Functions that are linear in each triangle and continuous at the middle of each side (Crouzeix and
// Raviart 1973), with one value for all the border: the same operators, where a "corner" is a side and
// its hat is 1 in its middle and 0 in those of the two others.
CGAL_GEODESIC_PROCESSING_EXPORT
Operators crouzeix_raviart_operators(const Surface_arrays& triangles, const Operators& operators);

// What a field is the sum of, orthogonal to each other, #triangles each: a gradient, the quarter turn of
// the gradient of a function of sides, and a rest, which is spanned by harmonic_fields().
struct Hodge_components
{
  Field gradient;
  Field rotation;
  Field harmonic;
};

// The Hodge decomposition of the fields of a mesh (Polthier and Preuss 2003).  On a component the three
// spaces have #sites - 1, #inner sides (one less where there is no border) and 2 genus +
// max(border loops - 1, 0) dimensions: twice the number of triangles together.
class CGAL_GEODESIC_PROCESSING_EXPORT Hodge_solver
{
public:
  // Two factorizations.  Throws Unsupported_surface_error on a cloud, where nothing is glued.
  Hodge_solver(const Surface_arrays& triangles, Operators operators);

  Hodge_components decompose(const Field& field) const;

private:
  Operators m_operators, m_edge_operators;
  Poisson_solver m_vertex_solver, m_edge_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H
