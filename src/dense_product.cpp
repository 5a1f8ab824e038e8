// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/dense_product.h>

#include <CGAL/Geodesic_processing/internal/blas.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

// As Fortran knows it.
template <typename Scalar>
using Gemm = void(const char*, const char*, const int*, const int*, const int*, const Scalar*,
                  const Scalar*, const int*, const Scalar*, const int*, const Scalar*, Scalar*,
                  const int*);

template <typename Result>
void multiply(Gemm<typename Result::Scalar>* gemm, bool is_transposed,
              const Eigen::Ref<const Result>& a, const Eigen::Ref<const Result>& b, Result& result)
{
  using Scalar = typename Result::Scalar;
  result.resize(is_transposed ? a.cols() : a.rows(), b.cols());
  if(result.size() == 0)
    return;
  if(b.rows() == 0)
    result.setZero();
  else if(!gemm && is_transposed)
    result.noalias() = a.transpose() * b;
  else if(!gemm)
    result.noalias() = a * b;
  else
  {
    const Blas_at_one_thread blas;
    const char way = is_transposed ? 'T' : 'N', plain = 'N';
    const int rows = int(result.rows()), columns = int(b.cols()), inner = int(b.rows());
    const int stride_a = int(a.outerStride()), stride_b = int(b.outerStride());
    const Scalar one = 1, zero = 0;
    gemm(&way, &plain, &rows, &columns, &inner, &one, a.data(), &stride_a, b.data(), &stride_b,
         &zero, result.data(), &rows);
  }
}

Gemm<double>* const dgemm = loaded<Gemm<double>>("dgemm_");
Gemm<float>* const sgemm = loaded<Gemm<float>>("sgemm_");

} // namespace

void product(const Columns& a, const Columns& b, Matrix& result)
{
  multiply<Matrix>(dgemm, false, a, b, result);
}
void product(const Float_columns& a, const Float_columns& b, Float_matrix& result)
{
  multiply<Float_matrix>(sgemm, false, a, b, result);
}
void transposed_product(const Columns& a, const Columns& b, Matrix& result)
{
  multiply<Matrix>(dgemm, true, a, b, result);
}
void transposed_product(const Float_columns& a, const Float_columns& b, Float_matrix& result)
{
  multiply<Float_matrix>(sgemm, true, a, b, result);
}

} // namespace CGAL::Geodesic_processing::internal
