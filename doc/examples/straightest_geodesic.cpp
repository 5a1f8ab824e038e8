// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces a straightest geodesic from the point nearest to given coordinates until it leaves the
// mesh, and another one once around a sphere of surfels.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Cloud = CGAL::Point_set_3<Point, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a sheet of size 4 by 3, folded upwards at x = 2.
  Mesh mesh;
  const auto fold = [](int i, int j) { return i < 2 ? Point(i, j, 0) : Point(2, j, i - 2); };
  CGAL::make_grid(4, 3, mesh, fold, true);

  // Locates the point of the mesh that is nearest to a point above it.
  const auto start = GP::locate_on_surface(mesh, Point(0.5, 0.5, 0.1));
  const auto path = GP::straightest_geodesic(mesh, start, Kernel::Vector_3(2, 1, 0), 100.);
  std::cout << "ended at " << path.points.back() << " after " << path.length << '\n';

  // On the unfolded sheet, the path is the segment from (0.5, 0.5) to the boundary x = 4 in the
  // direction (2, 1).
  const double expected = 3.5 * std::sqrt(5.) / 2.;
  bool is_correct = std::abs(path.length - expected) < 1e-9;

  // Creates surfels on a spiral from pole to pole. A great circle returns to its first point.
  const int n = 2000;
  Cloud cloud(true);
  for(int i = 0; i < n; ++i)
  {
    const double z = 1. - 2. * i / (n - 1), r = std::sqrt((std::max)(0., 1. - z * z));
    const double angle = i * CGAL_PI * (3. - std::sqrt(5.));
    const Kernel::Vector_3 normal(r * std::cos(angle), r * std::sin(angle), z);
    cloud.insert(CGAL::ORIGIN + normal, normal);
  }
  const auto circle = GP::straightest_geodesic(cloud, Cloud::Index(n / 2),
                                               Kernel::Vector_3(0., 0., 1.), 2. * CGAL_PI);
  const double gap = std::sqrt(CGAL::squared_distance(circle.points.front(), circle.points.back()));
  std::cout << "after " << circle.length << " it is " << gap << " from its first point\n";

  // The fitted surface contains spheres. What remains is the error of single steps.
  is_correct = is_correct && gap < 1e-6;
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
