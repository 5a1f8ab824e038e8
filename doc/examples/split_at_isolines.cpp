// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts bands around a point out of a mesh. In a plane they are rings between circles.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      40, 40, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  const Vertex center(20 * 41 + 20);
  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  GP::geodesic_distances(mesh, center, distance);

  const std::vector<double> radii = {5., 10., 15.};
  Mesh split;
  auto band = split.add_property_map<Face, std::size_t>("f:band").first;
  GP::split_at_isolines(mesh, distance, radii, split, band, GP::parameters::do_fit_circles(true));

  // Band i is between the radii i - 1 and i. The polygon with segments of length c in a circle of
  // radius r is smaller by a fraction of at most c^2 / (6 r^2), for r = 5 and c = sqrt(2) 1.4 %.
  bool is_correct = CGAL::is_valid_polygon_mesh(split);
  for(std::size_t i = 0; i < radii.size(); ++i)
  {
    const CGAL::Face_filtered_graph<Mesh> ring(split, i, band);
    const double area = CGAL::Polygon_mesh_processing::area(ring);
    const double inner = i == 0 ? 0. : radii[i - 1];
    const double expected = CGAL_PI * (radii[i] * radii[i] - inner * inner);
    std::cout << "area within " << radii[i] << ": " << area << ", between circles: " << expected
              << '\n';
    is_correct = is_correct && std::abs(area / expected - 1.) < 0.02;
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
