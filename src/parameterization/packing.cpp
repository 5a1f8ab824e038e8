// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameterization/packing.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Word = std::uint64_t;

// Cells of the grid along each axis. More are used for many charts, but no more than texels. The
// time increases with the cube of their number.
constexpr std::size_t default_grid_size = 512;
constexpr std::size_t cells_per_chart = 8; // along each axis, on average

constexpr std::size_t min_texels = 16, max_texels = 16384;

// The bisection of the scale ends at this ratio of its bounds.
constexpr double scale_tolerance = 1.01;

// Relative difference below which areas count as equal.
constexpr double area_tolerance = 1e-9;

// A chart that is smaller than the last one that tried all rows by this factor tries all rows
// again.
constexpr double size_ratio = 0.9;

// Minimum scale relative to the bound by the area; below it the charts do not fit.
constexpr double min_scale_ratio = 1e-6;

// Computes the convex hull in counterclockwise order (Andrew's monotone chain).
Outline convex_hull(Outline points)
{
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if(points.size() < 3)
    return points;
  Outline result;
  // The lower hull from left to right, then the upper hull back.
  for(int half = 0; half < 2; ++half)
  {
    const std::size_t begin = result.size();
    for(const Vec2& p : points)
    {
      while(result.size() >= begin + 2 &&
            !(cross(result.back() - result[result.size() - 2], p - result.back()) > 0.))
        result.pop_back();
      result.push_back(p);
    }
    result.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return result;
}

struct Bounding_box
{
  Vec2 low = {infinity, infinity}, high = {-infinity, -infinity};

  void add(const Vec2& p)
  {
    for(int axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  Vec2 size() const { return high - low; }
};

// Computes the bounding box of an outline rotated by `direction`.
Bounding_box bounding_box(const Outline& outline, const Vec2& direction)
{
  Bounding_box result;
  for(const Vec2& p : outline)
    result.add(rotated(p, direction));
  return result;
}

// Returns the rotation after which the bounding box has the smallest area. One edge of the convex
// hull is parallel to an axis then.
Vec2 min_rectangle_direction(const Outline& outline)
{
  const Outline hull_polygon = convex_hull(outline);
  Vec2 best = {1., 0.};
  double min_area = infinity, min_side = infinity;
  for(std::size_t i = 0; i < hull_polygon.size(); ++i)
  {
    const Vec2 edge = hull_polygon[(i + 1) % hull_polygon.size()] - hull_polygon[i];
    if(!(norm(edge) > 0.))
      continue;
    const Vec2 direction = (1. / norm(edge)) * Vec2{edge[0], -edge[1]},
               size = bounding_box(hull_polygon, direction).size();
    // Of boxes of equal area, the one with the shorter longer edge is chosen.
    const double area = size[0] * size[1], longer_side = std::max(size[0], size[1]);
    if(area < (1. - area_tolerance) * min_area ||
       (area < (1. + area_tolerance) * min_area && longer_side < min_side))
    {
      min_area = area;
      min_side = longer_side;
      best = direction;
    }
  }
  return best;
}

double polygon_area(const Outline& outline)
{
  double double_area = 0.;
  for(std::size_t i = 0; i < outline.size(); ++i)
    double_area += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  return std::abs(double_area) / 2.;
}

// The grid cells that an outline and a margin around it touch, as runs of cells.
struct Raster
{
  struct Run
  {
    std::uint32_t row, begin, length;
  };
  std::vector<Run> runs; // by increasing row
  std::size_t width = 0, height = 0;
  std::vector<std::uint32_t> longest_run; // longest run of each row
};

// Rasterizes an outline, given in units of cells. Its coordinates must be at least `margin`.
Raster rasterize(const Outline& outline, double margin)
{
  Raster result;
  Bounding_box box;
  for(const Vec2& p : outline)
    box.add(p);
  result.width = std::size_t(box.high[0] + margin) + 1;
  result.height = std::size_t(box.high[1] + margin) + 1;
  std::vector<bool> is_covered(result.width * result.height, false);
  const auto column = [&](double x)
  { return std::size_t(std::clamp(x, 0., double(result.width - 1))); };
  std::vector<std::vector<double>> crossings(result.height);
  for(std::size_t i = 0; i < outline.size(); ++i)
  {
    Vec2 p = outline[i], q = outline[(i + 1) % outline.size()];
    if(p[1] > q[1])
      std::swap(p, q);
    const double slope = q[1] > p[1] ? (q[0] - p[0]) / (q[1] - p[1]) : 0.;
    const auto x_at = [&](double y)
    { return std::clamp(p[0] + slope * (y - p[1]), std::min(p[0], q[0]), std::max(p[0], q[0])); };
    const auto first = std::size_t(std::max(0., p[1] - margin)),
               last = std::min(result.height - 1, std::size_t(q[1] + margin));
    for(std::size_t row = first; row <= last; ++row)
    {
      double from = p[0], to = q[0];
      if(q[1] > p[1])
      {
        from = x_at(std::max(p[1], double(row) - margin));
        to = x_at(std::min(q[1], double(row) + 1. + margin));
      }
      if(from > to)
        std::swap(from, to);
      for(std::size_t c = column(from - margin); c <= column(to + margin); ++c)
        is_covered[row * result.width + c] = true;
      if(const double row_center = double(row) + 0.5; p[1] <= row_center && row_center < q[1])
        crossings[row].push_back(x_at(row_center));
    }
  }
  result.longest_run.assign(result.height, 0);
  for(std::size_t row = 0; row < result.height; ++row)
  {
    std::sort(crossings[row].begin(), crossings[row].end());
    for(std::size_t i = 1; i < crossings[row].size(); i += 2)
      for(std::size_t c = column(crossings[row][i - 1]); c < column(crossings[row][i]); ++c)
        is_covered[row * result.width + c] = true;
    for(std::size_t c = 0; c < result.width; ++c)
      if(is_covered[row * result.width + c])
      {
        if(c == 0 || !is_covered[row * result.width + c - 1])
          result.runs.push_back({std::uint32_t(row), std::uint32_t(c), 0});
        result.longest_run[row] = std::max(result.longest_run[row], ++result.runs.back().length);
      }
  }
  return result;
}

// The occupied cells of a square grid, one bit per cell.
class Grid
{
public:
  explicit Grid(std::size_t cells)
      : m_cells(cells), m_words((cells + 63) / 64), m_occupied(m_cells * m_words, 0),
        m_longest_free(cells, std::uint32_t(cells)), m_first_free(cells, 0), m_blocked(m_words),
        m_row(m_words)
  {
    if(cells % 64 != 0) // bits beyond the last column
      for(std::size_t row = 0; row < cells; ++row)
        m_occupied[row * m_words + m_words - 1] = ~Word(0) << (cells % 64);
  }

  // Returns the lowest position, then the leftmost one, at which a raster is free, in rows from
  // `first_row` on and below `row_limit`.
  std::optional<std::array<std::size_t, 2>>
  find_position(const Raster& raster, std::size_t first_row, std::size_t row_limit)
  {
    if(raster.width > m_cells)
      return std::nullopt;
    for(std::size_t row = first_row; row + raster.height <= std::min(row_limit, m_cells); ++row)
      if(const auto column = find_column(raster, row))
        return std::array<std::size_t, 2>{*column, row};
    return std::nullopt;
  }

  void occupy(const Raster& raster, const std::array<std::size_t, 2>& position)
  {
    for(const auto& run : raster.runs)
      for(std::size_t c = position[0] + run.begin, end = c + run.length; c < end; ++c)
        m_occupied[(position[1] + run.row) * m_words + c / 64] |= Word(1) << (c % 64);
    for(std::size_t row = position[1]; row < position[1] + raster.height; ++row)
    {
      m_longest_free[row] = longest_free_run(row);
      std::size_t& word = m_first_free[row];
      while(word < m_words && m_occupied[row * m_words + word] == ~Word(0))
        ++word;
    }
  }

private:
  // Takes a step per word, and a step per cell of the runs in partly occupied words.
  std::uint32_t longest_free_run(std::size_t row) const
  {
    std::uint32_t run = 0, longest = 0;
    for(std::size_t i = row * m_words; i < (row + 1) * m_words; ++i)
    {
      Word free = ~m_occupied[i];
      if(free == ~Word(0))
      {
        run += 64;
        continue;
      }
      const auto free_cells = [&free](int from, int step)
      {
        std::uint32_t count = 0;
        while(free >> (from + step * int(count)) & 1)
          ++count;
        return count;
      };
      longest = std::max(longest, run + free_cells(0, 1));
      run = free_cells(63, -1);
      // Each step shortens all runs by one cell.
      std::uint32_t inner_run = 0;
      for(; free != 0; free &= free >> 1)
        ++inner_run;
      longest = std::max(longest, inner_run);
    }
    return std::max(longest, run);
  }

  // Combines each bit of m_row with the bit `shift` cells to its right.
  void dilate(std::size_t shift) { merge_shifted(m_row, m_row, shift); }

  // Combines `to` with `from` shifted to the left. Cells beyond the grid are occupied.
  void merge_shifted(std::vector<Word>& to, const std::vector<Word>& from, std::size_t shift) const
  {
    const std::size_t words = shift / 64, bits = shift % 64;
    for(std::size_t i = m_begin; i < m_words; ++i)
    {
      const std::size_t k = i + words;
      const Word low = k < m_words ? from[k] : ~Word(0),
                 high = k + 1 < m_words ? from[k + 1] : ~Word(0);
      to[i] |= bits == 0 ? low : low >> bits | high << (64 - bits);
    }
  }

  // Returns the leftmost column at which a raster is free if its first row is `row`. Bit c of
  // m_blocked is set if column c is not possible.
  std::optional<std::size_t> find_column(const Raster& raster, std::size_t row)
  {
    for(std::size_t i = 0; i < raster.height; ++i)
      if(m_longest_free[row + i] < raster.longest_run[i])
        return std::nullopt;
    // The words of smaller columns, in which a row has no free cell, are skipped.
    m_begin = 0;
    for(const auto& run : raster.runs)
      if(const std::size_t column = 64 * m_first_free[row + run.row]; column > run.begin)
        m_begin = std::max(m_begin, (column - run.begin) / 64);
    if(m_begin >= m_words)
      return std::nullopt;
    std::fill(m_blocked.begin(), m_blocked.end(), Word(0));
    for(const auto& run : raster.runs)
    {
      const auto begin = m_occupied.begin() + std::ptrdiff_t((row + run.row) * m_words);
      std::copy(begin + std::ptrdiff_t(m_begin), begin + std::ptrdiff_t(m_words),
                m_row.begin() + std::ptrdiff_t(m_begin));
      std::size_t dilated_width = 1;
      for(; 2 * dilated_width <= run.length; dilated_width *= 2)
        dilate(dilated_width);
      if(dilated_width < run.length)
        dilate(run.length - dilated_width);
      merge_shifted(m_blocked, m_row, run.begin);
      if(std::all_of(m_blocked.begin() + std::ptrdiff_t(m_begin), m_blocked.end(),
                     [](Word w) { return w == ~Word(0); }))
        return std::nullopt;
    }
    for(std::size_t c = 64 * m_begin; c + raster.width <= m_cells; ++c)
      if(!(m_blocked[c / 64] >> (c % 64) & 1))
        return c;
    return std::nullopt;
  }

  std::size_t m_cells, m_words;
  std::vector<Word> m_occupied;              // m_words words per row
  std::vector<std::uint32_t> m_longest_free; // longest free run of each row
  std::vector<std::size_t> m_first_free;     // first word of each row with a free cell
  std::vector<Word> m_blocked, m_row;        // buffers of find_column(), from word m_begin on
  std::size_t m_begin = 0;
};

class Packer
{
public:
  Packer(const std::vector<Outline>& outlines, std::size_t texels, std::size_t gutter)
      : m_outlines(outlines), m_texels(texels), m_margin(double(gutter) / 2.),
        m_order(outlines.size()), m_size(outlines.size())
  {
    const auto cells = std::size_t(double(cells_per_chart) * std::sqrt(double(outlines.size())));
    m_cells = std::min(std::max(default_grid_size, (cells + 63) / 64 * 64), texels);
    for(std::size_t i = 0; i < outlines.size(); ++i)
    {
      m_directions.push_back(min_rectangle_direction(outlines[i]));
      const Vec2 size = bounding_box(outlines[i], m_directions.back()).size();
      m_size[i] = std::max(size[0], size[1]);
    }
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t i, std::size_t j) { return m_size[i] > m_size[j]; });
  }

  double cell() const { return double(m_texels) / double(m_cells); }

  std::optional<Packing> pack_at_scale(double scale) const
  {
    Packing result;
    result.scale = scale;
    result.directions.resize(m_outlines.size());
    result.offsets.resize(m_outlines.size());
    if(!m_order.empty() && !(scale * m_size[m_order.front()] < 2. * double(m_texels)))
      return std::nullopt;
    Grid grid(m_cells);
    // A chart that is hardly smaller than another is hardly ever free at a lower position.
    std::size_t first_row = 0;
    double last_size = infinity; // of the last chart that tried all rows
    for(const std::size_t i : m_order)
    {
      if(m_size[i] < size_ratio * last_size)
      {
        first_row = 0;
        last_size = m_size[i];
      }
      std::size_t row_limit = m_cells;
      std::array<std::size_t, 2> best = {0, 0};
      std::optional<Raster> best_raster;
      Vec2 direction = m_directions[i];
      for(int quarter_turn = 0; quarter_turn < 4;
          ++quarter_turn, direction = rotated_left(direction))
      {
        const Vec2 lower_left = bounding_box(m_outlines[i], direction).low;
        Outline placed;
        for(const Vec2& p : m_outlines[i])
          placed.push_back((1. / cell()) * (scale * (rotated(p, direction) - lower_left) +
                                            Vec2{m_margin, m_margin}));
        const Raster raster = rasterize(placed, m_margin / cell());
        const auto position = grid.find_position(raster, first_row, row_limit);
        if(!position || (best_raster && (*position)[1] + raster.height == row_limit &&
                         (*position)[0] >= best[0]))
          continue;
        row_limit = (*position)[1] + raster.height;
        best = *position;
        best_raster = raster;
        result.directions[i] = direction;
        result.offsets[i] = cell() * Vec2{double(best[0]), double(best[1])} +
                            Vec2{m_margin, m_margin} - scale * lower_left;
      }
      if(!best_raster)
        return std::nullopt;
      grid.occupy(*best_raster, best);
      first_row = best[1];
    }
    return result;
  }

private:
  const std::vector<Outline>& m_outlines;
  std::size_t m_texels, m_cells;
  double m_margin; // in texels
  std::vector<Vec2> m_directions;
  std::vector<std::size_t> m_order;
  std::vector<double> m_size; // longer edge of the bounding box
};

[[noreturn]] void throw_does_not_fit(std::size_t number_of_charts, std::size_t texels)
{
  throw Invalid_argument_error(std::to_string(number_of_charts) +
                               " charts do not fit into a texture of " + std::to_string(texels) +
                               " x " + std::to_string(texels) + " texels.");
}

} // namespace

