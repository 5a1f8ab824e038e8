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
/// Computes paths between pairs of vertices, surfels or locations at interactive speed.
///
/// An A* search on edges, and on segments across unfolded adjacent faces, finds a path, which is
/// then shortened.
///
/// On a mesh, a path is locally shortest, as a path of `geodesic_path()`.  On scans, it is on
/// average a few hundredths of a percent longer than the exact shortest path.  No distance field is
/// computed: the cost of a query is that of the visited vertices.  Copies share the domain, and
/// different copies can be used concurrently.
///
/// \tparam Surface as for `geodesic_distances()`, but not a domain
template <typename Surface>
class Geodesic_path_finder
{
public:
  using Domain = internal::Domain_of<Surface>;

  /// Precomputes the domain of the surface; `np` takes the named parameters of `make_domain()`.
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_path_finder(const Surface& surface,
                                const NamedParameters& np = NamedParameters())
      : Geodesic_path_finder(Domain(surface, np))
  {}
  /// Uses an existing domain, which is shared.
  explicit Geodesic_path_finder(const Domain& domain)
      : m_domain(domain), m_finder(domain.triangles())
  {}

  /// Returns the domain of the surface.
  const Domain& domain() const { return m_domain; }

  /// Improves the lower bounds of the search by the distances from `number` landmarks: vertices or
  /// surfels far from each other.  \cgalCite{cgal:gh-cspas-05}  Each landmark takes one search on
  /// the whole surface, so that landmarks pay off for hundreds of queries.
  void add_landmarks(unsigned number) { m_finder.add_landmarks(number); }

  /// Returns a path from one vertex, surfel or location to another; empty if they are not
  /// connected.
  /// \throws Invalid_argument_error if a location is invalid
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
