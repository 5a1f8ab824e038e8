// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_FEATURE_DISTANCE_H
#define CGAL_GEODESIC_PROCESSING_FEATURE_DISTANCE_H

#include <CGAL/Geodesic_processing/Region_transport_solver.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the distance to a feature: a point, a curve, the boundary or any set of vertices. It
/// is minus the potential of a uniform mass that is transported to the feature.
///
/// The distance is never above the geodesic distance, and it is smaller by a fraction of an edge.
/// The fraction is larger if the feature is a location inside a face or between surfels.
/// The distances of two points differ by at most the geodesic distance between them. A single
/// solution yields all distances. The distribution of mass at the feature is a variable. If it is
/// fixed, as in \cgalCite{cgal:srgb-emd-14}, section 6.2, only distances to points are obtained.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Feature as `Region` of `Region_transport_solver`
/// \tparam DistanceMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `double` as values
/// \param surface a mesh or a cloud
/// \param feature as the region of `Region_transport_solver`
/// \param distance_map receives a `double` for each vertex or surfel; infinity if no path leads to
///        the feature
/// \param np named parameters of `Region_transport_solver` and its `compute()`
/// \returns the integral of the distance over all points with a path to the feature, and its bounds
/// \throws as `Region_transport_solver` and its `compute()`
///
/// 10 to 25 iterations of O(n<SUP>1.5</SUP>) each.
template <typename Method = Interior_point, typename Surface, typename Feature,
          typename DistanceMap, typename NamedParameters = internal::Default_parameters>
Earth_movers_cost feature_distance(const Surface& surface, const Feature& feature,
                                   DistanceMap distance_map,
                                   const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Solver = Region_transport_solver<typename decltype(domain)::Surface>;
  Solver solver(domain, feature, np);
  const auto unit_density = [&](const typename Solver::Vertex& vertex)
  { return solver.is_reachable(vertex) ? 1. : 0.; };
  const Earth_movers_cost cost = solver.template compute<Method>(
      mass_density(boost::make_function_property_map<typename Solver::Vertex>(unit_density)), np);
  const auto distance = [&](internal::Index i)
  {
    const auto vertex = domain.vertex(i);
    // Close to a location inside a face, the potential can be slightly positive.
    return solver.is_reachable(vertex) ? std::max(0., -solver.potential(vertex))
                                       : internal::infinity;
  };
  domain.write(distance, distance_map);
  return cost;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_FEATURE_DISTANCE_H
