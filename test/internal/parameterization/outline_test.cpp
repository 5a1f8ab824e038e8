// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace outline_test {

using namespace CGAL::Geodesic_processing::internal;

Outline star_polygon(std::size_t n, double scale)
{
  Outline result;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2. * pi * double(i) / double(n), radius = i % 2 == 0 ? scale : 0.3 * scale;
    result.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return result;
}

TEST(outline, simple_polygon_has_no_self_intersection)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const std::size_t n : {4u, 10u, 1000u})
      EXPECT_FALSE(find_self_intersection(star_polygon(n, scale)));
  EXPECT_FALSE(find_self_intersection({{0., 0.}, {1., 0.}, {0., 1.}}));
}

TEST(outline, finds_crossing_edges)
{
  // A figure eight.
  const auto found = find_self_intersection({{0., 0.}, {1., 1.}, {1., 0.}, {0., 1.}});
  ASSERT_TRUE(found);
  EXPECT_EQ(std::minmax(found->first, found->second), std::minmax(std::size_t(0), std::size_t(2)));
  // Winds twice around the center.
  Outline twice;
  for(int i = 0; i < 40; ++i)
    twice.push_back({(1. + 0.1 * std::sin(i * 0.155)) * std::cos(i * 0.31),
                     (1. + 0.1 * std::sin(i * 0.155)) * std::sin(i * 0.31)});
  EXPECT_TRUE(find_self_intersection(twice));
}

TEST(outline, touching_is_an_intersection)
{
  // A corner on an edge, a repeated corner, an edge that folds back, and an edge of length zero.
  EXPECT_TRUE(find_self_intersection({{0., 0.}, {2., 0.}, {2., 2.}, {1., 0.}, {0., 2.}}));
  EXPECT_TRUE(find_self_intersection({{0., 0.}, {2., 0.}, {1., 1.}, {2., 2.}, {0., 2.}, {1., 1.}}));
  EXPECT_TRUE(find_self_intersection({{0., 0.}, {2., 0.}, {1., 0.}, {1., 1.}}));
  EXPECT_TRUE(find_self_intersection({{0., 0.}, {0., 0.}, {1., 0.}, {0., 1.}}));
}

TEST(outline, predicates_are_exact)
{
  // The corner (x, x) of the notch is on the edge from (0, 0) to (3, 3), or one ulp off it.
  const double x = 1.1, above = std::nextafter(x, 2.);
  const auto notch = [&](double y) {
    return Outline{{0., 0.}, {3., 3.}, {0., 4.}, {x, y}, {-1., 2.}};
  };
  EXPECT_TRUE(find_self_intersection(notch(x)));
  EXPECT_FALSE(find_self_intersection(notch(above)));
  EXPECT_TRUE(is_left_turn({0., 0.}, {3., 3.}, {x, above}));
  EXPECT_FALSE(is_left_turn({0., 0.}, {3., 3.}, {x, x}));
}

TEST(outline, agrees_with_brute_force)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> wobble(-0.03, 0.03);
  int meeting = 0;
  for(int trial = 0; trial < 200; ++trial)
  {
    Outline polygon = star_polygon(24, 0.3);
    for(Vec2& p : polygon)
      p = p + Vec2{wobble(random), wobble(random)};
    // By signs of areas in double precision: for random coordinates no area is close to zero.
    bool expected = false;
    const auto side_of = [&](std::size_t i, const Vec2& p)
    { return cross(polygon[(i + 1) % 24] - polygon[i], p - polygon[i]) > 0.; };
    for(std::size_t i = 0; i < 24; ++i)
      for(std::size_t j = i + 2; j < 24; ++j)
        if(!(i == 0 && j == 23))
          expected = expected || (side_of(i, polygon[j]) != side_of(i, polygon[(j + 1) % 24]) &&
                                  side_of(j, polygon[i]) != side_of(j, polygon[i + 1]));
    EXPECT_EQ(find_self_intersection(polygon).has_value(), expected);
    meeting += expected;
  }
  EXPECT_GT(meeting, 5);
  EXPECT_LT(meeting, 195);
}

} // namespace outline_test
