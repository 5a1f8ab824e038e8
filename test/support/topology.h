// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TOPOLOGY_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TOPOLOGY_H

#include "triangulations.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::test {

// The topology of a set of triangles, computed from their corners only.
struct Topology
{
  // true for a manifold: each directed edge and each set of three corners occurs at most once, and
  // the triangles at each point form one fan
  bool is_simple = true;
  // Euler characteristic and number of boundary cycles of each component, sorted.
  std::vector<std::pair<std::ptrdiff_t, std::size_t>> components;

  bool operator==(const Topology& other) const
  {
    return is_simple == other.is_simple && components == other.components;
  }
  friend std::ostream& operator<<(std::ostream& out, const Topology& topology)
  {
    out << (topology.is_simple ? "simple" : "not simple");
    for(const auto& [characteristic, boundaries] : topology.components)
      out << ", " << characteristic << " with " << boundaries << " boundary cycles";
    return out;
  }
};

// The corner opposite to each directed edge of a triangle.
using Opposite_corners = std::map<std::pair<Index, Index>, Index>;

// Returns the number of triangles in the fan around p that contains one of its triangles. It is the
// number of all triangles at p if the surface is a manifold there.
inline std::size_t size_of_fan_at(Index p, const Opposite_corners& opposite_corner)
{
  const auto next = [&](Index from, Index to)
  {
    const auto found = opposite_corner.find({from, to});
    return found == opposite_corner.end() ? none : found->second;
  };
  // Turns clockwise until the boundary, or once around p.
  const Index first = opposite_corner.lower_bound({p, 0})->first.second;
  Index begin = first;
  for(Index q = next(first, p); q != none && q != first; q = next(q, p))
    begin = q;
  std::size_t number = 0;
  for(Index q = next(p, begin); q != none; q = next(p, q))
  {
    ++number;
    if(q == begin)
      break;
  }
  return number;
}

// Computes the topology of a triangle soup. Points without a triangle are ignored.
inline Topology topology(const std::vector<Index>& corners)
{
  Topology result;
  Opposite_corners opposite_corner;
  std::set<std::array<Index, 3>> triangles;
  std::map<Index, Index> parent; // towards the root of each component
  const auto root = [&](Index p)
  {
    parent.try_emplace(p, p);
    while(parent[p] != p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  for(std::size_t f = 0; f < corners.size(); f += 3)
  {
    std::array<Index, 3> sorted = {corners[f], corners[f + 1], corners[f + 2]};
    for(int k = 0; k < 3; ++k)
    {
      const Index a = sorted[k], b = sorted[(k + 1) % 3];
      result.is_simple = result.is_simple && a != b &&
                         opposite_corner.try_emplace({a, b}, sorted[(k + 2) % 3]).second;
      parent[root(a)] = root(b);
    }
    std::sort(sorted.begin(), sorted.end());
    result.is_simple = triangles.insert(sorted).second && result.is_simple;
  }
  if(!result.is_simple)
    return result;

  std::map<Index, std::pair<std::ptrdiff_t, std::size_t>> components;
  std::map<Index, std::size_t> degree; // triangles at each point
  std::map<Index, Index> next;         // next point along the boundary
  for(const auto& [p, to] : parent)
    ++components[root(p)].first;
  for(const auto& [edge, opposite] : opposite_corner)
  {
    const auto& [a, b] = edge;
    ++degree[a];
    const bool is_boundary = opposite_corner.count({b, a}) == 0;
    if(is_boundary || a < b)
      --components[root(a)].first;
    if(is_boundary)
      result.is_simple = next.try_emplace(a, b).second && result.is_simple;
  }
  for(const auto& f : triangles)
    ++components[root(f[0])].first;

  for(const auto& [p, number] : degree)
    result.is_simple = result.is_simple && size_of_fan_at(p, opposite_corner) == number;
  std::set<Index> unvisited;
  for(const auto& [a, b] : next)
    unvisited.insert(a);
  while(!unvisited.empty() && result.is_simple)
  {
    ++components[root(*unvisited.begin())].second;
    for(Index p = *unvisited.begin(); unvisited.erase(p) > 0;)
      p = next[p];
  }
  for(const auto& [p, component] : components)
    result.components.push_back(component);
  std::sort(result.components.begin(), result.components.end());
  return result;
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_TOPOLOGY_H
