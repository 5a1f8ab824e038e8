// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_POISSON_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_POISSON_SOLVER_H

#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Solves Poisson's equation L u = f with the positive semidefinite Laplacian L of the operators: the
// factorization of L with one vertex of each component pinned.
//
// If f sums to zero on each component (as minus_divergence() of a field does), u solves the equation
// and vanishes at the pinned vertex of each component.  This also gives the gradient part of a field.
class CGAL_GEODESIC_PROCESSING_EXPORT Poisson_solver : public Sparse_solver
{
public:
  // One assembly and one factorization.
  explicit Poisson_solver(const Operators& operators,
                          Elimination_order order = Elimination_order::fast);

  // The same for L = minus the divergence of K times the gradient, where K is `tensors`, one for each
  // triangle.
  Poisson_solver(const Operators& operators, const std::vector<Metric_tensor>& tensors,
                 Elimination_order order = Elimination_order::fast);

  // Pins and factorizes `matrix`, which `laplacian` has assembled.
  Poisson_solver(const Laplacian& laplacian, Sparse_matrix matrix,
                 Elimination_order order = Elimination_order::fast);
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_OPERATORS_POISSON_SOLVER_H
