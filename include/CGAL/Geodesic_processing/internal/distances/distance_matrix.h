// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <optional>
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

// Joins the columns of a matrix that belong to the same region.
struct Column_regions
{
  std::vector<Index> region; // #columns before; the region of each, or none
  std::size_t number_of_regions = 0;
  bool do_average = false; // the mean distance of a region instead of the minimum
};

// A matrix that is written to a file. Its rows begin with the source at first_row.
struct Matrix_job
{
  const std::vector<Front_source>& from;
  const std::vector<Surface_location>& to;
  std::size_t first_row = 0;
  std::optional<Column_regions> regions;
};

// Returns hashes that differ, almost certainly, if the surface or any of the other arguments does.
// The first row, the callback and the targets of the limits have no effect. O(size of the
// arguments).
CGAL_GEODESIC_PROCESSING_EXPORT
Matrix_key matrix_key(const Surface_arrays& triangles, Distance_method method,
                      std::optional<double> heat_time_step, const Matrix_job& job,
                      const Front_limits& limits);

// Computes the tiles of a matrix that are not finished, one after the other, and writes them. The
// rows of a tile are computed by several threads. A region without a reached column is infinite,
// and so is the mean of a region with a column that is not reached. Returns false if cancelled.
// Memory: one tile. Throws File_error, and Invalid_argument_error if a finite distance is too large
// for the format of the file; the file is then removed.
CGAL_GEODESIC_PROCESSING_EXPORT
bool write_distance_matrix(const Row_engine& engine, double scale, const Matrix_job& job,
                           const Front_limits& limits, unsigned number_of_threads,
                           Matrix_file& file);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DISTANCE_MATRIX_H
