// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_TO_REGION_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_TO_REGION_H

#include <CGAL/Geodesic_processing/Region_transport_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// finds out what it costs to move masses to wherever in a region it costs the least, once.  For many
/// masses and one region `Region_transport_solver` is prepared only once.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \param surface along which masses move
/// \param from masses, as `Earth_movers_solver` takes them
/// \param region as for `Region_transport_solver`
/// \param np what `Region_transport_solver` and its `compute()` take, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{arrival_map}
///     \cgalParamDescription{receives for each vertex or surfel the mass that arrives there}
///     \cgalParamNEnd
///   \cgalParamNBegin{potential_map}
///     \cgalParamDescription{receives for each vertex or surfel the function of slope one that proves
///       the lower bound} \cgalParamNEnd
///   \cgalParamNBegin{flow_map}
///     \cgalParamDescription{receives for each face, or surfel, the flow: a `Vector_3`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws as `Region_transport_solver` and its `compute()`
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
