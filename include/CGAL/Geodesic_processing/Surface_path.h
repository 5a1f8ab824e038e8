// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_SURFACE_PATH_H
#define CGAL_GEODESIC_PROCESSING_SURFACE_PATH_H

#include <CGAL/Geodesic_processing/Location.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include <vector>

namespace CGAL::Geodesic_processing {

/// \ingroup PkgGeodesicProcessingPaths
///
/// A polyline on a surface. On a mesh, consecutive locations belong to a common face. Consecutive
/// points are distinct.
template <typename Surface>
struct Surface_path
{
  using Location = typename internal::Surface_traits<Surface>::Location;
  /// The point type of the surface: that of its vertex point map, or of `Surfel_kernel`
  using Point_3 = typename internal::Surface_traits<Surface>::Point_3;

  std::vector<Location> locations; ///< the vertices of the polyline; empty if there is no path
  std::vector<Point_3> points;     ///< the positions of the locations, of the surface's kernel
  double length = 0.;              ///< the length of the polyline
  /// The distance that the method computes; +infinity if there is no path. With speeds it is a
  /// travel time, and the other members remain lengths
  double front_distance = 0.;
  /// A certified lower bound of the length of all paths between its ends. For shortest paths on a
  /// mesh, by `geodesic_path()`, `Geodesic_path_finder` or `Exact`, it is the length minus
  /// round-off errors: 2e-12 of the length, and those of thin triangles. With a
  /// `relative_tolerance` it is the length that follows from `lower()` of the
  /// `Geodesic_distance_solver`. For all other paths it is the straight distance in space
  double lower = 0.;

  /// Returns whether there is no path. O(1).
  bool empty() const { return locations.empty(); }
};

namespace internal {

template <typename Domain>
Surface_path<typename Domain::Surface>
surface_path(const Domain& domain, const std::vector<internal::Surface_location>& path,
             double front_distance)
{
  Surface_path<typename Domain::Surface> result;
  result.front_distance = front_distance;
  const Surface_arrays& t = *domain.triangles();
  for(const internal::Surface_location& location : path)
  {
    result.locations.push_back(domain.outer(location));
    result.points.push_back(domain.point(location));
  }
  result.length = t.scale * polyline_length(t, path);
  if(!path.empty())
    result.lower = t.scale * straight_distance(t, path.front(), path.back());
  return result;
}

} // namespace internal
} // namespace CGAL::Geodesic_processing

#endif // CGAL_GEODESIC_PROCESSING_SURFACE_PATH_H
