// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimates normals of points on a sphere, walks from one of them by the exponential map, and maps
// the others to its tangent plane by the logarithmic map.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Cloud = CGAL::Point_set_3<Point, Vector>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates points on a spiral from pole to pole, and a point far outside.
  const int n = 4000;
  Cloud cloud;
  for(int i = 0; i < n; ++i)
  {
    const double z = 1. - 2. * i / (n - 1), r = std::sqrt((std::max)(0., 1. - z * z));
    const double angle = i * CGAL_PI * (3. - std::sqrt(5.));
    cloud.insert(Point(r * std::cos(angle), r * std::sin(angle), z));
  }
  cloud.insert(Point(3., 0., 0.));

  // Removes the outlier, and computes normals and radii.
  const std::size_t number_of_outliers =
      GP::estimate_surfels(cloud, GP::parameters::outlier_percentage(0.02));
  double largest_angle = 0.;
  for(Cloud::Index i : cloud)
    largest_angle =
        (std::max)(largest_angle,
                   std::acos((std::min)(1., cloud.normal(i) * (cloud.point(i) - CGAL::ORIGIN))));
  std::cout << number_of_outliers << " point is removed. Normals are wrong by at most "
            << largest_angle << " radians.\n";

  // A quarter of a great circle in the direction of the x-axis leads from the north pole to (1, 0,
  // 0), approximately.
  const auto domain = GP::make_domain(cloud);
  const auto axis = GP::parameters::up_direction(Vector(1., 0., 0.));
  const Cloud::Index pole = *cloud.begin();
  const GP::Location<Cloud> end =
      GP::exponential_map(domain, pole, std::array<double, 2>{0., 0.5 * CGAL_PI}, axis);
  const double walk_error = std::sqrt(CGAL::squared_distance(domain.point(end), Point(1., 0., 0.)));

  // The norm of normal coordinates is the distance from the pole.
  auto uv = cloud.add_property_map<std::array<double, 2>>("uv").first;
  GP::logarithmic_map(domain, pole, uv, axis.maximum_distance(1.5));
  double map_error = 0.;
  for(Cloud::Index i : cloud)
    if(const double norm = std::hypot(uv[i][0], uv[i][1]); norm > 0.)
      map_error = (std::max)(map_error, std::abs(norm - std::acos(cloud.point(i).z())));
  std::cout << "The walk ends " << walk_error
            << " from the equator; distances on the map are wrong "
            << "by at most " << map_error << ".\n";

  // The spacing of the points is 0.06.
  return number_of_outliers == 1 && largest_angle < 0.06 && walk_error < 0.06 && map_error < 0.06
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
