// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_TRIANGLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_TRIANGLES_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

template <typename TriangleMesh>
struct Added_triangles
{
  using Graph = boost::graph_traits<TriangleMesh>;

  std::vector<typename Graph::vertex_descriptor> vertices;    // #points
  std::vector<typename Graph::halfedge_descriptor> halfedges; // 3 #triangles
};

// Links the boundary halfedges of added triangles. At a vertex with several fans, those of all fans
// are linked to one cycle, so that circulators around the vertex visit all fans that have a
// boundary.
template <typename TriangleMesh>
void link_added_boundary(const std::vector<std::array<Index, 3>>& triangles,
                         const std::vector<Index>& twins,
                         const Added_triangles<TriangleMesh>& added, TriangleMesh& mesh)
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const Halfedge null = boost::graph_traits<TriangleMesh>::null_halfedge();
  std::vector<Halfedge> first_boundary_halfedge(added.vertices.size(), null);
  for(Index h = 0; h < twins.size(); ++h)
  {
    if(twins[h] != none)
      continue;
    Index last = previous_halfedge(h);
    while(twins[last] != none)
      last = previous_halfedge(twins[last]);
    const Halfedge incoming = opposite(added.halfedges[h], mesh);
    const Halfedge outgoing = opposite(added.halfedges[last], mesh);
    const Index vertex = triangles[h / 3][h % 3];
    Halfedge& first_incoming = first_boundary_halfedge[vertex];
    if(first_incoming == null)
    {
      first_incoming = incoming;
      set_next(incoming, outgoing, mesh);
    }
    else
    {
      set_next(incoming, next(first_incoming, mesh), mesh);
      set_next(first_incoming, outgoing, mesh);
    }
    // CGAL requires that the halfedge of a boundary vertex is a boundary halfedge.
    set_halfedge(added.vertices[vertex], incoming, mesh);
  }
}

// Adds points and triangles with the given twins to a mesh. Unlike the functions of CGAL, it does
// not search for edges: a vertex may have several fans, and two edges may have the same vertices.
// O(n).
//
// twins: 3 #triangles, the opposite halfedge or none
template <typename TriangleMesh>
Added_triangles<TriangleMesh> add_triangles(const std::vector<std::array<double, 3>>& points,
                                            const std::vector<std::array<Index, 3>>& triangles,
                                            const std::vector<Index>& twins, TriangleMesh& mesh)
{
  const auto point_map = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  Added_triangles<TriangleMesh> added;
  added.vertices.reserve(points.size());
  added.halfedges.reserve(twins.size());
  for(const auto& p : points)
  {
    added.vertices.push_back(add_vertex(mesh));
    put(point_map, added.vertices.back(), Point(p[0], p[1], p[2]));
  }
  for(Index h = 0; h < twins.size(); ++h)
    added.halfedges.push_back(twins[h] != none && twins[h] < h
                                  ? opposite(added.halfedges[twins[h]], mesh)
                                  : halfedge(add_edge(mesh), mesh));
  for(Index f = 0; f < triangles.size(); ++f)
  {
    const auto face = add_face(mesh);
    set_halfedge(face, added.halfedges[3 * f], mesh);
    for(Index k = 0; k < 3; ++k)
    {
      const auto h = added.halfedges[3 * f + k];
      const auto target = added.vertices[triangles[f][(k + 1) % 3]];
      set_target(h, target, mesh);
      set_face(h, face, mesh);
      set_next(h, added.halfedges[3 * f + (k + 1) % 3], mesh);
      set_halfedge(target, h, mesh);
      if(twins[3 * f + k] == none)
        set_target(opposite(h, mesh), added.vertices[triangles[f][k]], mesh);
    }
  }
  link_added_boundary(triangles, twins, added, mesh);
  return added;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_TRIANGLES_H
