// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_READ_TRIANGLES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_READ_TRIANGLES_H

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <CGAL/boost/graph/properties.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Appends the vertices of a mesh to `vertices_of_mesh` in their order. Returns the faces as
// triples of positions in that order. Throws Unsupported_surface_error if a face is not a
// triangle.
template <typename TriangleMesh>
std::vector<std::array<Index, 3>> read_triangles(
    const TriangleMesh& mesh,
    std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>& vertices_of_mesh)
{
  const auto index = get(dynamic_vertex_property_t<Index>(), mesh);
  for(const auto vertex : vertices(mesh))
  {
    put(index, vertex, Index(vertices_of_mesh.size()));
    vertices_of_mesh.push_back(vertex);
  }
  std::vector<std::array<Index, 3>> result;
  for(const auto face : faces(mesh))
  {
    const auto first_halfedge = halfedge(face, mesh);
    auto h = first_halfedge;
    std::array<Index, 3> triangle;
    for(Index& v : triangle)
    {
      v = get(index, target(h, mesh)); // starts with the first vertex used to create the face
      h = next(h, mesh);
    }
    if(h != first_halfedge)
      throw Unsupported_surface_error("A face is not a triangle.");
    result.push_back(triangle);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_READ_TRIANGLES_H
