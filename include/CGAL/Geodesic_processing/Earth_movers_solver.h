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

/// Selects an interior point method for the second-order cone program. It takes few iterations,
/// each with a factorization, and reaches any gap. \cgalCite{cgal:v-cvxopt-10}
struct Interior_point
{};

/// Selects the alternating direction method of multipliers (ADMM). It takes many cheap
/// iterations, uses one factorization for all queries, and is suited for gaps of a percent.
/// \cgalCite{cgal:srgb-emd-14}, section 5
struct Alternating_directions
{};

/// Selects iteratively reweighted least squares, for comparison. Each iteration takes a
/// factorization, and the gap stalls at about a percent. \cgalCite{cgal:srgb-emd-14}, figure 4
struct Weiszfeld
{};

namespace internal {

// Returns the method that a tag stands for.
template <typename Method>
constexpr Transport_method transport_method()
{
  return std::is_same_v<Method, Interior_point> ? Transport_method::interior_point
         : std::is_same_v<Method, Weiszfeld>    ? Transport_method::weiszfeld
                                                : Transport_method::admm;
}

} // namespace internal

/// Gives access to the potential and the flow of the last query of a solver.
///
/// Members that write a property map take O(n) time. Other members that do not state their time
/// take O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Transport_solution
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;

  /// Returns the domain of the surface.
  const Domain& domain() const { return m_domain; }

  /// Returns the potential at a vertex or surfel. The potential increases along the flow, with
  /// slope at most one. Its integral over the target mass minus that over the source mass is the
  /// lower bound, if masses are at vertices. The bound of other masses, for example of densities,
  /// is an integral on the refined surface, of which only the original vertices have a value here.
  /// \param vertex a vertex or surfel of the surface
  /// \throws Invalid_argument_error if there was no query
  double potential(Vertex vertex) const { return last_result().potential[m_domain.index(vertex)]; }

  /// Writes the potential of each vertex or surfel, a `double`, to a property map.
  /// \tparam PotentialMap a model of `WritablePropertyMap` with vertices or surfels as keys
  /// \param map receives the potential
  /// \throws Invalid_argument_error if there was no query
  template <typename PotentialMap>
  void write_potential(PotentialMap map) const
  {
    const internal::Vector& potential = last_result().potential;
    m_domain.write([&](internal::Index i) { return potential[i]; }, map);
  }

  /// Writes the flow to a property map: a `Vector_3` for each face of a mesh or each surfel of a
  /// cloud, in mass per unit length of a line across it. If the surface was refined, this is the
  /// mean over the triangles of a face.
  /// \tparam FlowMap a model of `WritablePropertyMap` with faces or surfels as keys and `Vector_3`
  ///         as values
  /// \param map receives the flow
  /// \throws Invalid_argument_error if there was no query
  template <typename FlowMap>
  void write_flow(FlowMap map) const
  {
    internal::write_vectors(m_domain, last_result().flow, map);
  }

  /// Writes the likelihood that mass passes each vertex or surfel, a number in [0, 1]. It is the
  /// mean length of the flow in the incident triangles, divided by its maximum. Smoothing takes one
  /// factorization.
  ///
  /// \tparam LikelihoodMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         `double` as values
  /// \param map receives a `double` for each vertex or surfel
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{smoothing_radius}
  ///     \cgalParamDescription{standard deviation of the diffusion that smooths the result, in the
  ///       unit of the coordinates}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0: not smoothed}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error if there was no query, or if the radius is negative or not
  ///         finite
  template <typename LikelihoodMap, typename NamedParameters = internal::Default_parameters>
  void write_likelihood(LikelihoodMap map, const NamedParameters& np = NamedParameters()) const
  {
    const double radius = internal::parameter(np, internal_np::smoothing_radius, 0.);
    if(!(radius >= 0. && radius < internal::infinity))
      throw Invalid_argument_error("The smoothing radius is negative or not finite.");
    const internal::Surface_arrays& t = *m_domain.triangles();
    internal::Vector lengths = internal::mean_magnitudes(t, last_result().flow);
    if(radius > 0.)
      lengths = internal::diffused(internal::operators(t), lengths, radius / t.scale).cwiseMax(0.);
    const double largest = lengths.size() > 0 ? lengths.maxCoeff() : 0.;
    m_domain.write([&](internal::Index i) { return largest > 0. ? lengths[i] / largest : 0.; },
                   map);
  }

  /// Returns a tracer of streamlines of the flow of the last query.
  ///
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{do_straighten}
  ///     \cgalParamDescription{whether lines are shortened to geodesics; ignored if there is a
  ///       metric, or a speed that is neither zero nor one}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`true`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error if there was no query
  ///
  /// On a mesh this takes two factorizations and up to 300 back substitutions.
  template <typename NamedParameters = internal::Default_parameters>
  Streamline_tracer<Surface> streamlines(const NamedParameters& np = NamedParameters()) const
  {
    return {m_domain, *m_kernel, last_result(),
            internal::parameter(np, internal_np::do_straighten, true)};
  }

  /// Writes the potential and the flow to the property maps `potential_map` and `flow_map` of `np`,
  /// if it has them.
  /// \throws Invalid_argument_error if there was no query
  template <typename NamedParameters>
  void write_maps(const NamedParameters& np) const
  {
    internal::write_transport_maps(m_domain, last_result(), np);
  }

