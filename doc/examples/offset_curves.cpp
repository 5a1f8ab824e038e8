// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the offset curves of a point: the isolines of its geodesic distance. In a plane they are
// circles.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

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
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const Vertex center(10 * 21 + 10);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  GP::geodesic_distances(mesh, center, distance);

  // The circles of radius 4 and 8 are closed. That of radius 12 ends at the boundary, four times.
  std::vector<GP::Isoline<Mesh>> lines;
  GP::isolines(mesh, distance, std::vector<double>{4., 8., 12.}, std::back_inserter(lines),
               GP::parameters::do_fit_circles(true));
  bool is_correct = lines.size() == 6;
  for(const GP::Isoline<Mesh>& line : lines)
  {
    std::cout << (line.is_closed ? "closed" : "open") << " line at distance " << line.value
              << ", length " << line.length << '\n';
    is_correct = is_correct && line.is_closed == (line.value < 10.);
    for(const Point& p : line.points)
      is_correct =
          is_correct && std::abs(std::hypot(p.x() - 10., p.y() - 10.) - line.value) < 1e-12;
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
