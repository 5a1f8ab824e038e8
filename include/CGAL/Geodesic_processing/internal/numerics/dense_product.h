// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_PRODUCT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_PRODUCT_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <Eigen/Core>

// Products of large matrices of which one has few columns or rows. They use AVX2 if the processor
// has it. This takes half the time of an OpenBLAS that does not recognize the processor. One
// thread.

namespace CGAL::Geodesic_processing::internal {

using Matrix = Eigen::MatrixXd;
using Float_matrix = Eigen::MatrixXf;

// A matrix or a range of its columns.
using Matrix_ref = Eigen::Ref<const Matrix>;
using Float_matrix_ref = Eigen::Ref<const Float_matrix>;

// Computes the product of `a` with `b`.
CGAL_GEODESIC_PROCESSING_EXPORT
void product(const Matrix_ref& a, const Matrix_ref& b, Matrix& result);
CGAL_GEODESIC_PROCESSING_EXPORT
void product(const Float_matrix_ref& a, const Float_matrix_ref& b, Float_matrix& result);

// Computes the product of the transpose of `a` with `b`.
CGAL_GEODESIC_PROCESSING_EXPORT
void transposed_product(const Matrix_ref& a, const Matrix_ref& b, Matrix& result);
CGAL_GEODESIC_PROCESSING_EXPORT
void transposed_product(const Float_matrix_ref& a, const Float_matrix_ref& b, Float_matrix& result);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_PRODUCT_H
