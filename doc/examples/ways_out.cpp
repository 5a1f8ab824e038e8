// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How those in two rooms leave a building by its two doors.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
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
  // A floor of 2 by 1 with a wall in the middle that is open at the upper end.
  const int n = 40;
  Mesh floor;
  CGAL::make_grid(
      2 * n, n, floor, [](int i, int j) { return Point(double(i) / n, double(j) / n, 0.); }, true);
  auto speed = floor.add_property_map<Face, double>("f:speed", 1.).first;
  for(Face f : floor.faces())
  {
    const auto h = floor.halfedge(f);
    const Point center = CGAL::centroid(floor.point(floor.source(h)), floor.point(floor.target(h)),
                                        floor.point(floor.target(floor.next(h))));
    if(center.x() > 1. && center.x() < 1.05 && center.y() < 0.8)
      speed[f] = 0.;
  }
  const auto at = [&](double x, double y)
  {
    return *std::find_if(
        floor.vertices().begin(), floor.vertices().end(),
        [&](Vertex v) { return CGAL::squared_distance(floor.point(v), Point(x, y, 0.)) < 1e-12; });
  };

  // Doors in the lower left corner and at the lower end of the right side.
  const std::vector<Vertex> doors = {at(0., 0.), at(2., 0.)};
  const auto prepared = GP::parameters::speed_map(speed);
  GP::Region_transport_solver<Mesh> solver(floor, doors, prepared);

  // Two people: each takes the nearest door.
  const std::vector<Vertex> people = {at(0.5, 0.), at(1.25, 0.5)};
  const GP::Earth_movers_cost cost = solver.compute(people);
  const double mean = 0.5 * (0.5 + std::hypot(0.75, 0.5));
  std::cout << "They walk " << cost.value << " in the mean, and leave by the doors in parts of "
            << solver.arrival(doors[0]) << " and " << solver.arrival(doors[1]) << ".\n";
  bool right = std::abs(cost.value - mean) < 1e-3 * mean;

  // How far is it from everywhere?
  auto way = floor.add_property_map<Vertex, double>("v:way").first;
  right = right && GP::feature_distance(floor, doors, way, prepared).converged;
  double longest = 0.;
  for(Vertex v : floor.vertices())
    if(std::isfinite(way[v]))
      longest = std::max(longest, way[v]);
  std::cout << "Nobody is farther from a door than " << longest << ".\n";
  // That is in the middle of the upper side: the root of two, less a part of an edge.
  return right && longest > 1.4 && longest < std::sqrt(2.) + 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
