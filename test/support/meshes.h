// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESHES_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESHES_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include "triangulations.h"

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Conversions of triangulations to meshes of any type.

namespace CGAL::Geodesic_processing::test {

using internal::infinity;

// A mesh with its vertices and faces in the order of the triangulation.
template <typename Mesh>
struct Numbered
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;

  Mesh mesh;
  std::vector<Vertex> vertices;
  std::vector<Face> faces;
};

// Fills `result.mesh`, because a mesh with pointers must not be copied.
template <typename Mesh>
void fill(Numbered<Mesh>& result, const Triangulation& surface)
{
  auto map = get(vertex_point, result.mesh);
  using Point_3 = typename boost::property_traits<decltype(map)>::value_type;
  for(const Point& p : surface.points)
  {
    result.vertices.push_back(add_vertex(result.mesh));
    put(map, result.vertices.back(), Point_3(p[0], p[1], p[2]));
  }
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
  {
    const std::array<typename Numbered<Mesh>::Vertex, 3> corners = {
        result.vertices[surface.corners[c]], result.vertices[surface.corners[c + 1]],
        result.vertices[surface.corners[c + 2]]};
    result.faces.push_back(CGAL::Euler::add_face(corners, result.mesh));
  }
}

// Returns a location in a face from its barycentric coordinates with respect to the corners of the
// triangulation. The coordinates of the location are in the order of
// Polygon_mesh_processing::Face_location: the source of halfedge(face) is the first.
template <typename Mesh>
auto location_in(const Numbered<Mesh>& mesh, const Triangulation& surface, std::size_t face,
                 const std::array<double, 3>& barycentric)
{
  std::pair<typename Numbered<Mesh>::Face, std::array<double, 3>> result;
  result.first = mesh.faces[face];
  auto h = halfedge(result.first, mesh.mesh);
  for(int k = 0; k < 3; ++k, h = next(h, mesh.mesh))
    for(int i = 0; i < 3; ++i)
      if(mesh.vertices[surface.corners[3 * face + i]] == source(h, mesh.mesh))
        result.second[k] = barycentric[i];
  return result;
}

template <typename Point_3>
Point to_array(const Point_3& p)
{
  return {CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2])};
}

// Returns the position of a location of a mesh.
template <typename Mesh, typename Location>
Point point_of(const Mesh& mesh, const Location& location)
{
  Point result = {0., 0., 0.};
  auto h = halfedge(location.first, mesh);
  for(int k = 0; k < 3; ++k, h = next(h, mesh))
  {
    const Point corner = to_array(get(vertex_point, mesh, source(h, mesh)));
    for(int i = 0; i < 3; ++i)
      result[i] += location.second[k] * corner[i];
  }
  return result;
}

// Returns the path of a shared model, or an empty string if it does not exist.
inline std::string model(const std::string& name)
{
#ifdef GEODESIC_PROCESSING_DATA
  const std::string path = std::string(GEODESIC_PROCESSING_DATA) + "/" + name;
  if(std::ifstream(path))
    return path;
#endif
  return {};
}

// Reads a shared model. Returns false if it does not exist.
template <typename Mesh>
bool read_model(const std::string& name, Mesh& mesh)
{
  const std::string file = model(name);
  if(file.empty())
    return false;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("Not readable: " + name);
  return true;
}

inline bool read_model(const std::string& name, Triangulation& surface)
{
  surface = read_off(model(name));
  return !surface.points.empty();
}

// Appends the shared models that exist.
template <typename Surface>
void add_models(std::vector<std::pair<std::string, Surface>>& surfaces,
                const std::vector<std::string>& names)
{
  for(const std::string& name : names)
    if(Surface surface; read_model(name, surface))
      surfaces.emplace_back(name, std::move(surface));
}

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESHES_H
