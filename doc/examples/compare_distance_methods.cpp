// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds a domain once and passes it to three methods, each selected by a template argument.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

// Returns the relative error at the corner opposite the source. The path to it crosses the
// diagonals of the grid.
template <typename Method, typename Domain>
double relative_error(const char* name, const Domain& domain, Mesh& mesh, double truth)
{
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  GP::geodesic_distances<Method>(domain, Vertex(0), distance);
  const double error = std::abs(distance[Vertex(51 * 51 - 1)] / truth - 1.);
  std::cout << name << ": " << 100. * error << " % off\n";
  return error;
}

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      50, 50, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);

  const auto domain = GP::make_domain(mesh);
  const double truth = 50. * std::sqrt(2.);
  const double dijkstra = relative_error<GP::Dijkstra>("Dijkstra", domain, mesh, truth);
  const double marching = relative_error<GP::Fast_marching>("Fast_marching", domain, mesh, truth);
  const double front = relative_error<GP::Euclidean_front>("Euclidean_front", domain, mesh, truth);

  return front < 1e-9 && marching < 0.1 * dijkstra ? EXIT_SUCCESS : EXIT_FAILURE;
}
