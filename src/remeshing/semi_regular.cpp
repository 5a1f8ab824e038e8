// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/remeshing/semi_regular.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

std::array<double, 3> point_at(const Base_map& map, const Surface_arrays& coarse,
                               const Coarse_location& location)
{
  const auto& c = location.coordinates;
  const double sum = double(c[0]) + double(c[1]) + double(c[2]);
  return coordinates(coarse,
                     map.inverse({location.triangle, {c[0] / sum, c[1] / sum, c[2] / sum}}));
}

// Returns the maximum distance from the vertices of the mesh to the points of a level with the same
// base coordinates.
// base_locations: #vertices; vertices whose triangle is none are skipped
double deviation(const std::vector<Base_location>& base_locations, const Surface_arrays& coarse,
                 const Subdivision::Level& level, unsigned number_of_levels,
                 const std::vector<Vec3>& points)
{
  double result = 0.;
  for(Index vertex = 0; vertex < base_locations.size(); ++vertex)
  {
    auto [triangle, b] = base_locations[vertex];
    if(triangle == none)
      continue;
    for(unsigned i = 0; i < number_of_levels; ++i)
    {
      // If a coordinate is at least one half, the location lies in the child at this corner.
      // Otherwise it lies in the central child, whose corner k is the midpoint of the edge opposite
      // to corner k.
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
    Vec3 p = {0., 0., 0.};
    for(std::size_t k = 0; k < 3; ++k)
      p = p + b[k] * points[level.triangles[triangle][k]];
    const Vec3 q = coordinates(coarse, vertex_location(coarse, vertex));
    result = std::max(result, norm(p - q));
  }
  return result;
}

} // namespace

Semi_regular_mesh build_semi_regular_mesh(const Base_map& map, const Surface_arrays& coarse,
                                          unsigned number_of_levels, double maximum_deviation)
{
  const bool has_maximum = maximum_deviation > 0.;
  Subdivision subdivision = subdivide(map.base().triangles, Index(map.base().samples.size()),
                                      has_maximum ? 0 : number_of_levels);
  std::vector<Base_location> base_locations;
  if(has_maximum)
    for(Index vertex = 0; vertex < coarse.number_of_vertices(); ++vertex)
    {
      const Surface_location location = vertex_location(coarse, vertex);
      base_locations.push_back(location.triangle == none ? Base_location() : map(location));
    }
  Semi_regular_mesh result;
  for(;;)
  {
    const std::vector<Coarse_location> locations = coarse_locations(subdivision);
    while(result.points.size() < locations.size())
      result.points.push_back(point_at(map, coarse, locations[result.points.size()]));
    if(!has_maximum)
      break;
    const unsigned levels = unsigned(subdivision.levels.size() - 1);
    result.deviation =
        deviation(base_locations, coarse, subdivision.finest(), levels, result.points);
    if(levels == number_of_levels || result.deviation <= maximum_deviation * coarse.scale)
      break;
    subdivide(subdivision);
  }
  for(const Subdivision::Level& level : subdivision.levels)
    result.number_of_vertices.push_back(level.number_of_vertices);
  result.triangles = std::move(subdivision.levels.back().triangles);
  return result;
}

Semi_regular_mesh build_semi_regular_quads(const Base_map& map, const Surface_arrays& coarse,
                                           unsigned number_of_levels)
{
  Quad_subdivision subdivision = subdivide_into_quads(
      map.base().triangles, Index(map.base().samples.size()), number_of_levels + 1);
  Semi_regular_mesh result;
  for(const Coarse_location& location : subdivision.locations)
    result.points.push_back(point_at(map, coarse, location));
  result.number_of_vertices = std::move(subdivision.number_of_vertices);
  result.quads = std::move(subdivision.levels.back());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
