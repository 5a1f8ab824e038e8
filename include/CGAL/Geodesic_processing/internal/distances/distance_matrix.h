// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/distances/heat.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <variant>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What computes the rows of a matrix; each thread has a copy.
using Distance_engine = std::variant<const Front*, const Window_propagation*, const Heat_solver*>;

// The distances from each source, alone, to each place, times the scale.  Empty when the callback of
// the limits cancelled it.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::MatrixXd distance_matrix(const Distance_engine& engine, double scale,
                                const std::vector<Front_source>& from,
                                const std::vector<Surface_location>& to, const Front_limits& limits,
                                unsigned threads);

// Those within the limits, from each of some sites to each; throws Invalid_argument_error when there
// are more than 2^31.  column[site] is none or the site's place among the sources.
CGAL_GEODESIC_PROCESSING_EXPORT
Eigen::SparseMatrix<double, Eigen::RowMajor>
sparse_distance_matrix(const Distance_engine& engine, double scale,
                       const std::vector<Front_source>& from, const std::vector<Index>& column,
                       const Front_limits& limits, unsigned threads);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H