protected:
  template <typename NamedParameters>
  Transport_solution(const Domain& domain, const NamedParameters& np,
                     internal::Transport_region region = {})
      : m_domain(domain), m_kernel(std::make_shared<const internal::Multilevel_transport_solver>(
                              domain.triangles(), internal::number_of_refinements(domain, np),
                              internal::read_metric(domain, np), std::move(region)))
  {}

  template <typename NamedParameters>
  internal::Transport_options options(internal::Transport_method method, const NamedParameters& np)
  {
    internal::Transport_options result = internal::transport_options(np);
    result.method = method;
    result.do_normalize = internal::parameter(np, internal_np::do_normalize, false);
    if(internal::parameter(np, internal_np::do_start_from_last, false))
      result.warm_start = std::move(m_result.state);
    return result;
  }

  Earth_movers_cost cost() const { return m_result; }

  // Returns the result of the last query. Throws Invalid_argument_error if there was none.
  const internal::Transport_result& last_result() const
  {
    if(m_result.flow.empty())
      throw Invalid_argument_error("Nothing was computed yet: compute() must be called before.");
    return m_result;
  }

  Domain m_domain;
  std::shared_ptr<const internal::Multilevel_transport_solver> m_kernel;
  internal::Transport_result m_result;
};

/// Computes earth mover's distances between mass distributions on one surface.
///
/// The earth mover's distance is the 1-Wasserstein distance whose cost is the length of paths. It
/// is the minimum of the integral of the length of a flow. The divergence of this flow must be the
/// difference of the two mass distributions. This class computes a flow that is constant in each
/// face, and a potential of slope one that certifies a lower bound.
/// \cgalCite{cgal:srgb-emd-14}
///
/// Between two points, the result is the geodesic distance minus an error of the order of an edge
/// length. This error is some tenths of a percent on common meshes, and zero in the plane. The
/// distance is symmetric. It satisfies the triangle inequality up to the gap between the bounds.
///
/// A mass distribution is one of the following:
/// - a vertex, surfel or location: a unit mass there,
/// - a nonempty range of these: a unit mass in equal fractions,
/// - a property map of vertices or surfels: the mass at each, which may be negative,
/// - the result of `mass_density()`: mass per area, linear in each face.
///
/// Both distributions must have the same total mass on each connected component.
///
/// No mass crosses the boundary. On a cloud, the triangles of the local triangulation of each
/// surfel are used. Copies share the factorizations, and can compute concurrently.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Earth_movers_solver : public Transport_solution<Surface>
{
  using Base = Transport_solution<Surface>;

public:
  using typename Base::Domain;

  /// Factorizes the Laplacian on the last two refinement levels. About 1 KB per vertex.
  ///
  /// \param surface the surface, as for `geodesic_distances()`
  /// \param np named parameters of `make_domain()`, and the following
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{number_of_refinements}
  ///     \cgalParamDescription{the number of uniform 1-to-4 subdivisions of each triangle; each
  ///       halves the error and takes four to eight times as long}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{1 up to 5,000 vertices or surfels, otherwise 0}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{speed_map, face_speed_map}
  ///     \cgalParamDescription{as for `Geodesic_distance_solver::compute()`; the cost of a path is
  ///       then its travel time}
  ///     \cgalParamType{as for `Geodesic_distance_solver::compute()`}
  ///     \cgalParamDefault{1 everywhere}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{metric_map}
  ///     \cgalParamDescription{a symmetric positive definite matrix M for each vertex or surfel.
  ///       The length of a vector v is the square root of v<SUP>T</SUP> M v, divided by the speed.
  ///       M of a triangle is the mean of its corners}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with vertices or surfels as keys and
  ///       `Eigen::Matrix3d` values}
  ///     \cgalParamDefault{the identity}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{face_metric_map}
  ///     \cgalParamDescription{a symmetric positive definite matrix for each face of a mesh}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with faces as keys and `Eigen::Matrix3d`
  ///       values}
  ///     \cgalParamDefault{the identity}
  ///     \cgalParamExtra{`metric_map` and `face_metric_map` exclude each other.}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws as `make_domain()`
  /// \throws Unsupported_surface_error if no triangle has an area or the refined surface is too
  ///         large
  /// \throws Invalid_argument_error if a speed or a metric is invalid
  ///
  /// Takes two factorizations, each about O(n<SUP>1.5</SUP>).
  template <typename NamedParameters = internal::Default_parameters>
  explicit Earth_movers_solver(const Surface& surface,
                               const NamedParameters& np = NamedParameters())
      : Earth_movers_solver(Domain(surface, np), np)
  {}
  /// Uses an existing `domain`, which is shared. The time and `np` are as for a surface.
  /// \throws as for a surface, except for the exceptions of `make_domain()`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Earth_movers_solver(const Domain& domain, const NamedParameters& np = NamedParameters())
      : Base(domain, np)
  {}

  /// Computes the distance between two mass distributions. This replaces the potential and the
  /// flow of the last query.
  ///
  /// \tparam Method `Interior_point`, `Alternating_directions` or `Weiszfeld`
  /// \tparam From, To mass distributions as listed above
  /// \param from, to mass distributions as listed above
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the gap between the bounds, relative to the upper bound, at which
  ///       the iteration ends}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.001}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDescription{the maximum number of iterations on each level}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{100, for `Alternating_directions` 5,000}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_normalize}
  ///     \cgalParamDescription{whether both distributions are scaled to a total mass of one}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_bound_from_above}
  ///     \cgalParamDescription{whether `Earth_movers_cost::upper_continuous` is computed, which
  ///       takes a few times as long; meshes only}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`false`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_start_from_last}
  ///     \cgalParamDescription{whether `Alternating_directions` starts from the final state of the
  ///       last call, which saves iterations if the masses are similar}
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
  /// \returns the distance with certified bounds
  /// \throws Invalid_argument_error if a mass is not finite, if a location is not on the surface,
  ///         or if a range is empty
  /// \throws Invalid_argument_error if the total masses differ on the surface or on a component, or
  ///         if a total mass that must be normalized is not positive
  /// \throws Invalid_argument_error if the tolerance is not positive
  /// \throws Unsupported_surface_error if `do_bound_from_above` is set on a cloud
  /// \throws Cancelled if the callback returns false. The results of the last call remain valid.
  ///
  /// The default method takes 5 to 20 iterations of O(n<SUP>1.5</SUP>) to a gap of 0.1 percent.
  template <typename Method = Interior_point, typename From, typename To,
            typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost compute(const From& from, const To& to,
                            const NamedParameters& np = NamedParameters())
  {
    return compute(internal::transport_method<Method>(), from, to, np);
  }
#ifndef DOXYGEN_RUNNING
  template <typename From, typename To, typename NamedParameters>
  Earth_movers_cost compute(internal::Transport_method method, const From& from, const To& to,
                            const NamedParameters& np)
  {
    const auto options = this->options(method, np);
    this->m_result = this->m_kernel->solve(internal::masses(this->m_domain, from),
                                           internal::masses(this->m_domain, to), options);
    return this->cost();
  }
#endif
};

/// @}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_EARTH_MOVERS_SOLVER_H
