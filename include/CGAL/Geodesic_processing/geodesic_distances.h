// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCES_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCES_H

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes the geodesic distance from each vertex or surfel to its nearest source.
///
/// \tparam Method `Automatic` (the default), `Exact`, `Euclidean_front`, `Fast_marching`,
///         `Dijkstra` or `Heat`; their reference pages state their errors. On a mesh without
///         speeds, `Automatic` is `Exact`. `Runtime_method` reads the named parameter `method`
/// \tparam Surface a model of `FaceListGraph`, all of whose faces are triangles, a model of
///         `SurfelRange`, or a domain made by `make_domain()`
/// \tparam Sources a vertex, a surfel, a location, a `Source`, or a range of one of these
/// \tparam DistanceMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         floating point numbers as values
/// \param surface the surface on which distances are measured
/// \param sources a vertex, a surfel, a location, a `Source`, or a non-empty range of one of these
/// \param distance_map a writable property map that receives the distance of each vertex or surfel,
///        in the unit of the coordinates. The distance is +infinity if no source reaches it
/// \param np the named parameters of `Geodesic_distance_solver` and its `compute()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{source_label_map}
///     \cgalParamDescription{receives the label of the nearest source for each vertex or surfel.
///       The default label of a source is its position in the range. If no source reaches the
///       vertex or surfel, the label is the largest `std::size_t`}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
///       `std::size_t` as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
///   \cgalParamNBegin{predecessor_map}
///     \cgalParamDescription{receives, for each vertex or surfel, a neighbor that is closer to the
///       source. The shortest path arrives through a triangle with this neighbor, or along the edge
///       to it. Sources, and vertices or surfels that no source reaches, receive themselves}
///     \cgalParamType{a model of `WritablePropertyMap` with vertices or surfels as keys and
///       vertices or surfels as values}
///     \cgalParamDefault{nothing is written}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws as `Geodesic_distance_solver` and its `compute()`
///
/// O(n log n) time after `make_domain()`. `Exact` takes O(n<SUP>1.5</SUP>) time in practice; the
/// time of `Heat` is that of its factorization.
template <typename Method = Automatic, typename Surface, typename Sources, typename DistanceMap,
          typename NamedParameters = internal::Default_parameters>
void geodesic_distances(const Surface& surface, const Sources& sources, DistanceMap distance_map,
                        const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  Geodesic_distance_solver<typename decltype(domain)::Surface, Method> solver(domain, np);
  solver.compute(sources, np);
  solver.write_distances(distance_map);
  if constexpr(internal::has_parameter<NamedParameters, internal_np::source_label_map_t>)
    solver.write_source_labels(internal::parameter(np, internal_np::source_label_map, 0));
  if constexpr(internal::has_parameter<NamedParameters, internal_np::predecessor_map_t>)
    solver.write_predecessors(internal::parameter(np, internal_np::predecessor_map, 0));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_DISTANCES_H
