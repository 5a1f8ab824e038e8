// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/supernodes.h"

#include "numerics/simd.h"

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The workspace stores a block of right-hand sides with one row for each unknown.
constexpr std::size_t rhs_block_size = 32;

// Number of right-hand sides that are processed at once: two registers.
template <typename Pack>
constexpr std::size_t double_lanes = 2 * sizeof(Pack) / sizeof(double);
constexpr std::size_t tile_rows = 4;

// Computes target[r] -= sum over k of factor(r, k) source[k].
template <typename Pack, std::size_t rows>
GEODESIC_PROCESSING_INLINE void subtract(const double* factor, std::size_t row_stride,
                                         std::size_t column_stride, std::size_t number,
                                         const double* source, double* const* target)
{
  constexpr std::size_t half = double_lanes<Pack> / 2;
  Pack sum[rows][2];
  for(std::size_t r = 0; r < rows; ++r)
  {
    load(target[r], sum[r][0]);
    load(target[r] + half, sum[r][1]);
  }
  for(std::size_t k = 0; k < number; ++k, source += rhs_block_size, factor += column_stride)
  {
    Pack a, b;
    load(source, a);
    load(source + half, b);
    for(std::size_t r = 0; r < rows; ++r)
    {
      sum[r][0] -= factor[r * row_stride] * a;
      sum[r][1] -= factor[r * row_stride] * b;
    }
  }
  for(std::size_t r = 0; r < rows; ++r)
  {
    store(sum[r][0], target[r]);
    store(sum[r][1], target[r] + half);
  }
}

template <typename Pack>
GEODESIC_PROCESSING_INLINE void
subtract(std::size_t rows, const double* factor, std::size_t row_stride, std::size_t column_stride,
         std::size_t number, const double* source, double* const* target)
{
  if(rows == tile_rows)
    subtract<Pack, tile_rows>(factor, row_stride, column_stride, number, source, target);
  else
    for(std::size_t r = 0; r < rows; ++r)
      subtract<Pack, 1>(factor + r * row_stride, row_stride, column_stride, number, source,
                        target + r);
}

template <typename Pack>
GEODESIC_PROCESSING_INLINE void divide(double* target, double divisor)
{
  const double factor = 1. / divisor;
  for(std::size_t j = 0; j < double_lanes<Pack>; ++j)
    target[j] *= factor;
}

struct Block
{
  std::size_t column_begin, columns, rows; // the block's diagonal rows come first
  const int* row;
  const double* entry;

  Block(const Supernodes& factor, std::size_t i)
      : column_begin(std::size_t(factor.column_begin[i])),
        columns(std::size_t(factor.column_begin[i + 1]) - column_begin),
        rows(std::size_t(factor.row_begin[i + 1] - factor.row_begin[i])),
        row(factor.row + factor.row_begin[i]), entry(factor.entry + factor.entry_begin[i])
  {}

  const double* at(std::size_t r, std::size_t c) const { return entry + c * rows + r; }
};

// Solves with L, for the right-hand sides of two registers.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void solve_forward(const Block& block, double* x)
{
  double* target[tile_rows];
  double* const diagonal_x = x + block.column_begin * rhs_block_size;
  for(std::size_t r = 0; r < block.rows;)
  {
    const bool is_diagonal = r < block.columns;
    const std::size_t n = std::min(tile_rows, (is_diagonal ? block.columns : block.rows) - r);
    for(std::size_t i = 0; i < n; ++i)
      target[i] = x + std::size_t(block.row[r + i]) * rhs_block_size;
    const std::size_t previous_columns = is_diagonal ? r : block.columns;
    subtract<Pack>(n, block.at(r, 0), 1, block.rows, previous_columns, diagonal_x, target);
    for(std::size_t i = 0; is_diagonal && i < n; ++i)
    {
      subtract<Pack, 1>(block.at(r + i, r), 1, block.rows, i, diagonal_x + r * rhs_block_size,
                        target + i);
      divide<Pack>(target[i], *block.at(r + i, r + i));
    }
    r += n;
  }
}

