// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/dense_product.h>

#include "numerics/simd.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A column-major matrix, whose columns are `stride` apart.
template <typename Scalar>
struct View
{
  Scalar* data;
  std::size_t rows, columns, stride;

  Scalar* at(std::size_t row, std::size_t column) const { return data + column * stride + row; }
};

template <typename Scalar>
using Const_view = View<const Scalar>;

template <typename Pack, typename Scalar>
constexpr std::size_t lanes = sizeof(Pack) / sizeof(Scalar);

constexpr std::size_t tile_columns = 4;

// Computes a tile of the product: `columns` columns and as many rows as two registers hold. The
// tile's rows of the left factor are stored in `a`, one column after another.
template <typename Pack, std::size_t columns, typename Scalar>
GEODESIC_PROCESSING_INLINE void multiply_tile(const Scalar* a, const Const_view<Scalar>& b,
                                              std::size_t column, Scalar* result,
                                              std::size_t stride, std::size_t rows)
{
  constexpr std::size_t half = lanes<Pack, Scalar>;
  Pack sum[columns][2] = {};
  const Scalar* factor = b.at(0, column);
  for(std::size_t k = 0; k < b.rows; ++k, a += 2 * half)
  {
    Pack low, high;
    load(a, low);
    load(a + half, high);
    for(std::size_t j = 0; j < columns; ++j)
    {
      sum[j][0] += factor[j * b.stride + k] * low;
      sum[j][1] += factor[j * b.stride + k] * high;
    }
  }
  for(std::size_t j = 0; j < columns; ++j, result += stride)
  {
    Scalar partial_tile[2 * half];
    Scalar* const target = rows == 2 * half ? result : partial_tile;
    store(sum[j][0], target);
    store(sum[j][1], target + half);
    if(rows < 2 * half)
      std::copy_n(partial_tile, rows, result);
  }
}

// Computes the product. A block of rows of `a` that fits into the cache is packed into tiles and
// multiplied with all columns of `b`.
template <typename Pack, typename Scalar>
GEODESIC_PROCESSING_INLINE void multiply(const Const_view<Scalar>& a, const Const_view<Scalar>& b,
                                         const View<Scalar>& result)
{
  constexpr std::size_t tile = 2 * lanes<Pack, Scalar>, tiles = 8;
  std::vector<Scalar> block(tiles * tile * a.columns, Scalar(0));
  for(std::size_t begin = 0; begin < a.rows; begin += tiles * tile)
  {
    const std::size_t rows = std::min(tiles * tile, a.rows - begin);
    for(std::size_t k = 0; k < a.columns; ++k)
      for(std::size_t i = 0; i < rows; i += tile)
        for(std::size_t r = 0; r < std::min(tile, rows - i); ++r)
          block[i * a.columns + k * tile + r] = *a.at(begin + i + r, k);
    for(std::size_t j = 0; j < b.columns;)
    {
      const bool is_full = j + tile_columns <= b.columns;
      for(std::size_t i = 0; i < rows; i += tile)
      {
        const Scalar* const a_tile = block.data() + i * a.columns;
        Scalar* const target = result.at(begin + i, j);
        const std::size_t n = std::min(tile, rows - i);
        if(is_full)
          multiply_tile<Pack, tile_columns>(a_tile, b, j, target, result.stride, n);
        else
          multiply_tile<Pack, 1>(a_tile, b, j, target, result.stride, n);
      }
      j += is_full ? tile_columns : 1;
    }
  }
}

// Adds the inner products of `columns_a` columns of `a` with `columns_b` columns of `b` to
// `result`, over the first `rows` rows.
template <typename Pack, std::size_t columns_a, std::size_t columns_b, typename Scalar>
GEODESIC_PROCESSING_INLINE void
add_inner_products(const Scalar* a, std::size_t stride_a, const Scalar* b, std::size_t stride_b,
                   std::size_t rows, Scalar* result, std::size_t stride)
{
  constexpr std::size_t size = lanes<Pack, Scalar>;
  Pack sum[columns_a][columns_b] = {};
  std::size_t k = 0;
  for(; k + size <= rows; k += size)
    for(std::size_t j = 0; j < columns_b; ++j)
    {
      Pack b_pack, a_pack;
      load(b + j * stride_b + k, b_pack);
      for(std::size_t i = 0; i < columns_a; ++i)
      {
        load(a + i * stride_a + k, a_pack);
        sum[i][j] += a_pack * b_pack;
      }
    }
  for(std::size_t j = 0; j < columns_b; ++j)
    for(std::size_t i = 0; i < columns_a; ++i)
    {
      Scalar lane_sums[size], total = 0;
      store(sum[i][j], lane_sums);
      for(const Scalar lane_sum : lane_sums)
        total += lane_sum;
      for(std::size_t tail = k; tail < rows; ++tail)
        total += a[i * stride_a + tail] * b[j * stride_b + tail];
      result[j * stride + i] += total;
    }
}

