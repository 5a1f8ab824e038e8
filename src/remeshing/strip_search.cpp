// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/strip_search.h"

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Points on each edge that serve as nodes. The path is shortened afterwards.
constexpr Index points_per_edge = 3;

} // namespace

bool Strip_search::is_end_cell(Index cell) const
{
  return cell == m_nearby_cells[0] || cell == m_nearby_cells[1];
}

double Strip_search::detour_factor(Index vertex) const
{
  const Index cell = m_cell[vertex];
  return is_end_cell(cell) || cell == none                        ? 1.
         : cell == m_nearby_cells[2] || cell == m_nearby_cells[3] ? m_factors.near
                                                                  : m_factors.far;
}

// If the path is confined, an edge with one end vertex in a cell belongs to the cell.
double Strip_search::detour_factor_across(Index h) const
{
  const double from = detour_factor(m_mesh.source(h)), to = detour_factor(m_mesh.target(h));
  return m_factors.is_confined() ? std::min(from, to) : 0.5 * (from + to);
}

// Returns the cell of a new vertex on an edge: that of the closer end vertex. If the path is
// confined, the cell of an end of the path takes precedence.
Index Strip_search::cell_on(Index h, double fraction) const
{
  const Index from = m_cell[m_mesh.source(h)], to = m_cell[m_mesh.target(h)];
  if(m_factors.is_confined() && is_end_cell(from) != is_end_cell(to))
    return is_end_cell(from) ? from : to;
  return fraction < 0.5 ? from : to;
}

inline Vec3 Strip_search::point(Index node) const
{
  const std::vector<Vec3>& points = m_mesh.triangles().point;
  const Index h = node / points_per_edge;
  const double fraction = double(node % points_per_edge + 1) / double(points_per_edge + 1);
  return (1. - fraction) * points[m_mesh.source(h)] + fraction * points[m_mesh.target(h)];
}

// Relaxes the nodes of an edge from a point of the triangle of h.
inline void Strip_search::reach(Index h, const Vec3& from, double distance, Index previous)
{
  if(m_mesh.labels()[h] != none || m_mesh.triangles().twin[h] == none)
    return;
  const double factor = detour_factor_across(h);
  if(factor == infinity)
    return;
  for(Index i = 0; i < points_per_edge; ++i)
  {
    const Index node_index = points_per_edge * m_mesh.smaller_twin(h) + i;
    const Vec3 position = point(node_index);
    const double length = distance + factor * norm(position - from);
    Node& node = m_nodes[node_index];
    if(node.run == m_run && !(length < node.distance))
      continue;
    node = {length, m_run, previous, h};
    m_queue.emplace(length + norm(m_goal_point - position), node_index);
  }
}

std::vector<Index> Strip_search::find(const std::vector<Index>& start_corners,
                                      const std::vector<Index>& goal_corners, Index to)
{
  const Surface_arrays& t = m_mesh.triangles();
  ++m_run;
  m_nodes.resize(points_per_edge * t.corner.size());
  m_goal_point = t.point[to];
  m_queue = Queue();
  for(const Index corner : start_corners)
    reach(next_halfedge(corner), t.point[m_mesh.source(corner)], 0., none);
  double best = infinity;
  Index end = none;
  while(!m_queue.empty() && m_queue.top().first < best)
  {
    const auto [key, node_index] = m_queue.top();
    m_queue.pop();
    if(m_visits_left == 0)
      return {};
    --m_visits_left;
    const Node node = m_nodes[node_index];
    const Vec3 position = point(node_index);
    if(key > node.distance + norm(m_goal_point - position))
      continue;
    const Index entry = t.twin[node.halfedge], far = previous_halfedge(entry);
    if(m_mesh.source(far) == to && node.distance + norm(m_goal_point - position) < best &&
       std::find(goal_corners.begin(), goal_corners.end(), far) != goal_corners.end())
    {
      best = node.distance + norm(m_goal_point - position);
      end = node_index;
    }
    reach(next_halfedge(entry), position, node.distance, node_index);
    reach(far, position, node.distance, node_index);
  }
  std::vector<Index> result;
  for(Index node = end; node != none; node = m_nodes[node].from)
    result.push_back(m_nodes[node].halfedge);
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
