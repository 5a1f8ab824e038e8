// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/dense_solvers.h"

#include <Eigen/Eigenvalues>

namespace CGAL::Geodesic_processing::internal {

Eigen_system eigen_system(const Eigen::MatrixXd& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Symmetric_solver::Symmetric_solver(const Eigen::MatrixXd& matrix) : m_ldlt(matrix) {}

Eigen::MatrixXd Symmetric_solver::solve(const Eigen::MatrixXd& rhs) const
{
  return m_ldlt.solve(rhs);
}

Eigen::MatrixXd small_product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                              const Eigen::Ref<const Eigen::MatrixXd>& b)
{
  return a * b;
}

Eigen::MatrixXd small_transposed_product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                         const Eigen::Ref<const Eigen::MatrixXd>& b)
{
  return a.transpose() * b;
}

} // namespace CGAL::Geodesic_processing::internal
