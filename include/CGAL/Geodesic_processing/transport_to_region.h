// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_TO_REGION_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_TO_REGION_H

#include <CGAL/Geodesic_processing/Region_transport_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the minimum cost of moving masses to a region, where each mass arrives at the vertex
/// that is cheapest for it.
///
/// If there are many mass distributions and one region, use `Region_transport_solver`, which
/// factorizes only once.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam From a mass distribution as accepted by `Earth_movers_solver`
/// \tparam Region as for `Region_transport_solver`
/// \param surface the surface on which masses move
/// \param from a mass distribution as accepted by `Earth_movers_solver`
/// \param region as for `Region_transport_solver`
/// \param np named parameters of `Region_transport_solver` and its `compute()`, and the following
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{arrival_map}
///     \cgalParamDescription{receives for each vertex or surfel the mass that arrives there}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
///       `double` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{potential_map}
///     \cgalParamDescription{receives for each vertex or surfel the potential that certifies the
///       lower bound, a function of slope at most one}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
///       `double` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{flow_map}
///     \cgalParamDescription{receives for each face or surfel the flow, a `Vector_3`: mass per unit
///       length of a line across it}
///     \cgalParamType{a model of `WritablePropertyMap` with faces or surfels as keys and `Vector_3`
///       as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the cost with certified bounds
/// \throws as `Region_transport_solver` and its `compute()`
///
/// The time is that of `Region_transport_solver` and its `compute()`.
template <typename Method = Interior_point, typename Surface, typename From, typename Region,
          typename NamedParameters = internal::Default_parameters>
Earth_movers_cost transport_to_region(const Surface& surface, const From& from,
                                      const Region& region,
                                      const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Region_transport_solver<typename decltype(domain)::Surface> solver(domain, region, np);
  const Earth_movers_cost cost = solver.template compute<Method>(from, np);
  if constexpr(internal::has_parameter<NamedParameters, internal_np::arrival_map_t>)
    solver.write_arrivals(internal::parameter(np, internal_np::arrival_map, 0));
  solver.write_maps(np);
  return cost;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_TO_REGION_H
