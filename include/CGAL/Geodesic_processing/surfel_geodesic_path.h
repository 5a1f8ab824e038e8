// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SURFEL_GEODESIC_PATH_H
#define CGAL_GEODESIC_PROCESSING_SURFEL_GEODESIC_PATH_H

#include <CGAL/Geodesic_processing/Surfel_path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/is_supported.h>

#include <CGAL/tags.h>

#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a geodesic path on a surfel cloud by minimizing an energy. \cgalCite{cgal:rdsk-asg-06}
///
/// If there is more than one pair, `Surfel_path_finder` is faster: it reads the cloud only once.
///
/// \tparam Cloud a model of the concept `SurfelRange`, or its domain
/// \tparam FromLocation a surfel or a `Location<Cloud>`
/// \tparam ToLocation as `FromLocation`
/// \param surfels a model of `SurfelRange`, or its domain
/// \param from a surfel or a location
/// \param to a surfel or a location
/// \param np the named parameters of `Surfel_path_finder`
/// \returns the path; empty if `from` and `to` are not connected
/// \throws as `Surfel_path_finder` and its `operator()`
///
/// O(n log n) for the preparation; the path itself is found in a small fraction of this time.
template <typename Cloud, typename FromLocation, typename ToLocation,
          typename NamedParameters = internal::Default_parameters>
Surfel_path<Surface_of<Cloud>> surfel_geodesic_path(const Cloud& surfels, const FromLocation& from,
                                                    const ToLocation& to,
                                                    const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::surfel_geodesic_path, Cloud>());
  return Surfel_path_finder<Surface_of<Cloud>>(surfels, np)(from, to);
}

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a geodesic path for each of many pairs.
///
/// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`: several
///         pairs are processed at a time, on one cloud and one graph. Both give bitwise equal
///         results.
/// \tparam SurfelRange a model of the concept `SurfelRange`
/// \tparam Pairs a range of pairs
/// \param finder the path finder of the cloud, which is not modified
/// \param pairs a range of pairs of surfels or locations
/// \param np `number_of_threads`: the number of threads, used with `Parallel_tag`; by default, the
///        number of hardware threads
/// \returns a path for each pair; empty if its surfels or locations are not connected
/// \throws as `Surfel_path_finder::operator()`
///
/// Takes the time of `Surfel_path_finder::operator()` for each pair.
template <typename Concurrency_tag = Sequential_tag, typename SurfelRange, typename Pairs,
          typename NamedParameters = internal::Default_parameters>
std::vector<Surfel_path<SurfelRange>>
surfel_geodesic_paths(const Surfel_path_finder<SurfelRange>& finder, const Pairs& pairs,
                      const NamedParameters& np = NamedParameters())
{
  std::vector<std::pair<internal::Tangent_location, internal::Tangent_location>> query_pairs;
  for(const auto& [from, to] : pairs)
    query_pairs.emplace_back(finder.tangent_location(from), finder.tangent_location(to));
  std::vector<Surfel_path<SurfelRange>> result;
  for(const internal::Cloud_path& path : internal::find_paths(
          finder.kernel(), query_pairs, internal::number_of_threads<Concurrency_tag>(np)))
    result.push_back(finder.outer(path));
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFEL_GEODESIC_PATH_H
