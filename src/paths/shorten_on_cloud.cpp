// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_on_cloud.h"

#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "paths/shorten_geodesic.h"

#include <algorithm>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Patches contain the triangles in this k-ring of the path.
constexpr unsigned number_of_rings = 6;

// A mesh of some of a cloud's triangles, with the maps between both.
struct Patch
{
  Mesh_arrays mesh;
  std::vector<Index> cloud_vertex;   // #vertices of the patch: the vertex of the cloud
  std::vector<Index> cloud_triangle; // #faces of the patch: the triangle of the cloud
  std::unordered_map<Index, Index> patch_vertex, patch_face; // the inverse maps
};

// Returns the triangles whose corners are all in the k-ring of a path. Triangles that contain a
// location of the path come first, then all others by decreasing weight.
std::vector<Index> collect_triangles_near(const Surface_arrays& cloud,
                                          const std::vector<Surface_location>& path)
{
  std::unordered_set<Index> visited;
  std::vector<Index> ring, next, result;
  const auto visit = [&](Index vertex)
  {
    if(visited.insert(vertex).second)
      next.push_back(vertex);
  };
  for(const Surface_location& location : path)
    if(const Index vertex = vertex_of(cloud, location); vertex != none)
      visit(vertex);
    else
    {
      result.push_back(location.triangle);
      for(Index c = 3 * location.triangle; c < 3 * location.triangle + 3; ++c)
        visit(cloud.corner[c]);
    }
  const std::size_t number_of_path_triangles = result.size();
  for(unsigned i = 0; i < number_of_rings; ++i)
  {
    ring.clear();
    std::swap(ring, next);
    for(const Index vertex : ring)
      for(Index k = cloud.ring_begin[vertex]; k < cloud.ring_begin[vertex + 1]; ++k)
        for(Index c = cloud.ring[k] / 3 * 3, end = c + 3; c < end; ++c)
          visit(cloud.corner[c]);
  }
  for(const Index vertex : visited)
    for(Index k = cloud.ring_begin[vertex]; k < cloud.ring_begin[vertex + 1]; ++k)
    {
      const Index triangle = cloud.ring[k] / 3;
      // Each triangle is visited at its first corner only.
      bool is_inside = cloud.ring[k] == 3 * triangle;
      for(Index c = 3 * triangle; is_inside && c < 3 * triangle + 3; ++c)
        is_inside = visited.count(cloud.corner[c]) > 0;
      if(is_inside)
        result.push_back(triangle);
    }
  std::sort(result.begin() + number_of_path_triangles, result.end(),
            [&](Index a, Index b) {
              return cloud.weight[a] != cloud.weight[b] ? cloud.weight[a] > cloud.weight[b] : a < b;
            });
  return result;
}

// Builds a patch from triangles near a path. A triangle is added if its halfedges are not yet
// used.
Patch build_patch(const Surface_arrays& cloud, const std::vector<Surface_location>& path)
{
  Patch patch;
  std::vector<Index> corners;
  std::unordered_map<std::uint64_t, Index> halfedge_between; // by its source and its target
  const auto key = [](Index a, Index b) { return std::uint64_t(a) << 32 | b; };
  for(const Index triangle : collect_triangles_near(cloud, path))
  {
    const Index* corner = &cloud.corner[3 * std::size_t(triangle)];
    bool is_manifold = patch.patch_face.count(triangle) == 0;
    for(Index k = 0; is_manifold && k < 3; ++k)
      is_manifold = halfedge_between.count(key(corner[k], corner[(k + 1) % 3])) == 0;
    if(!is_manifold)
      continue;
    patch.patch_face.emplace(triangle, Index(patch.cloud_triangle.size()));
    patch.cloud_triangle.push_back(triangle);
    for(Index k = 0; k < 3; ++k)
    {
      halfedge_between.emplace(key(corner[k], corner[(k + 1) % 3]), Index(corners.size()));
      const auto [entry, is_new] =
          patch.patch_vertex.try_emplace(corner[k], Index(patch.cloud_vertex.size()));
      if(is_new)
        patch.cloud_vertex.push_back(corner[k]);
      corners.push_back(entry->second);
    }
  }
  std::vector<Index> twins(corners.size(), none);
  for(const auto& [ends, h] : halfedge_between)
    if(const auto twin = halfedge_between.find(ends << 32 | ends >> 32);
       twin != halfedge_between.end())
      twins[h] = twin->second;
  std::vector<std::array<double, 3>> points;
  for(const Index vertex : patch.cloud_vertex)
    points.push_back(cloud.point[vertex]);
  patch.mesh = build_mesh_arrays(std::move(points), corners, twins);
  return patch;
}

// Converts a location on the cloud to one on the patch. Returns false if the patch does not
// contain its vertex or triangle.
bool locate_on_patch(const Patch& patch, const Surface_arrays& cloud,
                     const Surface_location& location, Surface_location& result)
{
  if(const Index vertex = vertex_of(cloud, location); vertex != none)
  {
    const auto found_vertex = patch.patch_vertex.find(vertex);
    if(found_vertex == patch.patch_vertex.end())
      return false;
    result = vertex_location(patch.mesh.arrays, patch.mesh.internal_vertex[found_vertex->second]);
    return true;
  }
  const auto found_face = patch.patch_face.find(location.triangle);
  if(found_face == patch.patch_face.end())
    return false;
  result = location;
  result.triangle = patch.mesh.triangle_of_face[found_face->second];
  return true;
}

} // namespace

std::vector<Surface_location> shorten_on_cloud(const Surface_arrays& cloud,
                                               const std::vector<Surface_location>& input)
{
  std::vector<Surface_location> path;
  for(const Surface_location& location : input)
    path.push_back(canonical(cloud, location));
  if(path.size() < 2)
    return path;
  double length = polyline_length(cloud, path);

  // In each iteration, the path can move by the width of the patch. Eight iterations suffice for a
  // path that starts as a shortest path of graph edges.
  for(int i = 0; i < 8; ++i)
  {
    const Patch patch = build_patch(cloud, path);
    Surface_location from, to;
    if(!locate_on_patch(patch, cloud, path.front(), from) ||
       !locate_on_patch(patch, cloud, path.back(), to))
      break;
    const auto triangles = std::make_shared<const Surface_arrays>(patch.mesh.arrays);
    const std::vector<Surface_location> initial_path = Path_finder(triangles)(from, to);
    if(initial_path.empty())
      break;
    std::vector<Surface_location> next_path = shorten_geodesic(*triangles, initial_path).locations;
    for(Surface_location& location : next_path)
      location.triangle = patch.cloud_triangle[patch.mesh.face_of_triangle[location.triangle]];
    next_path.front() = path.front();
    next_path.back() = path.back();
    const double next_length = polyline_length(cloud, next_path);
    if(!(next_length < length))
      break;
    const bool is_converged = next_length > (1. - 1e-6) * length;
    path = std::move(next_path);
    length = next_length;
    if(is_converged)
      break;
  }
  return path;
}

} // namespace CGAL::Geodesic_processing::internal
