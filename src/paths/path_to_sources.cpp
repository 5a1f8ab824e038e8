// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include "paths/shorten_on_cloud.h"
#include "paths/descent.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "paths/quicken_path.h"
#include "paths/shorten_geodesic.h"

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the location on a source with the smallest Euclidean distance to a point.
Surface_location nearest_location_on(const Surface_arrays& t, const Front_source& source,
                                     const Vec3& point)
{
  Surface_location result = canonical(t, source.polyline.front());
  double min_distance = norm(scaled_coordinates(t, result) - point);
  for(std::size_t i = 1; i < source.polyline.size(); ++i)
  {
    const Surface_location segment_begin = canonical(t, source.polyline[i - 1]),
                           segment_end = canonical(t, source.polyline[i]);
    const Index triangle = common_triangle(t, segment_begin, segment_end);
    if(triangle == none)
      continue;
    const Vec3 origin = scaled_coordinates(t, segment_begin),
               segment = scaled_coordinates(t, segment_end) - origin;
    const double squared_length = dot(segment, segment);
    const double fraction = squared_length > 0.
                                ? std::clamp(dot(point - origin, segment) / squared_length, 0., 1.)
                                : 0.;
    const double distance = norm(origin + fraction * segment - point);
    if(distance < min_distance)
    {
      min_distance = distance;
      result = {triangle, none,
                (1. - fraction) * *barycentric_in(t, triangle, segment_begin) +
                    fraction * *barycentric_in(t, triangle, segment_end)};
    }
  }
  return result;
}

// Returns the path along predecessors from a location to its source.
std::vector<Surface_location> trace_predecessors(const Surface_arrays& t,
                                                 const Surface_location& from,
                                                 const std::vector<Front_source>& sources,
                                                 const std::function<double(Index)>& distance,
                                                 const std::function<Index(Index)>& predecessor,
                                                 const std::function<Index(Index)>& source)
{
  std::vector<Surface_location> path = {from};
  Index vertex = vertex_of(t, from);
  if(vertex == none)
  {
    double min_distance = infinity;
    for(Index k = 0; k < 3; ++k)
    {
      const Index corner = t.corner[3 * std::size_t(from.triangle) + k];
      if(distance(corner) < min_distance)
      {
        min_distance = distance(corner);
        vertex = corner;
      }
    }
    if(vertex == none)
      return {};
  }
  if(!(distance(vertex) < infinity))
    return {};
  Index last = vertex;
  for(; vertex != none; vertex = predecessor(vertex))
  {
    if(!is_same_point(t, path.back(), vertex_location(t, vertex)))
      path.push_back(vertex_location(t, vertex));
    last = vertex;
  }
  const Surface_location end = nearest_location_on(t, sources[source(last)], t.point[last]);
  if(!is_same_point(t, path.back(), end))
    path.push_back(end);
  return path;
}

} // namespace

std::vector<Surface_location> path_to_sources(const Surface_arrays& t, const Surface_location& from,
                                              const std::vector<Front_source>& sources,
                                              const std::function<double(Index)>& distance,
                                              const std::function<Index(Index)>& predecessor,
                                              const std::function<Index(Index)>& source,
                                              const std::vector<double>* slowness)
{
  const std::vector<Surface_location> path =
      t.is_cloud() ? trace_predecessors(t, from, sources, distance, predecessor, source)
                   : Descent(t, sources)(from, distance).locations;
  if(!slowness)
    return shorten_path(t, path);
  return t.is_cloud() ? path : quicken_path(t, *slowness, path);
}

std::vector<Surface_location> shorten_path(const Surface_arrays& t,
                                           const std::vector<Surface_location>& path)
{
  if(path.size() < 2)
    return path;
  return t.is_cloud() ? shorten_on_cloud(t, path) : shorten_geodesic(t, path).locations;
}

} // namespace CGAL::Geodesic_processing::internal
