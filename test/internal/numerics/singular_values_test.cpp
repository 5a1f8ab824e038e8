// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace CGAL::Geodesic_processing::internal;

std::array<double, 3> lengths_of(const std::array<Planar, 3>& p)
{
  return {norm(p[1] - p[0]), norm(p[2] - p[1]), norm(p[0] - p[2])};
}

TEST(singular_values, are_those_of_a_stretch)
{
  const std::array<Planar, 3> image = {Planar{0.3, 0.1}, Planar{1.4, 0.2}, Planar{0.5, 0.9}};
  for(const double turn : {0., 1., 4.})
    for(const double mirror : {1., -1.})
    {
      // By 3 along one direction and by 0.5 across, between two turns.
      std::array<Planar, 3> triangle, turned_image;
      for(int k = 0; k < 3; ++k)
      {
        turned_image[k] = {image[k][0], mirror * image[k][1]};
        triangle[k] = turned(image[k], {std::cos(turn), std::sin(turn)});
        triangle[k] = {3. * triangle[k][0], 0.5 * triangle[k][1]};
      }
      const Singular_values found = singular_values(lengths_of(triangle), turned_image);
      EXPECT_NEAR(found.most, 3., 1e-13); // a few roundings
      EXPECT_NEAR(found.least, 0.5, 1e-13);
      EXPECT_EQ(found.is_folded, mirror < 0.);
      EXPECT_NEAR(found.area, 1.5 * 0.5 * cross(image[1] - image[0], image[2] - image[0]), 1e-13);
    }
}

TEST(singular_values, are_infinite_without_area)
{
  const Singular_values found =
      singular_values({3., 4., 5.}, {Planar{0., 0.}, Planar{1., 1.}, Planar{2., 2.}});
  EXPECT_EQ(found.most, infinity);
  EXPECT_EQ(found.least, infinity);
  EXPECT_EQ(found.area, 6.);
}

} // namespace
