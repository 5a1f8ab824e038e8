// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_BIHARMONIC_METRIC_H
#define CGAL_GEODESIC_PROCESSING_BIHARMONIC_METRIC_H

#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>
#include <CGAL/Geodesic_processing/internal/adaptors/limits.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <CGAL/tags.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingDistances
///
/// Computes biharmonic distances \cgalCite{cgal:lrf-bd-10}. They are smooth everywhere and depend
/// on the whole surface, but they are not lengths of paths. They serve as a comparison for
/// `Transport_metric`.
///
/// Distances between connected components are infinite. Copies share all data, and can be queried
/// concurrently.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Biharmonic_metric
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;

  /// Precomputes the factorization, which takes about O(n<SUP>1.5</SUP>) time.
  ///
  /// \param surface the surface
  /// \param np named parameters of `make_domain()`
  /// \throws Unsupported_surface_error if no triangle has positive area
  template <typename NamedParameters = internal::Default_parameters>
  explicit Biharmonic_metric(const Surface& surface, const NamedParameters& np = NamedParameters())
      : Biharmonic_metric(Domain(surface, np))
  {}
  /// Uses an existing `domain`, which is shared. The time is that for a surface.
  /// \throws Unsupported_surface_error if no triangle has positive area
  explicit Biharmonic_metric(const Domain& domain)
      : m_domain(domain),
        m_distances(std::make_shared<const internal::Biharmonic_distances>(*domain.triangles()))
  {}

  /// Returns the domain of the surface. O(1).
  const Domain& domain() const { return m_domain; }

  /// Returns the distance between two vertices, surfels or locations. Takes two solutions of a
  /// linear system.
  ///
  /// \tparam P, Q a vertex, a surfel or a location
  /// \param p, q two vertices, surfels or locations
  /// \throws Invalid_argument_error if a location is not on the surface
  template <typename P, typename Q>
  double distance(const P& p, const Q& q) const
  {
    return pairs({internal::location(m_domain, p), internal::location(m_domain, q)})(0, 1);
  }

  /// Writes the distance from one location to every vertex or surfel. The first call takes one
  /// solution of a linear system per vertex, each later call takes two.
  ///
  /// \tparam Concurrency_tag as for `Transport_metric::write_distances()`
  /// \tparam Vertex_or_location a vertex, a surfel or a location
  /// \tparam DistanceMap a model of `WritablePropertyMap` with vertices or surfels as keys and
  ///         `double` as values
  /// \param from a vertex, surfel or location
  /// \param distance_map receives a `double` for each vertex or surfel; infinity on other
  ///        components
  /// \param np `number_of_threads` as for `geodesic_distance_matrix()`
  /// \throws Invalid_argument_error if the location is not on the surface
  template <typename Concurrency_tag = Sequential_tag, typename Vertex_or_location,
            typename DistanceMap, typename NamedParameters = internal::Default_parameters>
  void write_distances(const Vertex_or_location& from, DistanceMap distance_map,
                       const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    const internal::Vector found =
        m_distances->one_to_all(internal::masses_at(t, {internal::location(m_domain, from)}),
                                internal::number_of_threads<Concurrency_tag>(np));
    m_domain.write([&](internal::Index vertex) { return t.scale * found[vertex]; }, distance_map);
  }

  /// Returns the distances of all pairs of locations, as a symmetric matrix. Takes one solution of
  /// a linear system and O(k n) time for each of k locations.
  ///
  /// \tparam Locations a vertex, surfel or location, or a range of these
  /// \param locations a range of vertices, surfels or locations
  /// \throws Invalid_argument_error if a location is not on the surface
  template <typename Locations>
  Eigen::MatrixXd distance_matrix(const Locations& locations) const
  {
    return pairs(internal::locations(m_domain, locations));
  }

private:
  Eigen::MatrixXd pairs(const std::vector<internal::Surface_location>& locations) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    return t.scale * m_distances->all_pairs(internal::masses_at(t, locations));
  }

  Domain m_domain;
  std::shared_ptr<const internal::Biharmonic_distances> m_distances;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_BIHARMONIC_METRIC_H
