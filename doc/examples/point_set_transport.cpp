// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Transports masses on surfels of a sphere: from pole to pole, and from two surfels to the closer
// pole.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Cloud = CGAL::Point_set_3<Kernel::Point_3, Kernel::Vector_3>;

namespace GP = CGAL::Geodesic_processing;

int main()
{
  // Creates points on a spiral from pole to pole.
  const int n = 2000;
  Cloud cloud(true);
  for(int i = 0; i < n; ++i)
  {
    const double z = 1. - 2. * i / (n - 1), r = std::sqrt((std::max)(0., 1. - z * z));
    const double angle = i * CGAL_PI * (3. - std::sqrt(5.));
    const Kernel::Vector_3 normal(r * std::cos(angle), r * std::sin(angle), z);
    cloud.insert(CGAL::ORIGIN + normal, normal);
  }
  const Cloud::Index north(0), south(n - 1);

  // The distance between the poles is half of a great circle.
  const auto domain = GP::make_domain(cloud);
  const GP::Earth_movers_cost pole_to_pole = GP::earth_movers_distance(domain, north, south);
  std::cout << "From pole to pole, a unit mass takes the work " << pole_to_pole.value << ".\n";

  // Two surfels share a unit mass. Streamlines lead from them to the south pole.
  const std::vector<Cloud::Index> start = {Cloud::Index(n / 5), Cloud::Index(n / 2)};
  const auto latitude_angle = [&](Cloud::Index i) { return std::acos(cloud.point(i).z()); };
  std::vector<GP::Streamline<Cloud>> lines;
  GP::transport_streamlines(domain, start, south, 20, std::back_inserter(lines));
  double mean_length = 0.;
  for(const auto& line : lines)
    mean_length += line.length / double(lines.size());
  double expected_length = 0.;
  for(Cloud::Index i : start)
    expected_length += 0.5 * (CGAL_PI - latitude_angle(i));
  std::cout << lines.size() << " streamlines to the south pole have a mean length of "
            << mean_length << ", great circles of " << expected_length << ".\n";

  // If both poles are admitted, each half of the mass moves to the closer one.
  const std::vector<Cloud::Index> poles = {north, south};
  const GP::Earth_movers_cost to_poles = GP::transport_to_region(domain, start, poles);
  double expected_cost = 0.;
  for(Cloud::Index i : start)
    expected_cost += 0.5 * (std::min)(latitude_angle(i), CGAL_PI - latitude_angle(i));
  std::cout << "To the closer pole, it takes " << to_poles.value << " instead of " << expected_cost
            << ".\n";

  // At each end of a path, a fraction of the spacing of the surfels is missing.
  const double spacing = 0.08;
  return std::abs(pole_to_pole.value - CGAL_PI) < spacing && lines.size() == 20 &&
                 std::abs(mean_length - expected_length) < spacing &&
                 std::abs(to_poles.value - expected_cost) < spacing
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
}
