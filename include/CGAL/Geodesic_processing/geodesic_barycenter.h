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
/// The vertex or surfel that minimizes a weighted sum of squared distances, and the minimum.
template <typename Vertex>
struct Geodesic_barycenter
{
  Vertex vertex; ///< the vertex descriptor, or the index of the surfel
  double value;  ///< the weighted sum of squared distances there
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the geodesic barycenter of locations: the vertex or surfel that minimizes the weighted
/// sum of squared distances to them.
///
/// Between vertices the sum can be smaller. On a flat surface the difference is at most the sum of
/// the weights times the squared distance from the minimizer to the vertex. For the barycenter of
/// mass distributions see `transport_barycenter()`.
///
/// \tparam Method as for `geodesic_distances()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Locations a range of vertices, surfels, locations or `Source`s
/// \param surface the surface on which distances are measured
/// \param locations a nonempty range of vertices (or surfels), locations or `Source`s
/// \param np parameters of `Geodesic_distance_solver`, `speed_map` and `face_speed_map` as for its
///        `compute()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{weights}
///     \cgalParamDescription{a range of nonnegative numbers, one for each location, not all zero}
///     \cgalParamType{a range of `double`}
///     \cgalParamDefault{1 each}
///   \cgalParamNEnd
///   \cgalParamNBegin{objective_map}
///     \cgalParamDescription{receives for each vertex or surfel the weighted sum of squared
///       distances: a `double`, +infinity if a location of positive weight does not reach it}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
///       `double` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a `Geodesic_barycenter`
/// \throws Invalid_argument_error as `Geodesic_distance_solver::compute()`. Also if there is no
///         location, a weight is negative or not finite, all weights are zero, or no vertex is
///         reached from all locations
///
/// Takes one distance computation for each location.
template <typename Method = Automatic, typename Surface, typename Locations,
          typename NamedParameters = internal::Default_parameters>
Geodesic_barycenter<typename internal::Surface_traits<Surface_of<Surface>>::Vertex>
geodesic_barycenter(const Surface& surface, const Locations& locations,
                    const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Domain = std::decay_t<decltype(domain)>;
  Geodesic_distance_solver<typename Domain::Surface, Method> solver(domain, np);
  const std::size_t number_of_locations =
      std::size_t(std::distance(std::begin(locations), std::end(locations)));
  if(number_of_locations == 0)
    throw Invalid_argument_error("The range of locations is empty.");
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
    throw Invalid_argument_error("No vertex is reached from all locations.");
  if constexpr(internal::has_parameter<NamedParameters, internal_np::objective_map_t>)
    domain.write([&](internal::Index i) { return sum[i]; },
                 internal::parameter(np, internal_np::objective_map, 0));
  return {domain.vertex(internal::Index(best - sum.begin())), *best};
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_BARYCENTER_H
