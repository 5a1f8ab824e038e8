// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes distances around an obstacle on a noisy point cloud without normals: the cloud is smoothed,
// normals and radii are estimated, and the surfels of a wall get the speed zero.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/jet_smooth_point_set.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Cloud = CGAL::Point_set_3<Point, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // A plate of 1 x 1 with 61 x 61 points. Their noise is a fifth of the spacing. To read a file
  // instead, call CGAL::IO::read_point_set(name, cloud).
  constexpr int n = 61;
  constexpr double spacing = 1. / (n - 1);
  Cloud cloud;
  CGAL::Random random(1);
  const auto noise = [&] { return 0.2 * spacing * random.get_double(-1., 1.); };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      cloud.insert(Point(i * spacing + noise(), j * spacing + noise(), noise()));

  // Fronts pass through the surfels as they are, so noise is removed first.
  CGAL::jet_smooth_point_set<CGAL::Sequential_tag>(cloud, 24);
  GP::estimate_surfels(cloud);

  // A wall in 0.45 <= x <= 0.55, from y = 0 to y = 0.75. Each triangle with a surfel of speed zero
  // is an obstacle, so the wall becomes wider by up to one spacing.
  auto speed = cloud.add_property_map<double>("speed", 1.).first;
  for(Cloud::Index i : cloud)
  {
    const Point& p = cloud.point(i);
    if(std::abs(p.x() - 0.5) <= 0.05 && p.y() <= 0.75)
      speed[i] = 0.;
  }

  // From the surfel near (0.1, 0.1) to the one near (0.9, 0.1).
  const auto at = [](int i, int j) { return Cloud::Index(std::size_t(i * n + j)); };
  auto distance = cloud.add_property_map<double>("distance").first;
  GP::geodesic_distances(cloud, at(6, 6), distance, GP::parameters::speed_map(speed));
  const double found = distance[at(54, 6)];

  // Around the upper corners of the wall, and around those of the widest wall.
  const double shortest = 2. * std::hypot(0.35, 0.65) + 0.1;
  const double longest = 2. * std::hypot(0.35 - spacing, 0.65 + spacing) + 0.1 + 2. * spacing;
  std::cout << "distance " << found << ", between " << shortest << " and " << longest << '\n';

  // The remaining noise changes positions by less than the spacing.
  return found > shortest - spacing && found < longest + spacing ? EXIT_SUCCESS : EXIT_FAILURE;
}
