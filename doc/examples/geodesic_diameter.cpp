// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds the diameter and the radius of a mesh.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_grid(
      30, 40, mesh, [](int i, int j) { return Point(i, j, 0.); }, true);

  const auto diameter = GP::geodesic_diameter(mesh, GP::parameters::relative_tolerance(0.001));
  std::cout << "The diameter is between " << diameter.lower << " and " << diameter.upper
            << ", by distances from " << diameter.number_of_iterations << " vertices.\n";
  const auto radius = GP::geodesic_radius(mesh);
  std::cout << "The radius is between " << radius.lower << " and " << radius.upper << ".\n";
  const auto eccentricity = GP::geodesic_eccentricity(mesh, radius.center);
  std::cout << "No vertex is farther from " << radius.center << " than " << eccentricity.value
            << ".\n";
  // The diagonal of the rectangle is 50, and its center is a vertex.
  const bool is_correct = diameter.lower <= 50. + 1e-9 && diameter.upper >= 50. - 1e-9 &&
                          radius.lower <= 25. + 1e-9 && radius.upper >= 25. - 1e-9 &&
                          std::abs(eccentricity.value - radius.upper) < 1e-9;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
