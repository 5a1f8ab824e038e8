// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/loop_basis.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "paths/fans.h"

#include <algorithm>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The shortest paths along edges from one fan of each component.
class Shortest_path_forest
{
public:
  explicit Shortest_path_forest(const Surface_arrays& t)
      : t(t), m_fans(fans(t)), m_distance(m_fans.size(), infinity), m_parent(m_fans.size(), none)
  {
    for(Index root = 0; root < m_fans.size(); ++root)
      if(m_distance[root] == infinity)
        grow(root);
  }

  // Returns the length of the loop that an edge closes.
  double loop_length(Index h) const
  {
    return m_distance[origin(h)] + t.length[h] + m_distance[target(h)];
  }
  // Returns whether a halfedge or its twin is in the forest.
  bool contains(Index h) const
  {
    const auto leads_to = [&](Index fan)
    { return m_parent[fan] == h || (t.twin[h] != none && m_parent[fan] == t.twin[h]); };
    return leads_to(origin(h)) || leads_to(target(h));
  }

  // Returns the loop that an edge closes, without the part that is passed in both directions.
  std::vector<Surface_location> loop(Index h) const
  {
    std::vector<Index> forward = edges_from_root(target(h)), back = edges_from_root(origin(h));
    std::size_t common = 0;
    while(common < forward.size() && common < back.size() && forward[common] == back[common])
      ++common;
    std::vector<Surface_location> result;
    // From the end of the edge back to the common part, and forward to its begin.
    add(h, origin(h), target(h), result);
    Index fan = target(h);
    for(std::size_t i = forward.size(); i > common; --i)
      fan = add_edge(forward[i - 1], fan, result);
    for(std::size_t i = common; i < back.size(); ++i)
      fan = add_edge(back[i], fan, result);
    return result;
  }

private:
  Index origin(Index h) const { return m_fans.fan[h]; }
  Index target(Index h) const { return m_fans.fan[next_halfedge(h)]; }
  Index other_end(Index h, Index fan) const { return origin(h) == fan ? target(h) : origin(h); }

  void grow(Index root)
  {
    m_distance[root] = 0.;
    Vertex_queue& queue = m_queue;
    queue.push(root, 0.);
    while(!queue.empty())
    {
      const Index fan = queue.front().vertex;
      queue.pop();
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

  std::vector<Index> edges_from_root(Index fan) const
  {
    std::vector<Index> result;
    for(; m_parent[fan] != none; fan = other_end(m_parent[fan], fan))
      result.push_back(m_parent[fan]);
    std::reverse(result.begin(), result.end());
    return result;
  }

  Surface_location location(Index corner) const
  {
    Surface_location result;
    result.triangle = corner / 3;
    result.barycentric = barycentric_at_corner(corner);
    return result;
  }

  Index add_edge(Index h, Index from, std::vector<Surface_location>& path) const
  {
    const Index to = other_end(h, from);
    add(h, from, to, path);
    return to;
  }
  // Appends the begin of an edge and, if another edge joins the same vertices, its midpoint.
  void add(Index h, Index from, Index to, std::vector<Surface_location>& path) const
  {
    const bool is_reversed = origin(h) != from;
    const Surface_location begin = location(is_reversed ? next_halfedge(h) : h),
                           end = location(is_reversed ? h : next_halfedge(h));
    path.push_back(begin);
    const Index triangle = common_triangle(t, begin, end);
    if(from != to && (triangle == h / 3 || (t.twin[h] != none && triangle == t.twin[h] / 3)))
      return;
    Surface_location midpoint;
    midpoint.triangle = h / 3;
    midpoint.barycentric = barycentric_on_halfedge(h, 0.5);
    path.push_back(midpoint);
  }

  const Surface_arrays& t;
  Fans m_fans;
  std::vector<double> m_distance; // #fans: from the root
  std::vector<Index> m_parent;    // #fans: the last halfedge, of either direction; none at roots
  Vertex_queue m_queue = Vertex_queue(m_fans.size());
};

} // namespace

std::vector<std::vector<Surface_location>> loop_basis(const Surface_arrays& t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error(
        "A basis of loops requires a mesh, because the triangles of a cloud are not connected.");
  const Shortest_path_forest forest(t);
  struct Edge
  {
    double length;
    Index halfedge;
  };
  std::vector<Edge> edges;
  for(Index h = 0; h < t.corner.size(); ++h)
    if((t.twin[h] == none || h < t.twin[h]) && !forest.contains(h))
      edges.push_back({forest.loop_length(h), h});
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b)
            { return a.length != b.length ? a.length > b.length : a.halfedge < b.halfedge; });

  // The spanning tree of triangles. Its last node is the exterior of the boundary.
  const Index exterior = Index(t.number_of_triangles());
  std::vector<Index> parent(exterior + 1);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root_of = [&](Index node)
  {
    while(parent[node] != node)
      node = parent[node] = parent[parent[node]];
    return node;
  };
  std::vector<std::vector<Surface_location>> result;
  for(const Edge& edge : edges)
  {
    const Index twin = t.twin[edge.halfedge], a = root_of(edge.halfedge / 3),
                b = root_of(twin == none ? exterior : twin / 3);
    if(a == b)
      result.push_back(forest.loop(edge.halfedge));
    else
      parent[a] = b;
  }
  std::reverse(result.begin(), result.end());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
