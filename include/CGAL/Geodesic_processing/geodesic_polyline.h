// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_GEODESIC_POLYLINE_H
#define CGAL_GEODESIC_PROCESSING_GEODESIC_POLYLINE_H

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/is_supported.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// A path through given points on a surface.
template <typename Surface>
struct Geodesic_polyline : Surface_path<Surface>
{
  /// For each given point, the index of its location in `locations`. If the path is closed, one
  /// more index is that of the last location
  std::vector<std::size_t> corners;
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// Computes the shortest path that passes through points in a given order: it consists of the paths
/// of `Geodesic_path_finder` between consecutive points.
///
/// The path has corners at the points. `shorten_polyline()` shortens such a path and keeps only its
/// ends, `shorten_loop()` shortens a closed one and keeps no point.
///
/// \tparam Surface as for `geodesic_distances()`
/// \tparam Polyline a range of vertices, surfels, `Location<Surface>` or points of any kernel
/// \param surface as for `geodesic_distances()`
/// \param points at least two vertices, surfels, locations or points. A point stands for the
///        closest location on the surface. Equal consecutive points have the same location of the
///        path
/// \param np `vertex_point_map` on a mesh, the named parameters of `Surfel_path_finder` on a cloud;
///        and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{do_close}
///     \cgalParamDescription{whether the path returns from the last point to the first one}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the path. `length`, `front_distance` and `lower` are the sums of those of its parts; on
///          a mesh, `lower` is a lower bound of all paths through the points in this order. The
///          path is empty if two consecutive points are not connected
/// \throws Invalid_argument_error if there are fewer than two points, or if one is invalid
/// \throws as `Geodesic_path_finder`
///
/// Takes the preparation of `Geodesic_path_finder`, and one of its queries for each path.
template <typename Surface, typename Polyline,
          typename NamedParameters = internal::Default_parameters>
Geodesic_polyline<Surface_of<Surface>>
geodesic_polyline(const Surface& surface, const Polyline& points,
                  const NamedParameters& np = NamedParameters())
{
  static_assert(internal::require_support<Function::geodesic_polyline, Surface>());
  const auto domain = make_domain(surface, np);
  using Domain = std::decay_t<decltype(domain)>;
  using Element = std::decay_t<decltype(*std::begin(points))>;
  std::vector<typename Domain::Location> locations;
  if constexpr(internal::names_location<Domain, Element>)
    for(const Element& element : points)
      locations.push_back(domain.outer(internal::location(domain, element)));
  else
  {
    const Surface_locator<Surface_of<Surface>> locate(domain);
    for(const Element& point : points)
      locations.push_back(locate(point));
  }
  if(locations.size() < 2)
    throw Invalid_argument_error("A path through points requires at least two points.");
  if(internal::parameter(np, internal_np::do_close, false))
    locations.push_back(locations.front());

  Geodesic_path_finder<Surface_of<Surface>> finder(domain, np);
  Geodesic_polyline<Surface_of<Surface>> result;
  for(std::size_t i = 0; i + 1 < locations.size(); ++i)
  {
    const auto part = finder(locations[i], locations[i + 1]);
    if(part.empty())
      return {};
    // A part begins with the last location of the previous one.
    const std::size_t first = i == 0 ? 0 : 1;
    if(i == 0)
      result.corners.push_back(0);
    result.locations.insert(result.locations.end(), part.locations.begin() + first,
                            part.locations.end());
    result.points.insert(result.points.end(), part.points.begin() + first, part.points.end());
    result.corners.push_back(result.locations.size() - 1);
    result.length += part.length;
    result.front_distance += part.front_distance;
    result.lower += part.lower;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_GEODESIC_POLYLINE_H
