// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time of shortest path queries after precomputation.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: path_queries MESH\n";
    return EXIT_FAILURE;
  }

  GP::Geodesic_path_finder<Mesh> find_path(mesh);
  find_path.add_landmarks(8);
  std::mt19937 random(1);
  std::uniform_int_distribution<std::uint32_t> any(0, mesh.number_of_vertices() - 1);

  std::vector<double> milliseconds;
  double longest = 0.;
  for(int i = 0; i < 101; ++i)
  {
    CGAL::Real_timer timer;
    timer.start();
    const auto path = find_path(Vertex(any(random)), Vertex(any(random)));
    milliseconds.push_back(1000. * timer.time());
    longest = (std::max)(longest, path.length);
  }
  std::nth_element(milliseconds.begin(), milliseconds.begin() + 50, milliseconds.end());
  std::cout << "The median time of 101 paths between random vertices of a mesh with "
            << mesh.number_of_vertices() << " vertices is " << milliseconds[50]
            << " ms; the maximum length is " << longest << ".\n";
  return EXIT_SUCCESS;
}
