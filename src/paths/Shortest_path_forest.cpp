// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/Shortest_path_forest.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Shortest_path_forest::Shortest_path_forest(const Surface_arrays& triangles, Fans fans, Index root)
    : t(triangles), m_fans(std::move(fans)), m_distance(m_fans.size(), infinity),
      m_parent(m_fans.size(), none)
{
  Vertex_queue queue(m_fans.size());
  if(root != none)
    grow(root, queue);
  else
    for(Index fan = 0; fan < m_fans.size(); ++fan)
      if(m_distance[fan] == infinity)
        grow(fan, queue);
}

// Dijkstra's algorithm.
void Shortest_path_forest::grow(Index root, Vertex_queue& queue)
{
  m_distance[root] = 0.;
  queue.push(root, 0.);
  while(!queue.empty())
  {
    const Index fan = queue.pop().vertex;
    const auto relax = [&](Index h)
    {
      const Index end = other_end(h, fan);
      const double distance = m_distance[fan] + t.length[h];
      if(!(distance < m_distance[end]))
        return;
      m_distance[end] = distance;
      m_parent[end] = h;
      queue.push(end, distance);
    };
    m_fans.for_each_corner(t, fan,
                           [&](Index corner)
                           {
                             relax(corner);
                             if(t.twin[previous_halfedge(corner)] == none)
                               relax(previous_halfedge(corner));
                           });
  }
}

bool Shortest_path_forest::contains(Index h) const
{
  const auto leads_to = [&](Index fan)
  {
    const Index parent = m_parent[fan];
    return parent != none && (parent == h || parent == t.twin[h]);
  };
  return leads_to(origin(h)) || leads_to(target(h));
}

std::vector<Index> Shortest_path_forest::edges_from_root(Index fan) const
{
  std::vector<Index> result;
  for(; m_parent[fan] != none; fan = other_end(m_parent[fan], fan))
    result.push_back(m_parent[fan]);
  std::reverse(result.begin(), result.end());
  return result;
}

std::vector<Surface_location> Shortest_path_forest::loop(Index h) const
{
  const std::vector<Index> forward = edges_from_root(target(h)), back = edges_from_root(origin(h));
  std::size_t common = 0;
  while(common < forward.size() && common < back.size() && forward[common] == back[common])
    ++common;
  std::vector<Surface_location> result;
  Index fan = add_edge(h, origin(h), result);
  for(std::size_t i = forward.size(); i > common; --i)
    fan = add_edge(forward[i - 1], fan, result);
  for(std::size_t i = common; i < back.size(); ++i)
    fan = add_edge(back[i], fan, result);
  return result;
}

std::vector<Surface_location> Shortest_path_forest::loop_from_root(Index h) const
{
  const std::vector<Index> forward = edges_from_root(origin(h)), back = edges_from_root(target(h));
  std::vector<Surface_location> result;
  Index fan = origin(h);
  for(auto edge = forward.rbegin(); edge != forward.rend(); ++edge)
    fan = other_end(*edge, fan); // the root
  for(const Index edge : forward)
    fan = add_edge(edge, fan, result);
  fan = add_edge(h, fan, result);
  for(auto edge = back.rbegin(); edge != back.rend(); ++edge)
    fan = add_edge(*edge, fan, result);
  return result;
}

// Appends the begin of an edge and, if another edge joins the same vertices, its midpoint. Returns
// the other end.
Index Shortest_path_forest::add_edge(Index h, Index from, std::vector<Surface_location>& path) const
{
  const auto at_corner = [](Index corner) {
    return Surface_location{corner / 3, none, barycentric_at_corner(corner)};
  };
  const bool is_reversed = origin(h) != from;
  const Surface_location begin = at_corner(is_reversed ? next_halfedge(h) : h),
                         end = at_corner(is_reversed ? h : next_halfedge(h));
  path.push_back(begin);
  const Index triangle = common_triangle(t, begin, end), to = other_end(h, from);
  const bool is_unique =
      from != to && (triangle == h / 3 || (t.twin[h] != none && triangle == t.twin[h] / 3));
  if(!is_unique)
    path.push_back({h / 3, none, barycentric_on_halfedge(h, 0.5)});
  return to;
}

} // namespace CGAL::Geodesic_processing::internal
