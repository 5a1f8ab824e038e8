// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes distances to two sources on a planar mesh, the nearest source of each vertex, and
// distances to the boundary.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
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
      30, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);

  // The second source has an offset of 5, which is added to the distances from it.
  const Vertex corner(0);
  const Vertex middle(10 * 31 + 15);
  const std::vector<GP::Source<Mesh>> sources = {GP::Source<Mesh>(corner, 0., 0),
                                                 GP::Source<Mesh>(middle, 5., 1)};

  auto distance = mesh.add_property_map<Vertex, double>("v:distance").first;
  auto label = mesh.add_property_map<Vertex, std::size_t>("v:label").first;
  GP::geodesic_distances(mesh, sources, distance, GP::parameters::source_label_map(label));

  double largest_error = 0.;
  for(Vertex v : mesh.vertices())
  {
    const Vertex nearest = label[v] == 0 ? corner : middle;
    const double offset = label[v] == 0 ? 0. : 5.;
    const double expected =
        std::sqrt(CGAL::squared_distance(mesh.point(nearest), mesh.point(v))) + offset;
    largest_error = (std::max)(largest_error, std::abs(distance[v] - expected));
  }

  // The boundary of the rectangle is a single source.
  std::vector<GP::Source<Mesh>> boundary;
  GP::border_sources(mesh, std::back_inserter(boundary));
  GP::geodesic_distances(mesh, boundary, distance);
  for(Vertex v : mesh.vertices())
  {
    const Point& p = mesh.point(v);
    const double expected = (std::min)({p.x(), 30. - p.x(), p.y(), 20. - p.y()});
    largest_error = (std::max)(largest_error, std::abs(distance[v] - expected));
  }
  std::cout << boundary.size() << " boundary cycle, largest error " << largest_error << '\n';

  // On a planar convex mesh, the default method is exact up to round-off errors, here about 1e-14.
  return largest_error < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
