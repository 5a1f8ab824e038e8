// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes the barycenter of three vertices as a single vertex, as a mass distribution, and as a
// location.
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

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a unit square.
  const int n = 30;
  Mesh field;
  CGAL::make_grid(
      n, n, field, [](int i, int j) { return Point(double(i) / n, double(j) / n, 0.); }, true);
  const auto vertex_at = [&](double x, double y)
  {
    return *std::find_if(
        field.vertices().begin(), field.vertices().end(),
        [&](Vertex v) { return CGAL::squared_distance(field.point(v), Point(x, y, 0.)) < 1e-12; });
  };
  const std::vector<Vertex> houses = {vertex_at(0., 0.), vertex_at(1., 0.), vertex_at(0.5, 0.9)};

  // The vertex with the minimum sum of squared distances is the centroid, because the square is
  // convex.
  const auto well = GP::geodesic_barycenter(field, houses);
  std::cout << "The well is at " << field.point(well.vertex) << ", squared distances sum to "
            << well.value << ".\n";
  bool is_correct = CGAL::squared_distance(field.point(well.vertex), Point(0.5, 0.3, 0.)) < 1e-12;

  // In the plane, no mass distribution has a lower cost than the centroid.
  auto water = field.add_property_map<Vertex, double>("v:water").first;
  const GP::Transport_barycenter_cost cost = GP::transport_barycenter(field, houses, water);
  std::cout << "Water in many places costs " << cost.lower << " to " << cost.upper << ".\n";
  is_correct = is_correct && cost.is_converged && cost.lower < well.value + 1e-9 &&
               cost.upper > well.value - 1e-9;

  // The weight of the third house equals the sum of the two others.
  const std::vector<double> people = {1., 1., 2.};
  const auto weighted = GP::geodesic_barycenter(field, houses, GP::parameters::weights(people));
  std::cout << "For all people alike it is at " << field.point(weighted.vertex) << ".\n";
  const double middle = field.point(weighted.vertex).y(); // exact: 0.45, between two rows
  is_correct = is_correct && std::abs(middle - 0.45) < 0.51 / n;

  // The Karcher mean is not restricted to vertices.
  const auto mean = GP::karcher_mean(field, houses, GP::parameters::weights(people));
  std::cout << "Between the vertices it is at " << mean.point << ".\n";
  is_correct = is_correct && mean.is_converged && mean.value <= weighted.value &&
               CGAL::squared_distance(mean.point, Point(0.5, 0.45, 0.)) < 1e-12;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
