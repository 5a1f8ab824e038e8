// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H

#include <CGAL/Geodesic_processing/Surface_path.h>
#include <CGAL/Geodesic_processing/Surfel_path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/callback.h>
#include <CGAL/Geodesic_processing/internal/distances/Shortest_path_finder.h>
#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>
#include <CGAL/Geodesic_processing/make_domain.h>
#include <CGAL/Geodesic_processing/shorten_polyline.h>

#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

// Converts a path of a Shortest_path_finder.
template <typename Domain>
Surface_path<typename Domain::Surface> surface_path(const Domain& domain, const Bounded_path& path)
{
  auto result = surface_path(domain, path.locations, infinity);
  if(result.empty())
    return result;
  result.front_distance = result.length;
  result.lower = domain.triangles()->scale * path.lower;
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes paths between pairs of vertices, surfels or locations without a distance field.
///
/// On a mesh, an A* search on edges, and on segments across unfolded adjacent faces, finds a path,
/// which is then shortened to a locally shortest path. Its length bounds an exact search: only
/// windows of `Exact` that may belong to a shorter path are propagated, from one end towards the
/// other. The cost of a query is that of the visited faces.
///
/// On a cloud, paths are those of `Surfel_path_finder`, which minimizes an energy. `initial_path`
/// of a result is the graph path from which the minimization starts.
///
/// Queries use the memory of the finder, so they are not `const`. Copies share the domain, and
/// different copies can be used concurrently.
///
/// \tparam Surface as for `geodesic_distances()`, but not a domain
template <typename Surface>
class Geodesic_path_finder
{
  static constexpr bool is_cloud = internal::Is_cloud<Surface>::value;

public:
  using Domain = internal::Domain_of<Surface>;
  using Path = Geodesic_path<Surface>;

  /// Precomputes the domain of the surface. O(n) time on a mesh; on a cloud O(n log n), as
  /// `Surfel_path_finder`.
  ///
  /// \param surface a mesh or a cloud
  /// \param np the named parameters of `make_domain()`; on a cloud those of `Surfel_path_finder`
  /// \throws as `make_domain()`; on a cloud as `Surfel_path_finder`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_path_finder(const Surface& surface,
                                const NamedParameters& np = NamedParameters())
      : Geodesic_path_finder(Domain(surface, np), np)
  {}
  /// Uses an existing `domain`, which is shared. The time and `np` are as for a surface.
  /// \throws on a cloud as `Surfel_path_finder`
  template <typename NamedParameters = internal::Default_parameters>
  explicit Geodesic_path_finder(const Domain& domain, const NamedParameters& np = NamedParameters())
      : m_domain(domain), m_finder(finder(domain, np))
  {}

  /// Returns the domain of the surface. O(1).
  const Domain& domain() const { return m_domain; }

  /// Improves the lower bounds of the search on a mesh by the distances from `number` landmarks:
  /// vertices far from each other. \cgalCite{cgal:gh-cspas-05}  Each landmark takes one search on
  /// the whole mesh, so that landmarks pay off for hundreds of queries.
  void add_landmarks(unsigned number)
  {
    static_assert(!is_cloud, "The search on a cloud uses regions of surfels instead of landmarks.");
    m_finder.add_landmarks(number);
  }

  /// Returns a shortest path from one vertex, surfel or location to another; empty if they are not
  /// connected. On a cloud, the path is locally shortest on the surface that is fitted to the
  /// surfels; next to a hole of the sampling, it can have corners. Takes time proportional to the
  /// number of visited faces; on a cloud as `Surfel_path_finder::operator()`.
  /// \tparam FromLocation, ToLocation a vertex, a surfel or a location
  /// \param from, to vertices, surfels or locations
  /// \param np
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{callback}
  ///     \cgalParamDescription{a function that is called with 0 from time to time; if it returns
  ///       false, the search throws `Cancelled`, and the finder can be used again. It is not called
  ///       on a cloud}
  ///     \cgalParamType{`std::function<bool(double)>`}
  ///     \cgalParamDefault{no callback}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  /// \throws Invalid_argument_error if a location is invalid
  /// \throws Cancelled if the callback returns false
  template <typename FromLocation, typename ToLocation,
            typename NamedParameters = internal::Default_parameters>
  Path operator()(const FromLocation& from, const ToLocation& to,
                  [[maybe_unused]] const NamedParameters& np = NamedParameters())
  {
    if constexpr(is_cloud)
      return m_finder(from, to);
    else
      return internal::surface_path(m_domain,
                                    m_finder.shortest_path(internal::location(m_domain, from),
                                                           internal::location(m_domain, to),
                                                           internal::read_throwing_callback(np)));
  }
  /// Returns a locally shortest path; empty if the ends are not connected.
  ///
  /// On scans that are meshes, it takes a few milliseconds at most, and the path is on average a
  /// few hundredths of a percent longer than the shortest path. On other meshes it can be more than
  /// a third longer: 36 % on a cube of 12 triangles.
  /// \tparam FromLocation, ToLocation a vertex, a surfel or a location
  /// \param from, to vertices, surfels or locations
  /// \throws Invalid_argument_error if a location is invalid
  template <typename FromLocation, typename ToLocation>
  Path locally_shortest_path(const FromLocation& from, const ToLocation& to)
  {
    if constexpr(is_cloud)
      return m_finder(from, to);
    else
      return internal::surface_path(
          m_domain, m_finder.locally_shortest_path(internal::location(m_domain, from),
                                                   internal::location(m_domain, to)));
  }
  /// Shortens a polyline to a locally shortest path with the same ends; empty if consecutive
  /// locations are not connected. Short paths of the search join consecutive locations.
  /// Each takes the time of `locally_shortest_path()`.
  ///
  /// \tparam Polyline a range of vertices, surfels or locations
  /// \param polyline a range of at least two vertices, surfels or locations
  /// \returns the path
  /// \throws Invalid_argument_error if there are fewer than two, or if a location is invalid
  template <typename Polyline>
  Path shorten(const Polyline& polyline)
  {
    if constexpr(is_cloud)
      return m_finder.shorten(polyline);
    else
      return internal::surface_path(m_domain,
                                    m_finder.shorten(internal::locations(m_domain, polyline)));
  }

private:
  using Finder =
      std::conditional_t<is_cloud, Surfel_path_finder<Surface>, internal::Shortest_path_finder>;
  template <typename NamedParameters>
  static Finder finder(const Domain& domain, [[maybe_unused]] const NamedParameters& np)
  {
    if constexpr(is_cloud)
      return Finder(domain, np);
    else
      return Finder(domain.triangles());
  }

  Domain m_domain;
  Finder m_finder;
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// Shortens a polyline on a mesh or a cloud to a locally shortest path with the same ends.
///
/// The path stays near the polyline: on a mesh it has the same homotopy type. Consecutive points of
/// the polyline need not be close to each other, since short paths join them first.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Polyline a range of vertices, surfels, `Location<Surface>` or points of any kernel
/// \param surface as for `geodesic_distances()`
/// \param polyline a range of at least two vertices, surfels, locations or points. A point stands
///        for the closest location on the surface
/// \param np `vertex_point_map` on a mesh, the named parameters of `Surfel_path_finder` on a cloud
/// \returns the path, as `Geodesic_path_finder`; empty if two consecutive locations are not
///        connected
/// \throws Invalid_argument_error if there are fewer than two locations, or if one is invalid
///
/// The time is that of a query of `Geodesic_path_finder` for each pair of consecutive locations,
/// after `make_domain()`. For many polylines on one surface, use `Geodesic_path_finder::shorten()`.
template <typename Surface, typename Polyline,
          typename NamedParameters = internal::Default_parameters,
          std::enable_if_t<!internal::is_function_of_points<Polyline, Surface>, bool> = true>
Geodesic_path<Surface_of<Surface>> shorten_polyline(const Surface& surface,
                                                    const Polyline& polyline,
                                                    const NamedParameters& np = NamedParameters())
{
  const auto domain = make_domain(surface, np);
  using Domain = std::decay_t<decltype(domain)>;
  using Element = std::decay_t<decltype(*std::begin(polyline))>;
  Geodesic_path_finder<Surface_of<Surface>> finder(domain, np);
  if constexpr(internal::names_location<Domain, Element>)
    return finder.shorten(polyline);
  else
  {
    const Surface_locator<Surface_of<Surface>> locate(domain);
    std::vector<typename Domain::Location> locations;
    for(const Element& point : polyline)
      locations.push_back(locate(point));
    return finder.shorten(locations);
  }
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_PATH_FINDER_H
