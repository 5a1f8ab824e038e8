// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/loop_basis.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "paths/Shortest_path_forest.h"

#include <algorithm>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

std::vector<std::vector<Surface_location>> loop_basis(const Surface_arrays& t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error(
        "A basis of loops requires a mesh, because the triangles of a cloud are not connected.");
  const Shortest_path_forest forest(t, fans(t));
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
