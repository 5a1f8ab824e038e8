// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/matrix.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "distances/rows.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

namespace CGAL::Geodesic_processing::internal {

namespace {

// for_each_row() by whatever engine it is.
template <typename Row>
bool for_each_row_of(const Row_engine& engine, std::size_t rows, const Front_limits& limits,
                     unsigned threads, const Row& row)
{
  return std::visit([&](const auto* kernel)
                    { return for_each_row(*kernel, rows, limits, threads, row); },
                    engine);
}

} // namespace

Eigen::MatrixXd distance_matrix(const Row_engine& engine, double scale,
                                const std::vector<Source>& from, const std::vector<Location>& to,
                                const Front_limits& limits, unsigned threads)
{
  Eigen::MatrixXd result(from.size(), to.size());
  const bool is_complete = for_each_row_of(
      engine, from.size(), limits, threads,
      [&](std::size_t row, auto& kernel, const Front_limits& row_limits)
      {
        kernel.run({from[row]}, row_limits);
        for(std::size_t column = 0; column < to.size(); ++column)
          result(Eigen::Index(row), Eigen::Index(column)) =
              scale * (to[column].triangle == none ? kernel.distance(to[column].site)
                                                   : kernel.distance(to[column]));
      });
  return is_complete ? result : Eigen::MatrixXd();
}

Eigen::SparseMatrix<double, Eigen::RowMajor>
sparse_distance_matrix(const Row_engine& engine, double scale, const std::vector<Source>& from,
                       const std::vector<Index>& column, const Front_limits& limits,
                       unsigned threads)
{
  using Entry = std::pair<Index, double>; // column, distance
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  constexpr std::size_t most_entries = (std::numeric_limits<int>::max)();

  std::vector<std::vector<Entry>> rows(from.size());
  std::atomic<std::size_t> entries{0}; // so far, of all rows
  const bool is_complete =
      for_each_row_of(engine, from.size(), limits, threads,
                      [&](std::size_t i, auto& kernel, const Front_limits& row_limits)
                      {
                        kernel.run({from[i]}, row_limits);
                        for(const Index site : kernel.reached())
                          if(column[site] != none)
                            rows[i].emplace_back(column[site], scale * kernel.distance(site));
                        std::sort(rows[i].begin(), rows[i].end());
                        if((entries += rows[i].size()) > most_entries)
                          throw Invalid_argument_error(
                              "More than 2^31 pairs of sites are within the maximum distance.");
                      });
  if(!is_complete)
    return Matrix();

  Matrix result(Eigen::Index(from.size()), Eigen::Index(from.size()));
  for(std::size_t i = 0; i < rows.size(); ++i)
    result.outerIndexPtr()[i + 1] = result.outerIndexPtr()[i] + static_cast<int>(rows[i].size());
  result.resizeNonZeros(Eigen::Index(entries));
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    int place = result.outerIndexPtr()[i];
    for(const auto& [one, distance] : rows[i])
    {
      result.innerIndexPtr()[place] = static_cast<int>(one);
      result.valuePtr()[place++] = distance;
    }
    std::vector<Entry>().swap(rows[i]);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
