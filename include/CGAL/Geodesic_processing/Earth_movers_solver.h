// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_SOLVER_H
#define CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_SOLVER_H

#include <CGAL/Geodesic_processing/Streamline_tracer.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/operators/diffusion.h>
#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/internal/adaptors/transport_options.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/parameters.h>
#include <CGAL/Geodesic_processing/transport_costs.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_processing {

/// \addtogroup PkgGeodesicProcessingTransport
/// @{

/// chooses an interior point method for the second-order cone program: few iterations, each with a
/// factorization, to gaps of any size.  \cgalCite{cgal:v-cvxopt-10}
struct Interior_point
{};

/// chooses the alternating direction method of multipliers: many cheap iterations with one factorization
/// for all queries, for gaps of a percent.  \cgalCite{cgal:srgb-emd-14}, section 5
struct Alternating_directions
{};

/// chooses reweighted least squares, as of figure 4 there: a factorization in each iteration, and gaps of
/// about a percent that do not close.  For comparison.
struct Weiszfeld
{};

/// has the potential and the flow that the last query of a solver found.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Transport_solution
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;

  const Domain& domain() const { return m_domain; }

  /// returns the potential of a site: it grows along the flow, nowhere by more than distance does, and
  /// its integral over the masses is the lower bound.
  double potential(Vertex vertex) const { return m_result.potential[m_domain.index(vertex)]; }

  /// writes the potential of each site.
  template <typename PotentialMap>
  void write_potential(PotentialMap map) const
  {
    m_domain.write([&](internal::Index i) { return m_result.potential[i]; }, map);
  }

  /// writes the flow, in mass per length of a line across: a `Vector_3` for each face of a mesh, or
  /// each surfel of a cloud.  Where triangles were divided it is the mean over the parts.
  template <typename FlowMap>
  void write_flow(FlowMap map) const
  {
    internal::write_vectors(m_domain, m_result.flow, map);
  }

  /// writes for each site how much flows there, the mean length of the flow around it, relative to where
  /// that is the largest: from 0 to 1.
  /// \param radius by how much it is blurred: a standard deviation, in the coordinates' unit
  template <typename LikelihoodMap>
  void write_likelihood(LikelihoodMap map, double radius = 0.) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    internal::Vector lengths = internal::mean_magnitudes(t, m_result.flow);
    if(radius > 0.)
      lengths = internal::diffused(internal::operators(t), lengths, radius / t.scale).cwiseMax(0.);
    const double largest = lengths.size() > 0 ? lengths.maxCoeff() : 0.;
    m_domain.write([&](internal::Index i) { return largest > 0. ? lengths[i] / largest : 0.; },
                   map);
  }

  /// returns what follows the flow of the last query.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{do_straighten}
  ///     \cgalParamDescription{whether lines are pulled taut; never where there is a metric, or a speed
  ///       that is neither zero nor one} \cgalParamDefault{true} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when there was no query
  ///
  /// On a mesh two factorizations and up to 300 solutions.
  template <typename NamedParameters = internal::Default_parameters>
  Streamline_tracer<Surface> streamlines(const NamedParameters& np = NamedParameters()) const
  {
    if(m_result.flow.empty())
      throw Invalid_argument_error("There are no lines of a flow that was not computed.");
    return {m_domain, *m_kernel, m_result,
            internal::parameter(np, internal_np::do_straighten, true)};
  }

  /// writes the potential and the flow to the property maps `potential_map` and `flow_map` of `np`,
  /// if it has them.
  template <typename NamedParameters>
  void write_maps(const NamedParameters& np) const
  {
    internal::write_transport_maps(m_domain, m_result, np);
  }

protected:
  template <typename NamedParameters>
  Transport_solution(const Domain& domain, const NamedParameters& np,
                     internal::Transport_region region = {})
      : m_domain(domain), m_kernel(std::make_shared<const internal::Multilevel_transport_solver>(
                              domain.triangles(), internal::number_of_refinements(domain, np),
                              internal::read_metric(domain, np), std::move(region)))
  {}

  template <typename Method, typename NamedParameters>
  internal::Transport_options options(const NamedParameters& np)
  {
    using internal::Transport_method;
    internal::Transport_options result = internal::transport_options(np);
    result.method = std::is_same_v<Method, Interior_point> ? Transport_method::interior_point
                    : std::is_same_v<Method, Weiszfeld>    ? Transport_method::weiszfeld
                                                           : Transport_method::admm;
    result.do_normalize = internal::parameter(np, internal_np::do_normalize, false);
    if(internal::parameter(np, internal_np::do_start_from_last, false))
      result.warm_start = std::move(m_result.state);
    return result;
  }

  Earth_movers_cost cost() const { return m_result; }

  Domain m_domain;
  std::shared_ptr<const internal::Multilevel_transport_solver> m_kernel;
  internal::Transport_result m_result;
};

