// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the mean relative error and the running time of five geodesic distance methods.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Exact =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>>;

namespace GP = CGAL::Geodesic_processing;

template <typename Method>
void compare(const char* name, const Mesh& mesh, const std::vector<double>& exact,
             double tolerance = 0.)
{
  const auto np = GP::parameters::relative_tolerance(tolerance);
  GP::Geodesic_distance_solver<Mesh, Method> solver(mesh);
  solver.compute(Vertex(0), np); // warm-up, not measured
  CGAL::Real_timer timer;
  timer.start();
  solver.compute(Vertex(0), np);
  timer.stop();

  double sum = 0.;
  for(Vertex v : mesh.vertices())
    if(exact[v] > 0. && std::isfinite(exact[v]))
      sum += std::abs(solver.distance(v) / exact[v] - 1.);
  std::cout << name << ": mean error " << 100. * sum / mesh.number_of_vertices() << " %, "
            << 1000. * timer.time() << " ms\n";
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], mesh) || is_empty(mesh))
    return std::cerr << "usage: compare_methods MESH\n", EXIT_FAILURE;

  Exact exact(mesh);
  exact.add_source_point(Vertex(0));
  std::vector<double> truth;
  for(Vertex v : mesh.vertices())
    truth.push_back(exact.shortest_distance_to_source_points(v).first);

  compare<GP::Dijkstra>("Dijkstra", mesh, truth);
  compare<GP::Fast_marching>("Fast marching", mesh, truth);
  compare<GP::Heat>("Heat", mesh, truth);
  compare<GP::Euclidean_front>("Euclidean front", mesh, truth);
  compare<GP::Exact>("Exact, relative tolerance 0.001", mesh, truth, 0.001);
  compare<GP::Exact>("Exact", mesh, truth);
  return EXIT_SUCCESS;
}
