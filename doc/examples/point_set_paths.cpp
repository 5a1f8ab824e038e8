// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes many geodesic paths on noisy surfels of a cylinder, with two methods.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates a cylinder of radius 1 and height 3. The noise is a tenth of the spacing.
  const int columns = 90, rows = 43;
  const double spacing = 2. * CGAL_PI / columns;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-0.1 * spacing, 0.1 * spacing);
  Cloud cloud(true);
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
    {
      const double angle = spacing * i;
      const Kernel::Vector_3 normal(std::cos(angle), std::sin(angle), 0.);
      cloud.insert(CGAL::ORIGIN + (1. + noise(random)) * normal +
                       Kernel::Vector_3(0., 0., spacing * j),
                   normal);
    }

  // Pairs of surfels that are at most a third of a turn apart.
  std::vector<std::pair<Cloud::Index, Cloud::Index>> pairs;
  std::vector<double> lengths;
  for(int i = 5; i <= 30; i += 5)
    for(int j = 5; j <= 30; j += 5)
    {
      pairs.emplace_back(Cloud::Index(6 * columns), Cloud::Index((6 + j) * columns + i));
      lengths.push_back(spacing * std::hypot(i, j));
    }
  const auto mean_error = [&](const GP::Surfel_path_finder<Cloud>& finder)
  {
    const auto paths = GP::surfel_geodesic_paths<CGAL::Parallel_tag>(finder, pairs);
    double sum = 0.;
    for(std::size_t i = 0; i < paths.size(); ++i)
      sum += std::abs(paths[i].front_distance / lengths[i] - 1.);
    return sum / double(paths.size());
  };

  // By default, noise is removed first. With the disks of the surfels and the noise kept, the
  // energy balances length and distance from the surfels.
  const double error = mean_error(GP::Surfel_path_finder<Cloud>(cloud));
  const double error_of_disks = mean_error(GP::Surfel_path_finder<Cloud>(
      cloud, GP::parameters::surfel_path_method(GP::Surfel_path_method::disks)
                 .surfel_noise(GP::Surfel_noise::kept)));
  std::cout << pairs.size() << " paths: the mean error of their lengths is " << 100. * error
            << " % by default, and " << 100. * error_of_disks << " % with disks and noise.\n";
  return error < 0.005 && error_of_disks < 0.03 ? EXIT_SUCCESS : EXIT_FAILURE;
}
