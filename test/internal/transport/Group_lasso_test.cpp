// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Group_lasso.h"

#include "random_values.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace Group_lasso_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Two problems with a one-dimensional basis, in ten triangles.
struct Problems
{
  static constexpr Eigen::Index triangles = 10;

  Matrix basis, particular;
  Column<double> weight;

  Problems() : basis(2 * triangles, 1), particular(2 * triangles, 2), weight(triangles)
  {
    basis.col(0) = random_function(2 * triangles, 1).normalized();
    for(Eigen::Index j = 0; j < 2; ++j)
    {
      const Vector column = random_function(2 * triangles, unsigned(2 + j));
      particular.col(j) = column - basis.col(0).dot(column) * basis.col(0);
    }
    for(Eigen::Index f = 0; f < triangles; ++f)
      weight[f] = 0.5 + 0.1 * double(f);
  }

  double cost(Eigen::Index j, double coefficient) const
  {
    const Vector field = particular.col(j) + coefficient * basis.col(0);
    return (weight * lengths(field)).sum();
  }

  // By ternary search: the cost is convex.
  double minimum(Eigen::Index j) const
  {
    double low = -100., high = 100.;
    for(int i = 0; i < 200; ++i)
    {
      const double a = low + (high - low) / 3., b = high - (high - low) / 3.;
      (cost(j, a) < cost(j, b) ? high : low) = cost(j, a) < cost(j, b) ? b : a;
    }
    return cost(j, low);
  }
};

TEST(Group_lasso, bounds_converge_to_minimum)
{
  const Problems problems;
  Group_lasso<Matrix> solver(problems.basis, problems.weight, problems.particular);
  for(int i = 0; i < 2000; ++i)
  {
    solver.advance();
    for(Eigen::Index j = 0; j < 2; ++j)
    {
      EXPECT_LE(solver.lower(j), problems.minimum(j) + 1e-12); // round-off errors
      EXPECT_GE(solver.upper(j), problems.minimum(j) - 1e-12); // round-off errors of sums
    }
  }
  for(Eigen::Index j = 0; j < 2; ++j)
  {
    // A thousandth of the smallest tolerance that callers use.
    EXPECT_NEAR(solver.upper(j), problems.minimum(j), 1e-6);
    EXPECT_NEAR(solver.lower(j), problems.minimum(j), 1e-6);
  }
}

TEST(Group_lasso, removing_column_preserves_others)
{
  const Problems problems;
  Group_lasso<Matrix> both(problems.basis, problems.weight, problems.particular);
  Group_lasso<Matrix> second(problems.basis, problems.weight, problems.particular.col(1));
  both.advance();
  second.advance();
  both.remove_column(0);
  ASSERT_EQ(both.columns(), 1);
  both.advance();
  second.advance();
  EXPECT_NEAR(both.upper(0), second.upper(0), 1e-14); // sums in another order
  // Round-off errors of sums in a different order.
  EXPECT_NEAR(both.lower(0), second.lower(0), 1e-14);
}

} // namespace Group_lasso_test
