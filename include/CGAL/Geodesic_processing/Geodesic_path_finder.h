// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// finds paths between two places, one pair after the other, at interactive speed: an A* search over
/// edges and unfolded pairs of faces, then straightening.
///
/// On a mesh a path is locally shortest, as those of `geodesic_path()`; on scans it is in the mean some
/// hundredths of a percent longer than the shortest of all.  No distance field is computed: a query costs
/// what it visits.  Copies share the domain, and may search at the same time.
///
/// \tparam Surface as for `geodesic_distances()`, not a domain
template <typename Surface>
class Geodesic_path_finder
{
public:
  using Domain = internal::Domain_of<Surface>;

  /// prepares the surface; `np` is what `make_domain()` takes.
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_path_finder(const Surface& surface,
                                const NamedParameters& np = NamedParameters())
      : Geodesic_path_finder(Domain(surface, np))
  {}
  explicit Geodesic_path_finder(const Domain& domain)
      : m_domain(domain), m_finder(domain.triangles())
  {}

  const Domain& domain() const { return m_domain; }

  /// sharpens the bounds of the search by distances from `number` sites far apart: worth its time, that of
  /// as many fronts over the whole surface, before hundreds of queries.  \cgalCite{cgal:gh-cspas-05}
  void add_landmarks(unsigned number) { m_finder.add_landmarks(number); }

  /// returns a path from one site or location to another; empty when they are not connected.
  /// \throws Invalid_argument_error when a location is not usable
  template <typename FromLocation, typename ToLocation>
  Surface_path<Surface> operator()(const FromLocation& from, const ToLocation& to)
  {
    const auto found =
        m_finder(internal::location(m_domain, from), internal::location(m_domain, to));
    const auto path = internal::shorten_path(*m_domain.triangles(), found);
    auto result = internal::surface_path(m_domain, path, internal::infinity);
    if(!path.empty())
      result.front_distance = result.length;
    return result;
  }

private:
  Domain m_domain;
  internal::Path_finder m_finder;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H
