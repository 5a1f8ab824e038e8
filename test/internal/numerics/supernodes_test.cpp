// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/supernodes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace supernodes_test {

using namespace CGAL::Geodesic_processing::internal;
using Eigen::MatrixXd;

// A random Cholesky factor. If a block has entries in rows below its first row, the block of that
// first row must have them, too.
struct Random_factor
{
  std::vector<int> permutation, column_begin{0}, row_begin{0}, entry_begin, row;
  std::vector<double> entry;
  MatrixXd dense;

  explicit Random_factor(const std::vector<int>& widths, unsigned seed)
  {
    std::mt19937 random(seed);
    const auto random_value = [&] { return double(random()) / double(random.max()) - 0.5; };
    const int n = std::accumulate(widths.begin(), widths.end(), 0);
    dense = MatrixXd::Zero(n, n);
    permutation.resize(std::size_t(n));
    std::iota(permutation.begin(), permutation.end(), 0);
    std::shuffle(permutation.begin(), permutation.end(), random);
    std::vector<std::vector<int>> fill_rows(widths.size()); // the rows of fill-in
    for(const int width : widths)
      column_begin.push_back(column_begin.back() + width);
    for(std::size_t b = 0; b < widths.size(); ++b)
    {
      std::vector<int> rows = fill_rows[b];
      for(int r = column_begin[b + 1]; r < n; ++r)
        if(random() % 4 == 0)
          rows.push_back(r);
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      if(!rows.empty())
      {
        const auto next =
            std::size_t(std::upper_bound(column_begin.begin(), column_begin.end(), rows.front()) -
                        column_begin.begin() - 1);
        for(const int r : rows)
          if(r >= column_begin[next + 1])
            fill_rows[next].push_back(r);
      }
      std::vector<int> own_columns(column_begin[b + 1] - column_begin[b]);
      std::iota(own_columns.begin(), own_columns.end(), column_begin[b]);
      rows.insert(rows.begin(), own_columns.begin(), own_columns.end());
      entry_begin.push_back(int(entry.size()));
      for(const int c : own_columns)
        for(const int r : rows)
        {
          if(r < c) // not to be read: above the diagonal
          {
            entry.push_back(std::numeric_limits<double>::quiet_NaN());
            continue;
          }
          entry.push_back(r == c ? 2. + random_value() : random_value() / double(n));
          dense(r, c) = entry.back();
        }
      row.insert(row.end(), rows.begin(), rows.end());
      row_begin.push_back(int(row.size()));
    }
  }

  Supernodes supernodes() const
  {
    return {permutation.size(), column_begin.size() - 1, permutation.data(), column_begin.data(),
            row_begin.data(),   entry_begin.data(),      row.data(),         entry.data()};
  }

  MatrixXd solve(const MatrixXd& rhs) const
  {
    const Eigen::Map<const Eigen::VectorXi> indices(permutation.data(),
                                                    Eigen::Index(permutation.size()));
    const auto lower = dense.triangularView<Eigen::Lower>();
    const MatrixXd permuted_solution =
        lower.transpose().solve(lower.solve(rhs(indices, Eigen::all)));
    MatrixXd result(rhs.rows(), rhs.cols());
    result(indices, Eigen::all) = permuted_solution;
    return result;
  }
};

// Round-off errors of well-conditioned systems, whose solutions are sums of at most a hundred
// numbers.
constexpr double round_off = 1e-13;

TEST(Supernodes, matches_dense_solve)
{
  std::vector<double> workspace;
  unsigned seed = 0;
  for(const std::vector<int>& widths : std::vector<std::vector<int>>{
          {1}, {9}, {1, 1, 1}, {3, 2, 6, 1, 4}, {4, 8, 12, 5, 1, 1, 2, 7, 30}})
    for(const int number_of_columns : {1, 3, 8, 31, 32, 33, 70})
    {
      const Random_factor factor(widths, ++seed);
      std::srand(seed); // the generator that Eigen uses
      const MatrixXd rhs = MatrixXd::Random(factor.dense.rows(), number_of_columns);
      MatrixXd columns = rhs;
      substitute(factor.supernodes(), columns.data(), std::size_t(number_of_columns), workspace);
      EXPECT_LT((columns - factor.solve(rhs)).lpNorm<Eigen::Infinity>(), round_off);
    }
}

TEST(Supernodes, solves_unit_vectors)
{
  const Random_factor factor({4, 8, 3, 5, 1, 1, 2, 7, 30}, 5);
  std::vector<double> workspace;
  const MatrixXd inverse = factor.solve(MatrixXd::Identity(61, 61));
  for(Eigen::Index i = 0; i < 61; ++i)
  {
    MatrixXd column = MatrixXd::Identity(61, 61).col(i);
    substitute(factor.supernodes(), column.data(), 1, workspace);
    EXPECT_LT((column - inverse.col(i)).lpNorm<Eigen::Infinity>(), round_off);
  }
}

TEST(Supernodes, columns_are_solved_independently)
{
  const Random_factor factor({4, 8, 3, 5, 1, 1, 2, 7, 30}, 6);
  std::vector<double> workspace;
  std::srand(1); // the generator that Eigen uses
  MatrixXd all_at_once = MatrixXd::Random(61, 45);
  MatrixXd one_by_one = all_at_once;
  substitute(factor.supernodes(), all_at_once.data(), 45, workspace);
  for(Eigen::Index j = 0; j < 45; ++j)
    substitute(factor.supernodes(), one_by_one.col(j).data(), 1, workspace);
  EXPECT_EQ(one_by_one, all_at_once);
}

} // namespace supernodes_test
