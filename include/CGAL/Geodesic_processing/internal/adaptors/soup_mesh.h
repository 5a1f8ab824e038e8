// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_SOUP_MESH_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_SOUP_MESH_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <CGAL/Surface_mesh/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Links the boundary halfedges of a mesh. At a vertex with several fans, those of all fans are
// linked to one cycle, so that circulators around the vertex visit all fans that have a boundary.
//
// corners: 3 #triangles, vertices
// twins: 3 #triangles
// halfedges: 3 #triangles, the halfedges of the mesh
template <typename Point_3>
void link_boundary_halfedges(
    const std::vector<Index>& corners, const std::vector<Index>& twins,
    const std::vector<typename Surface_mesh<Point_3>::Halfedge_index>& halfedges,
    Surface_mesh<Point_3>& mesh)
{
  using Mesh = Surface_mesh<Point_3>;
  using Halfedge = typename Mesh::Halfedge_index;
  std::vector<Halfedge> first_boundary_halfedge(mesh.number_of_vertices());
  for(Index h = 0; h < corners.size(); ++h)
  {
    if(twins[h] != none)
      continue;
    Index last = previous_halfedge(h);
    while(twins[last] != none)
      last = previous_halfedge(twins[last]);
    const Halfedge incoming = mesh.opposite(halfedges[h]),
                   outgoing = mesh.opposite(halfedges[last]);
    Halfedge& first_incoming = first_boundary_halfedge[corners[h]];
    if(first_incoming == Mesh::null_halfedge())
    {
      first_incoming = incoming;
      mesh.set_next(incoming, outgoing);
    }
    else
    {
      mesh.set_next(incoming, mesh.next(first_incoming));
      mesh.set_next(first_incoming, outgoing);
    }
    // CGAL requires that the halfedge of a boundary vertex is a boundary halfedge.
    mesh.set_halfedge(typename Mesh::Vertex_index(corners[h]), incoming);
  }
}

// Returns the mesh of triangles with the given twins. Vertex i is point i, and face f is triangle
// f. A point with several fans remains one vertex. The coordinates are not set. O(n).
//
// corners: 3 #triangles, indices of points
// twins: 3 #triangles, the opposite halfedge or none
template <typename Point_3>
Surface_mesh<Point_3> soup_mesh(std::size_t number_of_points, const std::vector<Index>& corners,
                                const std::vector<Index>& twins)
{
  using Mesh = Surface_mesh<Point_3>;
  using Vertex = typename Mesh::Vertex_index;
  using Edge = typename Mesh::Edge_index;
  using Face = typename Mesh::Face_index;
  using Size = typename Mesh::size_type;
  const std::size_t number_of_boundary_edges =
      static_cast<std::size_t>(std::count(twins.begin(), twins.end(), none));
  Mesh mesh;
  mesh.resize(static_cast<Size>(number_of_points),
              static_cast<Size>((corners.size() + number_of_boundary_edges) / 2),
              static_cast<Size>(corners.size() / 3));

  std::vector<typename Mesh::Halfedge_index> halfedges(corners.size());
  Index number_of_edges = 0;
  for(Index h = 0; h < corners.size(); ++h)
    halfedges[h] = twins[h] != none && twins[h] < h ? mesh.opposite(halfedges[twins[h]])
                                                    : mesh.halfedge(Edge(number_of_edges++));
  for(Index h = 0; h < corners.size(); ++h)
  {
    const Vertex target(corners[next_halfedge(h)]);
    const Face face(h / 3);
    mesh.set_target(halfedges[h], target);
    mesh.set_face(halfedges[h], face);
    mesh.set_next(halfedges[h], halfedges[next_halfedge(h)]);
    mesh.set_halfedge(target, halfedges[h]);
    if(h % 3 == 0)
      mesh.set_halfedge(face, halfedges[h]);
    if(twins[h] == none)
      mesh.set_target(mesh.opposite(halfedges[h]), Vertex(corners[h]));
  }
  link_boundary_halfedges(corners, twins, halfedges, mesh);
  return mesh;
}

// Returns the mesh of a soup from its arrays. O(n).
//
// points: of the soup
// vertices: #vertices of the arrays, the vertices of the mesh
// faces: #triangles, the faces of the mesh
template <typename Point_3>
Surface_mesh<Point_3>
soup_mesh(const std::vector<Point_3>& points, const Surface_arrays& triangles,
          const std::vector<typename Surface_mesh<Point_3>::Vertex_index>& vertices,
          const std::vector<typename Surface_mesh<Point_3>::Face_index>& faces)
{
  std::vector<Index> corners(triangles.corner.size()), twins(triangles.corner.size());
  for(Index triangle = 0; triangle < faces.size(); ++triangle)
    for(Index k = 0; k < 3; ++k)
    {
      const Index from = 3 * triangle + k, to = 3 * Index(faces[triangle]) + k,
                  twin = triangles.twin[from];
      corners[to] = Index(vertices[triangles.corner[from]]);
      twins[to] = twin == none ? none : 3 * Index(faces[twin / 3]) + twin % 3;
    }
  Surface_mesh<Point_3> mesh = soup_mesh<Point_3>(points.size(), corners, twins);
  for(Index i = 0; i < points.size(); ++i)
    mesh.point(typename Surface_mesh<Point_3>::Vertex_index(i)) = points[i];
  return mesh;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_SOUP_MESH_H
