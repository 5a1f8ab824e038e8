// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_FEATURE_DISTANCE_H
#define CGAL_GEODESIC_PROCESSING_FEATURE_DISTANCE_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/Region_transport_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/transport/feature_masses.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Transports uniform mass to the uniform distribution on the feature, and writes the difference of
// the potential and its maximum in each component. Throws as Earth_movers_solver.
template <typename Method, typename Domain, typename Feature, typename DistanceMap,
          typename NamedParameters>
Earth_movers_cost write_fixed_mass_distances(const Domain& domain, const Feature& feature,
                                             DistanceMap distance_map, const NamedParameters& np)
{
  std::vector<std::size_t> labels;
  std::vector<std::vector<Surface_location>> polylines;
  for(const Front_source& source : sources(domain, feature, labels))
    polylines.push_back(source.polyline);
  const Feature_masses masses =
      uniform_feature_masses(*domain.triangles(), read_metric(domain, np), polylines);
  Earth_movers_solver<typename Domain::Surface> solver(domain, np);
  const Earth_movers_cost cost =
      solver.template compute<Method>(masses.surface, masses.feature, np);
  std::vector<double> max_potential(masses.has_feature.size(), -infinity);
  const auto potential = [&](Index i) { return solver.potential(domain.vertex(i)); };
  for(Index i = 0; i < masses.component.size(); ++i)
    max_potential[masses.component[i]] =
        (std::max)(max_potential[masses.component[i]], potential(i));
  domain.write(
      [&](Index i)
      {
        const Index c = masses.component[i];
        return masses.has_feature[c] ? max_potential[c] - potential(i) : infinity;
      },
      distance_map);
  return cost;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the distance to a feature: a point, a curve, the boundary or any set of vertices. It
/// is minus the potential of a uniform mass that is transported to the feature.
///
/// The distance is never above the geodesic distance, and it is smaller by a fraction of an edge.
/// The fraction is larger if the feature is a location inside a face or between surfels.
/// The distances of two points differ by at most the geodesic distance between them. A single
/// solution yields all distances. The distribution of mass at the feature is a variable. On request
/// it is fixed, as in \cgalCite{cgal:srgb-emd-14}, section 7. The result is then the distance only
/// if the feature is a point, or if the fixed distribution is that of shortest paths.
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
/// \param np named parameters of `Region_transport_solver` and its `compute()`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_fix_masses}
///     \cgalParamDescription{whether the mass that arrives is distributed uniformly over the
///       feature. The mass of each component is its area. It has equal masses per length of the
///       polylines of the component, or at each location if no polyline has a length. The written
///       value is the maximum of the potential in the component minus the potential. It changes by
///       at most the distance between two points}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{`capacities` and `spreading_weight` are then not used.}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the integral of the distance over all points with a path to the feature, and its
///          bounds; with fixed masses the cost of the transport to them
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
  if(internal::parameter(np, internal_np::do_fix_masses, false))
    return internal::write_fixed_mass_distances<Method>(domain, feature, distance_map, np);
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
