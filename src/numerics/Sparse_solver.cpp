// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "numerics/blas.h"
#include "numerics/supernodes.h"

#include <Eigen/Sparse>
#ifdef GEODESIC_PROCESSING_HAS_CHOLMOD
#  include <Eigen/CholmodSupport>
#else
#  include <Eigen/SparseCholesky>
#endif

#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

#ifdef GEODESIC_PROCESSING_HAS_CHOLMOD

namespace {

// The CHOLMOD state of one call, which threads cannot share. Meanwhile the calling thread opens no
// OpenMP teams. CHOLMOD always uses teams of four threads; on two busy processors their
// synchronization took up to 40 % of the time.
class Cholmod_common : public cholmod_common
{
public:
  Cholmod_common()
  {
    cholmod_start(this);
    print = 0; // otherwise CHOLMOD prints warnings on standard output
    // CHOLMOD_AUTO factorizes column by column if the blocks would be small. On a surface of many
    // small components, the calls of BLAS for each block took two thirds of the time.
    supernodal = CHOLMOD_AUTO;
    final_ll = 1; // otherwise a matrix that is not positive definite is not recognized
    static auto* const levels = find_function<int()>("omp_get_max_active_levels");
    if(levels)
    {
      m_levels = levels();
      set_levels(0);
    }
  }
  ~Cholmod_common()
  {
    cholmod_finish(this);
    if(m_levels > 0)
      set_levels(m_levels);
  }
  Cholmod_common(const Cholmod_common&) = delete;

private:
  static void set_levels(int levels)
  {
    static auto* const set = find_function<void(int)>("omp_set_max_active_levels");
    set(levels);
  }

  Single_threaded_blas m_blas;
  int m_levels = 0;
};

// CHOLMOD reports a lack of memory only by its status.
void check_memory(const Cholmod_common& common)
{
  if(common.status == CHOLMOD_OUT_OF_MEMORY)
    throw std::bad_alloc();
}

} // namespace

struct Sparse_solver::Solver
{
  Solver(const Sparse_matrix& matrix, Elimination_order order)
  {
    Cholmod_common common;
    // METIS begins each ordering by srand() and calls rand(), whose state all threads share.
    // Orderings at the same time would depend on each other, and so would round-off errors.
    static std::mutex metis_mutex;
    std::unique_lock<std::mutex> metis_lock(metis_mutex, std::defer_lock);
    if(order == Elimination_order::low_fill)
    {
      metis_lock.lock();
      common.nmethods = 2; // uses the better ordering; METIS may be missing
      common.method[0].ordering = CHOLMOD_METIS;
      common.method[1].ordering = CHOLMOD_AMD;
      // Merges supernodes into fewer and larger ones than the default (4, 16, 48), with more
      // explicit zeros. This reduces the time by a third for 6,000 to 40,000 unknowns.
      common.nrelax[0] = 16;
      common.nrelax[1] = 48;
      common.nrelax[2] = 96;
    }
    cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
    factor = cholmod_analyze(&view, &common);
    if(!factor)
      check_memory(common);
  }
  Solver(const Solver& other)
  {
    Cholmod_common common;
    factor = cholmod_copy_factor(other.factor, &common);
    check_memory(common);
  }
  ~Solver()
  {
    Cholmod_common common;
    cholmod_free_factor(&factor, &common);
  }

  bool factorize(const Sparse_matrix& matrix)
  {
    Cholmod_common common;
    cholmod_sparse view = Eigen::viewAsCholmod(matrix.selfadjointView<Eigen::Lower>());
    const bool is_factorized =
        factor && cholmod_factorize(&view, factor, &common) && factor->minor == factor->n;
    check_memory(common);
    return is_factorized;
  }

  Vector solve(const Vector& rhs) const
  {
    Cholmod_common common;
    cholmod_dense view = Eigen::viewAsCholmod(rhs.const_cast_derived());
    Vector result(rhs.size()); // allocated first, because an exception would leak the solution
    cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, &view, &common);
    if(!solution)
      throw std::bad_alloc();
    result = Vector::Map(static_cast<const double*>(solution->x), rhs.size());
    cholmod_free_dense(&solution, &common);
    return result;
  }

  void solve(Eigen::MatrixXd& columns) const
  {
    if(factor->is_super == 0)
    {
      for(Eigen::Index k = 0; k < columns.cols(); ++k)
        columns.col(k) = solve(Vector(columns.col(k)));
      return;
    }
    std::vector<double> workspace = acquire_workspace();
    substitute(supernodes(), columns.data(), std::size_t(columns.cols()), workspace);
    const std::lock_guard<std::mutex> lock(mutex);
    free_workspaces.push_back(std::move(workspace));
  }

  Supernodes supernodes() const
  {
    const auto integers = [](const void* array) { return static_cast<const int*>(array); };
    return {factor->n,
            factor->nsuper,
            integers(factor->Perm),
            integers(factor->super),
            integers(factor->pi),
            integers(factor->px),
            integers(factor->s),
            static_cast<const double*>(factor->x)};
  }

  std::vector<double> acquire_workspace() const
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if(free_workspaces.empty())
      return {};
    std::vector<double> result = std::move(free_workspaces.back());
    free_workspaces.pop_back();
    return result;
  }

  mutable std::mutex mutex;
  // Workspaces of completed calls: allocating this much memory for each call is slow.
  mutable std::vector<std::vector<double>> free_workspaces;
  cholmod_factor* factor = nullptr;
};

#else

struct Sparse_solver::Solver
{
  Solver(const Sparse_matrix& matrix, Elimination_order) : pattern(matrix)
  {
    ldlt.analyzePattern(pattern);
  }
  Solver(const Solver& other) : Solver(other.pattern, Elimination_order::fast) {}

  bool factorize(const Sparse_matrix& matrix)
  {
    ldlt.factorize(matrix);
    return ldlt.info() == Eigen::Success && !(ldlt.vectorD().minCoeff() <= 0.);
  }
  Vector solve(const Vector& rhs) const { return ldlt.solve(rhs); }
  void solve(Eigen::MatrixXd& columns) const { columns = ldlt.solve(columns).eval(); }

  Sparse_matrix pattern; // Eigen's factorizations cannot be copied
  Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower> ldlt;
};

#endif

Sparse_solver::Sparse_solver(const Sparse_matrix& matrix, Elimination_order order)
    : m_solver(std::make_unique<Solver>(matrix, order))
{
  if(!factorize(matrix))
    throw Unsupported_surface_error("A linear system of the surface could not be factorized.");
}

Sparse_solver::Sparse_solver(const Sparse_solver& other)
    : m_solver(std::make_unique<Solver>(*other.m_solver))
{}

Sparse_solver::~Sparse_solver() = default;

bool Sparse_solver::factorize(const Sparse_matrix& matrix)
{
  if(m_solver->factorize(matrix))
    return true;
  Sparse_matrix regularized = matrix;
  const Vector diagonal = matrix.diagonal();
  for(const double regularization : {1e-14, 1e-13, 1e-12})
  {
    regularized.diagonal() = (1. + regularization) * diagonal;
    if(m_solver->factorize(regularized))
      return true;
  }
  return false;
}

Vector Sparse_solver::solve(const Vector& rhs) const { return m_solver->solve(rhs); }

void Sparse_solver::solve_columns(Eigen::MatrixXd& columns) const { m_solver->solve(columns); }

} // namespace CGAL::Geodesic_processing::internal
