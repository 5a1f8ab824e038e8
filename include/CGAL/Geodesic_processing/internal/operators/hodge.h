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
// - `gradient` is the gradient of a function of the vertices, its potential.
// - `rotation` is the gradient of a function of the edges, its potential, rotated to the left.
// - `harmonic` is a linear combination of harmonic_fields().
//
// The integral of each potential over each component is zero. If the component has a boundary, the
// potential of the rotation is zero on the boundary instead. Potentials of vertices and edges
// without triangles of positive area are zero.
struct Hodge_components
{
  Field gradient;
  Field rotation;
  Field harmonic;
  Vector gradient_potential;              // #vertices
  std::vector<double> rotation_potential; // 3 #triangles: at the midpoint of each halfedge
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

// Computes the function of the vertices whose gradient, rotated to the left, is closest to a field.
// It is zero on the boundary. On components without boundary its integral is zero. The rotated
// gradients of such functions are a subspace of the rotations of Hodge_solver. One factorization.
// Throws as Hodge_solver. (Solomon, Rustamov, Guibas and Butscher 2014, section 4.1)
//
// Returns #vertices values.
CGAL_GEODESIC_PROCESSING_EXPORT
Vector vertex_rotation_potential(const Surface_arrays& triangles, const Operators& operators,
                                 const Field& field);

// The two components of a field of tangent vectors of surfels, each of #vertices vectors in space.
// Their sum is the tangential field, up to the round-off error of one subtraction.
struct Surfel_field_components
{
  std::vector<Vec3> gradient;
  std::vector<Vec3> remainder;
  std::vector<double> potential; // #vertices: the function whose gradient is taken
};

// Computes the gradient component of a field on a cloud, and the remainder. The triangles of a
// cloud overlap and have no twins, so that the remainder is not decomposed further.
//
// The gradient is that of the function of the vertices that is closest to the field on the
// triangles, by area times weight. The field of a triangle is the mean over its corners, projected
// to its plane. The gradient of a surfel is the mean over its triangles by area times weight,
// projected to its tangent plane. Coincident surfels have the mean of their fields, and the same
// gradient. The gradient is zero at surfels without triangles. The integral of the potential over
// the weighted triangles of each component is zero, as is the potential of surfels without
// triangles.
//
// field  #vertices vectors in space, finite; the component along the normal is ignored
//
// Throws Unsupported_surface_error if the surface is a mesh, whose vertices have no normals. Takes
// one factorization of the Laplacian.
CGAL_GEODESIC_PROCESSING_EXPORT
Surfel_field_components gradient_and_remainder(const Surface_arrays& cloud,
                                               std::vector<Vec3> field);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_HODGE_H
