// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SHORTEN_POLYLINE_H
#define CGAL_GEODESIC_PROCESSING_SHORTEN_POLYLINE_H

#include <CGAL/Geodesic_processing/internal/adaptors/path_options.h>
#include <CGAL/Geodesic_processing/surfel_variants.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing {

namespace internal {

template <typename Function, typename PointRange>
using Value_at_point =
    decltype(std::declval<const Function&>()(*std::begin(std::declval<const PointRange&>())));

template <typename Function, typename PointRange, typename = void>
inline constexpr bool is_function_of_points = false;
template <typename Function, typename PointRange>
inline constexpr bool
    is_function_of_points<Function, PointRange, std::void_t<Value_at_point<Function, PointRange>>> =
        true;

} // namespace internal

/// \ingroup PkgGeodesicProcessingPaths
/// The result of `shorten_polyline()`.
template <typename Point>
struct Shortened_polyline
{
  std::vector<Point> points;                ///< points on the surface, about four per control point
  double length = 0.;                       ///< the length of the polyline through the points
  double distance = 0.;                     ///< the length of the smooth curve through the points
  std::size_t number_of_control_points = 0; ///< of the finest level
  std::vector<Path_energy_level> levels;    ///< the levels of the minimization, from coarse to fine
};

/// \ingroup PkgGeodesicProcessingPaths
///
/// Shortens a polyline near a surface to a geodesic by minimizing an energy
/// \cgalCite{cgal:rdsk-asg-06}.
///
/// On a mesh or a cloud, use the overload in `CGAL/Geodesic_processing/Geodesic_path_finder.h`.
///
/// It is the energy that `Surfel_path_finder` minimizes with `Surfel_path_method::disks`. The
/// surface can be any surface for which squared distances can be computed. Examples are a triangle
/// mesh with an `AABB_tree`, and an implicit surface with a formula.
///
/// The endpoints are fixed. The result is a geodesic near the polyline. If two sheets of the
/// surface are close to each other, the polyline does not determine the sheet of the geodesic.
///
/// \tparam PointRange a range of points of one kernel
/// \tparam SquaredDistance a function object that takes such a point and returns a number
/// \param polyline a range of at least two points. They must be so close to the surface that their
///        nearest points are on the intended part of the surface
/// \param squared_distance a function that returns the squared distance of a point to the surface.
///        It must be smooth near the surface, except at edges and boundaries. Its gradient is
///        computed by finite differences, with seven calls per point
/// \param np the named parameters `number_of_control_points`, `node_weight` and `segment_weight` of
///        `Surfel_path_finder`
/// \returns a `Shortened_polyline`
/// \throws Invalid_argument_error if there are fewer than two points, if a point is not finite, or
///         if a squared distance is not a number
///
/// Takes time proportional to the number of control points in each iteration.
template <
    typename PointRange, typename SquaredDistance,
    typename NamedParameters = internal::Default_parameters,
    std::enable_if_t<internal::is_function_of_points<SquaredDistance, PointRange>, bool> = true>
Shortened_polyline<std::decay_t<decltype(*std::begin(std::declval<const PointRange&>()))>>
shorten_polyline(const PointRange& polyline, const SquaredDistance& squared_distance,
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
