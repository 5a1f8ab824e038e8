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

// In which order unknowns are eliminated: `quick` is found fast, `sparse` leaves fewer entries, which
// pays where one pattern is factorized again and again.
enum class Elimination_order
{
  fast,
  low_fill
};

// The factorization of a symmetric positive definite matrix, of which the lower triangle is read: by
// CHOLMOD where it was found, else by Eigen.
//
// Where some entries are a million times above others, rounding may hide that a matrix is definite: then
// its diagonal grows until it shows, at most by a millionth of a millionth of itself.
//
// The pattern is analysed once.  A copy shares no state, and is factorized anew before it solves.
class CGAL_GEODESIC_PROCESSING_EXPORT Sparse_solver
{
public:
  // Throws Unsupported_surface_error when the matrix is not definite.
  explicit Sparse_solver(const Sparse_matrix& matrix,
                         Elimination_order order = Elimination_order::fast);
  Sparse_solver(const Sparse_solver& other);
  ~Sparse_solver();

  // Another matrix with the same pattern.  False when it is not definite: then nothing can be solved.
  bool factorize(const Sparse_matrix& matrix);

  // May be called by several threads at once.
  Vector solve(const Vector& rhs) const;

  // Each column is a right side, and becomes the solution: thirty-two at once, in a fraction of their
  // time one by one, and sooner where they have few entries near each other.
  void solve_columns(Eigen::MatrixXd& columns) const;

private:
  struct Solver;
  std::unique_ptr<Solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_SPARSE_SOLVER_H
