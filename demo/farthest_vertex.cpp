// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the vertex with the maximum geodesic distance from the first vertex.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: farthest_vertex MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  GP::geodesic_distances(mesh, Vertex(0), distance);

  const auto is_closer = [&](Vertex a, Vertex b) { return distance[a] < distance[b]; };
  const Vertex farthest =
      *std::max_element(mesh.vertices().begin(), mesh.vertices().end(), is_closer);
  const double euclidean_distance =
      std::sqrt(CGAL::squared_distance(mesh.point(Vertex(0)), mesh.point(farthest)));

  std::cout << "Vertex " << farthest.idx() << " has the maximum geodesic distance, "
            << distance[farthest] << "; its Euclidean distance is " << euclidean_distance << ".\n";
  return CGAL::IO::write_polygon_mesh(argv[2], mesh) ? EXIT_SUCCESS : EXIT_FAILURE;
}
