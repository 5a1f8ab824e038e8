// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes geodesic paths on surfels of a sphere, without noise and with noise.
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
  bool is_correct = true;
  for(const double noise : {0., 0.01})
  {
    // Creates points on a spiral from pole to pole, with a spacing of about 0.05.
    const int n = 5000;
    Cloud cloud(true);
    for(int i = 0; i < n; ++i)
    {
      const double z = 1. - 2. * i / (n - 1);
      const double r = std::sqrt((std::max)(0., 1. - z * z));
      const double angle = i * CGAL_PI * (3. - std::sqrt(5.));
      const Kernel::Vector_3 normal(r * std::cos(angle), r * std::sin(angle), z);
      const double height = 1. + noise * std::sin(1000. * i * i); // pseudo-random noise
      cloud.insert(CGAL::ORIGIN + height * normal, normal);
    }
    const auto path = GP::surfel_geodesic_path(cloud, Cloud::Index(0), Cloud::Index(n - 1));
    std::cout << path.points.size() << " points, as far as " << path.front_distance
              << " from pole to pole\n";
    // The exact path is half a great circle. The noise amplitude is a fifth of the point spacing.
    is_correct = is_correct && std::abs(path.front_distance - CGAL_PI) < (noise > 0. ? 0.01 : 1e-6);
  }
  return is_correct ? EXIT_SUCCESS : EXIT_FAILURE;
}
