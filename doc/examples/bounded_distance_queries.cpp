// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Precomputes a solver once and runs several queries with a maximum distance. The cost of such a
// query depends on the number of vertices that it reaches, not on the size of the mesh.
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

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      200, 200, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);

  const double radius = 10.5;
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  bool is_correct = true;
  for(int i : {40, 100, 160})
  {
    const Vertex center(i * 201 + i);
    solver.compute(center, GP::parameters::maximum_distance(radius));

    std::size_t reached = 0;
    for(Vertex v : solver.reached())
    {
      ++reached;
      is_correct = is_correct && solver.distance(v) <= radius;
    }
    std::cout << reached << " vertices within " << radius << " of vertex " << center << '\n';

    // 349 integer lattice points lie in a disk of radius 10.5.
    is_correct = is_correct && reached == 349;
    is_correct = is_correct && std::isinf(solver.distance(Vertex(0)));
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
