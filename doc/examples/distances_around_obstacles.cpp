// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes shortest distances around an obstacle, with the default method: a wall across a plate,
// whose faces have speed zero. The distances are exact, also at many locations inside faces.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Location = CGAL::Geodesic_processing::Location<Mesh>;

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;

int main()
{
  // A plate of 20 x 20 units with a wall in the column 9 <= x <= 11, from y = 0 to y = 15.
  Mesh mesh;
  CGAL::make_grid(
      20, 20, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);
  auto speed = mesh.add_property_map<Face, double>("f:speed", 1.).first;
  for(const Face f : mesh.faces())
  {
    const Point center = PMP::construct_point(Location(f, {1. / 3., 1. / 3., 1. / 3.}), mesh);
    if(center.x() > 9. && center.x() < 11. && center.y() < 15.)
      speed[f] = 0.;
  }

  const Vertex source(0); // at (0, 0)
  GP::Geodesic_distance_solver<Mesh> solver(mesh);
  solver.compute(source, GP::parameters::face_speed_map(speed));

  // The shortest path to the opposite corner (20, 0) bends at both upper corners of the wall.
  const Vertex target(20);
  const double expected = 2. * std::hypot(9., 15.) + 2.;
  std::cout << "distance " << solver.distance(target) << ", path of "
            << solver.path(target).locations.size() << " locations\n";
  bool is_correct = std::abs(solver.distance(target) - expected) < 1e-12 * expected;

  // The distances of all face centers behind the wall, in one call.
  std::vector<Location> centers;
  for(const Face f : mesh.faces())
    if(PMP::construct_point(Location(f, {1. / 3., 1. / 3., 1. / 3.}), mesh).x() > 11.)
      centers.emplace_back(f, std::array<double, 3>{1. / 3., 1. / 3., 1. / 3.});
  std::vector<double> distances;
  solver.distances(centers, std::back_inserter(distances));
  const auto farthest = std::max_element(distances.begin(), distances.end());
  std::cout << "the farthest of " << distances.size() << " centers is at "
            << PMP::construct_point(centers[std::size_t(farthest - distances.begin())], mesh)
            << '\n';
  for(std::size_t i = 0; i < centers.size(); ++i)
  {
    // Around the wall: over its left upper corner (9, 15), then along or over the right one.
    const Point p = PMP::construct_point(centers[i], mesh);
    const double around = std::hypot(9., 15.) + 2. + std::hypot(p.x() - 11., p.y() - 15.);
    const double bound = std::hypot(p.x(), p.y());
    is_correct = is_correct && distances[i] <= around + 1e-12 && distances[i] >= bound - 1e-12;
    if(p.y() <= 15.)
      is_correct = is_correct && std::abs(distances[i] - around) < 1e-12 * around;
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
