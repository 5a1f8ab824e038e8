// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPARSE_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPARSE_SOLVER_H

#include <CGAL/Geodesic_processing/internal/export.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace CGAL::Geodesic_processing::internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// The factorization of a symmetric positive definite matrix, of which the lower triangle is read: by
// CHOLMOD where it was found, else by Eigen.
class CGAL_GEODESIC_PROCESSING_EXPORT Sparse_solver
{
public:
  // Throws Unsupported_surface_error when the matrix is not definite.
  explicit Sparse_solver(const Sparse_matrix& matrix);
  ~Sparse_solver();

  Vector solve(const Vector& right) const;

private:
  struct Solver;
  std::unique_ptr<Solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPARSE_SOLVER_H
