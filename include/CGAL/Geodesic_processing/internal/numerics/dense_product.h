// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_PRODUCT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_PRODUCT_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <Eigen/Core>

// Products of large matrices, one of which has few columns or rows, with the wide instructions of a
// processor that has them: half of the time of an OpenBLAS that does not know the processor.  One thread.

namespace CGAL::Geodesic_processing::internal {

using Matrix = Eigen::MatrixXd;
using Float_matrix = Eigen::MatrixXf;

// Some columns of a matrix, or all.
using Matrix_ref = Eigen::Ref<const Matrix>;
using Float_matrix_ref = Eigen::Ref<const Float_matrix>;

CGAL_GEODESIC_PROCESSING_EXPORT
void product(const Matrix_ref& a, const Matrix_ref& b, Matrix& result);
CGAL_GEODESIC_PROCESSING_EXPORT
void product(const Float_matrix_ref& a, const Float_matrix_ref& b, Float_matrix& result);

// Of the transpose of `a` with `b`.
CGAL_GEODESIC_PROCESSING_EXPORT
void transposed_product(const Matrix_ref& a, const Matrix_ref& b, Matrix& result);
CGAL_GEODESIC_PROCESSING_EXPORT
void transposed_product(const Float_matrix_ref& a, const Float_matrix_ref& b, Float_matrix& result);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_DENSE_PRODUCT_H
