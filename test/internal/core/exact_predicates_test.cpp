// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exact_predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace exact_predicates_test {

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

TEST(is_degenerate, is_exact)
{
  EXPECT_TRUE(is_degenerate({Vec3{0.5, 0.5, 0.5}, {12., 12., 12.}, {24., 24., 24.}}));
  EXPECT_TRUE(is_degenerate({Vec3{1., 2., 3.}, {1., 2., 3.}, {4., 5., 7.}}));
  const double above = std::nextafter(0.5, 1.);
  EXPECT_FALSE(is_degenerate({Vec3{0.5, above, 0.5}, {12., 12., 12.}, {24., 24., 24.}}));
}

constexpr std::array<Vec3, 3> triangle = {Vec3{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}};

TEST(triangles_intersect, is_exact)
{
  const auto intersects_triangle_above = [](double height)
  {
    return triangles_intersect(triangle,
                               {Vec3{0.25, 0.25, height}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}});
  };
  EXPECT_TRUE(intersects_triangle_above(-1.));
  EXPECT_TRUE(intersects_triangle_above(0.));
  EXPECT_FALSE(intersects_triangle_above(1e-300));
}

TEST(triangle_intersects_segment, is_exact)
{
  const auto intersects_segment_at = [](double y) {
    return triangle_intersects_segment(triangle, {Vec3{0.5, y, -1.}, {0.5, y, 1.}});
  };
  EXPECT_TRUE(intersects_segment_at(0.2));
  EXPECT_TRUE(intersects_segment_at(0.));
  EXPECT_FALSE(intersects_segment_at(-1e-300));
}

TEST(is_folded_flat, is_exact)
{
  const auto [p, q, r] = triangle;
  EXPECT_TRUE(is_folded_flat(p, q, r, {0.2, 0.2, 0.}));
  EXPECT_FALSE(is_folded_flat(p, q, r, {0.2, 0.2, 1e-300}));
  EXPECT_FALSE(is_folded_flat(p, q, r, {0.2, -0.2, 0.}));
}

} // namespace exact_predicates_test
