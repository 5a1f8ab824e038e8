// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_HODGE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_HODGE_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <memory>

namespace CGAL::Geodesic_processing::internal {

// Functions that are linear in each triangle and continuous at the middle of each side (Crouzeix and
// Raviart 1973), with one value for all the border: the same operators, where a "corner" is a side and
// its hat is 1 in its middle and 0 in those of the two others.
CGAL_GEODESIC_PROCESSING_EXPORT
Operators operators_of_sides(const Glued_triangles& triangles, const Operators& operators);

// What a field is the sum of, orthogonal to each other, #triangles each: a gradient, the quarter turn of
// the gradient of a function of sides, and a rest, which is spanned by harmonic_fields().
struct Hodge_parts
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
  Hodge_solver(const Glued_triangles& triangles, Operators operators);

  Hodge_parts decompose(const Field& field) const;

private:
  Operators m_operators, m_operators_of_sides;
  std::unique_ptr<Sparse_solver> m_sites, m_sides;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_HODGE_H
