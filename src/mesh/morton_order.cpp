// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

struct Bounding_box
{
  std::array<double, 3> low = {infinity, infinity, infinity},
                        high = {-infinity, -infinity, -infinity};

  void add(const std::array<double, 3>& point)
  {
    for(int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  void add(const Bounding_box& other)
  {
    for(int k = 0; k < 3; ++k)
    {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  double half_extent() const
  {
    double result = 0.;
    for(int k = 0; k < 3; ++k)
      result = std::max(result, high[k] / 2. - low[k] / 2.);
    return result;
  }
};

// Returns the bounding box of the points i for which is_inside(i) is true.
template <typename Predicate>
Bounding_box bounding_box(const std::vector<std::array<double, 3>>& points,
                          unsigned number_of_threads, const Predicate& is_inside)
{
  constexpr std::size_t block_size = 1 << 14;
  std::vector<Bounding_box> of_blocks((points.size() + block_size - 1) / block_size);
  for_each_block(points.size(), block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   Bounding_box box;
                   for(std::size_t i = begin; i < end; ++i)
                     if(is_inside(i))
                       box.add(points[i]);
                   of_blocks[block] = box;
                 });
  Bounding_box result;
  for(const Bounding_box& box : of_blocks)
    result.add(box);
  return result;
}

void check_coordinates(const std::vector<std::array<double, 3>>& points, unsigned number_of_threads)
{
  const auto is_finite = [&](std::size_t i)
  {
    return std::isfinite(points[i][0]) && std::isfinite(points[i][1]) &&
           std::isfinite(points[i][2]);
  };
  if(is_true_for_all(points.size(), number_of_threads, is_finite))
    return;
  std::size_t first = 0;
  while(is_finite(first))
    ++first;
  throw Invalid_argument_error("The coordinates of point " + std::to_string(first) +
                               " are not finite.");
}

} // namespace

Frame unit_frame(const std::vector<std::array<double, 3>>& points, const std::vector<Index>& used,
                 unsigned number_of_threads)
{
  if(points.empty())
    return {};
  check_coordinates(points, number_of_threads);
  Bounding_box box = bounding_box(points, number_of_threads, [](std::size_t) { return true; });
  if(box.half_extent() > 0.25 * std::numeric_limits<double>::max())
    throw Invalid_argument_error("The points are too far apart: their distances overflow.");
  if(!used.empty())
  {
    // Several threads can mark the same point.
    std::vector<std::atomic<bool>> is_used(points.size());
    for_each_index(used.size(), number_of_threads,
                   [&](std::size_t i) { is_used[used[i]].store(true, std::memory_order_relaxed); });
    box = bounding_box(points, number_of_threads,
                       [&](std::size_t i) { return is_used[i].load(std::memory_order_relaxed); });
  }
  Frame frame;
  for(int k = 0; k < 3; ++k)
    frame.origin[k] = box.low[k] / 2. + box.high[k] / 2.;
  // For smaller extents, no power of two scales the coordinates to normal numbers.
  if(box.half_extent() > std::numeric_limits<double>::min())
    frame.scale = std::ldexp(1., std::ilogb(box.half_extent()));
  return frame;
}

void to_frame(std::vector<std::array<double, 3>>& points, const Frame& frame,
              unsigned number_of_threads)
{
  constexpr double max_coordinate = 1e150; // squares do not overflow
  for_each_index(points.size(), number_of_threads,
                 [&, scaled = Scaling(frame)](std::size_t i)
                 {
                   for(std::size_t k = 0; k < 3; ++k)
                     points[i][k] = std::clamp(scaled(points[i][k] - frame.origin[k]),
                                               -max_coordinate, max_coordinate);
                 });
}

namespace {

// Moves bit i of a 21-bit number to bit 3 i.
std::uint64_t spread_bits(std::uint64_t x)
{
  x = (x | x << 32) & 0x1f00000000ffffull;
  x = (x | x << 16) & 0x1f0000ff0000ffull;
  x = (x | x << 8) & 0x100f00f00f00f00full;
  x = (x | x << 4) & 0x10c30c30c30c30c3ull;
  return (x | x << 2) & 0x1249249249249249ull;
}

// Sorts elements by digits of 11 bits: calls write(position, i) with the sorted position of each
// element i. Elements with the same digit remain in their order.
template <typename Digit, typename Write>
void sort_by_digit(std::size_t size, unsigned number_of_threads, const Digit& digit_of,
                   const Write& write)
{
  constexpr std::size_t number_of_digits = 2048;
  const std::size_t block_size = block_size_of_threads(size, number_of_threads);
  const auto for_each_position = [&](const auto& visit)
  { for_each_block(size, block_size, number_of_threads, visit); };
  // First the number of elements of each block and digit, then the positions of the next ones.
  std::vector<std::array<Index, number_of_digits>> position((size + block_size - 1) / block_size);
  for_each_position(
      [&](std::size_t block, std::size_t begin, std::size_t end)
      {
        position[block].fill(0);
        for(std::size_t i = begin; i < end; ++i)
          ++position[block][digit_of(i)];
      });
  Index sum = 0;
  for(std::size_t digit = 0; digit < number_of_digits; ++digit)
    for(auto& of_block : position)
      sum += std::exchange(of_block[digit], sum);
  for_each_position(
      [&](std::size_t block, std::size_t begin, std::size_t end)
      {
        for(std::size_t i = begin; i < end; ++i)
          write(position[block][digit_of(i)]++, i);
      });
}

} // namespace

std::vector<Index> morton_order(const std::vector<std::array<double, 3>>& points,
                                const Frame& frame, unsigned number_of_threads)
{
  const std::size_t n = points.size();
  // 11 bits per axis: of a surface of a million points, only a few are in the same cell.
  const Scaling scaled(frame);
  const auto cell = [&](const std::array<double, 3>& point, int k)
  {
    return static_cast<std::uint64_t>(
        std::clamp((scaled(point[k] - frame.origin[k]) + 2.) * 512., 0., 2047.));
  };
  const auto key_of = [&](std::size_t i)
  {
    return spread_bits(cell(points[i], 0)) | spread_bits(cell(points[i], 1)) << 1 |
           spread_bits(cell(points[i], 2)) << 2;
  };

  // Radix sort by the three digits of the keys.
  std::vector<std::uint64_t> entries(n), sorted(n);
  for_each_index(n, number_of_threads, [&](std::size_t i) { entries[i] = key_of(i); });
  // The two digits that remain after the first pass and the index of the point fit into 64 bits.
  sort_by_digit(
      n, number_of_threads, [&](std::size_t i) { return entries[i] & 2047; },
      [&](std::size_t position, std::size_t i) { sorted[position] = entries[i] >> 11 << 32 | i; });
  sort_by_digit(
      n, number_of_threads, [&](std::size_t i) { return sorted[i] >> 32 & 2047; },
      [&](std::size_t position, std::size_t i) { entries[position] = sorted[i]; });
  std::vector<Index> order(n);
  sort_by_digit(
      n, number_of_threads, [&](std::size_t i) { return entries[i] >> 43; },
      [&](std::size_t position, std::size_t i)
      { order[position] = static_cast<Index>(entries[i]); });
  return order;
}

} // namespace CGAL::Geodesic_processing::internal
