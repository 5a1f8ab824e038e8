// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_FUZZY_GEODESIC_H
#define CGAL_GEODESIC_PROCESSING_FUZZY_GEODESIC_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>
#include <CGAL/Geodesic_processing/exceptions.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <optional>

namespace CGAL::Geodesic_processing {

namespace internal {

// Returns the named parameter `width`; by default a twentieth of the distance.
template <typename NamedParameters>
double fuzzy_width(double distance, const NamedParameters& np)
{
  if(!(distance < infinity))
    throw Invalid_argument_error("No path connects the two locations.");
  const std::optional<double> width =
      parameter(np, internal_np::width, std::optional<double>()); // an empty one is the default
  const double result = width ? *width : 0.05 * distance;
  if(!(result > 0.) || !std::isfinite(result))
    throw Invalid_argument_error("The width of a fuzzy geodesic must be positive and finite.");
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes the likelihood that geodesics between the neighborhoods of two locations pass each
/// vertex. It is the amount of flow between two mass distributions around these locations.
/// \cgalCite{cgal:srgb-emd-14}, section 7
///
/// The two distributions are Gaussians of the distances by `Automatic`, truncated at four
/// times the width. The length of the flow is smoothed with a quarter of the width, since finer
/// details depend on the triangulation. It is scaled to a maximum of 1. If several paths are
/// equally short, the result weights them by the mass that each carries, unlike
/// `fuzzy_geodesic_by_distances()`.
///
/// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam P a vertex, a surfel or a `Location<Surface>`
/// \tparam Q a vertex, a surfel or a `Location<Surface>`
/// \tparam LikelihoodMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `double` as values
/// \param surface a mesh or a cloud
/// \param p, q two vertices, surfels or locations
/// \param likelihood_map receives a `double` from 0 to 1 for each vertex or surfel
/// \param np named parameters of `Earth_movers_solver`, its `compute()` and
///        `Transport_solution::write_maps()`, and the following
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{width}
///     \cgalParamDescription{the standard deviation of the Gaussians, a length; it should be at
///       least an edge length}
///     \cgalParamType{`double`}
///     \cgalParamDefault{a twentieth of the distance from `p` to `q`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the cost of transporting a unit mass
/// \throws Invalid_argument_error if no path leads from `p` to `q`, or if the width is not
///         positive. The default width is zero if `p` and `q` are the same location.
/// \throws as `Earth_movers_solver` and its `compute()`
///
/// Takes the time of `earth_movers_distance()`, and two distance computations.
template <typename Method = Interior_point, typename Surface, typename P, typename Q,
          typename LikelihoodMap, typename NamedParameters = internal::Default_parameters>
Earth_movers_cost fuzzy_geodesic(const Surface& surface, const P& p, const Q& q,
                                 LikelihoodMap likelihood_map,
                                 const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Solver = Earth_movers_solver<typename decltype(domain)::Surface>;
  using Distances = Geodesic_distance_solver<typename Solver::Domain::Surface>;
  Distances from_p(domain), from_q(domain);
  from_p.compute(p, parameters::targets(q));
  const double width = internal::fuzzy_width(from_p.distance(q), np);
  from_p.compute(p, parameters::maximum_distance(4. * width));
  from_q.compute(q, parameters::maximum_distance(4. * width));
  const auto gaussian_density = [&](const Distances& distances)
  {
    return mass_density(boost::make_function_property_map<typename Solver::Vertex>(
        [&distances, width](const typename Solver::Vertex& vertex)
        {
          const double x = distances.distance(vertex) / width;
          return std::exp(-0.5 * x * x);
        }));
  };
  Solver solver(domain, np);
  const Earth_movers_cost cost = solver.template compute<Method>(
      gaussian_density(from_p), gaussian_density(from_q), internal::chain(np).do_normalize(true));
  solver.write_likelihood(likelihood_map, parameters::smoothing_radius(0.25 * width));
  solver.write_maps(np);
  return cost;
}

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes how short the detour from one location to another through each vertex is:
/// \f$ \exp(-|d(p,x) + d(x,q) - d(p,q)| / \sigma) \f$.  \cgalCite{cgal:scf-fgcsc-10}
///
/// \tparam Method the distance method, as for `geodesic_distances()`
/// \tparam Surface as for `geodesic_distances()`
/// \tparam P a vertex, a surfel or a `Location<Surface>`
/// \tparam Q a vertex, a surfel or a `Location<Surface>`
/// \tparam LikelihoodMap a model of `WritablePropertyMap` with vertices or surfels as keys and
///         `double` as values
/// \param surface a mesh or a cloud
/// \param p, q two vertices, surfels or locations
/// \param likelihood_map receives a `double` from 0 to 1 for each vertex or surfel
/// \param np named parameters of `Geodesic_distance_solver`, and the following
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{width}
///     \cgalParamDescription{\f$ \sigma \f$, a length}
///     \cgalParamType{`double`}
///     \cgalParamDefault{a twentieth of the distance from `p` to `q`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \throws Invalid_argument_error as `fuzzy_geodesic()`
/// \throws as `Geodesic_distance_solver::compute()`
///
/// Takes two distance computations.
template <typename Method = Automatic, typename Surface, typename P, typename Q,
          typename LikelihoodMap, typename NamedParameters = internal::Default_parameters>
void fuzzy_geodesic_by_distances(const Surface& surface, const P& p, const Q& q,
                                 LikelihoodMap likelihood_map,
                                 const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Solver = Geodesic_distance_solver<typename decltype(domain)::Surface, Method>;
  Solver from_p(domain, np), from_q = from_p;
  from_p.compute(p, np);
  from_q.compute(q, np);
  const double distance = from_p.distance(q), width = internal::fuzzy_width(distance, np);
  domain.write(
      [&](internal::Index i)
      {
        const double detour_length =
            from_p.distance(domain.vertex(i)) + from_q.distance(domain.vertex(i));
        return std::exp(-std::abs(detour_length - distance) / width);
      },
      likelihood_map);
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_FUZZY_GEODESIC_H
