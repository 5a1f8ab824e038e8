// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/approximate_windows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace approximate_windows_test {

using namespace CGAL::Geodesic_processing::internal;

// Coordinates and distances are about 1.
constexpr double round_off = 1e-12;

// Two consecutive windows on an edge of length 1 with equal distances where they meet.
struct Pair
{
  Window a, b;
};

// Returns a pair whose sources are at most `spread` apart; sometimes one window is straight.
Pair random_pair(std::mt19937& random, double spread)
{
  std::uniform_real_distribution<double> uniform(0., 1.);
  const double meeting = 0.3 + 0.4 * uniform(random);
  Window a = {{3. * uniform(random) - 1., -0.2 - uniform(random)}, 1., 0., meeting, 0, 0.f};
  Window b = a;
  b.source = a.source + spread * Vec2{uniform(random) - 0.5, uniform(random) - 0.5};
  b.begin = meeting;
  b.end = 1.;
  if(uniform(random) < 0.2)
  {
    const Vec2 direction = b.source - Vec2{meeting, 0.};
    b.source = (1. / norm(direction)) * direction;
    b.signed_error = -0.f;
  }
  b.offset += a.distance(meeting) - b.distance(meeting);
  return {a, b};
}

TEST(Approximate_windows, merged_distances_are_lower_bounds_within_the_error)
{
  std::mt19937 random(1);
  int number_of_merged_pairs = 0;
  for(int i = 0; i < 1000; ++i)
  {
    const auto [a, b] = random_pair(random, 0.3);
    Window merged = b;
    if(!merge_similar(a, merged, 0.05, 1e-13))
      continue;
    ++number_of_merged_pairs;
    EXPECT_EQ(merged.begin, a.begin);
    EXPECT_EQ(merged.end, b.end);
    EXPECT_FALSE(merged.is_straight());
    EXPECT_NEAR(merged.distance(0.), a.distance(0.), round_off);
    EXPECT_NEAR(merged.distance(1.), b.distance(1.), round_off);
    double smallest = std::numeric_limits<double>::infinity();
    for(int k = 0; k <= 100; ++k)
    {
      const double x = k / 100., distance = (x < a.end ? a : b).distance(x);
      EXPECT_LE(merged.distance(x), distance + round_off);
      EXPECT_LE(distance, merged.distance(x) + merged.error() + round_off);
      smallest = std::min(smallest, distance);
    }
    EXPECT_LE(merged.error(), 0.05 * smallest); // the tolerance above
  }
  EXPECT_GT(number_of_merged_pairs, 500);
}

TEST(Approximate_windows, merged_lines_cover_those_of_both_windows)
{
  std::mt19937 random(2);
  for(int i = 0; i < 1000; ++i)
  {
    const auto [a, b] = random_pair(random, 0.3);
    Window merged = b;
    if(!merge_similar(a, merged, 0.05, 1e-13))
      continue;
    // The cosine of the angle between a line and the edge is the slope of the distance.
    EXPECT_LE(slope(merged, 0.), slope(a, 0.) + round_off);
    EXPECT_GE(slope(merged, 1.), slope(b, 1.) - round_off);
  }
}

TEST(Approximate_windows, errors_add_up)
{
  std::mt19937 random(3);
  auto [a, b] = random_pair(random, 0.1);
  Window merged = b;
  ASSERT_TRUE(merge_similar(a, merged, 0.1, 1e-13));
  const double error = merged.error();
  a.signed_error = 0.01f;
  ASSERT_TRUE(merge_similar(a, b, 0.1, 1e-13));
  EXPECT_GE(b.error(), error);
  EXPECT_GE(b.error(), 0.01);                // that of the first window
  EXPECT_LE(b.error(), error + 0.01 + 1e-8); // an error is stored as a float
}

TEST(Approximate_windows, windows_of_one_circle_are_merged_exactly)
{
  const Window whole = {{0.4, -1.}, 0.5, 0., 1., 7, 0.f};
  Window a = whole, b = whole;
  a.end = b.begin = 0.3;
  ASSERT_TRUE(merge_similar(a, b, 1e-9, 1e-13));
  EXPECT_NEAR(b.source[0], whole.source[0], round_off);
  EXPECT_NEAR(b.source[1], whole.source[1], round_off);
  EXPECT_NEAR(b.offset, whole.offset, round_off);
  EXPECT_EQ(b.origin, whole.origin);
}

TEST(Approximate_windows, others_are_not_merged)
{
  const Window window = {{0.4, -1.}, 0.5, 0., 1., 0, 0.f};
  const auto is_merged =
      [&](double begin, double end, double next_begin, double next_end, double offset)
  {
    Window a = window, b = window;
    a.begin = begin;
    a.end = end;
    b.begin = next_begin;
    b.end = next_end;
    b.offset += offset;
    return merge_similar(a, b, 0.01, 1e-13);
  };
  EXPECT_TRUE(is_merged(0., 0.5, 0.5, 1., 0.));
  EXPECT_FALSE(is_merged(0., 0.4, 0.5, 1., 0.));  // a gap
  EXPECT_FALSE(is_merged(0., 1., 0.5, 0.6, 0.));  // nested
  EXPECT_FALSE(is_merged(0., 0.5, 0.5, 1., 0.1)); // too different
  // The second window is nearer also at the begin of the first one.
  EXPECT_FALSE(is_merged(0., 0.5, 0., 1., -1.4));
}

} // namespace approximate_windows_test
