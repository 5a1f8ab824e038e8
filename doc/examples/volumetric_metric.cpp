// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes mean value coordinates, the distance and a path of two points inside a torus, and the
// distances from one of them to many points.
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

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a torus with radii 1 and 0.35.
  const int number_along = 48, number_around = 20;
  const double radius = 0.35;
  Mesh torus;
  for(int i = 0; i < number_along; ++i)
    for(int j = 0; j < number_around; ++j)
    {
      const double t = 2. * CGAL_PI * i / number_along, a = 2. * CGAL_PI * j / number_around;
      const double r = 1. + radius * std::cos(a);
      torus.add_vertex(Point(r * std::cos(t), r * std::sin(t), radius * std::sin(a)));
    }
  const auto at = [&](int i, int j)
  {
    return Mesh::Vertex_index(
        Mesh::size_type((i % number_along) * number_around + j % number_around));
  };
  for(int i = 0; i < number_along; ++i)
    for(int j = 0; j < number_around; ++j)
    {
      torus.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      torus.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }

  // The points are inside the torus, on opposite sides of its axis. Triangles are not refined.
  const Point p(1., 0., 0.), q(-1., 0.1, 0.);

  // The sum of the vertices, weighted by mean value coordinates, is the point.
  const auto weight = torus.add_property_map<Mesh::Vertex_index, double>("v:weight").first;
  GP::mean_value_coordinates(torus, q, weight);
  Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
  for(Mesh::Vertex_index v : torus.vertices())
    sum += weight[v] * (torus.point(v) - CGAL::ORIGIN);
  std::cout << "The weighted sum of the vertices is " << CGAL::ORIGIN + sum << ".\n";

  // A single distance.
  const double distance =
      GP::volumetric_distance(torus, p, q, GP::parameters::number_of_refinements(0u)).value;

  const GP::Volumetric_metric<Mesh> metric(torus, GP::parameters::number_of_refinements(0u));
  const GP::Earth_movers_cost cost = metric.cost(p, q);
  std::cout << "They are " << cost.lower << " to " << cost.upper << " from each other.\n";

  // Computes a path inside the torus.
  std::vector<Point> path;
  bool is_correct = metric.write_path(p, q, std::back_inserter(path)) && distance == cost.value &&
                    CGAL::squared_distance(CGAL::ORIGIN + sum, q) < 1e-20;
  double path_length = 0., farthest = 0.;
  for(std::size_t i = 1; i < path.size(); ++i)
  {
    path_length += std::sqrt(CGAL::squared_distance(path[i - 1], path[i]));
    farthest =
        (std::max)(farthest, std::hypot(std::hypot(path[i].x(), path[i].y()) - 1., path[i].z()));
  }
  std::cout << "A way is " << path_length << " long, and nowhere farther than " << farthest
            << " from the middle of the tube.\n";
  is_correct = is_correct && path_length > 2.1 && farthest < radius;

  // Computes the distances to 400 points of the plane z = 0, inside and outside the torus.
  std::vector<Point> slice;
  for(int i = 0; i < 20; ++i)
    for(int j = 0; j < 20; ++j)
      slice.emplace_back(0.15 * i - 1.425, 0.15 * j - 1.425, 0.);
  double largest = 0.;
  for(const GP::Earth_movers_cost& bounds : metric.costs<CGAL::Parallel_tag>(p, slice))
  {
    largest = (std::max)(largest, bounds.value);
    is_correct = is_correct && bounds.is_converged;
  }
  std::cout << "Of " << slice.size() << " points the farthest is at " << largest << ".\n";
  return is_correct && cost.lower >= std::sqrt(CGAL::squared_distance(p, q)) && largest > cost.lower
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
