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

// Triangulations as meshes of any kind, and what tests ask of both.

namespace CGAL::Geodesic_processing::test {

using internal::infinity;

// A mesh and its vertices and faces in the order of the triangulation.
template <typename Mesh>
struct Numbered
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Face = typename boost::graph_traits<Mesh>::face_descriptor;

  Mesh mesh;
  std::vector<Vertex> vertices;
  std::vector<Face> faces;
};

// Fills it in place: a mesh with pointers does not survive a copy.
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

// The location in a face, whose corners are those of the triangulation, as
// Polygon_mesh_processing::Face_location counts them: from the source of halfedge(face).
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

// Where a location of a mesh lies.
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

// A file among the shared models, or an empty string where they are not there.
inline std::string model(const std::string& name)
{
#ifdef GEODESIC_PROCESSING_DATA
  const std::string path = std::string(GEODESIC_PROCESSING_DATA) + "/" + name;
  if(std::ifstream(path))
    return path;
#endif
  return {};
}

// Why a test that needs them is skipped.
constexpr const char* no_models =
    "The shared models are not here: set GEODESIC_PROCESSING_DATA to their folder.";

// Reads a mesh among the shared models; false where they are not there.
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

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESHES_H
