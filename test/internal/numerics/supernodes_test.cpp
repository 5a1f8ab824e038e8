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

namespace {

using namespace CGAL::Geodesic_processing::internal;
using Eigen::MatrixXd;

// A random factor: what a block has below its first row there, the block of that row has too.
struct Random_factor
{
  std::vector<int> order, first{0}, first_row{0}, first_entry, row;
  std::vector<double> entry;
  MatrixXd dense;

  explicit Random_factor(const std::vector<int>& widths, unsigned seed)
  {
    std::mt19937 random(seed);
    const auto any = [&] { return double(random()) / double(random.max()) - 0.5; };
    const int n = std::accumulate(widths.begin(), widths.end(), 0);
    dense = MatrixXd::Zero(n, n);
    order.resize(std::size_t(n));
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    std::vector<std::vector<int>> from_before(widths.size()); // rows that filling brings
    for(const int width : widths)
      first.push_back(first.back() + width);
    for(std::size_t b = 0; b < widths.size(); ++b)
    {
      std::vector<int> rows = from_before[b];
      for(int r = first[b + 1]; r < n; ++r)
        if(random() % 4 == 0)
          rows.push_back(r);
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      if(!rows.empty())
      {
        const auto next = std::size_t(std::upper_bound(first.begin(), first.end(), rows.front()) -
                                      first.begin() - 1);
        for(const int r : rows)
          if(r >= first[next + 1])
            from_before[next].push_back(r);
      }
      std::vector<int> own(first[b + 1] - first[b]);
      std::iota(own.begin(), own.end(), first[b]);
      rows.insert(rows.begin(), own.begin(), own.end());
      first_entry.push_back(int(entry.size()));
      for(const int c : own)
        for(const int r : rows)
        {
          if(r < c) // must not be read
          {
            entry.push_back(std::numeric_limits<double>::quiet_NaN());
            continue;
          }
          entry.push_back(r == c ? 2. + any() : any() / double(n));
          dense(r, c) = entry.back();
        }
      row.insert(row.end(), rows.begin(), rows.end());
      first_row.push_back(int(row.size()));
    }
  }

  Supernodes supernodes() const
  {
    return {order.size(),     first.size() - 1,   order.data(), first.data(),
            first_row.data(), first_entry.data(), row.data(),   entry.data()};
  }

  MatrixXd solve(const MatrixXd& right) const
  {
    const Eigen::Map<const Eigen::VectorXi> places(order.data(), Eigen::Index(order.size()));
    const auto lower = dense.triangularView<Eigen::Lower>();
    const MatrixXd solved = lower.transpose().solve(lower.solve(right(places, Eigen::all)));
    MatrixXd result(right.rows(), right.cols());
    result(places, Eigen::all) = solved;
    return result;
  }
};

// Of well-conditioned systems, whose solutions are sums of a hundred numbers at most.
constexpr double rounding = 1e-13;

TEST(Supernodes, solve_as_dense_matrices_do)
{
  std::vector<double> space;
  unsigned seed = 0;
  for(const std::vector<int>& widths : std::vector<std::vector<int>>{
          {1}, {9}, {1, 1, 1}, {3, 2, 6, 1, 4}, {4, 8, 12, 5, 1, 1, 2, 7, 30}})
    for(const int number : {1, 3, 8, 31, 32, 33, 70})
    {
      const Random_factor factor(widths, ++seed);
      std::srand(seed); // Eigen's random values
      const MatrixXd right = MatrixXd::Random(factor.dense.rows(), number);
      MatrixXd columns = right;
      substitute(factor.supernodes(), columns.data(), std::size_t(number), space);
      EXPECT_LT((columns - factor.solve(right)).lpNorm<Eigen::Infinity>(), rounding);
    }
}

TEST(Supernodes, solve_right_sides_with_a_single_entry)
{
  const Random_factor factor({4, 8, 3, 5, 1, 1, 2, 7, 30}, 5);
  std::vector<double> space;
  const MatrixXd all = factor.solve(MatrixXd::Identity(61, 61));
  for(Eigen::Index i = 0; i < 61; ++i)
  {
    MatrixXd column = MatrixXd::Identity(61, 61).col(i);
    substitute(factor.supernodes(), column.data(), 1, space);
    EXPECT_LT((column - all.col(i)).lpNorm<Eigen::Infinity>(), rounding);
  }
}

TEST(Supernodes, give_a_column_the_same_in_whatever_company)
{
  const Random_factor factor({4, 8, 3, 5, 1, 1, 2, 7, 30}, 6);
  std::vector<double> space;
  std::srand(1); // Eigen's random values
  MatrixXd together = MatrixXd::Random(61, 45);
  MatrixXd alone = together;
  substitute(factor.supernodes(), together.data(), 45, space);
  for(Eigen::Index j = 0; j < 45; ++j)
    substitute(factor.supernodes(), alone.col(j).data(), 1, space);
  EXPECT_EQ(alone, together);
}

} // namespace
