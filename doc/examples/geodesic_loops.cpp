// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes closed curves on a tube with square cross-section: a basis of loops, a shortest loop
// through a vertex, and the shortening of a given loop.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Both ends of the tube are open. Its circumference is 4 in the middle and 8 at the ends.
  Mesh mesh;
  const int n = 4, m = 8;
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i < n; ++i)
    {
      const double size = 1. + 0.25 * std::abs(j - m / 2), x = size * (i == 0 || i == 3 ? 0. : 1.),
                   y = size * (i < 2 ? 0. : 1.);
      mesh.add_vertex(Point(x - 0.5 * size, y - 0.5 * size, j));
    }
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i)
    {
      const Vertex a(n * j + i), b(n * j + (i + 1) % n), c(n * j + n + i),
          d(n * j + n + (i + 1) % n);
      mesh.add_face(a, b, c);
      mesh.add_face(b, d, c);
    }

  // One loop is a basis. It is shortened to the middle of the tube.
  std::vector<GP::Geodesic_loop<Mesh>> basis;
  GP::loop_basis(mesh, std::back_inserter(basis));
  std::cout << basis.size() << " loop of length " << basis.front().length << '\n';

  // A shortest loop through a vertex at the end has a corner there.
  const GP::Geodesic_loop<Mesh> loop = GP::shortest_noncontractible_loop(mesh, Vertex(0));
  std::cout << "through a vertex at the end: " << loop.length << '\n';

  // It can be shortened. A loop that surrounds no tube is shrunk to a point.
  const GP::Geodesic_loop<Mesh> shortened = GP::shorten_loop(mesh, loop.locations),
                                point = GP::shorten_loop(
                                    mesh, std::vector<Vertex>{Vertex(4), Vertex(5), Vertex(9)});
  std::cout << "shortened: " << shortened.length << ", point: " << point.is_point() << '\n';

  const bool is_correct = basis.size() == 1 && std::abs(basis.front().length - 4.) < 1e-12 &&
                          std::abs(shortened.length - 4.) < 1e-12 && loop.length > 4. &&
                          loop.length < 8. && point.is_point();
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
