// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes how the people in two rooms leave a building through the nearest of two doors.
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
  // Creates a floor of size 2 by 1 with a wall at x = 1. The wall is open for y >= 0.8.
  const int n = 40;
  Mesh floor_plan;
  CGAL::make_grid(
      2 * n, n, floor_plan, [](int i, int j) { return Point(double(i) / n, double(j) / n, 0.); },
      true);
  auto speed = floor_plan.add_property_map<Face, double>("f:speed", 1.).first;
  for(Face f : floor_plan.faces())
  {
    const auto h = floor_plan.halfedge(f);
    const Point center = CGAL::centroid(floor_plan.point(floor_plan.source(h)),
                                        floor_plan.point(floor_plan.target(h)),
                                        floor_plan.point(floor_plan.target(floor_plan.next(h))));
    if(center.x() > 1. && center.x() < 1.05 && center.y() < 0.8)
      speed[f] = 0.;
  }
  const auto vertex_at = [&](double x, double y)
  {
    return *std::find_if(
        floor_plan.vertices().begin(), floor_plan.vertices().end(),
        [&](Vertex v)
        { return CGAL::squared_distance(floor_plan.point(v), Point(x, y, 0.)) < 1e-12; });
  };

  // The doors are the lower left and the lower right corner.
  const std::vector<Vertex> doors = {vertex_at(0., 0.), vertex_at(2., 0.)};
  const auto speed_parameters = GP::parameters::face_speed_map(speed);
  GP::Region_transport_solver<Mesh> solver(floor_plan, doors, speed_parameters);

  // Two people: each one uses the nearest door.
  const std::vector<Vertex> people = {vertex_at(0.5, 0.), vertex_at(1.25, 0.5)};
  const GP::Earth_movers_cost cost = solver.compute(people);
  const double mean = 0.5 * (0.5 + std::hypot(0.75, 0.5));
  std::cout << "They walk " << cost.value << " in the mean, and leave by the doors in parts of "
            << solver.arrival(doors[0]) << " and " << solver.arrival(doors[1]) << ".\n";
  bool is_correct = std::abs(cost.value - mean) < 1e-3 * mean;

  // Computes the distance of each vertex to the nearest door.
  auto distance_to_door = floor_plan.add_property_map<Vertex, double>("v:way").first;
  is_correct =
      is_correct &&
      GP::feature_distance(floor_plan, doors, distance_to_door, speed_parameters).is_converged;
  double longest = 0.;
  for(Vertex v : floor_plan.vertices())
    if(std::isfinite(distance_to_door[v]))
      longest = std::max(longest, distance_to_door[v]);
  std::cout << "Nobody is farther from a door than " << longest << ".\n";
  // The farthest vertex is (1, 1). Its exact distance sqrt(2) is underestimated by a fraction of
  // an edge length.
  return is_correct && longest > 1.4 && longest < std::sqrt(2.) + 1e-9 ? EXIT_SUCCESS
                                                                       : EXIT_FAILURE;
}
