// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_SOLVER_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_barycenter_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/field_vectors.h>
#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/internal/adaptors/transport_options.h>
#include <CGAL/Geodesic_processing/internal/adaptors/weights.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/transport_costs.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingTransport
///
/// finds barycenters of masses: those masses, not negative, from which the weighted sum of squared earth
/// mover's distances to given ones is the least.
///
/// Each of the given masses is what `Earth_movers_solver` takes, not negative: a site or a location, which
/// is a unit mass, a range of these, a property map of masses, or what `mass_density()` makes of one.
/// All have the same sum, on each component.
///
/// That sum of squares is convex, but not strictly: where several masses cost the same, any of them may
/// be found.  Between two points it is all the masses on shortest paths whose mean distance from both is the
/// same, from one in the middle to half at either end.  What to rely on is the cost, of which both bounds
/// are certified as those of `Earth_movers_solver` are; for one point see `geodesic_barycenter()`.
/// \cgalCite{cgal:srgb-emd-14}
///
/// Speeds, metrics, borders and clouds are as for `Earth_movers_solver`.  Copies share what was prepared,
/// and may compute at the same time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Transport_barycenter_solver
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;

  /// prepares the surface: two factorizations.
  ///
  /// \param np as for `Earth_movers_solver`
  /// \throws as `Earth_movers_solver`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_barycenter_solver(const Surface& surface,
                                       const NamedParameters& np = NamedParameters())
      : Transport_barycenter_solver(Domain(surface, np), np)
  {}
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_barycenter_solver(const Domain& domain,
                                       const NamedParameters& np = NamedParameters())
      : m_domain(domain), m_kernel(std::make_shared<const internal::Multilevel_barycenter_solver>(
                              domain.triangles(), internal::number_of_refinements(domain, np),
                              internal::read_metric(domain, np)))
  {}

  const Domain& domain() const { return m_domain; }

  /// finds the barycenter of masses; what the last call found is forgotten.
  ///
  /// \param masses a range, each element masses as above
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{weights}
  ///     \cgalParamDescription{a range of numbers, one for each of the masses: not negative, not all zero}
  ///     \cgalParamDefault{1 each} \cgalParamNEnd
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{of the gap between the bounds, relative to the upper one}
  ///     \cgalParamDefault{0.01} \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations} \cgalParamDefault{5,000} \cgalParamNEnd
  ///   \cgalParamNBegin{do_normalize}
  ///     \cgalParamDescription{whether to scale each of the masses to a sum of one}
  ///     \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{do_start_from_last}
  ///     \cgalParamDescription{whether to start where the last call, for as many masses, ended: for
  ///       example with other weights} \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and
  ///       ends by returning false: with the bounds that it has by then} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when there are no masses, one is negative or not finite, a place is
  ///         none of the surface's, sums differ, as a whole or on a component, or are zero, there are not
  ///         as many weights as masses, a weight is negative or not finite, all are zero, or the
  ///         tolerance is not positive
  ///
  /// An iteration is O(k n log n) for k masses; to a gap of 1 percent it takes some hundreds.
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
    options.callback =
        internal::parameter(np, CGAL::internal_np::callback, std::function<bool(double)>());
    if(internal::parameter(np, internal_np::do_start_from_last, false))
      options.warm_start = std::move(m_result.state);
    m_result = m_kernel->solve(distributions, internal::weights(np, distributions.size()),
                               internal::parameter(np, internal_np::do_normalize, false), options);
    return m_result;
  }

  /// returns the barycenter's mass at a site.
  double mass(Vertex vertex) const { return m_result.masses[m_domain.index(vertex)]; }

  /// writes the barycenter's mass at each site; with that on refined triangles shared by the sites near it.
  template <typename MassMap>
  void write_masses(MassMap map) const
  {
    m_domain.write([&](internal::Index i) { return m_result.masses[i]; }, map);
  }

  /// writes the barycenter's mass per area around each site, as far as masses may move there; zero where
  /// there is no mass, infinity where there is no area.
  template <typename DensityMap>
  void write_density(DensityMap map) const
  {
    const auto density = [&](internal::Index i)
    { return m_result.masses[i] > 0. ? m_result.masses[i] / m_kernel->vertex_areas()[i] : 0.; };
    m_domain.write(density, map);
  }

  /// writes the flow from the barycenter to one of the masses, by its position: see
  /// `Transport_solution::write_flow()`.
  /// \throws Invalid_argument_error when there is no such mass
  template <typename FlowMap>
  void write_flow(std::size_t position, FlowMap map) const
  {
    if(position >= m_result.flows.size())
      throw Invalid_argument_error("There is no flow to mass " + std::to_string(position) + " of " +
                                   std::to_string(m_result.flows.size()) + ".");
    internal::write_vectors(m_domain, m_result.flows[position], map);
  }

private:
  Domain m_domain;
  std::shared_ptr<const internal::Multilevel_barycenter_solver> m_kernel;
  internal::Barycenter_result m_result;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_BARYCENTER_SOLVER_H
