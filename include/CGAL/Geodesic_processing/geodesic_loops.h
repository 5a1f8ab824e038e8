// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_LOOPS_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_LOOPS_H

#include <CGAL/Geodesic_processing/internal/adaptors/sources.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/noncontractible_loop.h>
#include <CGAL/Geodesic_processing/internal/paths/loop_basis.h>
#include <CGAL/Geodesic_processing/internal/paths/loops.h>
#include <CGAL/Geodesic_processing/is_supported.h>
#include <CGAL/Geodesic_processing/locate_on_surface.h>
#include <CGAL/Geodesic_processing/make_domain.h>

#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// A closed curve on a mesh. Consecutive locations belong to a common face.
template <typename Surface>
struct Geodesic_loop
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;

  /// The vertices of the curve. The last one is the first one. A single location is a curve that is
  /// shrunk to a point; no location means that there is no loop
  std::vector<Location> locations;
  std::vector<Point_3> points; ///< the positions of the locations
  double length = 0.;          ///< the length of the curve

  /// Returns whether there is no loop. O(1).
  bool empty() const { return locations.empty(); }
  /// Returns whether the loop is shrunk to a point. O(1).
  bool is_point() const { return locations.size() == 1; }
};

namespace internal {

template <typename Domain>
Geodesic_loop<typename Domain::Surface> geodesic_loop(const Domain& domain, const Loop& loop)
{
  Geodesic_loop<typename Domain::Surface> result;
  for(const Surface_location& location : loop)
  {
    result.locations.push_back(domain.outer(location));
    result.points.push_back(domain.point(location));
  }
  result.length = domain.triangles()->scale * polyline_length(*domain.triangles(), loop);
  return result;
}

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
///
/// Shortens a closed curve on a mesh to a locally shortest one in its free homotopy class.
///
/// The result is straight in every face and across edges, and both angles at every vertex that it
/// passes are at least \f$ \pi \f$. It is not longer than the curve. If the curve is contractible,
/// the result is a point, also if a locally shortest closed curve is near it: on a sphere, all
/// curves are contractible. The result does not cross the boundary, but can touch it.
///
/// The result is locally shortest, and not always the shortest curve of its class. The curve is
/// shortened with one location fixed, then with another one, until nothing changes
/// \cgalCite{cgal:b-dstdf-17}. On a surface of genus g, Dehn's algorithm decides whether a curve is
/// contractible \cgalCite{cgal:ls-cgt-77}.
///
/// \tparam Surface a model of `FaceListGraph`, a soup or the domain of one of them
/// \tparam Polyline a range of vertices, of `Location<Surface>`, or of points of any kernel
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param loop at least one location. The last one is joined to the first one. Locations in a
///        common face are joined by a straight segment, others by a short path. A point stands for
///        the closest location on the mesh
/// \param np `vertex_point_map` and other named parameters of `make_domain()`
/// \returns the curve; empty if two consecutive locations are not connected
/// \throws Invalid_argument_error if there is no location, or if one is invalid
/// \throws as `make_domain()`
///
/// Angles of the result are at least \f$ \pi - 10^{-6} \f$. Takes O(n) time for n faces, and a
/// multiple of the number of faces that the curve and its intermediate positions cross.
template <typename Surface, typename Polyline,
          typename NamedParameters = internal::Default_parameters>
Geodesic_loop<Surface_of<Surface>> shorten_loop(const Surface& mesh, const Polyline& loop,
                                                const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::shorten_loop, Surface>());
  const auto domain = make_domain(mesh, np);
  using Domain = std::decay_t<decltype(domain)>;
  using Element = std::decay_t<decltype(*std::begin(loop))>;
  std::vector<internal::Surface_location> locations;
  if constexpr(internal::names_location<Domain, Element>)
    locations = internal::locations(domain, loop);
  else
  {
    const Surface_locator<Surface_of<Surface>> locate(domain);
    for(const Element& point : loop)
      locations.push_back(domain.inner(locate(point)));
  }
  std::vector<internal::Loop> loops = {internal::join_loop(domain.triangles(), locations)};
  if(!loops.front().empty())
    internal::shorten_loops(*domain.triangles(), loops);
  return internal::geodesic_loop(domain, loops.front());
}

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes closed curves that are a basis of the first homology group of a mesh.
///
/// Each component of genus g with b boundary cycles has \f$ 2 g + \max(b - 1, 0) \f$ loops: the
/// matrix of the periods of integral closed 1-forms has the determinant 1 or -1. The loops are the
/// shortest ones along edges through one vertex of the component \cgalCite{cgal:ew-goh-05}. Then
/// each is shortened in its free homotopy class, as by `shorten_loop()`. Components are joined
/// across edges: faces that meet only in a vertex are different components.
///
/// \tparam Surface a model of `FaceListGraph`, a soup or the domain of one of them
/// \tparam OutputIterator a model of `OutputIterator` for `Geodesic_loop<Surface_of<Surface>>`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param out takes the loops
/// \param np parameters of `make_domain()`; and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_shorten}
///     \cgalParamDescription{whether loops are shortened. Otherwise they run along edges.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the output iterator after the last loop
/// \throws as `make_domain()`
///
/// O(n log n) for n faces, and the time of `shorten_loop()` for each loop.
template <typename Surface, typename OutputIterator,
          typename NamedParameters = internal::Default_parameters>
OutputIterator loop_basis(const Surface& mesh, OutputIterator out,
                          const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::loop_basis, Surface>());
  const auto domain = make_domain(mesh, np);
  std::vector<internal::Loop> loops = internal::loop_basis(*domain.triangles());
  if(internal::parameter(np, internal_np::do_shorten, true))
    internal::shorten_noncontractible_loops(*domain.triangles(), loops);
  else
    for(internal::Loop& loop : loops)
      loop.push_back(loop.front());
  for(const internal::Loop& loop : loops)
    *out++ = internal::geodesic_loop(domain, loop);
  return out;
}

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes a shortest one of all closed curves through a given location that are not contractible.
///
/// The two halves of this curve are shortest paths in the universal cover
/// \cgalCite{cgal:ew-goh-05}. All homotopy classes that can contain it are found in a disk of the
/// universal cover. For each one, the shortest curve is computed by exact windows
/// \cgalCite{cgal:mmp-dgp-87}. A curve around a hole of a mesh with boundary is not contractible if
/// there is another hole, or a handle. The curve can have a corner at the location.
/// `shorten_loop()` removes it.
///
/// \tparam Surface a model of `FaceListGraph`, a soup or the domain of one of them
/// \tparam QueryLocation a vertex or a `Location<Surface>`
/// \param mesh as for `geodesic_distances()`, but not a cloud
/// \param through a vertex or a location
/// \param np parameters of `make_domain()`
/// \returns the curve, which begins and ends at the location; empty if all curves through the
///          location are contractible
/// \throws Invalid_argument_error if the location is invalid
/// \throws Unsupported_surface_error as `Exact`
/// \throws as `make_domain()`
///
/// The length is exact up to round-off errors. Takes some exact distance computations on the faces
/// that are closer to the location than half of the length of the curve, or slightly more.
template <typename Surface, typename QueryLocation,
          typename NamedParameters = internal::Default_parameters>
Geodesic_loop<Surface_of<Surface>>
shortest_noncontractible_loop(const Surface& mesh, const QueryLocation& through,
                              const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::shortest_noncontractible_loop, Surface>());
  const auto domain = make_domain(mesh, np);
  return internal::geodesic_loop(
      domain, internal::shortest_noncontractible_loop(*domain.triangles(),
                                                      internal::location(domain, through)));
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_LOOPS_H
