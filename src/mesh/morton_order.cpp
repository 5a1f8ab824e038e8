// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

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
  double half_extent() const
  {
    double result = 0.;
    for(int k = 0; k < 3; ++k)
      result = std::max(result, high[k] / 2. - low[k] / 2.);
    return result;
  }
};

} // namespace

Frame unit_frame(const std::vector<std::array<double, 3>>& points, const std::vector<Index>& used)
{
  if(points.empty())
    return {};
  Bounding_box box;
  for(std::size_t i = 0; i < points.size(); ++i)
  {
    for(const double x : points[i])
      if(!std::isfinite(x))
        throw Invalid_argument_error("The coordinates of point " + std::to_string(i) +
                                     " are not finite.");
    box.add(points[i]);
  }
  if(box.half_extent() > 0.25 * std::numeric_limits<double>::max())
    throw Invalid_argument_error("The points are too far apart: their distances overflow.");
  if(!used.empty())
  {
    std::vector<bool> is_used(points.size(), false);
    for(const Index i : used)
      is_used[i] = true;
    box = {};
    for(std::size_t i = 0; i < points.size(); ++i)
      if(is_used[i])
        box.add(points[i]);
  }
  Frame frame;
  for(int k = 0; k < 3; ++k)
    frame.origin[k] = box.low[k] / 2. + box.high[k] / 2.;
  // For smaller extents, no power of two scales the coordinates to normal numbers.
  if(box.half_extent() > std::numeric_limits<double>::min())
    frame.scale = std::ldexp(1., std::ilogb(box.half_extent()));
  return frame;
}

void to_frame(std::vector<std::array<double, 3>>& points, const Frame& frame)
{
  constexpr double max_coordinate = 1e150; // squares do not overflow
  const Scaling scaled(frame);
  for(auto& point : points)
    for(int k = 0; k < 3; ++k)
      point[k] = std::clamp(scaled(point[k] - frame.origin[k]), -max_coordinate, max_coordinate);
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
  for_each_block(n, std::size_t(1) << 14, number_of_threads,
                 [&](std::size_t, std::size_t first, std::size_t last)
                 {
                   for(std::size_t i = first; i < last; ++i)
                     entries[i] = key_of(i);
                 });
  std::array<std::array<Index, 2048>, 3> begin{};
  for(const std::uint64_t key : entries)
    for(std::size_t digit = 0; digit < 3; ++digit)
      ++begin[digit][key >> 11 * digit & 2047];
  for(auto& counts : begin)
    std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), Index(0));
  // The two digits that remain after the first pass and the index of the point fit into 64 bits.
  for(std::size_t i = 0; i < n; ++i)
    sorted[begin[0][entries[i] & 2047]++] = entries[i] >> 11 << 32 | i;
  std::swap(entries, sorted);
  for(const std::uint64_t entry : entries)
    sorted[begin[1][entry >> 32 & 2047]++] = entry;
  std::vector<Index> order(n);
  for(const std::uint64_t entry : sorted)
    order[begin[2][entry >> 43]++] = static_cast<Index>(entry);
  return order;
}

} // namespace CGAL::Geodesic_processing::internal
