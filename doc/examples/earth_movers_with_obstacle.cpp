// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes earth mover's distances in a unit square with a wall.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a unit square. The speed is zero inside the wall.
  const int n = 40;
  Mesh yard;
  CGAL::make_grid(
      n, n, yard, [](int i, int j) { return Point(double(i) / n, double(j) / n, 0.); }, true);
  auto speed = yard.add_property_map<Face, double>("f:speed", 1.).first;
  Vertex door, gate;
  for(Vertex v : yard.vertices())
  {
    if(yard.point(v) == Point(0.25, 0., 0.))
      door = v;
    if(yard.point(v) == Point(0.75, 0., 0.))
      gate = v;
  }
  for(Face f : yard.faces())
  {
    const auto h = yard.halfedge(f);
    const Point center = CGAL::centroid(yard.point(yard.source(h)), yard.point(yard.target(h)),
                                        yard.point(yard.target(yard.next(h))));
    if(center.x() > 0.5 && center.x() < 0.55 && center.y() < 0.6)
      speed[f] = 0.;
  }

  // The distance between two unit point masses is the length of the shortest path, here around both
  // upper corners of the wall.
  GP::Earth_movers_solver<Mesh> solver(yard, GP::parameters::face_speed_map(speed));
  const auto point_cost = solver.compute(door, gate, GP::parameters::do_bound_from_above(true));
  const double shortest = std::hypot(0.25, 0.6) + 0.05 + std::hypot(0.2, 0.6);
  std::cout << "From door to gate: between " << point_cost.lower << " and "
            << point_cost.upper_continuous << ", the shortest path takes " << shortest << ".\n";
  bool is_correct = point_cost.lower < shortest && shortest < point_cost.upper_continuous &&
                    std::abs(point_cost.value - shortest) < 1e-3 * shortest;

  // Transports a Gaussian density on the left of the wall to the uniform density on the square.
  auto heap = yard.add_property_map<Vertex, double>("v:heap", 0.).first;
  auto uniform = yard.add_property_map<Vertex, double>("v:even", 1.).first;
  for(Vertex v : yard.vertices())
    heap[v] = std::exp(-50. * CGAL::squared_distance(yard.point(v), Point(0.25, 0.3, 0.)));
  const auto heap_cost = solver.compute(GP::mass_density(heap), GP::mass_density(uniform),
                                        GP::parameters::do_normalize(true));
  std::cout << "The mean way of the heap's sand is " << heap_cost.value << " long, to "
            << 100. * (heap_cost.upper - heap_cost.lower) / heap_cost.upper << " percent, found in "
            << heap_cost.number_of_iterations << " steps.\n";

  // The flow must be zero inside the wall.
  auto flow = yard.add_property_map<Face, Vector>("f:flow").first;
  solver.write_flow(flow);
  for(Face f : yard.faces())
    is_correct = is_correct && (speed[f] > 0. || flow[f] == CGAL::NULL_VECTOR);
  return is_correct && heap_cost.is_converged ? EXIT_SUCCESS : EXIT_FAILURE;
}