/// finds out what it costs to move masses along a surface, for many masses on one surface.
///
/// The earth mover's distance, or 1-Wasserstein distance with lengths of paths as cost, is the least
/// integral of the length of a flow that leaves where there is too much mass, and arrives where some is
/// missing.  Here the flow is a vector for each face, and what proves a lower bound a function of slope
/// one.  Between two points it is the geodesic distance, less a part of the order of an edge: some
/// tenths of a percent on common meshes; in the plane it is exact.  It is symmetric, and the triangle
/// inequality holds within the gap between the bounds.  \cgalCite{cgal:srgb-emd-14}
///
/// Masses, on either side, are one of
/// - a site or a location: a unit mass there,
/// - a range of these, not empty: a unit mass in equal parts,
/// - a property map of vertices or surfels: mass at each, which may be negative,
/// - what `mass_density()` makes of such a map: mass per area, linear in each face.
///
/// What one side has more than the other is what moves; it must sum to zero, as a whole and on each
/// component.
///
/// Borders let nothing pass.  On a cloud the triangles around each surfel are used.  Copies share what
/// was prepared, and may compute at the same time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Earth_movers_solver : public Transport_solution<Surface>
{
  using Base = Transport_solution<Surface>;

public:
  using typename Base::Domain;

  /// prepares the surface: two factorizations, about 1 KB per vertex.
  ///
  /// \param np what `make_domain()` takes, and
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{number_of_refinements}
  ///     \cgalParamDescription{how often each triangle is divided in four, flat: each time what is lost
  ///       halves, for four to eight times the time}
  ///     \cgalParamDefault{1 up to 5,000 vertices or surfels, 0 above} \cgalParamNEnd
  ///   \cgalParamNBegin{speed_map}
  ///     \cgalParamDescription{the speed at vertices or in faces, finite and not negative, zero at
  ///       obstacles: time is what moving costs then} \cgalParamDefault{1 everywhere} \cgalParamNEnd
  ///   \cgalParamNBegin{metric_map}
  ///     \cgalParamDescription{an `Eigen::Matrix3d` M for each face or vertex, symmetric and positive
  ///       definite: the length of a vector v is the root of v<SUP>T</SUP> M v, over the speed}
  ///     \cgalParamDefault{the identity} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `make_domain()`
  /// \throws Unsupported_surface_error when there is no triangle with an area, or too many
  /// \throws Invalid_argument_error when a speed or a metric is not usable
  template <typename NamedParameters = internal::Default_parameters>
  explicit Earth_movers_solver(const Surface& surface,
                               const NamedParameters& np = NamedParameters())
      : Earth_movers_solver(Domain(surface, np), np)
  {}
  template <typename NamedParameters = internal::Default_parameters>
  explicit Earth_movers_solver(const Domain& domain, const NamedParameters& np = NamedParameters())
      : Base(domain, np)
  {}

  /// finds out what it costs to move masses; what the last call found is forgotten.
  ///
  /// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
  /// \param from, to masses as above
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{of the gap between the bounds, relative to the upper one}
  ///     \cgalParamDefault{0.001} \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDefault{100, of `Alternating_directions` 5,000} \cgalParamNEnd
  ///   \cgalParamNBegin{do_normalize}
  ///     \cgalParamDescription{whether to scale both sides so that each sums to one}
  ///     \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{do_bound_from_above}
  ///     \cgalParamDescription{whether to find `Earth_movers_cost::upper_continuous`: a few times as
  ///       long; meshes only} \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{do_start_from_last}
  ///     \cgalParamDescription{whether `Alternating_directions` start where the last call ended, which
  ///       pays when the masses are much the same} \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a `std::function<bool(double)>` that is told the fraction done and
  ///       ends by returning false: with the bounds that it has by then} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when a mass is not finite, a place is none of the surface's, a
  ///         range is empty, the sums differ, as a whole or on a component, a side that is to be
  ///         normalized has no positive sum, or the tolerance is not positive
  ///
  /// An iteration is O(n<SUP>1.5</SUP>); to 0.1 percent the default takes 5 to 20.
  template <typename Method = Interior_point, typename From, typename To,
            typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost compute(const From& from, const To& to,
                            const NamedParameters& np = NamedParameters())
  {
    const auto options = this->template options<Method>(np);
    this->m_result = this->m_kernel->solve(internal::masses(this->m_domain, from),
                                           internal::masses(this->m_domain, to), options);
    return this->cost();
  }
};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_SOLVER_H
