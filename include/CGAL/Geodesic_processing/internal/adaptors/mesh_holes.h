// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MESH_HOLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MESH_HOLES_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/triangulate_hole.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

template <typename TriangleMesh>
using Halfedge_of = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
template <typename TriangleMesh>
using Vertex_of = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

template <typename TriangleMesh>
bool is_boundary_halfedge(Halfedge_of<TriangleMesh> h, const TriangleMesh& mesh)
{
  return face(h, mesh) == boost::graph_traits<TriangleMesh>::null_face();
}

// Returns the next boundary halfedge in the same fan of faces.
template <typename TriangleMesh>
Halfedge_of<TriangleMesh> next_in_fan(Halfedge_of<TriangleMesh> h, const TriangleMesh& mesh)
{
  do
    h = prev(opposite(h, mesh), mesh);
  while(!is_boundary_halfedge(opposite(h, mesh), mesh));
  return opposite(h, mesh);
}

// The boundary halfedges of a hole. Each one ends where the next one starts, and each vertex occurs
// once. At vertices with several fans they need not follow each other in the mesh.
template <typename TriangleMesh>
using Hole_cycle = std::vector<Halfedge_of<TriangleMesh>>;

// Splits the boundary into cycles that visit each vertex at most once. At vertices with several
// fans, each cycle stays in its fan, so that parts that only touch are not connected. If a cycle
// revisits a vertex, the halfedges between the two visits become a separate cycle. O(n).
template <typename TriangleMesh>
std::vector<Hole_cycle<TriangleMesh>> find_holes(const TriangleMesh& mesh)
{
  using Halfedge = Halfedge_of<TriangleMesh>;
  std::vector<Hole_cycle<TriangleMesh>> holes;
  const auto is_visited = get(dynamic_halfedge_property_t<bool>(), mesh);
  // The position of a vertex in `cycle`, counted from one; zero if it is not in it.
  const auto position = get(dynamic_vertex_property_t<std::size_t>(), mesh);
  for(const auto v : vertices(mesh))
    put(position, v, 0);
  for(const Halfedge h : halfedges(mesh))
    put(is_visited, h, false);
  Hole_cycle<TriangleMesh> cycle;
  for(const Halfedge first : halfedges(mesh))
  {
    if(!is_boundary_halfedge(first, mesh))
      continue;
    for(Halfedge h = first; !get(is_visited, h); h = next_in_fan(h, mesh))
    {
      put(is_visited, h, true);
      cycle.push_back(h);
      const std::size_t previous_position = get(position, target(h, mesh));
      if(previous_position == 0)
      {
        put(position, target(h, mesh), cycle.size());
        continue;
      }
      const auto begin = cycle.begin() + static_cast<std::ptrdiff_t>(previous_position);
      for(auto inner = begin; inner + 1 != cycle.end(); ++inner)
        put(position, target(*inner, mesh), 0);
      holes.emplace_back(begin, cycle.end());
      cycle.erase(begin, cycle.end());
    }
    for(const Halfedge h : cycle)
      put(position, target(h, mesh), 0);
    if(!cycle.empty())
      holes.push_back(std::move(cycle));
    cycle = {};
  }
  return holes;
}

// Returns whether a hole is the boundary of an isolated face.
template <typename TriangleMesh>
bool is_around_isolated_face(const Hole_cycle<TriangleMesh>& hole, const TriangleMesh& mesh)
{
  const auto isolated_face = face(opposite(hole.front(), mesh), mesh);
  return std::all_of(hole.begin(), hole.end(),
                     [&](auto h) { return face(opposite(h, mesh), mesh) == isolated_face; });
}

// The neighbors of vertices on boundaries.
template <typename TriangleMesh>
using Boundary_neighbors = std::map<Vertex_of<TriangleMesh>, std::vector<Vertex_of<TriangleMesh>>>;

// Returns the edges of a mesh between vertices of holes. Circulators would not visit all edges at a
// vertex with several fans. O(n).
template <typename TriangleMesh>
Boundary_neighbors<TriangleMesh>
find_boundary_neighbors(const std::vector<Hole_cycle<TriangleMesh>>& holes,
                        const TriangleMesh& mesh)
{
  Boundary_neighbors<TriangleMesh> neighbors;
  const auto is_on_boundary = get(dynamic_vertex_property_t<bool>(), mesh);
  for(const auto v : vertices(mesh))
    put(is_on_boundary, v, false);
  for(const auto& hole : holes)
    for(const auto h : hole)
      put(is_on_boundary, source(h, mesh), true);
  for(const auto h : halfedges(mesh))
    if(get(is_on_boundary, source(h, mesh)) && get(is_on_boundary, target(h, mesh)))
      neighbors[source(h, mesh)].push_back(target(h, mesh));
  return neighbors;
}

