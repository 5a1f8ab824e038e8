// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DENSE_PRODUCT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DENSE_PRODUCT_H

#include <CGAL/Geodesic_processing/internal/export.h>

#include <Eigen/Core>

// Products of large matrices, by the BLAS that CHOLMOD brings along, which knows the processor: where it
// is there it takes less than half of the time of Eigen's own for any processor.  One thread each.

namespace CGAL::Geodesic_processing::internal {

using Matrix = Eigen::MatrixXd;
using Float_matrix = Eigen::MatrixXf;

// Some columns of a matrix, or all.
using Columns = Eigen::Ref<const Matrix>;
using Float_columns = Eigen::Ref<const Float_matrix>;

CGAL_GEODESIC_PROCESSING_EXPORT
void product(const Columns& a, const Columns& b, Matrix& result);
CGAL_GEODESIC_PROCESSING_EXPORT
void product(const Float_columns& a, const Float_columns& b, Float_matrix& result);

// Of the transpose of `a` with `b`.
CGAL_GEODESIC_PROCESSING_EXPORT
void transposed_product(const Columns& a, const Columns& b, Matrix& result);
CGAL_GEODESIC_PROCESSING_EXPORT
void transposed_product(const Float_columns& a, const Float_columns& b, Float_matrix& result);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DENSE_PRODUCT_H
