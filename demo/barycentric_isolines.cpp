// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameterizes a mesh over a base mesh and shows isolines of the maximum barycentric coordinate.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 4 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: barycentric_isolines MESH NUMBER RESULT.ply\n";
    return EXIT_FAILURE;
  }

  const GP::Base_parameterization<Mesh> base(mesh, std::stoul(argv[2]));

  // The maximum coordinate is 1 at base vertices and 1/3 at the centers of base faces. The color is
  // a random number of each base vertex, which is interpolated. Isolated vertices have no base
  // location.
  const auto max_coordinate =
      mesh.add_property_map<Mesh::Vertex_index, double>("v:coordinate", 0.).first;
  const auto color = mesh.add_property_map<Mesh::Vertex_index, double>("v:color", 0.).first;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<double> base_color(base.number_of_base_vertices());
  for(double& c : base_color)
    c = uniform(random);
  for(const auto v : mesh.vertices())
    if(!mesh.is_isolated(v))
    {
      const GP::Base_location location = base(v);
      const auto& coordinates = location.barycentric;
      max_coordinate[v] = *std::max_element(coordinates.begin(), coordinates.end());
      for(std::size_t k = 0; k < 3; ++k)
        color[v] += coordinates[k] * base_color[base.base_face(location.face)[k]];
    }

  // Computes the distance to the nearest base vertex.
  std::vector<GP::Base_parameterization<Mesh>::Location> corners;
  for(std::size_t i = 0; i < base.number_of_base_vertices(); ++i)
    corners.push_back(base.base_vertex(i));
  const auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance").first;
  GP::geodesic_distances(mesh, corners, distance);
  std::cout << base.number_of_base_faces() << " base faces, " << base.number_of_repaired_faces()
            << " of them repaired by mean value coordinates; " << base.number_of_flips()
            << " inverted triangles.\n";
  return CGAL::IO::write_polygon_mesh(argv[3], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