// Reads the boundary of a hole. `position` is a property map of the vertices with the value `none`,
// which it has again after the call.
template <typename TriangleMesh, typename PointMap, typename PositionMap>
Hole_boundary read_hole(const Hole_cycle<TriangleMesh>& hole, const TriangleMesh& mesh,
                        const PointMap& points, const Boundary_neighbors<TriangleMesh>& neighbors,
                        const PositionMap& position)
{
  const auto point = [&](Vertex_of<TriangleMesh> v)
  {
    const auto& p = get(points, v);
    const std::array<double, 3> result = {CGAL::to_double(p[0]), CGAL::to_double(p[1]),
                                          CGAL::to_double(p[2])};
    for(const double x : result)
      if(!std::isfinite(x))
        throw Invalid_argument_error("A coordinate at the boundary of a hole is not finite.");
    return result;
  };
  Hole_boundary result;
  const auto n = static_cast<Index>(hole.size());
  for(Index i = 0; i < n; ++i)
  {
    put(position, source(hole[i], mesh), i);
    result.points.push_back(point(source(hole[i], mesh)));
    result.apexes.push_back(point(target(next(opposite(hole[i], mesh), mesh), mesh)));
  }
  for(Index i = 0; i < n; ++i)
    for(const auto& neighbor : neighbors.at(source(hole[i], mesh)))
    {
      const Index j = get(position, neighbor);
      if(j != none && j != (i + 1) % n && i != (j + 1) % n)
        result.edges.push_back({i, j});
    }
  std::sort(result.edges.begin(), result.edges.end());
  result.edges.erase(std::unique(result.edges.begin(), result.edges.end()), result.edges.end());
  for(const auto h : hole)
    put(position, source(h, mesh), none);
  return result;
}

// Links the boundary halfedges that are left at the vertices of filled holes. At a vertex with
// several fans, those of all fans are linked to one cycle, so that circulators visit all fans that
// have a boundary. O(n).
template <typename TriangleMesh>
void link_boundaries(const std::vector<Hole_cycle<TriangleMesh>>& filled, TriangleMesh& mesh)
{
  // The first boundary halfedge that ends at each vertex; null if there is none.
  std::map<Vertex_of<TriangleMesh>, Halfedge_of<TriangleMesh>> first;
  for(const auto& hole : filled)
    for(const auto h : hole)
      first[target(h, mesh)] = boost::graph_traits<TriangleMesh>::null_halfedge();
  for(const auto h : halfedges(mesh))
  {
    if(!is_boundary_halfedge(h, mesh))
      continue;
    const auto found = first.find(target(h, mesh));
    if(found == first.end())
      continue;
    const auto outgoing = next_in_fan(h, mesh);
    if(found->second == boost::graph_traits<TriangleMesh>::null_halfedge())
    {
      found->second = h;
      set_next(h, outgoing, mesh);
      // If a vertex has boundary halfedges, its halfedge must be one of them.
      set_halfedge(target(h, mesh), h, mesh);
      continue;
    }
    set_next(h, next(found->second, mesh), mesh);
    set_next(found->second, outgoing, mesh);
  }
}

// Adds faces to a hole. Calls f with each of them. The boundary that remains at its vertices must
// be linked afterwards.
template <typename TriangleMesh, typename Function>
void add_hole_faces(const Hole_cycle<TriangleMesh>& hole, const Hole_triangles& triangles,
                    TriangleMesh& mesh, const Function& f)
{
  const std::size_t n = hole.size();
  std::vector<Vertex_of<TriangleMesh>> corners;
  std::map<std::array<Index, 2>, Halfedge_of<TriangleMesh>> halfedge_between;
  for(std::size_t i = 0; i < n; ++i)
  {
    corners.push_back(source(hole[i], mesh));
    set_halfedge(target(hole[i], mesh), hole[i], mesh);
    halfedge_between[{static_cast<Index>(i), static_cast<Index>((i + 1) % n)}] = hole[i];
  }
  for(const auto& triangle : triangles)
  {
    std::array<Halfedge_of<TriangleMesh>, 3> cycle;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Index a = triangle[k], b = triangle[(k + 1) % 3];
      auto found = halfedge_between.find({a, b});
      if(found == halfedge_between.end())
      {
        const auto h = halfedge(add_edge(mesh), mesh);
        set_target(h, corners[b], mesh);
        set_target(opposite(h, mesh), corners[a], mesh);
        found = halfedge_between.emplace(std::array{a, b}, h).first;
        halfedge_between[{b, a}] = opposite(h, mesh);
      }
      cycle[k] = found->second;
    }
    const auto added_face = add_face(mesh);
    for(std::size_t k = 0; k < 3; ++k)
    {
      set_face(cycle[k], added_face, mesh);
      set_next(cycle[k], cycle[(k + 1) % 3], mesh);
    }
    set_halfedge(added_face, cycle[0], mesh);
    f(added_face);
  }
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_MESH_HOLES_H
