// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the area of geodesic balls around a vertex. On a surface of Gauss curvature K, it is
// smaller than that of a disk by pi K r^4 / 12 for small radii r.
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
  const double pi = 3.14159265358979323846;
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const Vertex center(10 * 21 + 10);
  bool is_correct = true;
  for(const double radius : {0.5, 4., 8.})
  {
    const GP::Geodesic_ball<Mesh> ball = GP::geodesic_ball(mesh, center, radius);
    std::cout << "radius " << radius << ": area " << ball.area << ", " << ball.faces.size()
              << " faces inside, length of the circle " << ball.circles.front().length << '\n';
    // The grid is flat.
    is_correct = is_correct && std::abs(ball.area - pi * radius * radius) < 1e-9;
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
