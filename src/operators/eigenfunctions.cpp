// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/eigenfunctions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The problem L x = value M x on the sites where functions may be other than zero, as one of the operator
// M^(1/2) L^-1 M^(1/2), whose largest eigenvalues are the inverses of the least ones.
class Inverse_operator
{
public:
  Inverse_operator(const Glued_triangles& triangles, const Operators& operators)
  {
    const Vector mass = lumped_mass(operators);
    const std::vector<bool> is_border = border_sites(triangles);
    const auto [component, number] = components(operators);
    std::vector<bool> is_open(number, false);
    std::vector<Index> place(operators.number_of_sites, none);
    for(Index site = 0; site < place.size(); ++site)
      if(is_border[site])
        is_open[component[site]] = true;
      else if(mass[site] > 0.)
      {
        place[site] = Index(m_sites.size());
        m_sites.push_back(site);
      }

    const auto n = Eigen::Index(m_sites.size());
    m_root_of_mass.resize(n);
    for(Eigen::Index i = 0; i < n; ++i)
      m_root_of_mass[i] = std::sqrt(mass[m_sites[i]]);

    const Sparse_matrix whole = Laplacian(operators).matrix(operators);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(std::size_t(whole.nonZeros()));
    for(int column = 0; column < whole.outerSize(); ++column)
      for(Sparse_matrix::InnerIterator it(whole, column); it; ++it)
        if(place[it.row()] != none && place[it.col()] != none)
          entries.emplace_back(std::max(place[it.row()], place[it.col()]),
                               std::min(place[it.row()], place[it.col()]), it.value());
    m_laplacian.resize(n, n);
    m_laplacian.setFromTriplets(entries.begin(), entries.end());
    if(n == 0)
      return;

    // One site of each closed component is held; constants are taken out by hand.
    std::vector<Index> constant(number, none);
    Index constants = 0;
    Sparse_matrix held = m_laplacian;
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const Index c = component[m_sites[i]];
      if(is_open[c] || constant[c] != none)
        continue;
      constant[c] = constants++;
      held.coeffRef(i, i) *= 2.;
    }
    m_constants = Matrix::Zero(n, constants);
    for(Eigen::Index i = 0; i < n; ++i)
      if(const Index c = constant[component[m_sites[i]]]; c != none)
        m_constants(i, c) = m_root_of_mass[i];
    m_constants.colwise().normalize();
    m_solver = std::make_unique<Sparse_solver>(held, Elimination::quick);
  }

  Eigen::Index size() const { return Eigen::Index(m_sites.size()); }
  const Matrix& constants() const { return m_constants; }

  // To columns that are orthogonal to the constants.
  Matrix apply(const Matrix& columns) const
  {
    Matrix result = m_root_of_mass.asDiagonal() * columns;
    m_solver->solve_columns(result);
    return m_root_of_mass.asDiagonal() * result;
  }

  // How many functions have a value below a number, which lies in a gap; -1 when it could not be counted.
  Eigen::Index number_below(double value) const
  {
    Sparse_matrix shifted = m_laplacian;
    shifted.diagonal() -= value * m_root_of_mass.cwiseAbs2();
    const Eigen::SimplicialLDLT<Sparse_matrix, Eigen::Lower> ldlt(shifted);
    if(ldlt.info() != Eigen::Success || !ldlt.vectorD().allFinite())
      return -1;
    return (ldlt.vectorD().array() < 0.).count() - m_constants.cols();
  }

  // A column of values of functions at all sites.
  Matrix functions(const Matrix& columns, std::size_t number_of_sites) const
  {
    Matrix result = Matrix::Zero(Eigen::Index(number_of_sites), columns.cols());
    for(Eigen::Index i = 0; i < size(); ++i)
      result.row(m_sites[i]) = columns.row(i) / m_root_of_mass[i];
    return result;
  }

private:
  std::vector<Index> m_sites; // where functions may be other than zero
  Vector m_root_of_mass;      // of them
  Sparse_matrix m_laplacian;
  Matrix m_constants; // as columns, orthonormal: what the Laplacian does not see
  std::unique_ptr<Sparse_solver> m_solver;
};

// Golub and Underwood 1977, with all columns kept orthogonal to all others and never restarted: three
// to four columns for each function.
class Block_lanczos
{
public:
  explicit Block_lanczos(const Inverse_operator& inverse)
      : m_inverse(inverse), m_rest(inverse.size(), 0)
  {}

  // Columns that can still be added.
  Eigen::Index room() const { return m_inverse.size() - m_inverse.constants().cols() - m_size; }

  // Adds the next block, with some random columns in it: what no earlier one has seen of a group of
  // repeated values.
  void expand(Eigen::Index random_columns)
  {
    Matrix block(m_inverse.size(), m_rest.cols() + random_columns);
    block.leftCols(m_rest.cols()) = m_rest;
    for(Eigen::Index j = m_rest.cols(); j < block.cols(); ++j)
      for(double& x : block.col(j))
        x = m_value(m_random);
    make_orthogonal(block);
    const Eigen::Index added = std::min(make_orthonormal(block), room());
    block.conservativeResize(Eigen::NoChange, added);

    if(m_columns.cols() < m_size + added)
      m_columns.conservativeResize(m_inverse.size(), 2 * (m_size + added));
    if(m_columns.rows() == 0)
      m_columns.resize(m_inverse.size(), 2 * (m_size + added));
    m_columns.middleCols(m_size, added) = block;
    m_size += added;
    m_last = added;

    m_rest = m_inverse.apply(block);
    const Matrix share = make_orthogonal(m_rest);
    m_projected.conservativeResize(m_size, m_size);
    m_projected.rightCols(added) = share;
    m_projected.bottomRows(added) = share.transpose();
  }

