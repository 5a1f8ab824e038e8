// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_map/mean_iteration.h"

#include <gtest/gtest.h>

#include <limits>

namespace mean_iteration_test {

using namespace CGAL::Geodesic_processing::internal;

constexpr double round_off = 1e-15;

TEST(mean_iteration, unit_weights_have_sum_one)
{
  for(const double scale : {1e-300, 1., 1e306})
  {
    const Unit_weights result = unit_weights({1. * scale, 0., 3. * scale});
    ASSERT_EQ(result.values.size(), 3u);
    EXPECT_NEAR(result.values[0], 0.25, round_off);
    EXPECT_EQ(result.values[1], 0.);
    EXPECT_NEAR(result.values[2], 0.75, round_off);
    EXPECT_NEAR(result.sum / scale, 4., 4. * round_off);
  }
}

TEST(mean_iteration, unit_weights_do_not_overflow)
{
  const double largest = std::numeric_limits<double>::max();
  const Unit_weights result = unit_weights({largest, largest});
  EXPECT_EQ(result.values[0], 0.5);
  EXPECT_EQ(result.values[1], 0.5);
}

TEST(mean_iteration, completed_fraction_is_at_most_one)
{
  EXPECT_EQ(completed_fraction(0, 0), 0.);
  EXPECT_EQ(completed_fraction(25, 100), 0.25);
  EXPECT_EQ(completed_fraction(7, 5), 1.);
}

} // namespace mean_iteration_test
