// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the distances from each source, one query each, to each location, times `scale`. The
// matrix is #from x #to; unreachable pairs are infinite. Returns an empty matrix if the callback
// of the limits cancelled it.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::MatrixXd distance_matrix(const Row_engine& engine, double scale,
                                const std::vector<Front_source>& from,
                                const std::vector<Surface_location>& to, const Front_limits& limits,
                                unsigned number_of_threads);

// Returns the distances between the sources that are within the limits, times `scale`. The matrix
// is #from x #from. column: #vertices; the position of a vertex among the sources, or none.
// Throws Invalid_argument_error if there are more than 2^31 - 1 entries. Returns an empty matrix
// if cancelled.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::SparseMatrix<double, Eigen::RowMajor>
sparse_distance_matrix(const Row_engine& engine, double scale,
                       const std::vector<Front_source>& from, const std::vector<Index>& column,
                       const Front_limits& limits, unsigned number_of_threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H
