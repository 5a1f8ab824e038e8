// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unfold.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace unfold_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(Unfold, area_of_needle_keeps_its_digits)
{
  // An isosceles triangle of base 2e-8 and height h = sqrt(1 - 1e-16), which is 1 up to round-off
  // errors.
  EXPECT_NEAR(twice_area(1., 1., 2e-8), 2e-8, 1e-15 * 2e-8);
  EXPECT_EQ(twice_area(3., 4., 5.), 12.);
  EXPECT_EQ(twice_area(1., 1., 3.), 0.);
}

// Returns a triangle with these edge lengths.
Surface_arrays triangle(const std::array<double, 3>& lengths)
{
  Surface_arrays result;
  result.length.assign(lengths.begin(), lengths.end());
  return result;
}

TEST(Unfold, cosine_and_sine_keep_their_digits_in_isosceles_triangles)
{
  for(const double base : {1e-9, 1e-7, 0.1, 1., 1.9, 2. - 1e-13})
  {
    const double height = std::sqrt((1. - 0.5 * base) * (1. + 0.5 * base));
    const Surface_arrays t = triangle({base, 1., 1.});
    for(Index corner = 0; corner < 3; ++corner)
    {
      const Vec2 expected =
          corner < 2 ? Vec2{0.5 * base, height} : Vec2{1. - 0.5 * base * base, base * height};
      const Vec2 result = cosine_and_sine(t, corner);
      EXPECT_NEAR(result[0], expected[0], 1e-15);
      EXPECT_NEAR(result[1], expected[1], 1e-15 * expected[1]);
    }
  }
}

TEST(Unfold, cosine_and_sine_are_those_of_the_interior_angle)
{
  // Also a triangle that violates the triangle inequality, and edges of length zero.
  for(const std::array<double, 3>& lengths :
      {std::array<double, 3>{3., 4., 5.}, {2., 3., 4.}, {1., 1., 3.}, {0., 1., 1.}, {0., 0., 0.}})
    for(Index corner = 0; corner < 3; ++corner)
    {
      const double angle = interior_angle(triangle(lengths), corner);
      const Vec2 result = cosine_and_sine(triangle(lengths), corner);
      EXPECT_NEAR(result[0], std::cos(angle), 1e-15);
      EXPECT_NEAR(result[1], std::sin(angle), 1e-15);
    }
}

TEST(Unfold, third_corner_has_given_distances)
{
  const Vec2 corner = third_corner(5., 3., 4.);
  EXPECT_NEAR(norm(corner), 3., 1e-15 * 4); // units in the last place
  EXPECT_NEAR(norm(corner - Vec2{5., 0.}), 4., 1e-15 * 4);
  EXPECT_GT(corner[1], 0.);
}

TEST(Unfold, quarter_turns_are_exact)
{
  const Vec2 p = {0.1, -0.3};
  EXPECT_EQ(rotated_left(p), (Vec2{0.3, 0.1}));
  EXPECT_EQ(rotated_right(rotated_left(p)), p);
}

TEST(Unfold, straight_front_arrives_with_projected_delay)
{
  // The direction (0.6, 0.8) crosses the base from (0, 0) to (1, 0) with the slope 0.6.
  const Straight_front front(1., 0.6, {0.9, 0.8});
  EXPECT_NEAR(front.delay, 0.6 * 0.9 + 0.8 * 0.8, 1e-15);
  EXPECT_FALSE(front.is_closer_to_end);                              // it crosses at 0.3
  EXPECT_TRUE(Straight_front(1., 0.6, {1.5, 0.8}).is_closer_to_end); // at 0.9
  EXPECT_EQ(Straight_front(1., 0.6, {3., 0.8}).delay, infinity);
}

} // namespace unfold_test
