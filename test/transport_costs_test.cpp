// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/transport_costs.h>

#include <gtest/gtest.h>

#include <limits>

namespace transport_costs_test {

namespace GP = CGAL::Geodesic_processing;

TEST(transport_costs, continuous_bound_is_infinite_by_default)
{
  const GP::Earth_movers_cost cost;
  EXPECT_EQ(cost.upper_continuous, std::numeric_limits<double>::infinity());
  EXPECT_EQ(cost.value, 0.);
  EXPECT_FALSE(cost.is_converged);
  EXPECT_TRUE(GP::Transport_barycenter_cost().distances.empty());
}

} // namespace transport_costs_test
