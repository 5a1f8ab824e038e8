// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TRANSPORT_METRIC_H
#define CGAL_GEODESIC_PROCESSING_TRANSPORT_METRIC_H

#include <CGAL/Geodesic_processing/Earth_movers_solver.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/masses.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/transport/spectral_transport.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
/// the flow that a `Transport_metric` begins with.
enum class Transport_flow
{
  /// the gradient of the solution of Poisson's equation, as in the paper: it balances masses at sites.
  gradient,
  /// one that balances masses which are spread over the triangles around their sites, after Raviart and
  /// Thomas: nearer to geodesic distances for the same basis, rougher without one.  Clouds, and meshes of
  /// which pieces meet in a vertex alone, have gradients in its place.
  balanced
};

/// \ingroup PkgGeodesicProcessingDistances
///
/// measures by earth mover's distances among fewer flows, from spectral towards geodesic distances: the
/// family of metrics \f$ d_k \f$ of \cgalCite{cgal:srgb-emd-14}, between places or any masses.
///
/// A distance is the least cost, mass times way, of flows that carry the masses of one side to those of
/// the other, a unit of mass between places, among those that differ from a fixed one by turned gradients of \f$ k \f$ eigenfunctions of
/// the Laplacian, and by fields that go around handles and holes.  With \f$ k = 0 \f$ nothing is sought,
/// those fields neither: the distance is smooth, and known by Green's functions alone.  With a growing
/// \f$ k \f$ and one `Transport_flow` it never grows, and comes down towards geodesic distances, but not
/// to them: between points it stays some percent above however large the basis is.
///
/// For every \f$ k \f$ this is a metric, as far as it is computed.  `k` is rounded up, such that no group
/// of eigenfunctions of one eigenvalue is cut: the distance does not depend on their choice.  A place
/// inside a triangle is a mass shared by its corners.  Between components distances are infinite.
///
/// Preparing takes about as long as two and a half `k` solutions of Poisson's equation.  Copies share
/// everything, and may be asked at the same time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Transport_metric
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;

  /// prepares the surface with the flow of the least distances, `gradient` for `k` = 0 and `balanced`
  /// otherwise; `np` is what `make_domain()` takes.
  ///
  /// \throws Unsupported_surface_error when no triangle has an area
  template <typename NamedParameters = internal::Default_parameters>
  explicit Transport_metric(const Surface& surface, std::size_t k = 0,
                            const NamedParameters& np = NamedParameters())
      : Transport_metric(Domain(surface, np), k)
  {}
  explicit Transport_metric(const Domain& domain, std::size_t k = 0)
      : Transport_metric(domain, k, k == 0 ? Transport_flow::gradient : Transport_flow::balanced)
  {}
  Transport_metric(const Domain& domain, std::size_t k, Transport_flow flow)
      : m_domain(domain),
        m_transport(std::make_shared<const internal::Spectral_transport>(
            domain.triangles(), k,
            flow == Transport_flow::gradient ? internal::Particular_field::gradient
                                             : internal::Particular_field::raviart_thomas))
  {}

  const Domain& domain() const { return m_domain; }
  /// returns the number of eigenfunctions: `k`, rounded up to the next gap between eigenvalues.
  std::size_t basis_size() const { return m_transport->basis_size(); }
  /// returns what it begins with, which may be another one than was asked for.
  Transport_flow flow() const
  {
    return m_transport->kind() == internal::Particular_field::gradient ? Transport_flow::gradient
                                                                       : Transport_flow::balanced;
  }

  /// finds out what it costs to move masses, and bounds of it.
  ///
  /// A `balanced` flow moves masses that were spread over triangles; the residual is that of these.
  ///
  /// \param from, to masses, as `Earth_movers_solver` takes them
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{tolerance}
  ///     \cgalParamDescription{of the gap between the bounds, relative to the upper one}
  ///     \cgalParamDefault{0.001} \cgalParamNEnd
  ///   \cgalParamNBegin{maximum_number_of_iterations} \cgalParamDefault{5,000} \cgalParamNEnd
  ///   \cgalParamNBegin{do_normalize}
  ///     \cgalParamDescription{whether to scale both sides so that each sums to one}
  ///     \cgalParamDefault{false} \cgalParamNEnd
  ///   \cgalParamNBegin{flow_map}
  ///     \cgalParamDescription{receives for each face, or surfel, the flow: a `Vector_3`; nothing if
  ///       the cost is infinite} \cgalParamNEnd
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a `std::function<bool(double)>` that gets the fraction of the
  ///       iterations, and ends them by `false`; bounds hold all the same} \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error when a place is not on the surface, a mass not finite, the sums
  ///         differ, nothing can be scaled, or the tolerance is not positive
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
  /// returns the value of `cost()` between two places, or any masses.
  template <typename From, typename To>
  double distance(const From& from, const To& to, double tolerance = 1e-3) const
  {
    return cost(from, to, parameters::tolerance(tolerance)).value;
  }

  /// writes the distance of each site to a place.
  ///
  /// For `k` > 0 these are upper bounds, in the mean within a percent where there are fifty sites for each
  /// eigenfunction: the flow is sought among mean vectors of groups of triangles, and then measured in
  /// all triangles.
  ///
  /// \tparam Concurrency_tag `CGAL::Sequential_tag` (the default) or `CGAL::Parallel_tag`.  The result is
  ///         the same to the last bit.
  /// \param from a site or a location
  /// \param distance_map receives a `double` for each site; infinity on other components
  /// \param np `threads` and `callback` as for `geodesic_distance_matrix()`
  /// \returns false if the callback cancelled it; then nothing is written
  /// \throws Invalid_argument_error when the place is not on the surface
  template <typename Concurrency_tag = Sequential_tag, typename Vertex_or_location,
            typename DistanceMap, typename NamedParameters = internal::Default_parameters>
  bool write_distances(const Vertex_or_location& from, DistanceMap distance_map,
                       const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    const internal::Vector found = m_transport->one_to_all(
        internal::masses_at(t, {internal::location(m_domain, from)}), options<Concurrency_tag>(np));
    if(found.size() == 0)
      return false;
    m_domain.write([&](internal::Index vertex) { return t.scale * found[vertex]; }, distance_map);
    return true;
  }

  /// returns the distances of all pairs of places, within the tolerance for `k` > 0.
  ///
  /// It takes 16 bytes per vertex and place for `k` = 0.
  ///
  /// \tparam Concurrency_tag as for `write_distances()`
  /// \param locations a range of sites or of locations
  /// \param tolerance as for `cost()`
  /// \param np as for `write_distances()`
  /// \returns a symmetric matrix; an empty one when the callback cancelled it
  /// \throws Invalid_argument_error as `cost()`
  template <typename Concurrency_tag = Sequential_tag, typename Locations,
            typename NamedParameters = internal::Default_parameters>
  Eigen::MatrixXd distance_matrix(const Locations& locations, double tolerance = 1e-3,
                                  const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    internal::Spectral_transport_options chosen_options = options<Concurrency_tag>(np);
    chosen_options.tolerance = tolerance;
    return t.scale *
           m_transport->all_pairs(internal::masses_at(t, internal::locations(m_domain, locations)),
                                  chosen_options);
  }

private:
  template <typename Concurrency_tag, typename NamedParameters>
  static internal::Spectral_transport_options options(const NamedParameters& np)
  {
    internal::Spectral_transport_options result;
    result.threads = internal::threads<Concurrency_tag>(np);
    result.callback =
        internal::parameter(np, CGAL::internal_np::callback, std::function<bool(double)>());
    return result;
  }

  Domain m_domain;
  std::shared_ptr<const internal::Spectral_transport> m_transport;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_TRANSPORT_METRIC_H
