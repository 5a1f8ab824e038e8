// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/close_vertices.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

void merge_vertices(Operators& operators, const Vertex_groups& groups)
{
  std::vector<Index> representative(operators.number_of_vertices);
  std::iota(representative.begin(), representative.end(), Index(0));
  for(const std::vector<Index>& group : groups)
    for(const Index vertex : group)
      representative[vertex] = group.front();
  for(Index& vertex : operators.corner)
    vertex = representative[vertex];
}

void merge_vertices(Vector& masses, const Vertex_groups& groups)
{
  for(const std::vector<Index>& group : groups)
    for(const Index vertex : group)
      if(vertex != group.front())
        masses[group.front()] += std::exchange(masses[vertex], 0.);
}

Close_vertices close_vertices(const Surface_arrays& t, double max_length)
{
  using Neighbor = std::pair<Index, double>;
  std::vector<std::vector<Neighbor>> neighbors(t.number_of_vertices());
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.length[h] < max_length)
    {
      const Index v = t.corner[h], w = t.corner[next_halfedge(h)];
      neighbors[v].emplace_back(w, t.length[h]);
      neighbors[w].emplace_back(v, t.length[h]);
    }
  Close_vertices result;
  result.parent.assign(t.number_of_vertices(), none);
  result.parent_distance.assign(t.number_of_vertices(), 0.);
  std::vector<bool> is_grouped(t.number_of_vertices(), false);
  for(Index root = 0; root < neighbors.size(); ++root)
  {
    if(neighbors[root].empty() || is_grouped[root])
      continue;
    std::vector<Index> group = {root};
    is_grouped[root] = true;
    for(std::size_t i = 0; i < group.size(); ++i)
      for(const auto& [neighbor, length] : neighbors[group[i]])
        if(!is_grouped[neighbor])
        {
          is_grouped[neighbor] = true;
          result.parent[neighbor] = group[i];
          result.parent_distance[neighbor] = length;
          group.push_back(neighbor);
        }
    result.groups.push_back(std::move(group));
  }
  return result;
}

double cost_between_close_vertices(const Close_vertices& close, Vector masses)
{
  double result = 0.;
  for(const std::vector<Index>& group : close.groups)
    for(auto vertex = group.rbegin(); vertex != group.rend() - 1; ++vertex)
    {
      result += close.parent_distance[*vertex] * std::abs(masses[*vertex]);
      masses[close.parent[*vertex]] += masses[*vertex];
    }
  return result;
}

void merge_close_vertices(const Surface_arrays& t, const Close_vertices& close,
                          Operators& operators)
{
  merge_vertices(operators, close.groups);
  for(Index f = 0; f < operators.number_of_triangles(); ++f)
  {
    const Index* corner = &operators.corner[3 * f];
    Vec2* gradient = &operators.hat_gradient[3 * f];
    for(Index k = 0; k < 3; ++k)
    {
      const Index i = (k + 1) % 3, j = (k + 2) % 3;
      if(corner[i] != corner[j])
        continue;
      const double length = std::min(t.length[3 * f + k], t.length[3 * f + j]);
      const bool is_point = corner[k] == corner[i];
      gradient[i] = {0., 0.};
      gradient[j] = {is_point ? 0. : -1. / length, 0.};
      gradient[k] = -1. * gradient[j];
      operators.area[f] = is_point ? 0. : 0.1 * length * length;
      break;
    }
  }
}

void separate_close_vertices(const Operators& merged, const Operators& original, Field& flow)
{
  for(std::size_t f = 0; f < merged.number_of_triangles(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = 3 * f + (k + 1) % 3, j = 3 * f + (k + 2) % 3;
      if(merged.corner[i] != merged.corner[j])
        continue;
      const double mass = merged.area[f] * dot(flow[f], merged.hat_gradient[3 * f + k]);
      // The edge from corner j to corner k
      const Vec2 normal = rotated_left(original.hat_gradient[i]);
      const double scale = dot(normal, original.hat_gradient[3 * f + k]) * original.area[f];
      flow[f] = mass != 0. && scale != 0. ? (mass / scale) * normal : Vec2{0., 0.};
      break;
    }
}

} // namespace CGAL::Geodesic_processing::internal
