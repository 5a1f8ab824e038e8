// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCES_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCES_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
///
/// computes the distance of each site to its nearest source, along the surface.
///
/// \tparam Method `Euclidean_front` (the default), `Exact`, `Fast_marching`, `Dijkstra` or `Heat`; their pages
///         state their errors
/// \tparam Surface a model of `FaceListGraph`, all of whose faces are triangles, a model of
///         `SurfelRange`, or a domain made by `make_domain()`
/// \param surface where distances are measured
/// \param sources a site, a location, a `Source`, or a range of one of these, not empty
/// \param distance_map receives a value for each site: the distance, in the unit of the coordinates,
///        +infinity where no source reaches
/// \param np what `make_domain()` and `Geodesic_distance_solver::compute()` take, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{source_label_map}
///     \cgalParamDescription{receives for each site the label of its nearest source, by default its
///       position in the range; the largest `std::size_t` where none reaches} \cgalParamNEnd
///   \cgalParamNBegin{predecessor_map}
///     \cgalParamDescription{receives for each site a neighbour nearer to the source, next to which the
///       shortest path arrives; itself at sources and where none reaches} \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws as `make_domain()` and `Geodesic_distance_solver::compute()`
///
/// O(n log n) after `make_domain()`; `Exact` in practice O(n<SUP>1.5</SUP>), the heat method as its
/// factorization.
template <typename Method = Euclidean_front, typename Surface, typename Sources,
          typename DistanceMap, typename NamedParameters = internal::Default_parameters>
void geodesic_distances(const Surface& surface, const Sources& sources, DistanceMap distance_map,
                        const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Geodesic_distance_solver<typename decltype(domain)::Surface, Method> solver(domain);
  solver.compute(sources, np);
  solver.write_distances(distance_map);
  if constexpr(internal::has_parameter<NamedParameters, internal_np::source_label_map_t>)
    solver.write_source_labels(internal::parameter(np, internal_np::source_label_map, 0));
  if constexpr(internal::has_parameter<NamedParameters, internal_np::predecessor_map_t>)
    solver.write_predecessors(internal::parameter(np, internal_np::predecessor_map, 0));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCES_H
