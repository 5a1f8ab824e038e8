// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace CGAL::Geodesic_processing::internal;

TEST(orientation, is_exact)
{
  EXPECT_EQ(orientation({0., 0.}, {1., 0.}, {0., 1.}), 1);
  EXPECT_EQ(orientation({0., 0.}, {0., 1.}, {1., 0.}), -1);
  EXPECT_EQ(orientation({0.5, 0.5}, {12., 12.}, {24., 24.}), 0);
  // One unit in the last place beside a line, where the determinant in doubles is 0.
  const double above = std::nextafter(0.5, 1.);
  EXPECT_EQ(orientation({0.5, above}, {12., 12.}, {24., 24.}), 1);
  EXPECT_EQ(orientation({above, 0.5}, {12., 12.}, {24., 24.}), -1);
}

} // namespace
