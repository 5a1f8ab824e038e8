// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_FACES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_FACES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Adds the points and polygons of a surface to a mesh.  Returns the faces in the order of the
// polygons.  If `vertices` is given, it is set to the vertices in the order of the points.
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

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_ADAPTORS_ADD_FACES_H