void check_fits(std::size_t number_of_outlines, std::size_t texels, std::size_t gutter)
{
  if(texels < min_texels || texels > max_texels)
    throw Invalid_argument_error("The size of a texture must be between " +
                                 std::to_string(min_texels) + " and " + std::to_string(max_texels) +
                                 " texels.");
  if(gutter > texels)
    throw Invalid_argument_error("The gutter is wider than the texture.");
  // Even a single point occupies a square of the size of the gutter.
  if(double(number_of_outlines) * double(gutter * gutter) > double(texels * texels))
    throw_does_not_fit(number_of_outlines, texels);
}

Packing pack(const std::vector<Outline>& outlines, std::size_t texels, std::size_t gutter,
             unsigned number_of_threads)
{
  check_fits(outlines.size(), texels, gutter);
  const Packer packer(outlines, texels, gutter);
  double area = 0.;
  for(const Outline& outline : outlines)
    area += polygon_area(outline);
  if(!(area > 0.))
  {
    // Charts of area zero.
    if(auto found = packer.pack_at_scale(1.))
      return *found;
    throw_does_not_fit(outlines.size(), texels);
  }

  const double max_scale = double(texels) / std::sqrt(area);
  Packing best;
  double low = 0.5 * max_scale, high = max_scale;
  for(; low > min_scale_ratio * max_scale; high = low, low *= 0.5)
    if(auto found = packer.pack_at_scale(low))
    {
      best = std::move(*found);
      break;
    }
  if(best.scale == 0.)
    throw_does_not_fit(outlines.size(), texels);
  // Two scales per step, whatever the number of threads, so that the result does not depend on it.
  while(high > scale_tolerance * low)
  {
    std::array<std::optional<Packing>, 2> found;
    const double step = (high - low) / 3.;
    for_each_block(2, 1, number_of_threads,
                   [&](std::size_t i, std::size_t, std::size_t)
                   { found[i] = packer.pack_at_scale(low + double(i + 1) * step); });
    high = found[1] ? high : found[0] ? low + 2. * step : low + step;
    for(auto& packing : found)
      if(packing)
        best = std::move(*packing);
    low = best.scale;
  }
  return best;
}

} // namespace CGAL::Geodesic_processing::internal
