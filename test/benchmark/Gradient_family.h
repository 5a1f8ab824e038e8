// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BENCHMARK_GRADIENT_FAMILY_H
#define CGAL_GEODESIC_PROCESSING_BENCHMARK_GRADIENT_FAMILY_H

#include "operators/eigenfunctions.h"
#include "transport/Group_lasso.h"

#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace benchmarks {

namespace kernels = CGAL::Geodesic_processing::internal;

// The distances of Solomon, Rustamov, Guibas and Butscher 2014 without harmonic fields: the
// integral of the length of a gradient plus rotated gradients of k eigenfunctions, minimized for
// each pair of distributions. Spectral_transport with Particular_field::gradient also admits
// harmonic fields. On a connected mesh without handles and with at most one boundary cycle, there
// are none, and both have equal distances.
class Gradient_family
{
public:
  // `k` is rounded up as in eigenfunctions().
  Gradient_family(std::shared_ptr<const kernels::Surface_arrays> t, std::size_t k)
      : m_triangles(std::move(t)),
        m_operators(kernels::operators(*m_triangles, kernels::Degenerate_triangles::thickened)),
        m_particular(*m_triangles, m_operators, kernels::Particular_field::gradient, false)
  {
    const auto n = Eigen::Index(m_operators.number_of_triangles());
    m_sqrt_area.resize(n);
    for(Eigen::Index f = 0; f < n; ++f)
      m_sqrt_area[f] = std::sqrt(m_operators.area[std::size_t(f)]);
    m_basis.resize(2 * n, 0);
    if(k == 0)
      return;
    const auto eigen = kernels::eigenfunctions(*m_triangles, m_operators, k);
    // The squared norm of the gradient of an eigenfunction is its eigenvalue. Hence the columns are
    // orthonormal.
    const Matrix slopes = kernels::gradients(
        m_operators, eigen.function * eigen.value.cwiseSqrt().cwiseInverse().asDiagonal());
    m_basis.resize(2 * n, slopes.cols());
    m_basis.topRows(n) = -slopes.bottomRows(n);
    m_basis.bottomRows(n) = slopes.topRows(n);
  }

  std::size_t basis_size() const { return std::size_t(m_basis.cols()); }

  // Computes bounds of the distance of each column of differences of two distributions, as
  // Spectral_transport::distances() does. Each column must sum to zero on each component.
  std::vector<kernels::Transport_bounds> distances(const kernels::Masses& differences,
                                                   double tolerance) const
  {
    constexpr Eigen::Index columns_per_block = 32;
    std::vector<kernels::Transport_bounds> result;
    for(Eigen::Index begin = 0; begin < differences.cols(); begin += columns_per_block)
    {
      const Eigen::Index size = std::min(columns_per_block, differences.cols() - begin);
      const auto block =
          minimize(m_particular.fields(differences.middleCols(begin, size)), tolerance);
      result.insert(result.end(), block.begin(), block.end());
    }
    return result;
  }

private:
  using Matrix = kernels::Matrix;

  std::vector<kernels::Transport_bounds> minimize(Matrix particular, double tolerance) const
  {
    using namespace kernels;
    std::vector<Transport_bounds> result(std::size_t(particular.cols()));
    for(std::size_t j = 0; j < result.size(); ++j)
    {
      result[j].upper = (m_sqrt_area.array() * lengths(particular.col(Eigen::Index(j)))).sum();
      result[j].lower = m_basis.cols() == 0 ? result[j].upper : 0.;
    }
    if(m_basis.cols() == 0)
      return result;
    std::vector<std::size_t> column(result.size()); // columns that are not within the tolerance
    std::iota(column.begin(), column.end(), std::size_t(0));
    const Column<double> weight = m_sqrt_area.array();
    Group_lasso<Matrix> solver(m_basis, weight, std::move(particular));
    constexpr unsigned maximum_iterations = 5000; // as Spectral_transport_options
    for(unsigned i = 1; i <= maximum_iterations && !column.empty(); ++i)
    {
      solver.advance();
      if(i % 4 != 0) // computing the bounds costs about as much as an iteration
        continue;
      for(Eigen::Index j = solver.columns() - 1; j >= 0; --j)
      {
        Transport_bounds& bounds = result[column[std::size_t(j)]];
        bounds.upper = std::min(bounds.upper, solver.upper(j));
        bounds.lower = std::min(std::max(bounds.lower, solver.lower(j)), bounds.upper);
        if(!bounds.are_within(tolerance))
          continue;
        solver.remove_column(j);
        column[std::size_t(j)] = column.back();
        column.pop_back();
      }
    }
    return result;
  }

  std::shared_ptr<const kernels::Surface_arrays> m_triangles;
  kernels::Operators m_operators;
  kernels::Particular_fields m_particular;
  kernels::Vector m_sqrt_area; // #triangles
  Matrix m_basis;              // orthonormal columns
};

} // namespace benchmarks

#endif // CGAL_GEODESIC_PROCESSING_BENCHMARK_GRADIENT_FAMILY_H
