// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_WRITE_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_PROCESSING_WRITE_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/geodesic_distance_matrix.h>
#include <CGAL/Geodesic_processing/internal/distances/write_distance_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Reads the regions of the sources or the targets.
template <typename Domain, typename Vertices, typename RegionMap>
Matrix_regions matrix_regions(const Domain& domain, const Vertices& vertices, const RegionMap& map)
{
  static_assert(is_keyed_by<RegionMap, typename Domain::Vertex>,
                "A region map is a property map with vertices or surfels as keys.");
  Matrix_regions result;
  for(const auto& value : vertices)
  {
    const typename Domain::Vertex vertex(value);
    domain.inner_vertex(vertex); // throws if it does not belong to the surface
    const auto region = static_cast<std::size_t>(get(map, vertex)); // negative becomes large
    result.region.push_back(region < none ? static_cast<Index>(region) : none);
    if(result.region.back() != none)
      result.number_of_regions = std::max(result.number_of_regions, region + 1);
  }
  return result;
}
// An empty optional stands for no map.
template <typename Domain, typename Vertices, typename RegionMap>
std::optional<Matrix_regions> matrix_regions(const Domain& domain, const Vertices& vertices,
                                             const std::optional<RegionMap>& map)
{
  if(!map)
    return std::nullopt;
  return matrix_regions(domain, vertices, *map);
}

// Reads the arguments of write_geodesic_distance_matrix() and calls
// write(engine, job, limits, layout, number_of_threads).
template <typename Concurrency_tag, typename Number, typename Domain, typename Sources,
          typename NamedParameters, typename Write>
void with_matrix_job(const Domain& domain, Distance_method method, const Sources& from_sources,
                     const NamedParameters& np, const Write& write)
{
  static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, float>,
                "The numbers of a matrix are of type double or float.");
  const Matrix_query query = matrix_query(domain, from_sources, np);
  Matrix_job job{query.from, query.to};
  job.do_average = parameter(np, internal_np::do_average_regions, false);
  if constexpr(has_parameter<NamedParameters, internal_np::row_region_map_t>)
    job.row_regions =
        matrix_regions(domain, from_sources, parameter(np, internal_np::row_region_map, 0));
  if constexpr(has_parameter<NamedParameters, internal_np::region_map_t>)
  {
    const auto map = parameter(np, internal_np::region_map, 0);
    if constexpr(has_parameter<NamedParameters, internal_np::targets_t>)
      job.column_regions = matrix_regions(domain, parameter(np, internal_np::targets, 0), map);
    else
      job.column_regions = matrix_regions(domain, from_sources, map);
  }
  const std::pair<std::size_t, std::size_t> range = parameter(
      np, internal_np::row_range, std::pair<std::size_t, std::size_t>(0, job.number_of_rows()));
  if(range.first > range.second || range.second > job.number_of_rows())
    throw Invalid_argument_error("row_range is not a range of the rows.");

  const Matrix_layout layout = {range.second - range.first, job.number_of_columns(),
                                std::is_same_v<Number, float> ? Number_format::float32
                                                              : Number_format::float64,
                                range.first, job.number_of_rows()};
  Distance_engine engine(method, domain.triangles(), read_heat_time_step(np),
                         read_throwing_callback(np));
  engine.select(query.limits);
  write(engine.row_engine(), job, query.limits, layout, number_of_threads<Concurrency_tag>(np));
}

// Computes write_geodesic_distance_matrix() to a file.
template <typename Concurrency_tag, typename Number, typename Domain, typename Sources,
          typename NamedParameters>
