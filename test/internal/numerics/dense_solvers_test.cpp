// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/dense_solvers.h"

#include <gtest/gtest.h>

namespace dense_solvers_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(eigen_system, diagonalizes_a_symmetric_matrix)
{
  for(const Eigen::Index n : {1, 2, 3, 20})
  {
    // The second differences of n points, whose eigenvalues are known.
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
    matrix.diagonal().setConstant(2.);
    matrix.diagonal(-1).setConstant(-1.);
    matrix.diagonal(1).setConstant(-1.);
    const Eigen_system found = eigen_system(matrix);
    for(Eigen::Index k = 0; k < n; ++k)
      // Sums of n products.
      EXPECT_NEAR(found.values[k], 2. - 2. * std::cos(EIGEN_PI * double(k + 1) / double(n + 1)),
                  1e-14 * double(n)); // round-off errors
    const Eigen::MatrixXd product =
        found.vectors * found.values.asDiagonal() * found.vectors.transpose();
    // Round-off errors of sums of n products.
    EXPECT_LT((product - matrix).cwiseAbs().maxCoeff(), 1e-14 * double(n));
  }
}

TEST(eigen_system, reads_only_the_lower_triangle)
{
  Eigen::MatrixXd matrix(2, 2);
  matrix << 1., 100., 2., 1.;
  EXPECT_NEAR(eigen_system(matrix).values[0], -1., 1e-15); // round-off errors of a few operations
  EXPECT_NEAR(eigen_system(matrix).values[1], 3., 1e-15);  // round-off errors of a few operations
}

TEST(Symmetric_solver, solves_for_each_column)
{
  Eigen::MatrixXd matrix(2, 2), rhs(2, 2), expected(2, 2);
  matrix << 4., 0., 1., 2.; // the upper triangle is ignored
  expected << 1., 3., 2., -1.;
  rhs << 6., 11., 5., 1.;
  // Round-off errors of a few operations.
  EXPECT_LT((Symmetric_solver(matrix).solve(rhs) - expected).norm(), 1e-14);
}

TEST(small_product, multiplies_blocks)
{
  Eigen::MatrixXd a(2, 3), b(2, 1);
  a << 1., 2., 3., 4., 5., 6.;
  b << 1., -1.;
  EXPECT_EQ(small_product(a.leftCols(2), b), Eigen::Vector2d(-1., -1.));
  EXPECT_EQ(small_transposed_product(a.rightCols(2), b), Eigen::Vector2d(-3., -3.));
}

} // namespace dense_solvers_test
