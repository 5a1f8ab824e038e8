// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_BARYCENTER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_BARYCENTER_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/weights.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
/// is where the weighted sum of squared distances is the least, and that sum.
template <typename Vertex>
struct Geodesic_barycenter
{
  Vertex vertex;
  double value;
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// finds the barycenter of points: the site at which the weighted sum of squared distances to them is the
/// least.
///
/// Between sites it may be less: where the surface is flat by the sum of weights times the square of the
/// distance from there to the site at most.  For the barycenter of masses see `transport_barycenter()`.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Surface as for `geodesic_distances()`
/// \param surface where distances are measured
/// \param locations a range of vertices, locations or `Source`s; not empty
/// \param np what `make_domain()` takes, `speed_map` as for `Geodesic_distance_solver::compute()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{weights}
///     \cgalParamDescription{a range of numbers, one for each place: not negative, not all zero}
///     \cgalParamDefault{1 each} \cgalParamNEnd
///   \cgalParamNBegin{objective_map}
///     \cgalParamDescription{receives for each site the weighted sum of squared distances: a `double`,
///       +infinity where a place of positive weight does not reach} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error as `Geodesic_distance_solver::compute()`, when there is no place, a
///         weight is negative or not finite, all are zero, or no site is reached by all places
///
/// As many computations of distances as there are places.
template <typename Method = Euclidean_front, typename Surface, typename Locations,
          typename NamedParameters = internal::Default_parameters>
auto geodesic_barycenter(const Surface& surface, const Locations& locations,
                         const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Domain = std::decay_t<decltype(domain)>;
  Geodesic_distance_solver<typename Domain::Surface, Method> solver(domain);
  const std::size_t number_of_locations =
      std::size_t(std::distance(std::begin(locations), std::end(locations)));
  if(number_of_locations == 0)
    throw Invalid_argument_error("There is no place to find the barycenter of.");
  const std::vector<double> weights = internal::weights(np, number_of_locations);

  std::vector<double> sum(domain.number_of_vertices(), 0.);
  auto weight = weights.begin();
  for(const auto& location : locations)
  {
    solver.compute(location, np);
    if(*weight > 0.)
      for(internal::Index i = 0; i < sum.size(); ++i)
      {
        const double distance = solver.distance(domain.vertex(i));
        sum[i] += *weight * distance * distance;
      }
    ++weight;
  }
  const auto best = std::min_element(sum.begin(), sum.end());
  if(best == sum.end() || !(*best < internal::infinity))
    throw Invalid_argument_error("No site is reached by all places.");
  if constexpr(internal::has_parameter<NamedParameters, internal_np::objective_map_t>)
    domain.write([&](internal::Index i) { return sum[i]; },
                 internal::parameter(np, internal_np::objective_map, 0));
  return Geodesic_barycenter<typename Domain::Vertex>{
      domain.vertex(internal::Index(best - sum.begin())), *best};
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_BARYCENTER_H
