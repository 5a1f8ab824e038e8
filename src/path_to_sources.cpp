// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/path_to_sources.h>

#include <CGAL/Geodesic_processing/internal/cloud_path.h>
#include <CGAL/Geodesic_processing/internal/descent.h>
#include <CGAL/Geodesic_processing/internal/path_locations.h>
#include <CGAL/Geodesic_processing/internal/straighten.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

std::vector<Location> along_predecessors(const Glued_triangles& t, const Location& from,
                                         const std::function<double(Index)>& distance,
                                         const std::function<Index(Index)>& predecessor)
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
    path.push_back(at_site(t, site));
  }
  if(!(distance(site) < infinity))
    return {};
  while((site = predecessor(site)) != none)
    path.push_back(at_site(t, site));
  return path;
}

} // namespace

std::vector<Location> path_to_sources(const Glued_triangles& t, const Location& from,
                                      const std::vector<Source>& sources,
                                      const std::function<double(Index)>& distance,
                                      const std::function<Index(Index)>& predecessor)
{
  return shortened(t, t.is_cloud() ? along_predecessors(t, from, distance, predecessor)
                                   : Descent(t, sources)(from, distance).locations);
}

std::vector<Location> shortened(const Glued_triangles& t, const std::vector<Location>& path)
{
  if(path.size() < 2)
    return path;
  return t.is_cloud() ? smoothed_on_cloud(t, path) : straighten(t, path).locations;
}

} // namespace CGAL::Geodesic_processing::internal
