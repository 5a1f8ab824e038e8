// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_SOLVERS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_SOLVERS_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

// Operations on dense matrices. They have a source of their own, because Eigen's templates for them
// take ten seconds to compile.

namespace CGAL::Geodesic_processing::internal {

struct Eigen_system
{
  Eigen::VectorXd values;  // ascending
  Eigen::MatrixXd vectors; // orthonormal columns, in the same order
};

// Returns the eigenvalues and eigenvectors of a symmetric matrix, of which only the lower triangle
// is read.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen_system eigen_system(const Eigen::MatrixXd& matrix);

// Solves linear systems with a symmetric semidefinite matrix, of which only the lower triangle is
// read.
class CGAL_GEODESIC_PROCESSING_EXPORT Symmetric_solver
{
public:
  explicit Symmetric_solver(const Eigen::MatrixXd& matrix);

  // Returns the solution for each column.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;

private:
  Eigen::LDLT<Eigen::MatrixXd> m_ldlt;
};

// Computes the product of `a` with `b`. The function product() is faster if a factor is large.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::MatrixXd small_product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                              const Eigen::Ref<const Eigen::MatrixXd>& b);

// Computes the product of the transpose of `a` with `b`.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::MatrixXd small_transposed_product(const Eigen::Ref<const Eigen::MatrixXd>& a,
                                         const Eigen::Ref<const Eigen::MatrixXd>& b);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_SOLVERS_H
