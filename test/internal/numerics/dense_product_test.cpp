// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>

#include <gtest/gtest.h>

#include <limits>

namespace dense_product_test {

using namespace CGAL::Geodesic_processing::internal;

template <typename Matrix_type>
void expect_products(Eigen::Index rows, Eigen::Index inner, Eigen::Index columns)
{
  using Scalar = typename Matrix_type::Scalar;
  std::srand(1); // the generator that Eigen uses
  const Matrix_type a = Matrix_type::Random(rows, inner), b = Matrix_type::Random(inner, columns);
  const Matrix_type a_transposed = a.transpose(), expected = a.lazyProduct(b);
  Matrix_type result;
  // The sums of `inner` products of numbers below one are computed in another order.
  const Scalar round_off = Scalar(inner + 1) * std::numeric_limits<Scalar>::epsilon();
  product(a, b, result);
  ASSERT_EQ(result.rows(), rows);
  ASSERT_EQ(result.cols(), columns);
  EXPECT_TRUE(result.size() == 0 || (result - expected).cwiseAbs().maxCoeff() <= round_off);
  transposed_product(a_transposed, b, result);
  ASSERT_EQ(result.rows(), rows);
  ASSERT_EQ(result.cols(), columns);
  EXPECT_TRUE(result.size() == 0 || (result - expected).cwiseAbs().maxCoeff() <= round_off);
}

TEST(Dense_product, accepts_column_blocks)
{
  std::srand(1);
  const Matrix a = Matrix::Random(9, 7), b = Matrix::Random(9, 5);
  Matrix result;
  transposed_product(a.leftCols(3), b.middleCols(1, 2), result);
  const Matrix expected = a.leftCols(3).transpose().lazyProduct(b.middleCols(1, 2));
  // sums of nine products of numbers below one
  EXPECT_LT((result - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Dense_product, matches_eigen)
{
  for(const auto& [rows, inner, columns] :
      {std::array<int, 3>{7, 5, 3}, {1, 1, 1}, {300, 40, 17}, {40, 300, 1}, {0, 4, 4}, {4, 0, 4}})
  {
    expect_products<Matrix>(rows, inner, columns);
    expect_products<Float_matrix>(rows, inner, columns);
  }
}

} // namespace dense_product_test
