// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WRITE_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WRITE_DISTANCE_MATRIX_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/distances/Matrix_file.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Joins the rows or the columns of a matrix that belong to the same region.
struct Matrix_regions
{
  std::vector<Index> region; // of each row or column before; or none
  std::size_t number_of_regions = 0;
};

// The distances from sources, or from regions of sources, to locations or to regions of them.
struct Matrix_job
{
  const std::vector<Front_source>& from;
  const std::vector<Surface_location>& to;
  std::optional<Matrix_regions> row_regions = {}, column_regions = {};
  bool do_average = false; // the mean of the distances between regions instead of the minimum

  std::size_t number_of_rows() const
  {
    return row_regions ? row_regions->number_of_regions : from.size();
  }
  std::size_t number_of_columns() const
  {
    return column_regions ? column_regions->number_of_regions : to.size();
  }
};

// Returns hashes that differ, almost certainly, if the surface or any of the other arguments does.
// The callback and the targets of the limits have no effect. O(size of the arguments).
CGAL_GEODESIC_PROCESSING_EXPORT
Matrix_key matrix_key(const Surface_arrays& triangles, Distance_method method,
                      std::optional<double> heat_time_step, const Matrix_job& job,
                      const Front_limits& limits);

// Computes the tiles of a matrix that are not finished, one after the other, and writes them. Takes
// one query per row; for means between regions, one query per source. Several threads compute them.
//
// The entry of an empty region is infinite, and so is a mean if a pair is not connected. The
// minimum from a region is the distance from all of its sources in one query. With approximate
// methods, it can differ from the minimum of their single queries.
//
// Returns false if cancelled. Memory: a tile; for means between regions two tiles, and per thread a
// row. Throws File_error, and Invalid_argument_error if a finite distance is too large for the
// format of the file; the file is then removed.
CGAL_GEODESIC_PROCESSING_EXPORT
bool write_distance_matrix(const Row_engine& engine, double scale, const Matrix_job& job,
                           const Front_limits& limits, unsigned number_of_threads,
                           Matrix_file& file);

// As write_distance_matrix() to a file, but writes the rows to memory, in which they follow each
// other at distances of `row_stride` bytes. All threads compute different rows. If cancelled, some
// rows are not written.
CGAL_GEODESIC_PROCESSING_EXPORT
bool write_distance_matrix(const Row_engine& engine, double scale, const Matrix_job& job,
                           const Front_limits& limits, unsigned number_of_threads,
                           const Matrix_layout& layout, void* rows, std::ptrdiff_t row_stride);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WRITE_DISTANCE_MATRIX_H
