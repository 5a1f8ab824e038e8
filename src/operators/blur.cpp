// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/operators/blur.h>

namespace CGAL::Geodesic_processing::internal {

Vector blurred(const Operators& operators, const Vector& function, double radius)
{
  const Vector mass = lumped_mass(operators);
  Sparse_matrix matrix = 0.5 * radius * radius * Laplacian(operators).matrix(operators);
  for(Eigen::Index site = 0; site < mass.size(); ++site)
    matrix.coeffRef(site, site) += mass[site] > 0. ? mass[site] : 1.;
  return Sparse_solver(matrix).solve(mass.cwiseProduct(function));
}

} // namespace CGAL::Geodesic_processing::internal
