// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/convergence.h"

#include <gtest/gtest.h>

namespace convergence_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(is_cancelled, reports_logarithmic_progress)
{
  double progress = -1.;
  const auto record = [&](double fraction)
  {
    progress = fraction;
    return true;
  };
  EXPECT_FALSE(is_cancelled(record, 1., 1e-4));
  EXPECT_EQ(progress, 0.);
  EXPECT_FALSE(is_cancelled(record, 1e-2, 1e-4));
  EXPECT_NEAR(progress, 0.5, 1e-12); // round-off error of a quotient of logarithms
  EXPECT_FALSE(is_cancelled(record, 1e-6, 1e-4));
  EXPECT_EQ(progress, 1.);
  EXPECT_FALSE(is_cancelled(record, 0.5, 2.));
  EXPECT_EQ(progress, 1.);
}

TEST(is_cancelled, callback_cancels)
{
  EXPECT_TRUE(is_cancelled([](double) { return false; }, 0.1, 1e-3));
  EXPECT_FALSE(is_cancelled({}, 0.1, 1e-3));
}

} // namespace convergence_test
