// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/exits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace exits_test {

using namespace CGAL::Geodesic_processing::internal;

// A few round-off errors of numbers of order one.
constexpr double round_off = 1e-14;

TEST(exits, groups_exits_by_component)
{
  // Vertices 0 to 2 are one component, 3 to 5 another, where the capacity just suffices.
  const std::vector<Index> component = {0, 0, 0, 1, 1, 1};
  Vector masses(6);
  masses << -0.25, 0., 0., -0.25, -0.5, 0.;
  const double moved_mass = 4.;
  const std::vector<Exit> exits = {{5, 2., 0.}, {1, 2., 3.}, {3, 1., 0.5}};
  const Exit_groups groups = group_exits(exits, component, masses, moved_mass);
  ASSERT_EQ(groups.open.size(), 1u);
  EXPECT_EQ(groups.open[0].component, 0u);
  EXPECT_EQ(groups.open[0].mass, 0.25);
  EXPECT_EQ(groups.open[0].exits[0].capacity, 0.5);
  EXPECT_EQ(groups.open[0].exits[0].price, 12.);
  EXPECT_EQ(groups.order, std::vector<std::size_t>{1});
  ASSERT_EQ(groups.full.size(), 1u);
  EXPECT_EQ(groups.full[0].mass, 0.75);
  EXPECT_EQ(groups.outflow, (std::vector<double>{0.5, 0., 0.25}));
  EXPECT_NEAR(groups.cost, 0.5 * 2. * 0.25 * 0.25, round_off);
}

TEST(exits, dual_cost_is_minimum_cost)
{
  Vector potential(3);
  potential << 0.2, 0.5, 0.1;
  // Two exits with quadratic prices and a free one with a capacity.
  const Exit_group group = {0, 1., {{0, infinity, 1.}, {1, 0.3, 0.5}, {2, 0.25, 0.}}};
  double exact = infinity;
  for(double x = 0.; x <= 1.; x += 1e-3)
    for(double y = 0.; y <= std::min(0.3, 1. - x); y += 1e-3)
      if(const double z = 1. - x - y; z <= 0.25)
        exact = std::min(exact, 0.2 * x + 0.5 * x * x + 0.5 * y + 0.25 * y * y + 0.1 * z);
  const Exit_cost found = dual_exit_cost(group, potential);
  EXPECT_LE(found.cost, exact);
  EXPECT_NEAR(found.cost, exact, 1e-5); // the cost is quadratic around the minimum
  // The free exit is full; the others leave at the marginal cost or are full.
  EXPECT_NEAR(std::min(0.3, (found.marginal_cost - 0.5) / 0.5) + found.marginal_cost - 0.2 + 0.25,
              1., 1e-9);
}

TEST(exits, free_exit_bounds_marginal_cost)
{
  Vector potential(2);
  potential << 0.4, 0.7;
  const Exit_cost found =
      dual_exit_cost({0, 2., {{0, infinity, 0.}, {1, infinity, 0.}}}, potential);
  EXPECT_NEAR(found.cost, 0.8, round_off);
  EXPECT_NEAR(found.marginal_cost, 0.4, round_off);
}

TEST(exits, full_group_pays_most_at_dearest_exit)
{
  Vector potential(2);
  potential << 0.4, 0.7;
  EXPECT_NEAR(full_marginal_cost({0, 2., {{0, 1., 2.}, {1, 1., 0.5}}}, potential), 2.4, round_off);
}

} // namespace exits_test
