// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

namespace CGAL::Geodesic_processing::internal {

// Computes the operators of nonconforming linear elements (Crouzeix and Raviart 1973). Such
// functions are linear in each triangle and continuous at the midpoint of each edge. In the result,
// `corner[h]` is the index of the edge of halfedge h, and all boundary edges share the index 0. The
// hat function of an edge is 1 at its midpoint and 0 at the midpoints of the two other edges of a
// triangle. Throws Unsupported_surface_error if the surface is a cloud.
CGAL_GEODESIC_PROCESSING_EXPORT
Operators crouzeix_raviart_operators(const Surface_arrays& triangles, const Operators& operators);

// The three orthogonal components of a field, each of #triangles vectors. Their sum is the field.
// - `gradient` is the gradient of a function of the vertices.
// - `rotation` is the rotated gradient of a function of the edges.
// - `harmonic` is a linear combination of harmonic_fields().
struct Hodge_components
{
  Field gradient;
  Field rotation;
  Field harmonic;
};

// Computes the Hodge decomposition of the fields of a mesh (Polthier and Preuss 2003). On one
// component, the gradients have dimension #vertices - 1. The rotations have dimension #inner edges,
// or one less if the component has no boundary. The harmonic fields have dimension 2 genus +
// max(#boundary loops - 1, 0). The sum is 2 #triangles.
class CGAL_GEODESIC_PROCESSING_EXPORT Hodge_solver
{
public:
  // Factorizes two Laplacians. Throws Unsupported_surface_error if the surface is a cloud, because
  // the triangles of a cloud have no twins.
  Hodge_solver(const Surface_arrays& triangles, Operators operators);

  // Returns the three components of a field of #triangles vectors. Two solutions.
  Hodge_components decompose(const Field& field) const;

private:
  Operators m_operators, m_edge_operators;
  Poisson_solver m_vertex_solver, m_edge_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H
