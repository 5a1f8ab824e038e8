// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace Sparse_solver_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;

// Returns the lower triangle of a matrix with 2 + shift on the diagonal and -1 / width on as many
// subdiagonals as its width.
Sparse_matrix band_matrix(int n, int width, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, i, 2. + shift);
    for(int j = std::max(0, i - width); j < i; ++j)
      entries.emplace_back(i, j, -1. / width);
  }
  Sparse_matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

constexpr int n = 1000;
// The factorization proceeds by columns for the first width, and by blocks of columns for the
// second.
constexpr int widths[] = {1, 100};

TEST(Sparse_solver, has_small_residual)
{
  std::mt19937 random(1);
  for(const int width : widths)
  {
    const Sparse_matrix matrix = band_matrix(n, width, 1e-3);
    const Sparse_solver solver(matrix);
    for(int i = 0; i < 5; ++i)
    {
      Vector rhs(n);
      for(double& x : rhs)
        x = double(random()) / double(random.max()) - 0.5;
      const Vector x = solver.solve(rhs);
      const Vector residual = matrix.selfadjointView<Eigen::Lower>() * x - rhs;
      // A backward stable solver leaves a residual of round-off errors of |A| |x|.
      EXPECT_LT(residual.norm(), 1e-14 * 4. * x.norm());
    }
  }
}

TEST(Sparse_solver, column_solves_match_single_solves)
{
  std::srand(1); // the generator that Eigen uses
  for(const int width : widths)
  {
    const Sparse_solver solver(band_matrix(n, width, 1e-3));
    for(const int number_of_columns : {1, 7, 40, 7})
    {
      const Eigen::MatrixXd rhs = Eigen::MatrixXd::Random(n, number_of_columns);
      Eigen::MatrixXd columns = rhs;
      solver.solve_columns(columns);
      for(int j = 0; j < number_of_columns; ++j)
      {
        const Vector x = solver.solve(rhs.col(j));
        // The sums of some thousand terms are computed in another order.
        EXPECT_LT((columns.col(j) - x).norm(), 1e-11 * x.norm());
      }
    }
  }
}

TEST(Sparse_solver, refactorizes_matrix_of_same_pattern)
{
  const Vector rhs = Vector::Ones(n);
  for(const int width : widths)
    for(const Elimination_order order : {Elimination_order::fast, Elimination_order::low_fill})
    {
      const Sparse_solver original(band_matrix(n, width, 1.), order);
      Sparse_solver copy = original;
      EXPECT_FALSE(copy.factorize(band_matrix(n, width, -3.)));
      EXPECT_TRUE(copy.factorize(band_matrix(n, width, 2.)));
      EXPECT_EQ(original.solve(rhs), Sparse_solver(band_matrix(n, width, 1.), order).solve(rhs));
      EXPECT_EQ(copy.solve(rhs), Sparse_solver(band_matrix(n, width, 2.), order).solve(rhs));
    }
}

TEST(Sparse_solver, solves_concurrently)
{
  const Vector rhs = Vector::Ones(n);
  for(const int width : widths)
  {
    const Sparse_solver solver(band_matrix(n, width, 1e-3));
    const Vector expected = solver.solve(rhs);
    std::vector<Vector> solutions(100);
    for_each_block(solutions.size(), 1, 4,
                   [&](std::size_t block, std::size_t, std::size_t)
                   { solutions[block] = solver.solve(rhs); });
    for(const Vector& x : solutions)
      EXPECT_EQ(x, expected);
  }
}

// Orderings by METIS depend on rand(), whose state all threads share. Orderings of large regular
// grids differ then.
TEST(Sparse_solver, factorizations_do_not_depend_on_concurrent_ones)
{
  constexpr int side = 120;
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < side * side; ++i)
  {
    entries.emplace_back(i, i, 6.01); // more than the sum of the others
    if(i % side > 0)
      entries.emplace_back(i, i - 1, -1.);
    if(i >= side)
      entries.emplace_back(i, i - side, -1.);
    if(i >= side && i % side > 0)
      entries.emplace_back(i, i - side - 1, -1.);
  }
  Sparse_matrix grid(side * side, side * side);
  grid.setFromTriplets(entries.begin(), entries.end());
  const Vector rhs = Vector::LinSpaced(side * side, 0., 1.);
  const Vector expected = Sparse_solver(grid, Elimination_order::low_fill).solve(rhs);
  std::vector<int> is_equal(8, 0);
  for_each_block(is_equal.size(), 1, 3,
                 [&](std::size_t i, std::size_t, std::size_t) {
                   is_equal[i] =
                       Sparse_solver(grid, Elimination_order::low_fill).solve(rhs) == expected;
                 });
  EXPECT_EQ(is_equal, std::vector<int>(8, 1));
}

TEST(Sparse_solver, throws_on_indefinite_matrix)
{
  for(const int width : widths)
    EXPECT_THROW(Sparse_solver(band_matrix(n, width, -3.)), Unsupported_surface_error);
}

} // namespace Sparse_solver_test
