// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_METRIC_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_METRIC_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
/// Selects the particular flow of a `Transport_metric`, which `k` eigenfunctions then correct.
enum class Transport_flow
{
  /// The gradient of the solution of Poisson's equation, as in the paper. It balances masses at
  /// vertices.
  gradient,
  /// A Raviart-Thomas field, which balances masses that are spread over the triangles incident to
  /// their vertices. For the same positive `k` the results are closer to geodesic distances; for
  /// `k` = 0 they are less smooth. It is replaced by `gradient` on clouds, and on meshes with
  /// pieces that are connected by a single vertex only.
  balanced
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes spectral approximations of the earth mover's distance: the metrics \f$ d_k \f$ of
/// \cgalCite{cgal:srgb-emd-14}, between locations or general mass distributions.
///
/// A distance is the minimum cost of a flow that transports one mass distribution to the other.
/// The cost is the integral of the length of the flow. Locations are unit masses.
///
/// The flow is the sum of a fixed particular flow, which a `Transport_flow` selects, and a
/// correction. The corrections are spanned by the rotated gradients of \f$ k \f$ eigenfunctions
/// of the Laplacian and by the harmonic fields, which wind around handles and holes. If
/// \f$ k = 0 \f$, there is no correction, also not by harmonic fields. The distance is then smooth
/// and is computed from Green's functions.
///
/// For a fixed `Transport_flow` the distance does not increase with \f$ k \f$. It approaches the
/// geodesic distance but does not converge to it: between points that are several edges apart it
/// remains some percent above, for any basis size. Between adjacent vertices it can be smaller,
/// because the mass of a vertex is spread over its faces.
///
/// For every \f$ k \f$ this is a metric, up to the gap between the computed bounds. The number
/// \f$ k \f$ is rounded up to the end of a group of equal eigenvalues. Hence the distance does not
/// depend on the choice of eigenfunctions. The mass of a location inside a triangle is distributed
/// to the corners by barycentric coordinates. Distances between connected components are infinite.
///
/// Construction takes about as long as 2.5 `k` solutions of Poisson's equation. Copies share all
/// data, and can be queried concurrently. Members that do not state their time take O(1) time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Transport_metric
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;

  /// Precomputes the particular flow and the basis.
  ///
  /// \param surface the surface
  /// \param k the number of eigenfunctions, which is rounded up
  /// \param np the named parameters of `make_domain()`, and
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{transport_flow}
  ///     \cgalParamDescription{the particular flow}
  ///     \cgalParamType{`Transport_flow`}
  ///     \cgalParamDefault{the one with the smaller distances: `gradient` if `k` is 0, otherwise
  ///       `balanced`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Unsupported_surface_error if no triangle has positive area. Also if `k` is positive
  ///         and more than 512 components are closed, or no gap follows the first 512 + 8 `k`
  ///         eigenvalues
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_metric(const Surface& surface, std::size_t k = 0,
                            const NamedParameters& np = NamedParameters())
      : Transport_metric(Domain(surface, np), k, np)
  {}
  /// Uses an existing `domain`, which is shared. `k`, `np` and the time are as for a surface.
  /// \throws Unsupported_surface_error if no triangle has positive area. Also if `k` is positive
  ///         and more than 512 components are closed, or no gap follows the first 512 + 8 `k`
  ///         eigenvalues
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_metric(const Domain& domain, std::size_t k = 0,
                            const NamedParameters& np = NamedParameters())
      : m_domain(domain),
        m_transport(std::make_shared<const internal::Spectral_transport>(
            domain.triangles(), k,
            internal::parameter(np, internal_np::transport_flow,
                                k == 0 ? Transport_flow::gradient : Transport_flow::balanced) ==
                    Transport_flow::gradient
                ? internal::Particular_field::gradient
                : internal::Particular_field::raviart_thomas))
  {}

  /// Returns the domain of the surface.
  const Domain& domain() const { return m_domain; }
  /// Returns the number of eigenfunctions: `k`, rounded up to the next gap between eigenvalues.
  std::size_t basis_size() const { return m_transport->basis_size(); }
  /// Returns the particular flow, which can differ from the requested one.
  Transport_flow flow() const
  {
    return m_transport->kind() == internal::Particular_field::gradient ? Transport_flow::gradient
                                                                       : Transport_flow::balanced;
  }

