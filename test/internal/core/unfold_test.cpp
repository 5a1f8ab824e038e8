// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unfold.h"

#include <gtest/gtest.h>

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
