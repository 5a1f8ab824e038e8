// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_POISSON_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_POISSON_SOLVER_H

#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Solves Poisson's equation L u = f, where L is the positive semidefinite Laplacian of the
// operators. This class factorizes L with one pinned vertex in each component.
//
// If f sums to zero on each component, u solves the equation and vanishes at the pinned vertices.
// The function minus_divergence() returns such an f for every field. The gradient of the solution
// is then the gradient part of the field.
class CGAL_GEODESIC_PROCESSING_EXPORT Poisson_solver : public Sparse_solver
{
public:
  // Assembles and factorizes L for K = identity (see Laplacian).
  explicit Poisson_solver(const Operators& operators,
                          Elimination_order order = Elimination_order::fast);

  // Assembles and factorizes L for the tensors K of all triangles (see Laplacian).
  Poisson_solver(const Operators& operators, const std::vector<Metric_tensor>& tensors,
                 Elimination_order order = Elimination_order::fast);

  // Pins and factorizes `matrix`, which must be assembled by `laplacian`.
  Poisson_solver(const Laplacian& laplacian, Sparse_matrix matrix,
                 Elimination_order order = Elimination_order::fast);
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_POISSON_SOLVER_H
