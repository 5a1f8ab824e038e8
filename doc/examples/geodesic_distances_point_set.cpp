// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances on surfels that were scattered on a sphere.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // A spiral from pole to pole whose points have about equal areas around them.
  const int n = 5000;
  Cloud cloud(true);
  for(int i = 0; i < n; ++i)
  {
    const double z = 1. - 2. * i / (n - 1);
    const double r = std::sqrt((std::max)(0., 1. - z * z));
    const double angle = i * CGAL_PI * (3. - std::sqrt(5.));
    const Kernel::Vector_3 normal(r * std::cos(angle), r * std::sin(angle), z);
    cloud.insert(CGAL::ORIGIN + normal, normal);
  }

  auto distance = cloud.add_property_map<double>("distance").first;
  GP::geodesic_distances(cloud, *cloud.begin(), distance);

  double mean_error = 0.;
  for(Cloud::Index i : cloud)
    mean_error += std::abs(distance[i] - std::acos(CGAL::to_double(cloud.point(i).z()))) / n;
  std::cout << "mean error " << mean_error << '\n';

  // A chord is shorter than its arc by a 24th of the squared angle, 0.05 radians here; triangles of
  // a cloud are irregular, for which a hundred times that is allowed.
  return mean_error < 100. * CGAL_PI * 0.05 * 0.05 / 24. ? EXIT_SUCCESS : EXIT_FAILURE;
}
