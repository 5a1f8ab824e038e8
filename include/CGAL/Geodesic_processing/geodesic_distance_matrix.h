// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_MATRIX_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_MATRIX_H

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/method.h>
#include <CGAL/Geodesic_processing/internal/distances/distance_matrix.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/tags.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// The rows and the columns of a distance matrix, and the limits of its queries.
struct Matrix_query
{
  std::vector<Front_source> from;
  std::vector<Surface_location> to;
  Front_limits limits;
};

// Reads the sources and the named parameters of geodesic_distance_matrix().
template <typename Domain, typename Sources, typename NamedParameters>
Matrix_query matrix_query(const Domain& domain, const Sources& from_sources,
                          const NamedParameters& np)
{
  std::vector<std::size_t> labels;
  Matrix_query result{sources(domain, from_sources, labels), {}, limits(domain, np)};
  Front_limits& asked = result.limits;
  asked.callback = read_throwing_callback(np);
  if constexpr(!has_parameter<NamedParameters, internal_np::targets_t>)
    asked.targets = locations(domain, from_sources);
  result.to = asked.targets;
  // If there are as many targets as vertices, stopping at the targets does not save time.
  if(result.to.size() >= domain.number_of_vertices())
    asked.targets.clear();
  return result;
}

// Computes geodesic_distance_matrix() by a method that is selected at run time.
template <typename Concurrency_tag, typename Domain, typename Sources, typename NamedParameters>
Eigen::MatrixXd distances_of_pairs(const Domain& domain, Distance_method method,
                                   const Sources& from_sources, const NamedParameters& np)
{
  const Matrix_query query = matrix_query(domain, from_sources, np);
  Distance_engine engine(method, domain.triangles(), read_heat_time_step(np),
                         read_throwing_callback(np));
  engine.select(query.limits);
  return distance_matrix(engine.row_engine(), domain.triangles()->scale, query.from, query.to,
                         query.limits, number_of_threads<Concurrency_tag>(np));
}

// Computes sparse_geodesic_distance_matrix() by a method that is selected at run time.
template <typename Concurrency_tag, typename Domain, typename Vertices, typename NamedParameters>
Eigen::SparseMatrix<double, Eigen::RowMajor>
distances_of_near_pairs(const Domain& domain, Distance_method method, const Vertices& vertices,
                        double maximum_distance, const NamedParameters& np)
{
  Front_limits asked = limits(domain, chain(np).maximum_distance(maximum_distance));
  asked.callback = read_throwing_callback(np);
  std::vector<Front_source> from;
  std::vector<Index> column_of(domain.number_of_vertices(), none);
  for(const auto& vertex : vertices)
  {
    const Surface_location location = domain.inner_vertex(vertex);
    if(column_of[location.vertex] != none)
      throw Invalid_argument_error("A vertex is given twice.");
    column_of[location.vertex] = Index(from.size());
    from.push_back({{location}, 0., Index(from.size())});
  }
  Distance_engine engine(method, domain.triangles(), read_heat_time_step(np),
                         read_throwing_callback(np));
  engine.select(asked);
  return sparse_distance_matrix(engine.row_engine(), domain.triangles()->scale, from, column_of,
                                asked, number_of_threads<Concurrency_tag>(np));
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the matrix of geodesic distances from each source to each target.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`: several
///         sources are processed at a time, by one solver per thread. Both give bitwise equal
///         results.
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Sources a vertex, a surfel, a location, a `Source`, or a range of one of these
/// \param surface the surface, as for `geodesic_distances()`
/// \param sources a vertex, a surfel, a location, a `Source`, or a non-empty range of one of these
/// \param np the named parameters of `make_domain()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{targets}
///     \cgalParamDescription{a vertex, a surfel, a location, or a range of them: the columns}
///     \cgalParamType{a vertex, a surfel, a location, or a range of these}
///     \cgalParamDefault{the sources, which then must be vertices, surfels or locations}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_distance}
///     \cgalParamDescription{targets farther than this distance are not reached}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_threads}
///     \cgalParamDescription{the number of threads, used with `Parallel_tag`}
///     \cgalParamType{`unsigned`}
///     \cgalParamDefault{the number of hardware threads}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the completed fraction of the rows,
///       before and during each row, by one thread at a time; if it returns false, the function
///       throws `Cancelled`}
///     \cgalParamType{`std::function<bool(double)>`}
///     \cgalParamDefault{no callback}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// and `speed_map`, `face_speed_map` and `relative_tolerance` as for
/// `Geodesic_distance_solver::compute()`, and `heat_time_step` as for `Geodesic_distance_solver`.
/// With a relative tolerance, an entry is the mean of the lower and the upper bound.
///
/// \returns a matrix with one row per source and one column per target; an entry is +infinity if
///          the source does not reach the target. With approximate methods or a relative
///          tolerance, it is symmetric only up to their errors.
/// \throws as `Geodesic_distance_solver` and its `compute()`
///
/// Takes one distance computation for each source.
template <typename Method = Automatic, typename Concurrency_tag = Sequential_tag, typename Surface,
          typename Sources, typename NamedParameters = internal::Default_parameters>
Eigen::MatrixXd geodesic_distance_matrix(const Surface& surface, const Sources& sources,
                                         const NamedParameters& np = NamedParameters())
{
  return internal::distances_of_pairs<Concurrency_tag>(
      make_domain(surface, np), internal::read_method<Method>(np), sources, np);
}

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the geodesic distances of all pairs of vertices or surfels whose distance is at most
/// `maximum_distance`.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Concurrency_tag as for `geodesic_distance_matrix()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Vertices a range of vertices or surfels
/// \param surface the surface, as for `geodesic_distances()`
/// \param vertices a range of distinct vertices or surfels; row and column `i` belong to the `i`-th
///        one
/// \param maximum_distance the bound of the distances, not negative
/// \param np the named parameters of `make_domain()`, and `number_of_threads`, `heat_time_step` and
///        `callback` as for `geodesic_distance_matrix()`
/// \returns a compressed matrix with sorted rows. It has an entry for each pair within the bound,
///          even if the distance is 0.
/// \throws Invalid_argument_error if the bound is negative or not a number, if a vertex or surfel
///         occurs twice, or if there are more than 2<SUP>31</SUP> pairs
/// \throws Cancelled if the callback returns false
///
/// Takes time and memory proportional to the number of vertices or surfels that the fronts visit.
template <typename Method = Automatic, typename Concurrency_tag = Sequential_tag, typename Surface,
          typename Vertices, typename NamedParameters = internal::Default_parameters>
Eigen::SparseMatrix<double, Eigen::RowMajor>
sparse_geodesic_distance_matrix(const Surface& surface, const Vertices& vertices,
                                double maximum_distance,
                                const NamedParameters& np = NamedParameters())
{
  return internal::distances_of_near_pairs<Concurrency_tag>(
      make_domain(surface, np), internal::read_method<Method>(np), vertices, maximum_distance, np);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCE_MATRIX_H
