// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>

#include <gtest/gtest.h>

#include <cmath>

namespace singular_values_test {

using namespace CGAL::Geodesic_processing::internal;

std::array<double, 3> edge_lengths(const std::array<Vec2, 3>& p)
{
  return {norm(p[1] - p[0]), norm(p[2] - p[1]), norm(p[0] - p[2])};
}

TEST(singular_values, recover_known_stretch)
{
  const std::array<Vec2, 3> image = {Vec2{0.3, 0.1}, Vec2{1.4, 0.2}, Vec2{0.5, 0.9}};
  for(const double angle : {0., 1., 4.})
    for(const double sign : {1., -1.})
    {
      // The map stretches by 3 along one axis and by 0.5 along the other, after a rotation.
      std::array<Vec2, 3> triangle, reflected_image;
      for(int k = 0; k < 3; ++k)
      {
        reflected_image[k] = {image[k][0], sign * image[k][1]};
        triangle[k] = rotated(image[k], {std::cos(angle), std::sin(angle)});
        triangle[k] = {3. * triangle[k][0], 0.5 * triangle[k][1]};
      }
      const Singular_values found = singular_values(edge_lengths(triangle), reflected_image);
      EXPECT_NEAR(found.sigma_1, 3., 1e-13);  // round-off errors of a few operations
      EXPECT_NEAR(found.sigma_2, 0.5, 1e-14); // round-off errors, measured 9e-16
      EXPECT_EQ(found.is_inverted, sign < 0.);
      // Round-off errors, measured 9e-16.
      EXPECT_NEAR(found.area, 1.5 * 0.5 * cross(image[1] - image[0], image[2] - image[0]), 1e-14);
    }
}

TEST(singular_values, do_not_depend_on_units)
{
  const std::array<Vec2, 3> image = {Vec2{0.3, 0.1}, Vec2{1.4, 0.2}, Vec2{0.5, 0.9}};
  const std::array<double, 3> lengths = {2., 3., 4.};
  const Singular_values expected = singular_values(lengths, image);
  // The squares of these powers of two are not representable.
  for(const double unit : {0x1p-600, 0x1p600})
    for(const double image_unit : {0x1p-600, 1., 0x1p600})
    {
      const Singular_values found =
          singular_values({unit * lengths[0], unit * lengths[1], unit * lengths[2]},
                          {image_unit * image[0], image_unit * image[1], image_unit * image[2]});
      if(image_unit == 1. || image_unit == unit)
      {
        EXPECT_EQ(found.sigma_1, unit / image_unit * expected.sigma_1);
        EXPECT_EQ(found.sigma_2, unit / image_unit * expected.sigma_2);
      }
      EXPECT_EQ(found.is_inverted, expected.is_inverted);
    }
}

TEST(singular_values, are_infinite_for_degenerate_image)
{
  const Singular_values found =
      singular_values({3., 4., 5.}, {Vec2{0., 0.}, Vec2{1., 1.}, Vec2{2., 2.}});
  EXPECT_EQ(found.sigma_1, infinity);
  EXPECT_EQ(found.sigma_2, infinity);
  EXPECT_EQ(found.area, 6.);
}

} // namespace singular_values_test
