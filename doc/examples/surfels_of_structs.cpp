// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Computes a path on a cloud whose surfels are structs of an application.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;

namespace GP = CGAL::Geodesic_processing;

struct Sample
{
  using R = Kernel; // the points of paths are of this kernel
  float position[3];
  float normal[3];
};

int main()
{
  // Creates samples of a cylinder of radius 1 and height 2.
  std::vector<Sample> samples;
  const int columns = 100, rows = 33;
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
    {
      const double angle = 2. * CGAL_PI * i / columns;
      const float x = float(std::cos(angle)), y = float(std::sin(angle));
      samples.push_back({{x, y, float(j) / 16.f}, {x, y, 0.f}});
    }

  // The keys of both maps are the elements of the range.
  const auto point_map = boost::make_function_property_map<Sample>(
      [](const Sample& s) { return Kernel::Point_3(s.position[0], s.position[1], s.position[2]); });
  const auto normal_map = boost::make_function_property_map<Sample>(
      [](const Sample& s) { return Kernel::Vector_3(s.normal[0], s.normal[1], s.normal[2]); });

  // Sources and targets are positions in the range: the path leads from the first sample to one at
  // a quarter of the circumference and at the upper end.
  const std::size_t from = 0, to = (rows - 1) * columns + columns / 4;
  const auto path = GP::geodesic_path(samples, from, to,
                                      GP::parameters::point_map(point_map).normal_map(normal_map));
  std::cout << path.points.size() << " points, length " << path.front_distance << '\n';

  // The cylinder unfolds to a rectangle. The samples are rounded to single precision, but the
  // surface is also fitted: it deviates from the cylinder by some 0.0001.
  const double expected = std::hypot(CGAL_PI / 2., 2.);
  return std::abs(path.front_distance - expected) < 1e-3 ? EXIT_SUCCESS : EXIT_FAILURE;
}
