// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes geodesic distances on a point cloud sampled from a sphere.
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
  // Creates points on a spiral from pole to pole, with Voronoi cells of nearly equal area.
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

  // The relative difference of an arc and its chord is angle^2 / 24, with an angle of 0.05 here.
  // The triangles of a cloud are irregular, therefore the tolerance is 100 times larger.
  return mean_error < 100. * CGAL_PI * 0.05 * 0.05 / 24. ? EXIT_SUCCESS : EXIT_FAILURE;
}
