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
/// measures by biharmonic distances \cgalCite{cgal:lrf-bd-10}, which are smooth everywhere, know the whole
/// surface, and are no lengths of paths: `Transport_metric` is compared with them.
///
/// Between components distances are infinite.  Copies share everything, and may be asked at the same
/// time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Biharmonic_metric
{
public:
  using Domain = internal::Domain_of<Surface>;
  using Vertex = typename Domain::Vertex;
  using Location = typename Domain::Location;

  /// prepares the surface; `np` is what `make_domain()` takes.
  ///
  /// \throws Unsupported_surface_error when no triangle has an area
  template <typename NamedParameters = internal::Default_parameters>
  explicit Biharmonic_metric(const Surface& surface, const NamedParameters& np = NamedParameters())
      : Biharmonic_metric(Domain(surface, np))
  {}
  explicit Biharmonic_metric(const Domain& domain)
      : m_domain(domain),
        m_distances(std::make_shared<const internal::Biharmonic_distances>(*domain.triangles()))
  {}

  const Domain& domain() const { return m_domain; }

  /// returns the distance between two places, sites or locations.
  ///
  /// \throws Invalid_argument_error when a place is not on the surface
  template <typename P, typename Q>
  double distance(const P& p, const Q& q) const
  {
    return pairs({internal::location(m_domain, p), internal::location(m_domain, q)})(0, 1);
  }

  /// writes the distance of each site to a place.  The first call solves a system for each site, the
  /// next ones two.
  ///
  /// \tparam Concurrency_tag as for `Transport_metric::write_distances()`
  /// \param from a site or a location
  /// \param distance_map receives a `double` for each site; infinity on other components
  /// \param np `threads` as for `geodesic_distance_matrix()`
  /// \throws Invalid_argument_error when the place is not on the surface
  template <typename Concurrency_tag = Sequential_tag, typename Vertex_or_location,
            typename DistanceMap, typename NamedParameters = internal::Default_parameters>
  void write_distances(const Vertex_or_location& from, DistanceMap distance_map,
                       const NamedParameters& np = NamedParameters()) const
  {
    const internal::Surface_arrays& t = *m_domain.triangles();
    const internal::Vector found =
        m_distances->one_to_all(internal::masses_at(t, {internal::location(m_domain, from)}),
                                internal::threads<Concurrency_tag>(np));
    m_domain.write([&](internal::Index vertex) { return t.scale * found[vertex]; }, distance_map);
  }

  /// returns the distances of all pairs of places, a range of sites or of locations.
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
