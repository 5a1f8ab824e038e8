// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes distances with a relative tolerance on a torus. Certified bounds show which of the
// vertices are within a radius; only for the others exact distances are needed.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // A closed surface: opposite sides of a grid of 200 x 100 squares are joined.
  const int columns = 200, rows = 100;
  const double pi = std::acos(-1.);
  Mesh mesh;
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
    {
      const double u = 2. * pi * i / columns, v = 2. * pi * j / rows;
      const double from_axis = 2. + std::cos(v);
      mesh.add_vertex(Point(from_axis * std::cos(u), from_axis * std::sin(u), std::sin(v)));
    }
  const auto vertex = [&](int i, int j) { return Vertex((i % columns) + columns * (j % rows)); };
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
    {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }

  const Vertex source(0);
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  solver.compute(source, GP::parameters::relative_tolerance(1e-3));

  const double radius = 2.5;
  std::size_t inside = 0;
  std::vector<Vertex> undecided;
  for(const Vertex v : mesh.vertices())
    if(solver.upper(v) <= radius)
      ++inside;
    else if(solver.lower(v) <= radius)
      undecided.push_back(v);
  std::cout << inside << " vertices are within the radius, " << undecided.size()
            << " are undecided\n";

  // Exact distances: only as far as needed.
  solver.compute(source, GP::parameters::targets(undecided));
  for(const Vertex v : undecided)
    if(solver.distance(v) <= radius)
      ++inside;
  std::cout << inside << " vertices are within the radius\n";

  // The same number by exact distances alone.
  solver.compute(source, GP::parameters::maximum_distance(radius));
  return solver.reached().size() == inside ? EXIT_SUCCESS : EXIT_FAILURE;
}
