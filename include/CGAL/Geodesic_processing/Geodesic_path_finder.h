// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/internal/distances/Shortest_path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/make_domain.h>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes paths between pairs of vertices, surfels or locations without a distance field.
///
/// An A* search on edges, and on segments across unfolded adjacent faces, finds a path, which is
/// then shortened to a locally shortest path.  On a mesh, its length bounds an exact search: only
/// windows of `Exact` that may belong to a shorter path are propagated, from one end towards the
/// other.  The cost of a query is that of the visited faces.  Copies share the domain, and
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

  /// Returns a shortest path from one vertex, surfel or location to another; empty if they are not
  /// connected.  On a cloud, the path is locally shortest.
  /// \throws Invalid_argument_error if a location is invalid
  template <typename FromLocation, typename ToLocation>
  Surface_path<Surface> operator()(const FromLocation& from, const ToLocation& to)
  {
    return surface_path(m_finder.shortest_path(internal::location(m_domain, from),
                                               internal::location(m_domain, to)));
  }
  /// Returns a locally shortest path; empty if the ends are not connected.
  ///
  /// It takes a few milliseconds at most on scans, where it is on average a few hundredths of a
  /// percent longer than the shortest path.  On other meshes it can be a third longer.
  /// \throws Invalid_argument_error if a location is invalid
  template <typename FromLocation, typename ToLocation>
  Surface_path<Surface> locally_shortest_path(const FromLocation& from, const ToLocation& to)
  {
    return surface_path(m_finder.locally_shortest_path(internal::location(m_domain, from),
                                                       internal::location(m_domain, to)));
  }

private:
  Surface_path<Surface> surface_path(const internal::Bounded_path& path) const
  {
    auto result = internal::surface_path(m_domain, path.locations, internal::infinity);
    if(result.empty())
      return result;
    result.front_distance = result.length;
    result.lower = m_domain.triangles()->scale * path.lower;
    return result;
  }

  Domain m_domain;
  internal::Shortest_path_finder m_finder;
};

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H
