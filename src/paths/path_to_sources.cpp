// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include "paths/cloud_path.h"
#include "paths/descent.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>
#include "paths/straighten.h"

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The place of a source that is nearest in space to a point.
Location nearest_on(const Glued_triangles& t, const Source& source, const Spatial& point)
{
  Location result = cleaned(t, source.polyline.front());
  double least = norm(scaled_coordinates(t, result) - point);
  for(std::size_t i = 1; i < source.polyline.size(); ++i)
  {
    const Location p = cleaned(t, source.polyline[i - 1]), q = cleaned(t, source.polyline[i]);
    const Index triangle = common_triangle(t, p, q);
    if(triangle == none)
      continue;
    const Spatial begin = scaled_coordinates(t, p), side = scaled_coordinates(t, q) - begin;
    const double square = dot(side, side);
    const double share = square > 0. ? std::clamp(dot(point - begin, side) / square, 0., 1.) : 0.;
    const double distance = norm(begin + share * side - point);
    if(distance < least)
    {
      least = distance;
      result = {triangle, none,
                (1. - share) * *seen_from(t, triangle, p) + share * *seen_from(t, triangle, q)};
    }
  }
  return result;
}

std::vector<Location> along_predecessors(const Glued_triangles& t, const Location& from,
                                         const std::vector<Source>& sources,
                                         const std::function<double(Index)>& distance,
                                         const std::function<Index(Index)>& predecessor,
                                         const std::function<Index(Index)>& source)
{
  std::vector<Location> path = {from};
  Index site = site_of(t, from);
  if(site == none)
  {
    double least = infinity;
    for(Index k = 0; k < 3; ++k)
    {
      const Index corner = t.corner[3 * std::size_t(from.triangle) + k];
      if(distance(corner) < least)
      {
        least = distance(corner);
        site = corner;
      }
    }
    if(site == none)
      return {};
  }
  if(!(distance(site) < infinity))
    return {};
  Index last = site;
  for(; site != none; site = predecessor(site))
  {
    if(!is_same_point(t, path.back(), at_site(t, site)))
      path.push_back(at_site(t, site));
    last = site;
  }
  const Location end = nearest_on(t, sources[source(last)], t.point[last]);
  if(!is_same_point(t, path.back(), end))
    path.push_back(end);
  return path;
}

} // namespace

std::vector<Location> path_to_sources(const Glued_triangles& t, const Location& from,
                                      const std::vector<Source>& sources,
                                      const std::function<double(Index)>& distance,
                                      const std::function<Index(Index)>& predecessor,
                                      const std::function<Index(Index)>& source)
{
  return shortened(t, t.is_cloud()
                          ? along_predecessors(t, from, sources, distance, predecessor, source)
                          : Descent(t, sources)(from, distance).locations);
}

std::vector<Location> shortened(const Glued_triangles& t, const std::vector<Location>& path)
{
  if(path.size() < 2)
    return path;
  return t.is_cloud() ? smoothed_on_cloud(t, path) : straighten(t, path).locations;
}

} // namespace CGAL::Geodesic_processing::internal
