// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes a Bezier curve and a closed B-spline with the same control points on an icosahedron.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Mesh mesh;
  CGAL::make_icosahedron(mesh, Point(0., 0., 0.), 1.);
  const GP::Surface_locator<Mesh> locate(mesh);
  std::vector<GP::Location<Mesh>> control_points;
  for(const Point& p : {Point(1., 0., 0.), Point(0., 1., 0.5), Point(-1., 0., 0.)})
    control_points.push_back(locate(p));

  const auto curve = GP::geodesic_bezier_curve(mesh, control_points);
  const auto spline =
      GP::geodesic_spline(mesh, control_points, GP::parameters::degree(2).is_closed(true));
  std::cout << "Bezier curve: length " << curve.length << ", " << curve.points.size()
            << " points\n";
  std::cout << "Closed spline: length " << spline.length << ", " << spline.points.size()
            << " points\n";
  // A Bezier curve ends at the first and at the last control point.
  const auto domain = GP::make_domain(mesh);
  const bool is_correct =
      CGAL::squared_distance(curve.points.front(), domain.point(control_points.front())) < 1e-20 &&
      CGAL::squared_distance(curve.points.back(), domain.point(control_points.back())) < 1e-20 &&
      spline.points.front() == spline.points.back();
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