void write_distances_of_pairs(const Domain& domain, Distance_method method,
                              const Sources& from_sources, const std::string& path,
                              const NamedParameters& np)
{
  const auto write = [&](const Row_engine& engine, const Matrix_job& job,
                         const Front_limits& limits, const Matrix_layout& layout, unsigned threads)
  {
    // One row per thread at least, so that no thread is idle.
    const std::size_t default_size = std::max(std::size_t(1) << 26, threads * layout.row_size());
    Matrix_file file(path, layout, parameter(np, internal_np::tile_size, default_size),
                     matrix_key(*domain.triangles(), method, read_heat_time_step(np), job, limits));
    write_distance_matrix(engine, domain.triangles()->scale, job, limits, threads, file);
  };
  with_matrix_job<Concurrency_tag, Number>(domain, method, from_sources, np, write);
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingDistances
///
/// Writes the matrix of geodesic distances from each source to each target to a file, for matrices
/// that do not fit in memory. The entries are those of `geodesic_distance_matrix()`, by default
/// exact distances on meshes. \cgalCite{cgal:qhyyz-fedgc-16}
///
/// The file has the format `.npy` of NumPy, version 1.0, in row-major order, and can be opened by
/// `numpy.load(path, mmap_mode='r')`. It is created in its final size and written in tiles of at
/// most 1,024 consecutive rows. Until it is complete, its name is `path` + `.unfinished`. An
/// existing file `path` is kept until then, and then replaced. Thus a file `path` is always complete.
///
/// A tile is synchronized with the disk before the text file `path` + `.tiles` records it. If the
/// computation is interrupted, even by `kill -9`, the same call continues after the recorded tiles,
/// and the result is the same to the last bit. The record has hashes of the surface and of the
/// arguments, and checksums, so that damaged lines are ignored. It is locked, so that two processes
/// do not write the same matrix, and it is removed at the end.
///
/// Parts of the matrix can be computed on several machines by the same program: each call has another
/// `row_range` and `path`. `merge_distance_matrices()` joins the parts. The header of a part has a
/// comment with its rows and the hashes, which NumPy ignores.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Concurrency_tag as for `geodesic_distance_matrix()`
/// \tparam Number `double` (the default) or `float`, to which entries are rounded
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Sources as for `geodesic_distance_matrix()`
/// \param surface the surface, as for `geodesic_distances()`
/// \param sources as for `geodesic_distance_matrix()`
/// \param path the file
/// \param np the named parameters of `geodesic_distance_matrix()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{row_range}
///     \cgalParamDescription{the rows that are written: the positions of the first source, or region
///       of `row_region_map`, and past the last one}
///     \cgalParamType{`std::pair<std::size_t, std::size_t>`}
///     \cgalParamDefault{all rows}
///   \cgalParamNEnd
///   \cgalParamNBegin{region_map}
///     \cgalParamDescription{the region of each target, counted from 0. The matrix then has one
///       column per region: the minimum of the distances to its targets. A negative region means
///       that the target is in none. A region without targets has infinite distances.}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertices or surfels as keys and integers
///       as values. The targets must then be a range of vertices or surfels.}
///     \cgalParamDefault{Each target has a column.}
///   \cgalParamNEnd
///   \cgalParamNBegin{row_region_map}
///     \cgalParamDescription{the region of each source, as `region_map`. The matrix then has one row
///       per region: the distances from the nearest of its sources. With both maps, the entries are
///       the distances between regions.}
///     \cgalParamType{a model of `ReadablePropertyMap` with vertices or surfels as keys and integers
///       as values. The sources must then be a range of vertices or surfels.}
///     \cgalParamDefault{Each source has a row.}
///   \cgalParamNEnd
///   \cgalParamNBegin{do_average_regions}
///     \cgalParamDescription{whether an entry is the mean of the distances of all pairs instead of
///       the minimum. It is infinite if a target of the region is not reached.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{tile_size}
///     \cgalParamDescription{the number of bytes of a tile, which has at least one row and at most 1,024}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{2<SUP>26</SUP>, or one row per thread if these are more bytes}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre `region_map` has a value for each target, and `row_region_map` for each source.
/// \throws as `geodesic_distance_matrix()`
/// \throws Invalid_argument_error if `row_range` is not a range of the rows, or if `Number` is
///         `float` and a finite distance is too large for it. The unfinished file is then removed
/// \throws File_error if the file cannot be written, if the disk has too little space, if another
///         process is writing the same file, or if the record belongs to another surface or other
///         arguments
///
/// Takes one distance computation for each source. With `row_region_map` and minima, it takes one for
/// each region, from all of its sources. Uses memory for one tile, for means of `row_region_map` for
/// two, and per thread for one solver and one row. If the callback cancels, finished tiles remain,
/// and the next call continues.
template <typename Method = Automatic, typename Concurrency_tag = Sequential_tag,
          typename Number = double, typename Surface, typename Sources,
          typename NamedParameters = internal::Default_parameters>
void write_geodesic_distance_matrix(const Surface& surface, const Sources& sources,
                                    const std::string& path,
                                    const NamedParameters& np = NamedParameters())
{
  internal::write_distances_of_pairs<Concurrency_tag, Number>(
      make_domain(surface, np), internal::read_method<Method>(np), sources, path, np);
}

/// \ingroup PkgGeodesicProcessingDistances
///
/// Writes the matrix of geodesic distances from each source to each target to memory of the caller,
/// for example to an `Eigen::Map` of a file. No other copy of the matrix exists. The entries, and
/// the regions of targets and sources, are those of `write_geodesic_distance_matrix()` to a file.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Concurrency_tag as for `geodesic_distance_matrix()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Sources as for `geodesic_distance_matrix()`
/// \tparam Matrix a matrix, map or reference of Eigen in row-major order, whose rows are contiguous.
///         Its numbers are of type `double` or `float`, to which entries are rounded
/// \param surface the surface, as for `geodesic_distances()`
/// \param sources as for `geodesic_distance_matrix()`
/// \param matrix receives the distances; the sizes must be those of the result
/// \param np the named parameters of `write_geodesic_distance_matrix()` to a file, except for
///        `tile_size`
/// \pre as for a file
/// \throws as `geodesic_distance_matrix()`
/// \throws Invalid_argument_error if the matrix has another number of rows or columns, if
///         `row_range` is not a range of the rows, or if the numbers are of type `float` and a finite
///         distance is too large for them
/// \throws Cancelled if the callback returns false. Then some rows are not written
///
/// The time is that of a file. Uses memory per thread for one solver and one row, and for means of
/// `row_region_map` 64 MB.
template <typename Method = Automatic, typename Concurrency_tag = Sequential_tag, typename Surface,
          typename Sources, typename Matrix,
          typename NamedParameters = internal::Default_parameters>
void write_geodesic_distance_matrix(const Surface& surface, const Sources& sources,
                                    Eigen::MatrixBase<Matrix>& matrix,
                                    const NamedParameters& np = NamedParameters())
{
  static_assert(bool(Matrix::Flags & Eigen::DirectAccessBit) && bool(Matrix::IsRowMajor) &&
                    Matrix::InnerStrideAtCompileTime == 1,
                "The matrix is in row-major order, and its rows are contiguous.");
  using Number = typename Matrix::Scalar;
  const auto domain = make_domain(surface, np);
  const auto write = [&](const internal::Row_engine& engine, const internal::Matrix_job& job,
                         const internal::Front_limits& limits,
                         const internal::Matrix_layout& layout, unsigned threads)
  {
    if(std::size_t(matrix.rows()) != layout.rows || std::size_t(matrix.cols()) != layout.columns)
      throw Invalid_argument_error(
          "The matrix has another number of rows or columns than the result.");
    internal::write_distance_matrix(
        engine, domain.triangles()->scale, job, limits, threads, layout, matrix.derived().data(),
        std::ptrdiff_t(sizeof(Number)) * std::ptrdiff_t(matrix.derived().outerStride()));
  };
  internal::with_matrix_job<Concurrency_tag, Number>(domain, internal::read_method<Method>(np),
                                                     sources, np, write);
}

/// \ingroup PkgGeodesicProcessingDistances
///
/// Joins parts of a matrix that `write_geodesic_distance_matrix()` has written for several ranges of
/// rows. The result is the same, to the last bit, as that of one call for all rows.
///
/// \tparam Paths a range of `std::string`
/// \param paths the parts, in any order
/// \param merged the file of the result, which is none of the parts. It is written as by
///        `write_geodesic_distance_matrix()`: it has its name only when it is complete, and the same
///        call continues if it was interrupted
/// \throws File_error if a part is not complete or is no matrix of this package, if the parts
///         belong to several surfaces or were computed with different arguments, if rows are missing
///         or are in two parts, or if a file cannot be read or written. The message names the rows
///
/// Takes linear time, and memory for one tile of 64 MB.
template <typename Paths>
void merge_distance_matrices(const Paths& paths, const std::string& merged)
{
  internal::merge_matrix_files(std::vector<std::string>(std::begin(paths), std::end(paths)),
                               merged);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_WRITE_GEODESIC_DISTANCE_MATRIX_H
