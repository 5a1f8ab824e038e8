// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_DISTANCE_H
#define CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_DISTANCE_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// finds out what it costs to move masses along a surface: the earth mover's distance with the lengths of
/// paths as cost.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \param surface along which masses move
/// \param from, to masses, as `Earth_movers_solver` takes them
/// \param np what `Earth_movers_solver` and its `compute()` take, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{potential_map}
///     \cgalParamDescription{receives for each vertex or surfel the function of slope one that proves
///       the lower bound} \cgalParamNEnd
///   \cgalParamNBegin{flow_map}
///     \cgalParamDescription{receives for each face, or surfel, the flow: a `Vector_3`} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws as `Earth_movers_solver` and its `compute()`
template <typename Method = Interior_point, typename Surface, typename From, typename To,
          typename NamedParameters = internal::Default_parameters>
Earth_movers_cost earth_movers_distance(const Surface& surface, const From& from, const To& to,
                                        const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Earth_movers_solver<typename decltype(domain)::Surface> solver(domain, np);
  const Earth_movers_cost cost = solver.template compute<Method>(from, to, np);
  solver.write_maps(np);
  return cost;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_DISTANCE_H
