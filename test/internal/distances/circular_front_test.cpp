// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/circular_front.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace circular_front_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of a few operations on numbers of size 1; measured are 3e-17.
constexpr double round_off = 1e-15;

// A circle around `center`, which is below the first axis.
Circular_front circle_around(const Vec2& center)
{
  const double radius = norm(center);
  return {(1. / radius) * center, 1. / radius};
}

TEST(Circular_front, gain_is_difference_of_distances)
{
  const Vec2 center = {0.3, -2.}, y = {0.8, 0.9};
  double gain;
  Vec2 back;
  ASSERT_TRUE(cross_edge(circle_around(center), 1., y, gain, back));
  EXPECT_NEAR(gain, norm(y - center) - norm(center), round_off);
  EXPECT_NEAR(norm(back - (1. / norm(center - y)) * (center - y)), 0., round_off);
}

TEST(Circular_front, rejects_lines_that_miss_the_edge)
{
  double gain;
  Vec2 back;
  EXPECT_FALSE(cross_edge(circle_around({0.3, -2.}), 1., {5., 0.9}, gain, back));
  EXPECT_FALSE(cross_edge(circle_around({0.3, -2.}), 1., {-2., 0.9}, gain, back));
}

TEST(Circular_front, is_determined_by_two_distances)
{
  const Vec2 center = {0.3, -2.}, z = {1., 0.};
  const Circular_front exact = circle_around(center);
  const double difference = norm(z - center) - norm(center);
  Circular_front fitted = {{1., 0.}, exact.curvature};
  ASSERT_TRUE(fit_source_direction(1., difference, fitted));
  EXPECT_NEAR(norm(fitted.source - exact.source), 0., round_off);
  EXPECT_FALSE(fit_source_direction(1., 1.5, fitted)); // longer than the edge

  EXPECT_NEAR(circle_residual(exact.curvature, 1., difference, exact.source[0]), 0., round_off);
  // The residual has the sign of an error of the difference.
  EXPECT_GT(circle_residual(exact.curvature, 1., difference + 0.01, exact.source[0]), 0.);
  // An iteration of some steps.
  EXPECT_NEAR(fitted_curvature(0., 1., difference, exact.source[0], norm(center)), exact.curvature,
              10. * round_off);
  EXPECT_EQ(fitted_curvature(2., 1., difference, exact.source[0], norm(center)), 2.);
}

} // namespace circular_front_test
