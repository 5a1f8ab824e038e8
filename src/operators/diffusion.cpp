// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/diffusion.h>

namespace CGAL::Geodesic_processing::internal {

Vector diffused(const Operators& operators, const Vector& function, double radius)
{
  const Vector mass = lumped_mass(operators);
  Sparse_matrix matrix = 0.5 * radius * radius * Laplacian(operators).matrix(operators);
  for(Eigen::Index vertex = 0; vertex < mass.size(); ++vertex)
    matrix.coeffRef(vertex, vertex) += mass[vertex] > 0. ? mass[vertex] : 1.;
  return Sparse_solver(matrix).solve(mass.cwiseProduct(function));
}

} // namespace CGAL::Geodesic_processing::internal
