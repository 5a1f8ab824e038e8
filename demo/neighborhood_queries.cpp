// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the mean number of vertices within a radius and the time of such a query.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
  {
    std::cerr << "usage: neighborhood_queries MESH\n";
    return EXIT_FAILURE;
  }

  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double radius = 0.03 * (std::max)(box.x_span(), (std::max)(box.y_span(), box.z_span()));

  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  CGAL::Real_timer timer;
  timer.start();
  std::size_t number_of_neighbors = 0;
  for(Vertex v : mesh.vertices())
  {
    solver.compute(v, GP::parameters::maximum_distance(radius));
    number_of_neighbors += solver.reached().size();
  }
  timer.stop();

  const double n = double(mesh.number_of_vertices());
  std::cout << "A radius of " << radius << " around a vertex contains " << number_of_neighbors / n
            << " vertices on average; a query takes " << 1e6 * timer.time() / n
            << " microseconds.\n";
  return EXIT_SUCCESS;
}
