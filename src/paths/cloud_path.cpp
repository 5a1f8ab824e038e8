// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/cloud_path.h"

#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "paths/straighten.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr unsigned rings_around_path = 6;

// A surface of some of the triangles of a cloud, and the way back.
struct Patch
{
  Glued_mesh mesh;
  std::vector<Index> site_of_vertex;   // in the cloud
  std::vector<Index> triangle_of_face; // in the cloud
  std::unordered_map<Index, Index> vertex_of_site, face_of_triangle;
};

// Triangles with all corners near a path; those that hold a location of it first, then by weight.
std::vector<Index> triangles_near(const Glued_triangles& cloud, const std::vector<Location>& path)
{
  std::unordered_set<Index> near;
  std::vector<Index> ring, next, result;
  const auto reach = [&](Index site)
  {
    if(near.insert(site).second)
      next.push_back(site);
  };
  for(const Location& location : path)
    if(const Index site = site_of(cloud, location); site != none)
      reach(site);
    else
    {
      result.push_back(location.triangle);
      for(Index c = 3 * location.triangle; c < 3 * location.triangle + 3; ++c)
        reach(cloud.corner[c]);
    }
  const std::size_t number_first = result.size();
  for(unsigned i = 0; i < rings_around_path; ++i)
  {
    ring.clear();
    std::swap(ring, next);
    for(const Index site : ring)
      for(Index k = cloud.first[site]; k < cloud.first[site + 1]; ++k)
        for(Index c = cloud.star[k] / 3 * 3, last = c + 3; c < last; ++c)
          reach(cloud.corner[c]);
  }
  for(const Index site : near)
    for(Index k = cloud.first[site]; k < cloud.first[site + 1]; ++k)
    {
      const Index triangle = cloud.star[k] / 3;
      // Once for each triangle: at the first of its corners.
      bool is_inside = cloud.star[k] == 3 * triangle;
      for(Index c = 3 * triangle; is_inside && c < 3 * triangle + 3; ++c)
        is_inside = near.count(cloud.corner[c]) > 0;
      if(is_inside)
        result.push_back(triangle);
    }
  std::sort(result.begin() + number_first, result.end(),
            [&](Index a, Index b) {
              return cloud.weight[a] != cloud.weight[b] ? cloud.weight[a] > cloud.weight[b] : a < b;
            });
  return result;
}

Patch patch_around(const Glued_triangles& cloud, const std::vector<Location>& path)
{
  Patch patch;
  std::vector<Index> corners;
  std::unordered_map<std::uint64_t, Index> side_between; // from one site to another
  const auto key = [](Index a, Index b) { return std::uint64_t(a) << 32 | b; };
  for(const Index triangle : triangles_near(cloud, path))
  {
    const Index* corner = &cloud.corner[3 * std::size_t(triangle)];
    bool is_free = patch.face_of_triangle.count(triangle) == 0;
    for(Index k = 0; is_free && k < 3; ++k)
      is_free = side_between.count(key(corner[k], corner[(k + 1) % 3])) == 0;
    if(!is_free)
      continue;
    patch.face_of_triangle.emplace(triangle, Index(patch.triangle_of_face.size()));
    patch.triangle_of_face.push_back(triangle);
    for(Index k = 0; k < 3; ++k)
    {
      side_between.emplace(key(corner[k], corner[(k + 1) % 3]), Index(corners.size()));
      const auto [place, is_new] =
          patch.vertex_of_site.try_emplace(corner[k], Index(patch.site_of_vertex.size()));
      if(is_new)
        patch.site_of_vertex.push_back(corner[k]);
      corners.push_back(place->second);
    }
  }
  std::vector<Index> twins(corners.size(), none);
  for(const auto& [ends, side] : side_between)
    if(const auto twin = side_between.find(ends << 32 | ends >> 32); twin != side_between.end())
      twins[side] = twin->second;
  std::vector<std::array<double, 3>> points;
  for(const Index site : patch.site_of_vertex)
    points.push_back(cloud.point[site]);
  patch.mesh = glue(std::move(points), corners, twins);
  return patch;
}

// A location of the cloud on the patch; its triangle or site must be there.
bool onto(const Patch& patch, const Glued_triangles& cloud, const Location& location,
          Location& result)
{
  if(const Index site = site_of(cloud, location); site != none)
  {
    const auto vertex = patch.vertex_of_site.find(site);
    if(vertex == patch.vertex_of_site.end())
      return false;
    result = at_site(patch.mesh.triangles, patch.mesh.site_of_vertex[vertex->second]);
    return true;
  }
  const auto face = patch.face_of_triangle.find(location.triangle);
  if(face == patch.face_of_triangle.end())
    return false;
  result = location;
  result.triangle = patch.mesh.triangle_of_face[face->second];
  return true;
}

} // namespace

std::vector<Location> smoothed_on_cloud(const Glued_triangles& cloud,
                                        const std::vector<Location>& given)
{
  std::vector<Location> path;
  for(const Location& location : given)
    path.push_back(cleaned(cloud, location));
  if(path.size() < 2)
    return path;
  double length = polyline_length(cloud, path);

  // Each time the path moves by up to the width of the patch; eight times is far enough for any
  // path that started as the shortest chain of arcs.
  for(int i = 0; i < 8; ++i)
  {
    const Patch patch = patch_around(cloud, path);
    Location from, to;
    if(!onto(patch, cloud, path.front(), from) || !onto(patch, cloud, path.back(), to))
      break;
    const auto triangles = std::make_shared<const Glued_triangles>(patch.mesh.triangles);
    const std::vector<Location> chain = Path_finder(triangles)(from, to);
    if(chain.empty())
      break;
    std::vector<Location> next = straighten(*triangles, chain).locations;
    for(Location& location : next)
      location.triangle = patch.triangle_of_face[patch.mesh.face_of_triangle[location.triangle]];
    next.front() = path.front();
    next.back() = path.back();
    const double next_length = polyline_length(cloud, next);
    if(!(next_length < length))
      break;
    const bool stays = next_length > (1. - 1e-6) * length;
    path = std::move(next);
    length = next_length;
    if(stays)
      break;
  }
  return path;
}

} // namespace CGAL::Geodesic_processing::internal
