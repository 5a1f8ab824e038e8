// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/supernodes.h"

#include "numerics/wide.h"

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Right sides lie side by side, a row for each unknown.
constexpr std::size_t row_size = 32;

// Two registers of each of some rows.
template <typename Pack>
constexpr std::size_t lanes = 2 * sizeof(Pack) / sizeof(double);
constexpr std::size_t rows_at_once = 4;

// target[r] -= sum of factor(r, k) source[k].
template <typename Pack, std::size_t rows>
GEODESIC_PROCESSING_INLINE void subtract(const double* factor, std::size_t next_r,
                                         std::size_t next_k, std::size_t number,
                                         const double* source, double* const* target)
{
  constexpr std::size_t half = lanes<Pack> / 2;
  Pack sum[rows][2];
  for(std::size_t r = 0; r < rows; ++r)
  {
    load(target[r], sum[r][0]);
    load(target[r] + half, sum[r][1]);
  }
  for(std::size_t k = 0; k < number; ++k, source += row_size, factor += next_k)
  {
    Pack a, b;
    load(source, a);
    load(source + half, b);
    for(std::size_t r = 0; r < rows; ++r)
    {
      sum[r][0] -= factor[r * next_r] * a;
      sum[r][1] -= factor[r * next_r] * b;
    }
  }
  for(std::size_t r = 0; r < rows; ++r)
  {
    store(sum[r][0], target[r]);
    store(sum[r][1], target[r] + half);
  }
}

template <typename Pack>
GEODESIC_PROCESSING_INLINE void subtract(std::size_t rows, const double* factor, std::size_t next_r,
                                         std::size_t next_k, std::size_t number,
                                         const double* source, double* const* target)
{
  if(rows == rows_at_once)
    subtract<Pack, rows_at_once>(factor, next_r, next_k, number, source, target);
  else
    for(std::size_t r = 0; r < rows; ++r)
      subtract<Pack, 1>(factor + r * next_r, next_r, next_k, number, source, target + r);
}

template <typename Pack>
GEODESIC_PROCESSING_INLINE void divide(double* target, double divisor)
{
  const double factor = 1. / divisor;
  for(std::size_t j = 0; j < lanes<Pack>; ++j)
    target[j] *= factor;
}

struct Block
{
  std::size_t first, columns, rows; // its own columns come first among the rows
  const int* row;
  const double* entry;

  Block(const Supernodes& factor, std::size_t i)
      : first(std::size_t(factor.first[i])), columns(std::size_t(factor.first[i + 1]) - first),
        rows(std::size_t(factor.first_row[i + 1] - factor.first_row[i])),
        row(factor.row + factor.first_row[i]), entry(factor.entry + factor.first_entry[i])
  {}

  const double* at(std::size_t r, std::size_t c) const { return entry + c * rows + r; }
};

// By L, in some lanes.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void solve_forward(const Block& block, double* x)
{
  double* target[rows_at_once];
  double* const own = x + block.first * row_size;
  for(std::size_t r = 0; r < block.rows;)
  {
    const bool is_own = r < block.columns;
    const std::size_t n = std::min(rows_at_once, (is_own ? block.columns : block.rows) - r);
    for(std::size_t i = 0; i < n; ++i)
      target[i] = x + std::size_t(block.row[r + i]) * row_size;
    const std::size_t before = is_own ? r : block.columns;
    subtract<Pack>(n, block.at(r, 0), 1, block.rows, before, own, target);
    for(std::size_t i = 0; is_own && i < n; ++i)
    {
      subtract<Pack, 1>(block.at(r + i, r), 1, block.rows, i, own + r * row_size, target + i);
      divide<Pack>(target[i], *block.at(r + i, r + i));
    }
    r += n;
  }
}

// By the transpose of L, in some lanes of the block's rows.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void solve_backward(const Block& block, double* rows)
{
  double* target[rows_at_once];
  for(std::size_t end = block.columns; end > 0;)
  {
    const std::size_t n = std::min(rows_at_once, end), begin = end - n;
    for(std::size_t i = 0; i < n; ++i)
      target[i] = rows + (begin + i) * row_size;
    subtract<Pack>(n, block.at(end, begin), block.rows, 1, block.rows - end, rows + end * row_size,
                   target);
    for(std::size_t i = n; i-- > 0;)
    {
      const std::size_t c = begin + i;
      subtract<Pack, 1>(block.at(c + 1, c), block.rows, 1, end - c - 1, rows + (c + 1) * row_size,
                        target + i);
      divide<Pack>(target[i], *block.at(c, c));
    }
    end = begin;
  }
}

// The rows of x hold right sides; `rows` has room for those of a block.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void solve(const Supernodes& factor, double* x, std::size_t columns,
                                      double* rows)
{
  std::vector<bool> is_zero(factor.number, true);
  for(std::size_t i = 0; i < factor.number; ++i)
  {
    const Block block(factor, i);
    const double* const own = x + block.first * row_size;
    if(is_zero[i] &&
       std::all_of(own, own + block.columns * row_size, [](double value) { return value == 0.; }))
      continue;
    for(std::size_t lane = 0; lane < columns; lane += lanes<Pack>)
      solve_forward<Pack>(block, x + lane);
    // All other rows are of blocks that this one leads to.
    if(block.rows > block.columns)
      is_zero[std::size_t(std::upper_bound(factor.first, factor.first + factor.number,
                                           block.row[block.columns]) -
                          factor.first) -
              1] = false;
  }
  for(std::size_t i = factor.number; i-- > 0;)
  {
    const Block block(factor, i);
    for(std::size_t r = 0; r < block.rows; ++r)
      std::copy_n(x + std::size_t(block.row[r]) * row_size, row_size, rows + r * row_size);
    for(std::size_t lane = 0; lane < columns; lane += lanes<Pack>)
      solve_backward<Pack>(block, rows + lane);
    std::copy_n(rows, block.columns * row_size, x + block.first * row_size);
  }
}

void solve_narrow(const Supernodes& factor, double* x, std::size_t columns, double* rows)
{
  solve<Narrow<double>>(factor, x, columns, rows);
}

GEODESIC_PROCESSING_FOR_WIDE
void solve_wide(const Supernodes& factor, double* x, std::size_t columns, double* rows)
{
  solve<Wide<double>>(factor, x, columns, rows);
}

} // namespace

void substitute(const Supernodes& factor, double* columns, std::size_t count,
                std::vector<double>& space)
{
  const auto solve = has_wide_instructions() ? solve_wide : solve_narrow;
  std::size_t most_rows = 0;
  for(std::size_t i = 0; i < factor.number; ++i)
    most_rows = std::max(most_rows, std::size_t(factor.first_row[i + 1] - factor.first_row[i]));
  space.resize((factor.size + most_rows) * row_size);
  double* const x = space.data();
  for(std::size_t begin = 0; begin < count; begin += row_size)
  {
    const std::size_t n = std::min(row_size, count - begin);
    double* const block = columns + begin * factor.size;
    for(std::size_t i = 0; i < factor.size; ++i)
    {
      const double* const right = block + factor.order[i];
      for(std::size_t j = 0; j < row_size; ++j)
        x[i * row_size + j] = j < n ? right[j * factor.size] : 0.;
    }
    solve(factor, x, n, x + factor.size * row_size);
    for(std::size_t i = 0; i < factor.size; ++i)
    {
      double* const solution = block + factor.order[i];
      for(std::size_t j = 0; j < n; ++j)
        solution[j * factor.size] = x[i * row_size + j];
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal
