// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/semi_regular.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

std::array<double, 3> point_at(const Base_map& map, const Glued_triangles& coarse,
                               const Base_place& place)
{
  const auto& c = place.coordinates;
  const double sum = double(c[0]) + double(c[1]) + double(c[2]);
  return coordinates(coarse, map.inverse({place.triangle, {c[0] / sum, c[1] / sum, c[2] / sum}}));
}

// How far sites are at most from the points of a level's triangles that have their place on the base.
double deviation(const std::vector<Base_location>& places, const Glued_triangles& coarse,
                 const Subdivision::Level& level, unsigned times,
                 const std::vector<Spatial>& points)
{
  double result = 0.;
  for(Index site = 0; site < places.size(); ++site)
  {
    auto [triangle, b] = places[site];
    if(triangle == none)
      continue;
    for(unsigned i = 0; i < times; ++i)
    {
      // A corner's child, or the middle one, each of whose corners lies across from one.
      const std::size_t k = std::size_t(std::max_element(b.begin(), b.end()) - b.begin());
      triangle *= 4;
      for(double& x : b)
        x *= 2.;
      if(b[k] >= 1.)
      {
        triangle += Index(k);
        b[k] -= 1.;
        continue;
      }
      triangle += 3;
      for(double& x : b)
        x = 1. - x;
    }
    Spatial p = {0., 0., 0.};
    for(std::size_t k = 0; k < 3; ++k)
      p = p + b[k] * points[level.triangles[triangle][k]];
    const Spatial q = coordinates(coarse, at_site(coarse, site));
    result = std::max(result, norm(p - q));
  }
  return result;
}

} // namespace

Semi_regular semi_regular(const Base_map& map, const Glued_triangles& coarse, unsigned times,
                          double maximum_deviation)
{
  const bool has_maximum = maximum_deviation > 0.;
  Subdivision subdivision =
      subdivide(map.base().triangles, Index(map.base().samples.size()), has_maximum ? 0 : times);
  std::vector<Base_location> of_sites;
  if(has_maximum)
    for(Index site = 0; site < coarse.number_of_sites(); ++site)
    {
      const Location location = at_site(coarse, site);
      of_sites.push_back(location.triangle == none ? Base_location() : map(location));
    }
  Semi_regular result;
  for(;;)
  {
    const std::vector<Base_place> place = base_places(subdivision);
    while(result.points.size() < place.size())
      result.points.push_back(point_at(map, coarse, place[result.points.size()]));
    if(!has_maximum)
      break;
    const unsigned levels = unsigned(subdivision.levels.size() - 1);
    result.deviation = deviation(of_sites, coarse, subdivision.finest(), levels, result.points);
    if(levels == times || result.deviation <= maximum_deviation * coarse.scale)
      break;
    subdivide(subdivision);
  }
  for(const Subdivision::Level& level : subdivision.levels)
    result.number_of_vertices.push_back(level.number_of_vertices);
  result.triangles = std::move(subdivision.levels.back().triangles);
  return result;
}

Semi_regular semi_regular_quads(const Base_map& map, const Glued_triangles& coarse, unsigned times)
{
  Quad_subdivision subdivision =
      subdivide_into_quads(map.base().triangles, Index(map.base().samples.size()), times + 1);
  Semi_regular result;
  for(const Base_place& place : subdivision.places)
    result.points.push_back(point_at(map, coarse, place));
  result.number_of_vertices = std::move(subdivision.number_of_vertices);
  result.quads = std::move(subdivision.levels.back());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
