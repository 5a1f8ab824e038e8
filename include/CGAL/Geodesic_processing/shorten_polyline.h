// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SHORTEN_POLYLINE_H
#define CGAL_GEODESIC_PROCESSING_SHORTEN_POLYLINE_H

#include <CGAL/Geodesic_processing/internal/adaptors/path_options.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
/// what `shorten_polyline()` finds.
template <typename Point>
struct Shortened_polyline
{
  std::vector<Point> points; ///< on the surface; about four for each control point
  double length = 0.;        ///< of the polyline through them
  double distance = 0.;      ///< of the curve through them
  std::size_t number_of_control_points = 0;
  std::vector<Path_energy_level> levels; ///< from coarse to fine
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// makes a polyline near a surface a geodesic by the energy that `Surfel_path_finder` minimizes with
/// `Surfel_path_method::disks`, \cgalCite{cgal:rdsk-asg-06} on any surface that offers squared
/// distances: a triangle mesh by its `AABB_tree`, an implicit surface by a formula.
///
/// The ends stay.  The result is the geodesic nearby, as far as that can be told from a polyline:
/// it does not know in which of two thin sheets it lies.
///
/// \param polyline a range of points, at least two, so near to the surface that the nearest point of
///        each is the right one
/// \param squared_distance a function of a point, smooth near the surface but for edges and borders;
///        its gradient is taken by differences, seven calls for each point
/// \param np `number_of_control_points`, `node_weight` and `segment_weight` as for `Surfel_path_finder`
/// \throws Invalid_argument_error when there are fewer than two points, when they are not finite, or when
///         a squared distance is not a number
template <typename PointRange, typename SquaredDistance,
          typename NamedParameters = internal::Default_parameters>
auto shorten_polyline(const PointRange& polyline, const SquaredDistance& squared_distance,
                      const NamedParameters& np = NamedParameters())
{
  using Point = std::decay_t<decltype(*std::begin(polyline))>;
  std::vector<internal::Vec3> chain;
  for(const Point& p : polyline)
    chain.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  const internal::Shortened_path path =
      internal::shorten_path([&](const internal::Vec3& p)
                             { return CGAL::to_double(squared_distance(Point(p[0], p[1], p[2]))); },
                             internal::path_options(np), chain);
  Shortened_polyline<Point> result;
  for(const internal::Projection& foot : path.points)
    result.points.emplace_back(foot.point[0], foot.point[1], foot.point[2]);
  result.length = path.polyline_length;
  result.distance = path.length;
  result.number_of_control_points = path.number_of_control_points;
  result.levels = path.levels;
  return result;
}

} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SHORTEN_POLYLINE_H