  /// Computes the cost of transporting one mass distribution to another, with bounds.
  ///
  /// A `balanced` flow transports masses that were spread over triangles. The residual is then
  /// computed for the spread masses.
  ///
  /// \tparam From, To mass distributions, as for `Earth_movers_solver`
  /// \param from, to mass distributions, as for `Earth_movers_solver`
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{the gap between the bounds, relative to the upper bound, at which
  ///       the iteration ends}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{0.001}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations}
  ///     \cgalParamDescription{the maximum number of iterations}
  ///     \cgalParamType{`unsigned`}
  ///     \cgalParamDefault{5,000}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{do_normalize}
  ///     \cgalParamDescription{whether both distributions are scaled to a total mass of one}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{false}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{flow_map}
  ///     \cgalParamDescription{receives the flow, a `Vector_3` for each face or surfel. If the cost
  ///       is infinite, nothing is written}
  ///     \cgalParamType{a model of `WritablePropertyMap` with faces or surfels as keys and
  ///       `Vector_3` as values}
  ///     \cgalParamDefault{nothing is written}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that receives the fraction of the maximum number of
  ///       iterations. If it returns `false`, the function throws `Cancelled`}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error if a location is not on the surface, a mass is not finite, the
  ///         total masses differ, a total mass cannot be normalized, or the tolerance is not
  ///         positive
  /// \throws Cancelled if the callback returns false
  /// \pre Property maps have a value for each of their keys.
  /// \returns the cost with bounds; infinite if the masses differ on a component
  ///
  /// Takes one solution of Poisson's equation, and O(`k` n) time for each iteration.
  template <typename From, typename To, typename NamedParameters = internal::Default_parameters>
  Earth_movers_cost cost(const From& from, const To& to,
                         const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    const std::vector<double>& area = m_transport->operators().area;
    internal::Spectral_transport_options chosen_options = options<Sequential_tag>(np);
    chosen_options.tolerance = internal::parameter(np, internal_np::tolerance, 1e-3);
    chosen_options.maximum_iterations =
        internal::parameter(np, internal_np::maximum_number_of_iterations, 5000u);
    const internal::Mass_distribution moved = internal::difference(
        t, area, internal::masses(m_domain, from), internal::masses(m_domain, to),
        internal::parameter(np, internal_np::do_normalize, false));
    internal::Transport_result found =
        m_transport->transport(internal::masses_at_vertices(t, area, moved), chosen_options);
    internal::rescale(found, t.scale);
    if constexpr(internal::has_parameter<NamedParameters, internal_np::flow_map_t>)
      if(!found.flow.empty())
        internal::write_vectors(m_domain, found.flow,
                                internal::parameter(np, internal_np::flow_map, 0));
    return Earth_movers_cost(found);
  }
  /// Returns the value of `cost()` between two locations or general mass distributions, and takes
  /// the same time. `From`, `To`, `from`, `to` and `np` are as for `cost()`.
  /// \throws as `cost()`
  template <typename From, typename To, typename NamedParameters = internal::Default_parameters>
  double distance(const From& from, const To& to,
                  const NamedParameters& np = NamedParameters()) const
  {
    return cost(from, to, np).value;
  }

  /// Writes the distance from one location to every vertex or surfel.
  ///
  /// For `k` > 0 these are upper bounds. With 50 vertices per eigenfunction they are within one
  /// percent on average. The correction is optimized on clusters of triangles, with one mean vector
  /// for each cluster. The length of the resulting flow is then integrated over all triangles.
  ///
  /// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`. The
  ///         results are identical bit by bit.
  /// \tparam Vertex_or_location a vertex, a surfel or a location
  /// \tparam DistanceMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         `double` as values
  /// \param from a vertex, surfel or location
  /// \param distance_map receives a `double` for each vertex or surfel; infinity on other
  ///        components
  /// \param np `number_of_threads` and `callback` as for `geodesic_distance_matrix()`
  /// \throws Invalid_argument_error if the location is not on the surface
  /// \throws Cancelled if the callback returns false
  ///
  /// Takes one solution of Poisson's equation for each vertex or surfel, and if `k` > 0 another
  /// O(`k` n) time for each.
  template <typename Concurrency_tag = Sequential_tag, typename Vertex_or_location,
            typename DistanceMap, typename NamedParameters = internal::Default_parameters>
  void write_distances(const Vertex_or_location& from, DistanceMap distance_map,
                       const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    const internal::Vector found = m_transport->one_to_all(
        internal::masses_at(t, {internal::location(m_domain, from)}), options<Concurrency_tag>(np));
    m_domain.write([&](internal::Index vertex) { return t.scale * found[vertex]; }, distance_map);
  }

  /// Returns the distances of all pairs of locations, within the tolerance if `k` > 0.
  ///
  /// If `k` = 0, this takes 16 bytes per vertex and location. Otherwise it takes the time of a
  /// `cost()` for each pair.
  ///
  /// \tparam Concurrency_tag as for `write_distances()`
  /// \tparam Locations a vertex, surfel or location, or a range of these
  /// \param locations a range of vertices, surfels or locations
  /// \param np `tolerance` as for `cost()`, and the named parameters of `write_distances()`
  /// \returns a symmetric matrix
  /// \throws Invalid_argument_error as `cost()`
  /// \throws Cancelled if the callback returns false
  template <typename Concurrency_tag = Sequential_tag, typename Locations,
            typename NamedParameters = internal::Default_parameters>
  Eigen::MatrixXd distance_matrix(const Locations& locations,
                                  const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    internal::Spectral_transport_options chosen_options = options<Concurrency_tag>(np);
    chosen_options.tolerance = internal::parameter(np, internal_np::tolerance, 1e-3);
    return t.scale *
           m_transport->all_pairs(internal::masses_at(t, internal::locations(m_domain, locations)),
                                  chosen_options);
  }

private:
  template <typename Concurrency_tag, typename NamedParameters>
  static internal::Spectral_transport_options options(const NamedParameters& np)
  {
    internal::Spectral_transport_options result;
    result.number_of_threads = internal::number_of_threads<Concurrency_tag>(np);
    result.callback = internal::read_throwing_callback(np);
    return result;
  }

  Domain m_domain;
  std::shared_ptr<const internal::Spectral_transport> m_transport;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_METRIC_H
