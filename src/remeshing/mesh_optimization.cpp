// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/mesh_optimization.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "mesh/flips.h"
#include "mesh/self_intersections.h"

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Steps of the fit after many relaxation steps: they reduce the distance by 2 to 5 percent.
constexpr int number_of_angle_preserving_steps = 3;

} // namespace

Coarse_mesh Mesh_optimization::build_mesh(const Cells& cells, const Sampling& sampling,
                                          std::vector<std::array<Index, 3>> triangles) const
{
  const Surface_arrays& t = m_surface.triangles();
  Coarse_mesh result{{}, std::move(triangles)};
  std::vector<bool> is_fixed;
  const bool has_max_deviation = m_options.maximum_deviation < infinity;
  const std::vector<Index> farthest =
      has_max_deviation ? farthest_vertices(cells, sampling) : std::vector<Index>();
  for(Index cell = 0; cell < cells.samples.size(); ++cell)
  {
    const Surface_location& sample = sampling.samples()[cells.samples[cell]];
    result.points.push_back(scaled_coordinates(t, sample));
    is_fixed.push_back(m_surface.is_on_feature(sample) ||
                       (has_max_deviation && farthest[cell] == none));
  }
  flip_to_larger_angles(result.points, kept_edges(cells, farthest, result.triangles),
                        result.triangles);
  if(m_options.does_fit_to_input)
    fit(t, cells.labels, is_fixed, result, m_options.maximum_deviation / m_surface.unit_size(),
        m_options.number_of_relaxation_steps < many_relaxation_steps
            ? 0
            : number_of_angle_preserving_steps);
  return result;
}

// Returns the edges between cells that a feature joins, and those between cells without another
// vertex than their sample. `farthest` is empty, or contains none for each such cell.
std::vector<std::array<Index, 2>>
Mesh_optimization::kept_edges(const Cells& cells, const std::vector<Index>& farthest,
                              const std::vector<std::array<Index, 3>>& triangles) const
{
  std::vector<std::array<Index, 2>> result;
  const auto add = [&](Index x, Index y)
  {
    if(x != y)
      result.push_back({std::min(x, y), std::max(x, y)});
  };
  const Surface_arrays& t = m_surface.triangles();
  for(Index h = 0; h < t.corner.size(); ++h)
    if(m_surface.is_feature()[h])
      add(cells.labels[t.corner[h]], cells.labels[t.corner[next_halfedge(h)]]);
  if(!farthest.empty())
    for(const auto& f : triangles)
      for(int k = 0; k < 3; ++k)
        if(const Index x = f[k], y = f[(k + 1) % 3]; farthest[x] == none && farthest[y] == none)
          add(x, y);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<Surface_location> Mesh_optimization::far_locations(const Cells& cells,
                                                               const Sampling& sampling,
                                                               const Coarse_mesh& mesh)
{
  if(!(m_options.maximum_deviation < infinity))
    return {};
  const std::vector<double>& distances = sampling.distances();
  std::vector<Index> labels = cells.labels;
  for(Index vertex = 0; vertex < labels.size(); ++vertex)
    if(distances[vertex] == 0.)
      labels[vertex] = none;
  std::vector<Index> vertices = far_vertices(m_surface.triangles(), labels, mesh,
                                             m_options.maximum_deviation / m_surface.unit_size());
  if(vertices.empty())
  {
    const std::vector<Index> farthest = farthest_vertices(cells, sampling);
    for(const auto& f : mesh.triangles)
    {
      Index best = none;
      for(const Index cell : f)
        if(const Index vertex = farthest[cell];
           vertex != none && (best == none || distances[vertex] > distances[best]))
          best = vertex;
      if(best != none && is_far(mesh, f))
        vertices.push_back(best);
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  std::vector<Surface_location> result;
  for(const Index vertex : vertices)
    result.push_back({none, vertex, {}});
  return result;
}

// Returns true if the centroid or an edge midpoint of a triangle is farther from the input mesh
// than the maximum deviation.
bool Mesh_optimization::is_far(const Coarse_mesh& mesh, const std::array<Index, 3>& triangle)
{
  const Surface_arrays& t = m_surface.triangles();
  const Surface_arrays& coarse = m_surface.coarse();
  if(!m_tree)
    m_tree.emplace(m_surface.refinement().coarse);
  const auto is_point_far = [&](const Vec3& p)
  {
    const Vec3 point = t.origin + t.scale * p;
    return norm(point - coordinates(coarse, m_tree->nearest(point))) >
           m_options.maximum_deviation * coarse.scale;
  };
  const Vec3 &a = mesh.points[triangle[0]], &b = mesh.points[triangle[1]],
             &c = mesh.points[triangle[2]];
  return is_point_far((1. / 3.) * (a + b + c)) || is_point_far(0.5 * (a + b)) ||
         is_point_far(0.5 * (b + c)) || is_point_far(0.5 * (c + a));
}

std::vector<Surface_location>
Mesh_optimization::locations_at_intersections(const Cells& cells, const Sampling& sampling,
                                              Remeshing& candidate)
{
  const std::size_t max_pairs = candidate.triangles.size();
  const auto intersections = self_intersections(candidate.points, candidate.triangles, max_pairs);
  candidate.number_of_self_intersections = intersections.size();
  if(intersections.empty() || intersections.size() == max_pairs)
    return {};
  const std::vector<bool> is_self_intersecting = self_intersecting_cells(cells);
  std::vector<bool> is_affected(cells.samples.size(), false);
  for(const auto& triangle_pair : intersections)
  {
    const auto is_intersection_free = [&](Index f)
    {
      const auto& corners = candidate.triangles[f];
      return !is_self_intersecting[corners[0]] && !is_self_intersecting[corners[1]] &&
             !is_self_intersecting[corners[2]];
    };
    if(is_intersection_free(triangle_pair[0]) || is_intersection_free(triangle_pair[1]))
      for(const Index f : triangle_pair)
        for(const Index cell : candidate.triangles[f])
          is_affected[cell] = true;
  }
  const std::vector<Index> farthest = farthest_vertices(cells, sampling);
  std::vector<Surface_location> result;
  for(Index cell = 0; cell < farthest.size(); ++cell)
    if(is_affected[cell] && farthest[cell] != none)
      result.push_back({none, farthest[cell], {}});
  return result;
}

// Returns the cells (#cells) with a vertex of an input triangle that intersects another one.
std::vector<bool> Mesh_optimization::self_intersecting_cells(const Cells& cells)
{
  if(!m_is_self_intersecting)
  {
    const Surface_arrays& coarse = m_surface.coarse();
    std::vector<std::array<Index, 3>> corners(coarse.number_of_triangles());
    for(Index f = 0; f < corners.size(); ++f)
      std::copy_n(&coarse.corner[3 * std::size_t(f)], 3, corners[f].begin());
    m_is_self_intersecting.emplace(corners.size(), false);
    for(const auto& triangle_pair : self_intersections(coarse.point, corners, corners.size()))
      for(const Index f : triangle_pair)
        (*m_is_self_intersecting)[f] = true;
  }
  const Surface_arrays& t = m_surface.triangles();
  const std::vector<Index>& parent = m_surface.refinement().parent;
  std::vector<bool> result(cells.samples.size(), false);
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    if((*m_is_self_intersecting)[parent.empty() ? f : parent[f]])
      for(Index k = 0; k < 3; ++k)
        result[cells.labels[t.corner[3 * f + k]]] = true;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
