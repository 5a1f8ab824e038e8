// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SPARSE_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SPARSE_SOLVER_H

#include <CGAL/Geodesic_processing/exceptions.h>

#include <Eigen/Sparse>
#ifdef GEODESIC_PROCESSING_HAS_CHOLMOD
#  include <Eigen/CholmodSupport>
#else
#  include <Eigen/SparseCholesky>
#endif

#include <memory>

namespace CGAL::Geodesic_processing::internal {

using Sparse_matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// The factorization of a symmetric positive definite matrix, of which the lower triangle is read: by
// CHOLMOD where it was found, else by Eigen.  For use in src/ only.
class Sparse_solver
{
public:
  explicit Sparse_solver(const Sparse_matrix& matrix) : m_solver(std::make_unique<Solver>())
  {
    m_solver->compute(matrix);
    if(m_solver->info() != Eigen::Success)
      throw Unsupported_surface_error("A linear system of the surface could not be factorized.");
  }

  Vector solve(const Vector& right) const { return m_solver->solve(right); }

private:
#ifdef GEODESIC_PROCESSING_HAS_CHOLMOD
  using Solver = Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Lower>;
#else
  using Solver = Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower>;
#endif
  std::unique_ptr<Solver> m_solver;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SPARSE_SOLVER_H
