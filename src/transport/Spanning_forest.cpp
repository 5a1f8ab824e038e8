// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Spanning_forest.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the length of the edge that leads from the corner c to the next corner of its triangle.
// It is computed from the gradients, because these contain the metric.
double edge_length(const Operators& operators, std::size_t c)
{
  const Vec2* gradient = &operators.hat_gradient[c - c % 3];
  const double parallelogram = std::abs(cross(gradient[c % 3], gradient[(c + 1) % 3]));
  // The gradients of a triangle that became an edge are parallel; one of them is zero.
  if(parallelogram == 0.)
    return 1. / std::max(norm(gradient[c % 3]), norm(gradient[(c + 1) % 3]));
  // The gradient of the opposite corner is one over its height. Its product with the length of the
  // edge is one over the area, up to a factor.
  return norm(gradient[(c + 2) % 3]) / parallelogram;
}

} // namespace

Spanning_forest::Spanning_forest(const Operators& operators)
    : m_parent(operators.number_of_vertices, none),
      m_parent_distance(operators.number_of_vertices, 0.)
{
  struct Edge
  {
    Index vertex;
    double length;
  };
  const std::size_t n = operators.number_of_vertices;
  // Each triangle adds its three edges to both of their vertices.
  const auto for_each_edge = [&](const auto& f)
  {
    for(std::size_t c = 0; c < operators.corner.size(); ++c)
      if(operators.area[c / 3] > 0.)
        f(operators.corner[c], operators.corner[c - c % 3 + (c + 1) % 3], c);
  };
  std::vector<std::size_t> begin(n + 2, 0);
  for_each_edge([&](Index a, Index b, std::size_t) { ++begin[a + 2], ++begin[b + 2]; });
  for(std::size_t i = 2; i < begin.size(); ++i)
    begin[i] += begin[i - 1];
  std::vector<Edge> edges(begin.back());
  for_each_edge(
      [&](Index a, Index b, std::size_t c)
      {
        const double length = edge_length(operators, c);
        edges[begin[a + 1]++] = {b, length};
        edges[begin[b + 1]++] = {a, length};
      });

  m_order.reserve(n);
  std::vector<bool> is_in_tree(n, false);
  const auto add = [&](Index vertex)
  {
    is_in_tree[vertex] = true;
    m_order.push_back(vertex);
  };
  for(Index root = 0; root < n; ++root)
  {
    if(is_in_tree[root])
      continue;
    std::size_t i = m_order.size();
    for(add(root); i < m_order.size(); ++i)
      for(std::size_t j = begin[m_order[i]]; j < begin[m_order[i] + 1]; ++j)
        if(const auto [next, length] = edges[j]; !is_in_tree[next])
        {
          m_parent[next] = m_order[i];
          m_parent_distance[next] = length;
          add(next);
        }
  }
}

double Spanning_forest::cost(Vector masses) const
{
  double result = 0.;
  for(auto it = m_order.rbegin(); it != m_order.rend(); ++it)
    if(m_parent[*it] != none)
    {
      result += m_parent_distance[*it] * std::abs(masses[*it]);
      masses[m_parent[*it]] += masses[*it];
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
