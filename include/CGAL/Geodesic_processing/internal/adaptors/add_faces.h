// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_FACES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_FACES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Adds the points and polygons of a surface to a mesh. Returns the faces in the order of the
// polygons. If `vertices` is given, it is set to the vertices in the order of the points.
template <typename Polygon, typename OutputMesh>
auto add_faces(
    const std::vector<std::array<double, 3>>& points, const std::vector<Polygon>& polygons,
    OutputMesh& output,
    std::vector<typename boost::graph_traits<OutputMesh>::vertex_descriptor>* vertices = nullptr)
{
  using Graph = boost::graph_traits<OutputMesh>;
  using Vertex = typename Graph::vertex_descriptor;
  const auto point_map = get(CGAL::vertex_point, output);
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  std::vector<Vertex> added;
  for(const auto& p : points)
  {
    added.push_back(add_vertex(output));
    put(point_map, added.back(), Point(p[0], p[1], p[2]));
  }
  std::vector<std::vector<Vertex>> corners;
  for(const Polygon& polygon : polygons)
  {
    corners.emplace_back();
    for(const auto corner : polygon)
      corners.back().push_back(added[corner]);
  }
  CGAL::Euler::add_faces(corners, output);
  std::vector<typename Graph::face_descriptor> faces;
  for(const auto& polygon : corners)
    faces.push_back(face(halfedge(polygon[0], polygon[1], output).first, output));
  if(vertices)
    *vertices = std::move(added);
  return faces;
}

// The triangles of a surface and their corners, without isolated vertices.
struct Used_triangles
{
  std::vector<Index> vertices;                 // the vertices of the surface that have triangles
  std::vector<std::array<double, 3>> points;   // their coordinates, in the unit of the caller
  std::vector<std::array<Index, 3>> triangles; // #triangles: indices of `vertices`
};

inline Used_triangles used_triangles(const Surface_arrays& surface)
{
  Used_triangles result;
  result.triangles.resize(surface.number_of_triangles());
  std::vector<Index> position(surface.number_of_vertices(), none);
  for(std::size_t i = 0; i < surface.corner.size(); ++i)
  {
    const Index vertex = surface.corner[i];
    if(position[vertex] == none)
    {
      position[vertex] = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(vertex);
      result.points.push_back(coordinates(surface, {none, vertex, {}}));
    }
    result.triangles[i / 3][i % 3] = position[vertex];
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_FACES_H
