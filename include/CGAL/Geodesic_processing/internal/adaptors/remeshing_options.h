// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_REMESHING_OPTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_REMESHING_OPTIONS_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/feature_polylines.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Calls visit(h, value) for each halfedge of the domain with the value of its edge in an edge map
// of the mesh. An empty optional stands for no map.
template <typename Domain, typename EdgeMap, typename Visitor>
void for_each_halfedge(const Domain& domain, const EdgeMap& map, const Visitor& visit)
{
  static_assert(!Is_cloud<typename Domain::Surface>::value,
                "An edge map requires a mesh, because a cloud has no edges.");
  const auto& mesh = domain.mesh();
  for(Index f = 0; f < domain.triangles()->number_of_triangles(); ++f)
  {
    auto h = halfedge(domain.face(f), mesh);
    for(Index i = 3 * f; i < 3 * f + 3; ++i, h = next(h, mesh))
      visit(i, get(map, edge(h, mesh)));
  }
}

template <typename Domain, typename EdgeMap, typename Visitor>
void for_each_halfedge(const Domain& domain, const std::optional<EdgeMap>& map,
                       const Visitor& visit)
{
  if(map)
    for_each_halfedge(domain, *map, visit);
}

// Returns for each halfedge whether a remeshing must keep its edge: boundary edges, sharp edges,
// and edges that are constrained by a named parameter.
template <typename Domain, typename NamedParameters>
std::vector<bool> constrained_halfedges(const Domain& domain, const NamedParameters& np)
{
  const double angle = parameter(np, internal_np::sharp_angle, 180.);
  if(!(angle >= 0.))
    throw Invalid_argument_error("The sharp angle is negative or not a number.");
  std::vector<bool> result = boundary_and_sharp_halfedges(*domain.triangles(), angle);
  if constexpr(has_parameter<NamedParameters, CGAL::internal_np::edge_is_constrained_t>)
    for_each_halfedge(domain, parameter(np, CGAL::internal_np::edge_is_constrained, 0),
                      [&](Index i, bool is_kept) { result[i] = result[i] || is_kept; });
  return result;
}

// Returns for each halfedge the spacing of samples along its edge if the edge is kept, in scaled
// units. Zero means no given spacing; the result is empty if no spacing is given at all.
template <typename Domain, typename NamedParameters>
std::vector<double> halfedge_spacing(const Domain& domain, const NamedParameters& np)
{
  const double scale = domain.triangles()->scale;
  const auto checked = [](double spacing)
  {
    if(!(spacing >= 0. && spacing < infinity))
      throw Invalid_argument_error("A spacing along feature edges is negative or not finite.");
    return spacing;
  };
  const auto map = parameter(np, internal_np::edge_spacing_map, 0);
  constexpr bool has_map = has_parameter<NamedParameters, internal_np::edge_spacing_map_t>;
  const double uniform_spacing = checked(parameter(np, internal_np::curve_spacing, 0.)) / scale;
  std::vector<double> result;
  if((has_map && is_given(map)) || uniform_spacing > 0.)
    result.assign(domain.triangles()->corner.size(), uniform_spacing);
  if constexpr(has_map)
    for_each_halfedge(domain, map,
                      [&](Index i, double spacing)
                      {
                        if(checked(spacing) > 0.)
                          result[i] = spacing / scale;
                      });
  return result;
}

// Converts the named parameters of a remeshing or of a base mesh to options. Throws
// Invalid_argument_error if one is out of range.
template <typename Domain, typename NamedParameters>
Remeshing_options remeshing_options(const Domain& domain, std::size_t number,
                                    const NamedParameters& np)
{
  const Surface_arrays& t = *domain.triangles();
  Remeshing_options options;
  options.number_of_samples = number;
  const double deviation = parameter(np, internal_np::maximum_deviation, infinity);
  if(!(deviation > 0.))
    throw Invalid_argument_error("The maximum deviation is not positive.");
  options.maximum_deviation = deviation / t.scale;
  options.does_fit_to_input = parameter(np, internal_np::do_fit, false);
  options.is_feature = constrained_halfedges(domain, np);
  options.feature_spacing = halfedge_spacing(domain, np);
  options.number_of_relaxation_steps =
      parameter(np, internal_np::number_of_relaxation_steps, std::size_t(0));
  options.seed = static_cast<unsigned>(parameter(np, CGAL::internal_np::random_seed, 0u));
  const Front_limits front_limits = limits(domain, np);
  options.callback = front_limits.callback;
  options.slowness = front_limits.slowness;
  if(options.slowness && std::any_of(options.slowness->begin(), options.slowness->end(),
                                     [](double s) { return !(s < infinity); }))
    throw Invalid_argument_error(
        "A speed is zero: a surface cannot be remeshed in regions that no front reaches.");
  if constexpr(has_parameter<NamedParameters, internal_np::first_samples_t>)
    for(const Surface_location& sample :
        locations(domain, parameter(np, internal_np::first_samples, 0)))
    {
      options.first_samples.push_back(canonical(t, sample));
      if(options.first_samples.back().triangle == none)
        throw Invalid_argument_error("A first sample is an isolated vertex.");
    }
  return options;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_REMESHING_OPTIONS_H
