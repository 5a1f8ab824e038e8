// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_DISTANCE_H
#define CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_DISTANCE_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the earth mover's distance (1-Wasserstein distance) between two mass distributions on
/// a surface, whose cost is the length of paths.
///
/// If many distributions on one surface are compared, use `Earth_movers_solver`, which factorizes
/// only once.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam From a mass distribution as accepted by `Earth_movers_solver`
/// \tparam To a mass distribution as accepted by `Earth_movers_solver`
/// \param surface the surface on which masses move
/// \param from, to mass distributions as accepted by `Earth_movers_solver`
/// \param np named parameters of `Earth_movers_solver` and its `compute()`, and the following
///
/// \cgalNamedParamsBegin
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
/// \returns the distance with certified bounds
/// \throws as `Earth_movers_solver` and its `compute()`
///
/// Two factorizations and 5 to 20 iterations of O(n<SUP>1.5</SUP>).
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
