// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/write_distance_matrix.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "distances/for_each_row.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <variant>

namespace CGAL::Geodesic_processing::internal {

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

void add_regions(const std::optional<Matrix_regions>& regions, Hash& hash)
{
  hash.add(std::uint64_t{regions.has_value()});
  if(regions)
    hash.add(regions->region);
}

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
  surface.add(triangles.graph.length);

  Hash arguments;
  arguments.add(std::uint64_t(method));
  arguments.add(heat_time_step.value_or(-1.));
  for(const Front_source& source : job.from)
  {
    arguments.add(source.polyline);
    arguments.add(source.offset);
  }
  arguments.add(job.to);
  add_regions(job.row_regions, arguments);
  add_regions(job.column_regions, arguments);
  arguments.add(std::uint64_t{job.do_average});
  arguments.add(limits.maximum_distance);
  arguments.add(limits.relative_tolerance);
  if(limits.slowness)
    arguments.add(*limits.slowness);
  return {surface.value(), arguments.value()};
}

namespace {

// Returns the number of rows or columns of each region.
std::vector<std::size_t> region_sizes(const Matrix_regions& regions)
{
  std::vector<std::size_t> result(regions.number_of_regions, 0);
  for(const Index region : regions.region)
    if(region != none)
      ++result[region];
  return result;
}

struct Overflow_error : Invalid_argument_error
{
  Overflow_error()
      : Invalid_argument_error(
            "A distance is too large for numbers of 32 bits. Write numbers of 64 bits.")
  {}
};

void put_number(double value, Number_format format, std::size_t column, char* row)
{
  if(format == Number_format::float64)
  {
    std::memcpy(row + column * sizeof value, &value, sizeof value);
    return;
  }
  if(value > double((std::numeric_limits<float>::max)()) && value < infinity)
    throw Overflow_error();
  const float single = static_cast<float>(value);
  std::memcpy(row + column * sizeof single, &single, sizeof single);
}

// Computes the rows of a matrix.
template <typename Engine>
class Row_computation
{
public:
  // batch_size: bytes of the distances from the sources of a region that are averaged at a time
  Row_computation(const Engine& engine, double scale, const Matrix_job& job,
                  const Front_limits& limits, unsigned number_of_threads,
                  const Matrix_layout& layout, std::size_t batch_size)
      : m_engines(engine), m_scale(scale), m_job(job), m_limits(limits),
        m_number_of_threads(number_of_threads), m_layout(layout), m_batch_size(batch_size)
  {
    if(job.column_regions)
      m_column_size = region_sizes(*job.column_regions);
    if(!job.row_regions)
      return;
    const std::vector<std::size_t> sizes = region_sizes(*job.row_regions);
    m_row_sources.resize(sizes.size());
    for(std::size_t region = 0; region < sizes.size(); ++region)
      m_row_sources[region].reserve(sizes[region]);
    for(std::size_t i = 0; i < job.from.size(); ++i)
      if(const Index region = job.row_regions->region[i]; region != none)
        m_row_sources[region].push_back(job.from[i]);
  }

  // Computes consecutive rows of the layout and writes them at distances of `stride` bytes. Returns
  // false if cancelled.
  bool compute(std::size_t begin, std::size_t end, char* rows, std::ptrdiff_t stride)
  {
    const auto address = [=](std::size_t row)
    { return rows + std::ptrdiff_t(row - begin) * stride; };
    if(!m_job.row_regions || !m_job.do_average)
      return run(begin, end - begin, end - begin,
                 [&](std::size_t i, Engine& engine, const Front_limits& limits)
                 {
                   const std::vector<double> values =
                       joined_distances(sources_of_row(begin + i), engine, limits);
                   write(values, 1, address(begin + i));
                 });
    for(std::size_t row = begin; row < end; ++row)
      if(!compute_mean(row, address(row)))
        return false;
    return true;
  }

private:
  // Calls body(i, engine, limits) for i < size, on several threads. The callback receives the
  // fraction of the matrix if that are `number_of_rows` rows.
  template <typename Body>
  bool run(std::size_t first_row, std::size_t number_of_rows, std::size_t size, const Body& body)
  {
    Front_limits limits = m_limits;
    if(m_limits.callback)
      limits.callback = [&](double fraction)
      {
        return m_limits.callback((double(first_row) + fraction * double(number_of_rows)) /
                                 double(m_layout.rows));
      };
    return for_each_row(m_engines, size, limits, m_number_of_threads, body);
  }

  std::vector<Front_source> sources_of_row(std::size_t row) const
  {
    row += m_layout.first_row;
    return m_job.row_regions ? m_row_sources[row] : std::vector<Front_source>{m_job.from[row]};
  }

