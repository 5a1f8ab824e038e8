// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/Poisson_solver.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

Sparse_matrix pinned(const Laplacian& laplacian, Sparse_matrix matrix)
{
  laplacian.pin(matrix);
  return matrix;
}

Sparse_matrix pinned_laplacian(const Operators& operators)
{
  const Laplacian laplacian(operators);
  return pinned(laplacian, laplacian.matrix(operators));
}

Sparse_matrix pinned_laplacian(const Operators& operators,
                               const std::vector<Metric_tensor>& tensors)
{
  const Laplacian laplacian(operators);
  Sparse_matrix matrix = laplacian.matrix(operators);
  laplacian.assemble(operators, tensors, matrix);
  return pinned(laplacian, matrix);
}

} // namespace

Poisson_solver::Poisson_solver(const Operators& operators, Elimination_order order)
    : Sparse_solver(pinned_laplacian(operators), order)
{}

Poisson_solver::Poisson_solver(const Operators& operators,
                               const std::vector<Metric_tensor>& tensors, Elimination_order order)
    : Sparse_solver(pinned_laplacian(operators, tensors), order)
{}

Poisson_solver::Poisson_solver(const Laplacian& laplacian, Sparse_matrix matrix,
                               Elimination_order order)
    : Sparse_solver(pinned(laplacian, matrix), order)
{}

} // namespace CGAL::Geodesic_processing::internal
