// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_EIGEN_SYSTEM_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_EIGEN_SYSTEM_H

#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <Eigen/Core>

namespace CGAL::Geodesic_processing::internal {

struct Eigen_system
{
  Eigen::VectorXd values;  // ascending
  Eigen::MatrixXd vectors; // orthonormal columns, in the same order
};

// Returns the eigenvalues and eigenvectors of a symmetric matrix, of which only the lower triangle is
// read.  In a source of its own, because Eigen's solver takes ten seconds to compile.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen_system eigen_system(const Eigen::MatrixXd& matrix);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_NUMERICS_EIGEN_SYSTEM_H
