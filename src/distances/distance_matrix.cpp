// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/distance_matrix.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "distances/for_each_row.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
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

namespace {

// A hash of a sequence of numbers (Fowler, Noll and Vo, with words instead of bytes).
class Hash
{
public:
  void add(std::uint64_t word)
  {
    m_value = (m_value ^ word) * 0x100000001b3u;
    m_value ^= m_value >> 32;
  }
  void add(double number)
  {
    std::uint64_t word;
    std::memcpy(&word, &number, sizeof word);
    add(word);
  }
  void add(Index index) { add(std::uint64_t{index}); }
  void add(const std::array<double, 3>& numbers)
  {
    for(const double x : numbers)
      add(x);
  }
  void add(const Surface_location& location)
  {
    add(location.triangle);
    add(location.vertex);
    add(location.barycentric);
  }
  template <typename T>
  void add(const std::vector<T>& values)
  {
    add(std::uint64_t{values.size()});
    for(const T& value : values)
      add(value);
  }
  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 0xcbf29ce484222325u;
};

// Writes the distances of a row, or those of its regions, in the format of a file.
class Row_writer
{
public:
  Row_writer(const Matrix_job& job, Number_format format) : m_job(job), m_format(format)
  {
    if(!job.regions)
      return;
    m_region_size.assign(job.regions->number_of_regions, 0);
    for(const Index region : job.regions->region)
      if(region != none)
        ++m_region_size[region];
  }

  // distance: maps a column before regions are joined to a distance
  template <typename Distance>
  void write(const Distance& distance, char* out) const
  {
    const std::size_t number_of_columns = m_job.to.size();
    if(!m_job.regions)
    {
      for(std::size_t column = 0; column < number_of_columns; ++column)
        put(distance(column), column, out);
      return;
    }
    const bool do_average = m_job.regions->do_average;
    std::vector<double> values(m_region_size.size(), do_average ? 0. : infinity);
    for(std::size_t column = 0; column < number_of_columns; ++column)
    {
      const Index region = m_job.regions->region[column];
      if(region == none)
        continue;
      double& value = values[region];
      value = do_average ? value + distance(column) : std::min(value, distance(column));
    }
    for(std::size_t region = 0; region < values.size(); ++region)
      put(m_region_size[region] == 0 ? infinity
          : do_average               ? values[region] / double(m_region_size[region])
                                     : values[region],
          region, out);
  }

private:
  void put(double value, std::size_t column, char* out) const
  {
    if(m_format == Number_format::float64)
      std::memcpy(out + column * sizeof value, &value, sizeof value);
    else
    {
      if(value > double((std::numeric_limits<float>::max)()) && value < infinity)
        throw Invalid_argument_error("A distance is too large for numbers of 32 bits. Write "
                                     "numbers of 64 bits.");
      const float single = static_cast<float>(value);
      std::memcpy(out + column * sizeof single, &single, sizeof single);
    }
  }

  const Matrix_job& m_job;
  Number_format m_format;
  std::vector<std::size_t> m_region_size; // #regions
};

} // namespace

Matrix_key matrix_key(const Surface_arrays& triangles, Distance_method method,
                      std::optional<double> heat_time_step, const Matrix_job& job,
                      const Front_limits& limits)
{
  Hash surface;
  surface.add(triangles.corner);
  surface.add(triangles.length);
  surface.add(triangles.scale);
  surface.add(triangles.point);
  surface.add(triangles.graph.target);

  Hash arguments;
  arguments.add(std::uint64_t(method));
  arguments.add(heat_time_step.value_or(-1.));
  for(const Front_source& source : job.from)
  {
    arguments.add(source.polyline);
    arguments.add(source.offset);
  }
  arguments.add(job.to);
  if(job.regions)
  {
    arguments.add(job.regions->region);
    arguments.add(std::uint64_t(job.regions->do_average));
  }
  arguments.add(limits.maximum_distance);
  arguments.add(limits.relative_tolerance);
  if(limits.slowness)
    arguments.add(*limits.slowness);
  return {surface.value(), arguments.value()};
}

bool write_distance_matrix(const Row_engine& engine, double scale, const Matrix_job& job,
                           const Front_limits& limits, unsigned number_of_threads,
                           Matrix_file& file)
try
{
  const Row_writer writer(job, file.layout().format);
  const std::size_t row_size = file.layout().row_size();
  std::vector<char> rows;
  for(std::size_t tile = 0; tile < file.number_of_tiles(); ++tile)
  {
    if(file.is_finished(tile))
      continue;
    const std::size_t begin = file.first_row(tile), number_of_rows = file.end_row(tile) - begin;
    rows.resize(number_of_rows * row_size);
    Front_limits tile_limits = limits;
    if(limits.callback)
      tile_limits.callback = [&, begin](double fraction)
      {
        return limits.callback((double(begin) + fraction * double(number_of_rows)) /
                               double(file.layout().rows));
      };
    const bool is_complete =
        for_each_row_with(engine, number_of_rows, tile_limits, number_of_threads,
                          [&](std::size_t row, auto& row_engine, const Front_limits& row_limits)
                          {
                            row_engine.run({job.from[job.first_row + begin + row]}, row_limits);
                            const auto distance = [&](std::size_t column)
                            {
                              const Surface_location& to = job.to[column];
                              return scale * (to.triangle == none ? row_engine.distance(to.vertex)
                                                                  : row_engine.distance(to));
                            };
                            writer.write(distance, rows.data() + row * row_size);
                          });
    if(!is_complete)
      return false;
    file.write(tile, rows);
  }
  file.finish();
  return true;
}
catch(const Invalid_argument_error&)
{
  file.discard(); // no later call could finish it
  throw;
}

} // namespace CGAL::Geodesic_processing::internal
