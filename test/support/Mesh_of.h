// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESH_OF_H
#define CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESH_OF_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "meshes.h"

#include <vector>

// The mesh type of most tests of the public functions, and surfel clouds.

namespace CGAL::Geodesic_processing::test {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

// Converts a triangulation to a mesh; vertex i is point i of the triangulation.
inline Mesh mesh_of(const Triangulation& surface)
{
  Numbered<Mesh> result;
  fill(result, surface);
  return result.mesh;
}

// Adds a vertex property map.
template <typename T = double>
auto vertex_map(Mesh& mesh)
{
  return mesh.add_property_map<Vertex, T>().first;
}

template <typename Map>
std::vector<double> values(const Mesh& mesh, const Map& map)
{
  std::vector<double> result;
  for(const Vertex v : mesh.vertices())
    result.push_back(double(get(map, v)));
  return result;
}

// Returns a location in a face from barycentric coordinates; the source of halfedge(face) is the
// first corner.
inline std::pair<Face, std::array<double, 3>> location_of(std::size_t face,
                                                          const std::array<double, 3>& barycentric)
{
  return {Face(Mesh::size_type(face)), barycentric};
}

inline std::pair<Face, std::array<double, 3>> random_location_of(const Mesh& mesh,
                                                                 std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0., 1.);
  double a = unit(random), b = unit(random);
  if(a + b > 1.)
  {
    a = 1. - a;
    b = 1. - b;
  }
  return location_of(random() % num_faces(mesh), {1. - a - b, a, b});
}

using Surfels = std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>>;

// Random surfels of the unit square.
inline Surfels flat_surfels(std::size_t n, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0., 1.);
  Surfels result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double u = unit(random), v = unit(random);
    result.emplace_back(Kernel::Point_3(u, v, 0.), Kernel::Vector_3(0., 0., 1.));
  }
  return result;
}

// Surfels at the vertices of a subdivided icosahedron.
inline Surfels sphere_surfels(unsigned level)
{
  Surfels result;
  for(const Point& p : icosphere(level).points)
    result.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(p[0], p[1], p[2]));
  return result;
}

using Surfel_point_map = CGAL::First_of_pair_property_map<Surfels::value_type>;
using Surfel_normal_map = CGAL::Second_of_pair_property_map<Surfels::value_type>;

} // namespace CGAL::Geodesic_processing::test

#endif // CGAL_GEODESIC_PROCESSING_TEST_SUPPORT_MESH_OF_H
