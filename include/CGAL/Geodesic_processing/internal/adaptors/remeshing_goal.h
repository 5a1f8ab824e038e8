// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_GOAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_GOAL_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/curves.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/remeshing/remeshing.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// What a map of the mesh's edges says of each side of the domain.
template <typename Surface, typename Domain, typename EdgeMap, typename Use>
void for_each_side(const Surface& surface, const Domain& domain, const EdgeMap& map, const Use& use)
{
  static_assert(std::is_same_v<Surface, typename Domain::Surface> && !Is_cloud<Surface>::value,
                "A map of edges takes the mesh itself, not its domain, and no cloud.");
  for(Index f = 0; f < domain.triangles()->number_of_triangles(); ++f)
  {
    auto h = halfedge(domain.face(f), surface);
    for(Index side = 3 * f; side < 3 * f + 3; ++side, h = next(h, surface))
      use(side, get(map, edge(h, surface)));
  }
}

// #sides: the curves that a remeshing is to keep: borders, sharp edges and those that a map names.
template <typename Surface, typename Domain, typename NamedParameters>
std::vector<bool> curves_to_keep([[maybe_unused]] const Surface& surface, const Domain& domain,
                                 const NamedParameters& np)
{
  const double angle = parameter(np, internal_np::sharp_angle, 180.);
  if(!(angle >= 0.))
    throw Invalid_argument_error("The sharp angle is negative or not a number.");
  std::vector<bool> result = border_and_sharp_sides(*domain.triangles(), angle);
  if constexpr(has_parameter<NamedParameters, CGAL::internal_np::edge_is_constrained_t>)
    for_each_side(surface, domain, parameter(np, CGAL::internal_np::edge_is_constrained, 0),
                  [&](Index side, bool is_kept) { result[side] = result[side] || is_kept; });
  return result;
}

// #sides: how far apart samples are to be on each where it is kept, in the domain's scale; zero
// where that is left open, and empty where it is for all.
template <typename Surface, typename Domain, typename NamedParameters>
std::vector<double> spacing_of_sides([[maybe_unused]] const Surface& surface, const Domain& domain,
                                     const NamedParameters& np)
{
  const double scale = domain.triangles()->scale;
  const auto checked = [](double spacing)
  {
    if(!(spacing >= 0. && spacing < infinity))
      throw Invalid_argument_error("A spacing along curves is negative or not finite.");
    return spacing;
  };
  constexpr bool has_map = has_parameter<NamedParameters, internal_np::edge_spacing_map_t>;
  const double everywhere = checked(parameter(np, internal_np::curve_spacing, 0.)) / scale;
  std::vector<double> result;
  if(has_map || everywhere > 0.)
    result.assign(domain.triangles()->corner.size(), everywhere);
  if constexpr(has_map)
    for_each_side(surface, domain, parameter(np, internal_np::edge_spacing_map, 0),
                  [&](Index side, double spacing)
                  {
                    if(checked(spacing) > 0.)
                      result[side] = spacing / scale;
                  });
  return result;
}

// What named parameters ask of a remeshing, or of a base mesh.
template <typename Surface, typename Domain, typename NamedParameters>
Remeshing_goal remeshing_goal(const Surface& surface, const Domain& domain, std::size_t number,
                              const NamedParameters& np)
{
  const Glued_triangles& t = *domain.triangles();
  Remeshing_goal goal;
  goal.number = number;
  const double deviation = parameter(np, internal_np::maximum_deviation, infinity);
  if(!(deviation > 0.))
    throw Invalid_argument_error("The maximum deviation is not positive.");
  goal.maximum_deviation = deviation / t.scale;
  goal.is_fitted = parameter(np, internal_np::do_fit, false);
  goal.is_curve = curves_to_keep(surface, domain, np);
  goal.curve_spacing = spacing_of_sides(surface, domain, np);
  goal.relaxation_steps = parameter(np, internal_np::number_of_relaxation_steps, std::size_t(0));
  goal.seed = static_cast<unsigned>(parameter(np, CGAL::internal_np::random_seed, 0u));
  const Front_limits asked = limits(domain, np);
  goal.callback = asked.callback;
  goal.slowness = asked.slowness;
  if(goal.slowness && std::any_of(goal.slowness->begin(), goal.slowness->end(),
                                  [](double s) { return !(s < infinity); }))
    throw Invalid_argument_error(
        "A speed is zero: a surface cannot be remeshed where no front goes.");
  if constexpr(has_parameter<NamedParameters, internal_np::first_samples_t>)
    for(const Location& sample : locations(domain, parameter(np, internal_np::first_samples, 0)))
    {
      goal.first_samples.push_back(cleaned(t, sample));
      if(goal.first_samples.back().triangle == none)
        throw Invalid_argument_error("A first sample is an isolated vertex.");
    }
  return goal;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_GOAL_H
