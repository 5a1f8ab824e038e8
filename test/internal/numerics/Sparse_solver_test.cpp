// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;

// The lower triangle of 2 + shift on the diagonal and -1 beside it.
Sparse_matrix chain(int n, double shift)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < n; ++i)
  {
    entries.emplace_back(i, i, 2. + shift);
    if(i > 0)
      entries.emplace_back(i, i - 1, -1.);
  }
  Sparse_matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(Sparse_solver, leaves_a_small_residual)
{
  const int n = 1000;
  const Sparse_matrix matrix = chain(n, 1e-3);
  const Sparse_solver solver(matrix);
  std::mt19937 random(1);
  for(int i = 0; i < 5; ++i)
  {
    Vector right(n);
    for(double& x : right)
      x = double(random()) / double(random.max()) - 0.5;
    const Vector x = solver.solve(right);
    const Vector residual = matrix.selfadjointView<Eigen::Lower>() * x - right;
    // Backward stable: roundings of |A| |x|.
    EXPECT_LT(residual.norm(), 1e-14 * 4. * x.norm());
  }
}

TEST(Sparse_solver, solves_for_columns_as_for_one)
{
  const int n = 1000;
  const Sparse_solver solver(chain(n, 1e-3));
  std::srand(1); // Eigen's random values
  for(const int number : {1, 7, 40, 7})
  {
    const Eigen::MatrixXd right = Eigen::MatrixXd::Random(n, number);
    Eigen::MatrixXd columns = right;
    solver.solve_columns(columns);
    for(int j = 0; j < number; ++j)
    {
      const Vector x = solver.solve(right.col(j));
      // Another order of some thousand sums.
      EXPECT_LT((columns.col(j) - x).norm(), 1e-11 * x.norm());
    }
  }
}

TEST(Sparse_solver, factorizes_again_what_has_the_same_pattern)
{
  const int n = 1000;
  const Vector right = Vector::Ones(n);
  for(const Elimination elimination : {Elimination::quick, Elimination::sparse})
  {
    const Sparse_solver first(chain(n, 1.), elimination);
    Sparse_solver second = first;
    EXPECT_FALSE(second.factorize(chain(n, -3.)));
    EXPECT_TRUE(second.factorize(chain(n, 2.)));
    EXPECT_EQ(first.solve(right), Sparse_solver(chain(n, 1.), elimination).solve(right));
    EXPECT_EQ(second.solve(right), Sparse_solver(chain(n, 2.), elimination).solve(right));
  }
}

TEST(Sparse_solver, solves_in_threads)
{
  const Sparse_solver solver(chain(1000, 1e-3));
  const Vector right = Vector::Ones(1000), expected = solver.solve(right);
  std::vector<Vector> found(100);
  for_each_block(found.size(), 1, 4,
                 [&](std::size_t block, std::size_t, std::size_t)
                 { found[block] = solver.solve(right); });
  for(const Vector& x : found)
    EXPECT_EQ(x, expected);
}

TEST(Sparse_solver, refuses_a_matrix_that_is_not_definite)
{
  EXPECT_THROW(Sparse_solver(chain(10, -3.)), Unsupported_surface_error);
}

} // namespace
