// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/slowness.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>

namespace slowness_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;

TEST(Slowness, is_reciprocal_of_speed)
{
  const auto slowness = slowness_of({1., 2., 0.25, 0., 1e-310});
  EXPECT_EQ(slowness[0], 1.);
  EXPECT_EQ(slowness[1], 0.5);
  EXPECT_EQ(slowness[2], 4.);
  EXPECT_EQ(slowness[3], infinity); // an obstacle
  EXPECT_EQ(slowness[4], infinity); // overflows
}

TEST(Slowness, throws_on_invalid_speeds)
{
  for(const double speed : {-1., -1e-300, infinity, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(slowness_of({1., speed}), Invalid_argument_error);
}

TEST(Slowness, of_triangle_is_mean_over_corners)
{
  const test::Array_surface surface(test::square(1));
  std::vector<double> slowness(4);
  for(Index i = 0; i < 4; ++i)
    slowness[surface.vertex(i)] = 1. + i;
  // The point (0, 1) is a corner of triangle 1 only.
  slowness[surface.vertex(2)] = infinity;
  const auto mean = mean_over_corners(*surface.triangles(), slowness);
  EXPECT_NEAR(mean[surface.triangle(0)], (1. + 2. + 4.) / 3., 1e-15); // a few round-off errors
  EXPECT_EQ(mean[surface.triangle(1)], infinity);
}

} // namespace slowness_test
