// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/eigen_system.h"

#include <Eigen/Eigenvalues>

namespace CGAL::Geodesic_processing::internal {

Eigen_system eigen_system(const Eigen::MatrixXd& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

} // namespace CGAL::Geodesic_processing::internal