template <typename Pack, std::size_t columns_b, typename Scalar>
GEODESIC_PROCESSING_INLINE void
add_inner_products(const Const_view<Scalar>& a, const Const_view<Scalar>& b, std::size_t begin,
                   std::size_t rows, std::size_t j, const View<Scalar>& result)
{
  std::size_t i = 0;
  for(; i + tile_columns <= a.columns; i += tile_columns)
    add_inner_products<Pack, tile_columns, columns_b>(
        a.at(begin, i), a.stride, b.at(begin, j), b.stride, rows, result.at(i, j), result.stride);
  for(; i < a.columns; ++i)
    add_inner_products<Pack, 1, columns_b>(a.at(begin, i), a.stride, b.at(begin, j), b.stride, rows,
                                           result.at(i, j), result.stride);
}

template <typename Pack, typename Scalar>
GEODESIC_PROCESSING_INLINE void multiply_transposed(const Const_view<Scalar>& a,
                                                    const Const_view<Scalar>& b,
                                                    const View<Scalar>& result)
{
  constexpr std::size_t rows_at_once = 512;
  for(std::size_t j = 0; j < result.columns; ++j)
    std::fill_n(result.at(0, j), result.rows, Scalar(0));
  for(std::size_t begin = 0; begin < a.rows; begin += rows_at_once)
  {
    const std::size_t rows = std::min(rows_at_once, a.rows - begin);
    std::size_t j = 0;
    for(; j + 2 <= b.columns; j += 2)
      add_inner_products<Pack, 2>(a, b, begin, rows, j, result);
    if(j < b.columns)
      add_inner_products<Pack, 1>(a, b, begin, rows, j, result);
  }
}

template <typename Pack, typename Scalar>
GEODESIC_PROCESSING_INLINE void multiply(bool is_transposed, const Const_view<Scalar>& a,
                                         const Const_view<Scalar>& b, const View<Scalar>& result)
{
  if(is_transposed)
    multiply_transposed<Pack>(a, b, result);
  else
    multiply<Pack>(a, b, result);
}

template <typename Scalar>
void multiply_baseline(bool is_transposed, const Const_view<Scalar>& a, const Const_view<Scalar>& b,
                       const View<Scalar>& result)
{
  multiply<Baseline_pack<Scalar>>(is_transposed, a, b, result);
}

template <typename Scalar>
GEODESIC_PROCESSING_TARGET_AVX2_FMA void
multiply_avx2(bool is_transposed, const Const_view<Scalar>& a, const Const_view<Scalar>& b,
              const View<Scalar>& result)
{
  multiply<Avx2_pack<Scalar>>(is_transposed, a, b, result);
}

template <typename Matrix_type>
auto view(Matrix_type& matrix)
{
  using Scalar = std::remove_pointer_t<decltype(matrix.data())>;
  return View<Scalar>{matrix.data(), std::size_t(matrix.rows()), std::size_t(matrix.cols()),
                      std::size_t(matrix.outerStride())};
}

template <typename Result>
void multiply(bool is_transposed, const Eigen::Ref<const Result>& a,
              const Eigen::Ref<const Result>& b, Result& result)
{
  using Scalar = typename Result::Scalar;
  result.resize(is_transposed ? a.cols() : a.rows(), b.cols());
  const auto kernel = has_avx2() ? multiply_avx2<Scalar> : multiply_baseline<Scalar>;
  kernel(is_transposed, view(a), view(b), view(result));
}

} // namespace

void product(const Matrix_ref& a, const Matrix_ref& b, Matrix& result)
{
  multiply<Matrix>(false, a, b, result);
}
void product(const Float_matrix_ref& a, const Float_matrix_ref& b, Float_matrix& result)
{
  multiply<Float_matrix>(false, a, b, result);
}
void transposed_product(const Matrix_ref& a, const Matrix_ref& b, Matrix& result)
{
  multiply<Matrix>(true, a, b, result);
}
void transposed_product(const Float_matrix_ref& a, const Float_matrix_ref& b, Float_matrix& result)
{
  multiply<Float_matrix>(true, a, b, result);
}

} // namespace CGAL::Geodesic_processing::internal