  // The best approximations in the span of all columns, largest values first, and which are good: a
  // residual within 1e-8 of the value leaves one of 1e-16 in the value.
  void solve()
  {
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(m_projected);
    m_values = solver.eigenvalues().reverse();
    m_vectors = solver.eigenvectors().rowwise().reverse();
    const Matrix residual = m_rest * m_vectors.bottomRows(m_last);
    m_good = 0;
    while(m_good < m_size &&
          (room() == 0 || residual.col(m_good).norm() <= 1e-8 * m_values[m_good]))
      ++m_good;
  }
  Eigen::Index size() const { return m_size; }
  Eigen::Index number_of_good_ones() const { return m_good; }
  double value(Eigen::Index i) const { return 1. / m_values[i]; }
  Matrix vectors(Eigen::Index number) const
  {
    Matrix result;
    product(m_columns.leftCols(m_size), m_vectors.leftCols(number), result);
    return result;
  }

private:
  // To the constants and to all columns, which are not changed: twice is enough.  Returns the shares of
  // the columns.
  Matrix make_orthogonal(Matrix& block) const
  {
    Matrix shares = Matrix::Zero(m_size, block.cols());
    Matrix share, part;
    for(int sweep = 0; sweep < 2; ++sweep)
    {
      block -= m_inverse.constants() * (m_inverse.constants().transpose() * block);
      if(m_size == 0)
        continue;
      transposed_product(m_columns.leftCols(m_size), block, share);
      product(m_columns.leftCols(m_size), share, part);
      block -= part;
      shares += share;
    }
    return shares;
  }

  // Modified Gram-Schmidt; columns in which rounding alone is left are dropped.
  Eigen::Index make_orthonormal(Matrix& block) const
  {
    Eigen::Index kept = 0;
    const Vector size = block.colwise().norm();
    for(Eigen::Index j = 0; j < block.cols(); ++j)
    {
      Vector column = block.col(j);
      for(int sweep = 0; sweep < 2; ++sweep)
        for(Eigen::Index i = 0; i < kept; ++i)
          column -= block.col(i).dot(column) * block.col(i);
      if(!(column.norm() > 1e-10 * size.maxCoeff()))
        continue;
      block.col(kept++) = column.normalized();
    }
    return kept;
  }

  const Inverse_operator& m_inverse;
  std::mt19937 m_random{1};
  std::uniform_real_distribution<double> m_value{-1., 1.};
  Matrix m_columns;        // more than m_size
  Eigen::Index m_size = 0; // columns that there are
  Eigen::Index m_last = 0; // columns of the last block
  Matrix m_projected;      // the operator among the columns
  Matrix m_rest;           // what the operator makes of the last block, without the columns' share
  Vector m_values;
  Matrix m_vectors;
  Eigen::Index m_good = 0;
};

// The least number of functions, `number` or more, after which there is a gap; none of those that are
// known, though one more must be.
Eigen::Index up_to_gap(const Block_lanczos& lanczos, Eigen::Index number)
{
  for(Eigen::Index k = number; k < lanczos.number_of_good_ones(); ++k)
    if(lanczos.value(k) - lanczos.value(k - 1) > spectral_gap(std::size_t(k)) * lanczos.value(k))
      return k;
  return 0;
}

} // namespace

std::vector<bool> border_sites(const Glued_triangles& triangles)
{
  std::vector<bool> result(triangles.number_of_sites(), false);
  for(Index side = 0; side < triangles.twin.size(); ++side)
    if(triangles.twin[side] == none)
      result[triangles.corner[side]] = result[triangles.corner[next_side(side)]] = true;
  return result;
}

Eigenfunctions eigenfunctions(const Glued_triangles& triangles, const Operators& operators,
                              std::size_t number)
{
  const Inverse_operator inverse(triangles, operators);
  const Eigen::Index all = inverse.size() - inverse.constants().cols();
  const Eigen::Index wanted = Eigen::Index(std::min(number, std::size_t(all)));
  Eigenfunctions result;
  if(wanted == 0)
  {
    result.function.resize(Eigen::Index(operators.number_of_sites), 0);
    return result;
  }

  constexpr Eigen::Index block = 8; // as quick as 4, and half of the time of 32
  Block_lanczos lanczos(inverse);
  lanczos.expand(block);
  Eigen::Index chosen = 0, next = std::min(all, wanted + wanted / 2 + 2 * block);
  for(int recounts = 0; chosen == 0;)
  {
    while(lanczos.room() > 0 && lanczos.size() < next)
      lanczos.expand(0);
    next = lanczos.size() + lanczos.size() / 8 + block;
    lanczos.solve();
    chosen = lanczos.room() == 0 && wanted == all ? all : up_to_gap(lanczos, wanted);
    if(lanczos.room() == 0 && chosen == 0)
      chosen = all;
    if(chosen == 0 || chosen == all || recounts == 5)
      continue;
    // In the middle of the gap.
    const double between = 0.5 * (lanczos.value(chosen - 1) + lanczos.value(chosen));
    const Eigen::Index missing = inverse.number_below(between) - chosen;
    if(missing <= 0)
      continue;
    lanczos.expand(missing + block);
    chosen = 0;
    ++recounts;
  }

  result.value.resize(chosen);
  for(Eigen::Index i = 0; i < chosen; ++i)
    result.value[i] = lanczos.value(i);
  result.function = inverse.functions(lanczos.vectors(chosen), operators.number_of_sites);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