  // Returns the distances of each column, or their sums or minima of each region.
  std::vector<double> joined_distances(const std::vector<Front_source>& sources, Engine& engine,
                                       const Front_limits& limits) const
  {
    std::vector<double> result(m_job.number_of_columns(),
                               m_job.column_regions && m_job.do_average ? 0. : infinity);
    if(sources.empty())
      return result;
    engine.run(sources, limits);
    for(std::size_t column = 0; column < m_job.to.size(); ++column)
    {
      const Index region =
          m_job.column_regions ? m_job.column_regions->region[column] : static_cast<Index>(column);
      if(region == none)
        continue;
      const Surface_location& to = m_job.to[column];
      const double distance =
          m_scale * (to.triangle == none ? engine.distance(to.vertex) : engine.distance(to));
      double& value = result[region];
      if(!m_job.column_regions)
        value = distance;
      else
        value = m_job.do_average ? value + distance : std::min(value, distance);
    }
    return result;
  }

  // Writes the mean of the distances from the sources of a region. The sum is in the order of the
  // sources, so that it does not depend on the number of threads.
  bool compute_mean(std::size_t row, char* out)
  {
    const std::vector<Front_source> sources = sources_of_row(row);
    std::vector<double> sum(m_job.number_of_columns(), 0.);
    const std::size_t bytes = std::max<std::size_t>(1, sum.size() * sizeof(double)),
                      batch_size = std::max<std::size_t>(1, m_batch_size / bytes);
    std::vector<std::vector<double>> batch;
    for(std::size_t begin = 0; begin < sources.size(); begin += batch_size)
    {
      batch.resize(std::min(batch_size, sources.size() - begin));
      const bool is_complete =
          run(row, 1, batch.size(),
              [&](std::size_t i, Engine& engine, const Front_limits& limits)
              { batch[i] = joined_distances({sources[begin + i]}, engine, limits); });
      if(!is_complete)
        return false;
      for(const std::vector<double>& values : batch)
        for(std::size_t column = 0; column < sum.size(); ++column)
          sum[column] += values[column];
    }
    write(sum, sources.size(), out);
    return true;
  }

  // Writes a row in the format of the file. If the regions are averaged, divides its values by the
  // number of pairs.
  void write(const std::vector<double>& values, std::size_t number_of_sources, char* out) const
  {
    for(std::size_t column = 0; column < values.size(); ++column)
    {
      const std::size_t count =
          number_of_sources * (m_column_size.empty() ? 1 : m_column_size[column]);
      const double value = count == 0         ? infinity
                           : m_job.do_average ? values[column] / double(count)
                                              : values[column];
      put_number(value, m_layout.format, column, out);
    }
  }

  Engine_pool<Engine> m_engines;
  double m_scale;
  const Matrix_job& m_job;
  const Front_limits& m_limits;
  unsigned m_number_of_threads;
  const Matrix_layout& m_layout;
  std::size_t m_batch_size;
  std::vector<std::size_t> m_column_size;               // #regions of columns
  std::vector<std::vector<Front_source>> m_row_sources; // #regions of rows
};

} // namespace

bool write_distance_matrix(const Row_engine& engine, double scale, const Matrix_job& job,
                           const Front_limits& limits, unsigned number_of_threads,
                           Matrix_file& file)
try
{
  const auto write_tiles = [&](const auto* row_engine)
  {
    Row_computation computation(*row_engine, scale, job, limits, number_of_threads, file.layout(),
                                file.tile_size());
    const std::size_t row_size = file.layout().row_size();
    std::vector<char> rows;
    for(std::size_t tile = 0; tile < file.number_of_tiles(); ++tile)
      if(!file.is_finished(tile))
      {
        const std::size_t begin = file.first_row(tile), end = file.end_row(tile);
        rows.resize((end - begin) * row_size);
        if(!computation.compute(begin, end, rows.data(), std::ptrdiff_t(row_size)))
          return false;
        file.write(tile, rows);
      }
    file.finish();
    return true;
  };
  return std::visit(write_tiles, engine);
}
catch(const Overflow_error&)
{
  file.discard(); // no later call could finish it
  throw;
}

bool write_distance_matrix(const Row_engine& engine, double scale, const Matrix_job& job,
                           const Front_limits& limits, unsigned number_of_threads,
                           const Matrix_layout& layout, void* rows, std::ptrdiff_t row_stride)
{
  constexpr std::size_t batch_size = std::size_t(1) << 26; // as that of a tile of a file
  return std::visit(
      [&](const auto* row_engine)
      {
        Row_computation computation(*row_engine, scale, job, limits, number_of_threads, layout,
                                    batch_size);
        return computation.compute(0, layout.rows, static_cast<char*>(rows), row_stride);
      },
      engine);
}

} // namespace CGAL::Geodesic_processing::internal
