// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shortens a drawn polyline on a cloud. It leads around a cylinder the long way, and the geodesic
// does so, too. The shortest path takes the other way.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Cloud = CGAL::Point_set_3<Point, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  Cloud cloud(true);
  for(int i = 0; i < 60; ++i)
    for(int j = 0; j <= 20; ++j)
    {
      const double a = 2. * CGAL_PI * i / 60.;
      cloud.insert(Point(std::cos(a), std::sin(a), 0.1 * j),
                   Kernel::Vector_3(std::cos(a), std::sin(a), 0.));
    }
  const auto domain = GP::make_domain(cloud);

  // A zigzag line from the angle 0 to the angle 4, which is more than half of the circumference.
  std::vector<Point> polyline;
  for(int i = 0; i <= 8; ++i)
    polyline.emplace_back(std::cos(0.5 * i), std::sin(0.5 * i), i % 2 == 0 ? 0.7 : 1.3);
  const auto drawn = GP::shorten_polyline(domain, polyline);
  const auto shortest = GP::geodesic_path(domain, GP::locate_on_surface(domain, polyline.front()),
                                          GP::locate_on_surface(domain, polyline.back()));
  std::cout << "length of the drawn geodesic " << drawn.front_distance << ", of the shortest path "
            << shortest.front_distance << '\n';

  // Both are circular arcs of radius one. The fitted surface has errors of fourth order.
  return std::abs(drawn.front_distance - 4.) < 1e-3 &&
                 std::abs(shortest.front_distance - (2. * CGAL_PI - 4.)) < 1e-3
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
