// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/distance_matrix.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "distances/for_each_row.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Calls for_each_row() with the type of the engine.
template <typename Row>
bool for_each_row_with(const Row_engine& engine, std::size_t number_of_rows,
                       const Front_limits& limits, unsigned number_of_threads, const Row& row)
{
  return std::visit(
      [&](const auto* row_engine)
      { return for_each_row(*row_engine, number_of_rows, limits, number_of_threads, row); },
      engine);
}

} // namespace

Eigen::MatrixXd distance_matrix(const Row_engine& engine, double scale,
                                const std::vector<Front_source>& from,
                                const std::vector<Surface_location>& to, const Front_limits& limits,
                                unsigned number_of_threads)
{
  Eigen::MatrixXd result(from.size(), to.size());
  const bool is_complete = for_each_row_with(
      engine, from.size(), limits, number_of_threads,
      [&](std::size_t row, auto& row_engine, const Front_limits& row_limits)
      {
        row_engine.run({from[row]}, row_limits);
        for(std::size_t column = 0; column < to.size(); ++column)
          result(Eigen::Index(row), Eigen::Index(column)) =
              scale * (to[column].triangle == none ? row_engine.distance(to[column].vertex)
                                                   : row_engine.distance(to[column]));
      });
  if(!is_complete)
    return {};
  return result;
}

Eigen::SparseMatrix<double, Eigen::RowMajor>
sparse_distance_matrix(const Row_engine& engine, double scale,
                       const std::vector<Front_source>& from, const std::vector<Index>& column,
                       const Front_limits& limits, unsigned number_of_threads)
{
  using Entry = std::pair<Index, double>; // column, distance
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  constexpr std::size_t max_entries = (std::numeric_limits<int>::max)();

  std::vector<std::vector<Entry>> rows(from.size());
  std::atomic<std::size_t> number_of_entries{0}; // of all rows computed so far
  const bool is_complete = for_each_row_with(
      engine, from.size(), limits, number_of_threads,
      [&](std::size_t i, auto& row_engine, const Front_limits& row_limits)
      {
        row_engine.run({from[i]}, row_limits);
        for(const Index vertex : row_engine.reached())
          if(column[vertex] != none)
            rows[i].emplace_back(column[vertex], scale * row_engine.distance(vertex));
        std::sort(rows[i].begin(), rows[i].end());
        if((number_of_entries += rows[i].size()) > max_entries)
          throw Invalid_argument_error(
              "More than 2^31 pairs of vertices are within the maximum distance.");
      });
  if(!is_complete)
    return Matrix();

  Matrix result(Eigen::Index(from.size()), Eigen::Index(from.size()));
  for(std::size_t i = 0; i < rows.size(); ++i)
    result.outerIndexPtr()[i + 1] = result.outerIndexPtr()[i] + static_cast<int>(rows[i].size());
  result.resizeNonZeros(Eigen::Index(number_of_entries));
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    int entry_index = result.outerIndexPtr()[i];
    for(const auto& [col, distance] : rows[i])
    {
      result.innerIndexPtr()[entry_index] = static_cast<int>(col);
      result.valuePtr()[entry_index++] = distance;
    }
    std::vector<Entry>().swap(rows[i]);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
