// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts the vertices that the topology of a surface requires and measures the triangle quality.
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

double mean_of_smallest_angles(const Mesh& mesh)
{
  double sum = 0.;
  for(const auto f : mesh.faces())
  {
    double smallest = 180.;
    for(const auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      smallest = std::min(smallest, CGAL::approximate_angle(mesh.point(mesh.source(h)),
                                                            mesh.point(mesh.target(h)),
                                                            mesh.point(mesh.target(mesh.next(h)))));
    sum += smallest;
  }
  return sum / double(mesh.number_of_faces());
}

int main(int argc, char* argv[])
{
  Mesh mesh, coarse, even;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
  {
    std::cerr << "usage: remeshing MESH RESULT.ply\n";
    return EXIT_FAILURE;
  }

  GP::geodesic_delaunay_remeshing(mesh, 0, coarse);
  std::cout << "The topology of the input with " << mesh.number_of_vertices()
            << " vertices requires " << coarse.number_of_vertices() << " vertices.\n";

  for(const std::size_t steps : {0, 10})
  {
    even.clear();
    GP::geodesic_delaunay_remeshing(mesh, 2000, even,
                                    GP::parameters::number_of_relaxation_steps(steps));
    std::cout << even.number_of_vertices() << " vertices after " << steps
              << " relaxation steps: the mean of the minimum angles of faces is "
              << mean_of_smallest_angles(even) << " degrees.\n";
  }
  return CGAL::IO::write_polygon_mesh(argv[2], even) ? EXIT_SUCCESS : EXIT_FAILURE;
}
