// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SPARSE_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SPARSE_SOLVER_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace CGAL::Geodesic_processing::internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// The elimination order of the unknowns. An order for `fast` is computed quickly. The factor of
// `low_fill` has fewer entries; use it if many matrices of one pattern are factorized.
enum class Elimination_order
{
  fast,
  low_fill
};

// Factorizes a symmetric positive definite matrix, of which the lower triangle is read. This class
// uses CHOLMOD if it is available, otherwise Eigen.
//
// If some entries are a million times larger than others, the factorization can fail by round-off
// errors. It is then repeated with a diagonal that is increased by a relative 1e-14 to 1e-12.
//
// The pattern is analyzed once. A copy shares no state and must be factorized again before it can
// solve.
class CGAL_GEODESIC_PROCESSING_EXPORT Sparse_solver
{
public:
  // Throws Unsupported_surface_error if the matrix is not positive definite.
  explicit Sparse_solver(const Sparse_matrix& matrix,
                         Elimination_order order = Elimination_order::fast);
  Sparse_solver(const Sparse_solver& other);
  ~Sparse_solver();

  // Factorizes another matrix of the same pattern. Returns false if it is not positive definite;
  // then solve() must not be called.
  bool factorize(const Sparse_matrix& matrix);

  // Returns the solution for one right-hand side. Thread-safe.
  Vector solve(const Vector& rhs) const;

  // Replaces each column, a right-hand side, by its solution. Blocks of 32 columns are solved at
  // once, which takes a fraction of the time of single solutions. It is faster if the right-hand
  // sides have few nonzero entries close to each other in the elimination order. Thread-safe.
  void solve_columns(Eigen::MatrixXd& columns) const;

private:
  struct Solver;
  std::unique_ptr<Solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SPARSE_SOLVER_H
