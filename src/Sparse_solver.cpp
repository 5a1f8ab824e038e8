// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/Sparse_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <Eigen/Sparse>
#ifdef GEODESIC_PROCESSING_HAS_CHOLMOD
#  include <Eigen/CholmodSupport>
#else
#  include <Eigen/SparseCholesky>
#endif

namespace CGAL::Geodesic_processing::internal {

#ifdef GEODESIC_PROCESSING_HAS_CHOLMOD

struct Sparse_solver::Solver : Eigen::CholmodSupernodalLLT<Sparse_matrix, Eigen::Lower>
{
  Solver() { cholmod().print = 0; } // it warns on standard output
  bool is_definite() const { return info() == Eigen::Success; }
};

#else

struct Sparse_solver::Solver : Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower>
{
  bool is_definite() const { return info() == Eigen::Success && !(vectorD().minCoeff() <= 0.); }
};

#endif

Sparse_solver::Sparse_solver(const Sparse_matrix& matrix) : m_solver(std::make_unique<Solver>())
{
  m_solver->compute(matrix);
  if(!m_solver->is_definite())
    throw Unsupported_surface_error("A linear system of the surface could not be factorized.");
}

Sparse_solver::~Sparse_solver() = default;

Vector Sparse_solver::solve(const Vector& right) const { return m_solver->solve(right); }

} // namespace CGAL::Geodesic_processing::internal