// Solves with the transpose of L, for the right-hand sides of two registers. `rows` holds the rows
// of this block.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void solve_backward(const Block& block, double* rows)
{
  double* target[tile_rows];
  for(std::size_t end = block.columns; end > 0;)
  {
    const std::size_t n = std::min(tile_rows, end), begin = end - n;
    for(std::size_t i = 0; i < n; ++i)
      target[i] = rows + (begin + i) * rhs_block_size;
    subtract<Pack>(n, block.at(end, begin), block.rows, 1, block.rows - end,
                   rows + end * rhs_block_size, target);
    for(std::size_t i = n; i-- > 0;)
    {
      const std::size_t c = begin + i;
      subtract<Pack, 1>(block.at(c + 1, c), block.rows, 1, end - c - 1,
                        rows + (c + 1) * rhs_block_size, target + i);
      divide<Pack>(target[i], *block.at(c, c));
    }
    end = begin;
  }
}

// Solves for a block of right-hand sides x. `rows` is the workspace for the rows of one supernode.
template <typename Pack>
GEODESIC_PROCESSING_INLINE void solve(const Supernodes& factor, double* x, std::size_t columns,
                                      double* rows)
{
  std::vector<bool> is_zero(factor.number_of_supernodes, true);
  for(std::size_t i = 0; i < factor.number_of_supernodes; ++i)
  {
    const Block block(factor, i);
    const double* const diagonal_x = x + block.column_begin * rhs_block_size;
    if(is_zero[i] && std::all_of(diagonal_x, diagonal_x + block.columns * rhs_block_size,
                                 [](double value) { return value == 0.; }))
      continue;
    for(std::size_t lane = 0; lane < columns; lane += double_lanes<Pack>)
      solve_forward<Pack>(block, x + lane);
    // The block of the first row below the diagonal contains all other rows, too: marking it
    // suffices.
    if(block.rows > block.columns)
      is_zero[std::size_t(std::upper_bound(factor.column_begin,
                                           factor.column_begin + factor.number_of_supernodes,
                                           block.row[block.columns]) -
                          factor.column_begin) -
              1] = false;
  }
  for(std::size_t i = factor.number_of_supernodes; i-- > 0;)
  {
    const Block block(factor, i);
    for(std::size_t r = 0; r < block.rows; ++r)
      std::copy_n(x + std::size_t(block.row[r]) * rhs_block_size, rhs_block_size,
                  rows + r * rhs_block_size);
    for(std::size_t lane = 0; lane < columns; lane += double_lanes<Pack>)
      solve_backward<Pack>(block, rows + lane);
    std::copy_n(rows, block.columns * rhs_block_size, x + block.column_begin * rhs_block_size);
  }
}

void solve_baseline(const Supernodes& factor, double* x, std::size_t columns, double* rows)
{
  solve<Baseline_pack<double>>(factor, x, columns, rows);
}

GEODESIC_PROCESSING_TARGET_AVX2_FMA
void solve_avx2(const Supernodes& factor, double* x, std::size_t columns, double* rows)
{
  solve<Avx2_pack<double>>(factor, x, columns, rows);
}

} // namespace

void substitute(const Supernodes& factor, double* columns, std::size_t count,
                std::vector<double>& workspace)
{
  const auto solve = has_avx2() ? solve_avx2 : solve_baseline;
  std::size_t max_rows = 0;
  for(std::size_t i = 0; i < factor.number_of_supernodes; ++i)
    max_rows = std::max(max_rows, std::size_t(factor.row_begin[i + 1] - factor.row_begin[i]));
  workspace.resize((factor.size + max_rows) * rhs_block_size);
  double* const x = workspace.data();
  for(std::size_t begin = 0; begin < count; begin += rhs_block_size)
  {
    const std::size_t n = std::min(rhs_block_size, count - begin);
    double* const block = columns + begin * factor.size;
    for(std::size_t i = 0; i < factor.size; ++i)
    {
      const double* const rhs = block + factor.permutation[i];
      for(std::size_t j = 0; j < rhs_block_size; ++j)
        x[i * rhs_block_size + j] = j < n ? rhs[j * factor.size] : 0.;
    }
    solve(factor, x, n, x + factor.size * rhs_block_size);
    for(std::size_t i = 0; i < factor.size; ++i)
    {
      double* const solution = block + factor.permutation[i];
      for(std::size_t j = 0; j < n; ++j)
        solution[j * factor.size] = x[i * rhs_block_size + j];
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal
