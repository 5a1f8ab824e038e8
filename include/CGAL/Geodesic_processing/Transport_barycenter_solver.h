// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_SOLVER_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_barycenter_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/field_vectors.h>
#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/internal/adaptors/transport_options.h>
#include <CGAL/Geodesic_processing/internal/adaptors/weights.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/transport_costs.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// Computes barycenters of mass distributions on one surface. The barycenter is the nonnegative
/// distribution that minimizes the weighted sum of squared earth mover's distances to the given
/// ones.
///
/// Each given distribution must be nonnegative. It can have any type that `Earth_movers_solver`
/// accepts: a vertex, surfel or location (unit mass), a range of these, a property map of masses,
/// or the result of `mass_density()`. All must have the same total mass on each connected
/// component.
///
/// The minimum is not unique, since the objective is convex but not strictly convex. If several
/// distributions have the same cost, any of them is returned. For two points, this set contains
/// all distributions on shortest paths whose mean distances to both points are equal. For example,
/// all mass is at the midpoint, or half of it is at each end. The cost is unique, and its bounds
/// are certified as in `Earth_movers_solver`. If the barycenter must be a point, use
/// `geodesic_barycenter()`.
/// \cgalCite{cgal:srgb-emd-14}
///
/// Speeds, metrics, boundaries and clouds are treated as in `Earth_movers_solver`. Copies share the
/// factorizations, and can compute concurrently.
///
/// Members that write a property map take O(n) time. Other members that do not state their time
/// take O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Transport_barycenter_solver
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;

  /// Refines the surface and computes two factorizations, each in about O(n<SUP>1.5</SUP>) time.
  ///
  /// \param surface the surface, as for `geodesic_distances()`
  /// \param np named parameters of `Earth_movers_solver`
  /// \throws as `Earth_movers_solver`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_barycenter_solver(const Surface& surface,
                                       const NamedParameters& np = NamedParameters())
      : Transport_barycenter_solver(Domain(surface, np), np)
  {}
  /// Uses an existing `domain`, which is shared. The time and `np` are as for a surface.
  /// \throws as for a surface, except for the exceptions of `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_barycenter_solver(const Domain& domain,
                                       const NamedParameters& np = NamedParameters())
      : m_domain(domain), m_kernel(std::make_shared<const internal::Multilevel_barycenter_solver>(
                              domain.triangles(), internal::number_of_refinements(domain, np),
                              internal::read_metric(domain, np)))
  {}

  /// Returns the domain of the surface.
  const Domain& domain() const { return m_domain; }

  /// Computes the barycenter of mass distributions. This replaces the result of the last call.
  ///
  /// \tparam Masses a range of mass distributions
  /// \param masses a range of mass distributions as listed above
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{weights}
  ///     \cgalParamDescription{a weight for each distribution: not negative, not all zero}
  ///     \cgalParamType{a range of numbers}
  ///     \cgalParamDefault{1 for each}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the gap between the bounds, relative to the upper bound, at which
  ///       the iteration ends}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.01}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDescription{the maximum number of iterations}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{5,000}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_normalize}
  ///     \cgalParamDescription{whether each distribution is scaled to a total mass of one}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_start_from_last}
  ///     \cgalParamDescription{whether to start from the final state of the last call, which must
  ///       have had as many distributions; for example, if only weights change}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{receives the progress in [0, 1]; if it returns `false`, the function
  ///       throws `Cancelled`}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \pre Property maps have a value for each of their keys.
  /// \returns the cost of the barycenter with certified bounds
  /// \throws Invalid_argument_error if there is no distribution, if a mass is negative or not
  ///         finite, or if a location is not on the surface
  /// \throws Invalid_argument_error if the total masses are zero, or if they differ on the surface
  ///         or on a component
  /// \throws Invalid_argument_error if the number of weights is not the number of distributions,
  ///         if a weight is negative or not finite, or if all weights are zero
  /// \throws Invalid_argument_error if the tolerance is not positive, or if `do_start_from_last` is
  ///         set and the number of distributions differs from that of the last call
  /// \throws Cancelled if the callback returns false
  ///
  /// An iteration is O(k n log n) for k distributions. A gap of 1 percent takes some hundred
  /// iterations.
  template <typename Masses, typename NamedParameters = internal::Default_parameters>
  Transport_barycenter_cost compute(const Masses& masses,
                                    const NamedParameters& np = NamedParameters())
  {
    std::vector<internal::Mass_distribution> distributions;
    for(const auto& distribution : masses)
      distributions.push_back(internal::masses(m_domain, distribution));
    internal::Barycenter_options options;
    options.tolerance = internal::parameter(np, internal_np::tolerance, options.tolerance);
    options.maximum_iterations =
        internal::parameter(np, internal_np::maximum_number_of_iterations, 0u);
    options.callback = internal::read_throwing_callback(np);
    if(internal::parameter(np, internal_np::do_start_from_last, false))
      options.warm_start = std::move(m_result.state);
    m_result = m_kernel->solve(distributions, internal::weights(np, distributions.size()),
                               internal::parameter(np, internal_np::do_normalize, false), options);
    return m_result;
  }

  /// Returns the mass of the barycenter at a vertex or surfel.
  /// \param vertex a vertex or surfel of the surface
  /// \throws Invalid_argument_error if no barycenter was computed
  double mass(Vertex vertex) const { return last_masses()[m_domain.index(vertex)]; }

  /// Writes the mass of the barycenter at each vertex or surfel, a `double`. Masses at vertices
  /// that were inserted by refinement are distributed to the original ones.
  /// \tparam MassMap a model of `WritablePropertyMap` with vertices or surfels as keys
  /// \param map receives the masses
  /// \throws Invalid_argument_error if no barycenter was computed
  template <typename MassMap>
  void write_masses(MassMap map) const
  {
    const internal::Vector& masses = last_masses();
    m_domain.write([&](internal::Index i) { return masses[i]; }, map);
  }

  /// Writes the density of the barycenter at each vertex or surfel. This is the mass divided by a
  /// third of the area of the incident triangles outside of obstacles. If there is no mass, the
  /// density is zero. If there is mass but no area, it is infinite.
  /// \tparam DensityMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         `double` as values
  /// \param map receives the densities
  /// \throws Invalid_argument_error if no barycenter was computed
  template <typename DensityMap>
  void write_density(DensityMap map) const
  {
    const internal::Vector& masses = last_masses();
    const auto density = [&](internal::Index i)
    { return masses[i] > 0. ? masses[i] / m_kernel->vertex_areas()[i] : 0.; };
    m_domain.write(density, map);
  }

  /// Writes the flow from the barycenter to the given distribution at `position`, as
  /// `Transport_solution::write_flow()`.
  /// \tparam FlowMap as for `Transport_solution::write_flow()`
  /// \param map receives the flow
  /// \throws Invalid_argument_error if `position` is not less than the number of distributions
  template <typename FlowMap>
  void write_flow(std::size_t position, FlowMap map) const
  {
    if(position >= m_result.flows.size())
      throw Invalid_argument_error("There is no flow with index " + std::to_string(position) +
                                   "; the number of flows is " +
                                   std::to_string(m_result.flows.size()) + ".");
    internal::write_vectors(m_domain, m_result.flows[position], map);
  }

private:
  // Returns the masses of the last barycenter. Throws Invalid_argument_error if there was none.
  const internal::Vector& last_masses() const
  {
    if(m_result.masses.size() == 0)
      throw Invalid_argument_error("Nothing was computed yet: compute() must be called before.");
    return m_result.masses;
  }

  Domain m_domain;
  std::shared_ptr<const internal::Multilevel_barycenter_solver> m_kernel;
  internal::Barycenter_result m_result;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_SOLVER_H
