// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/window_operations.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace window_operations_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of a few operations on numbers of size 1; measured are 6e-17.
constexpr double round_off = 1e-15;

const Window circular = {{0.4, -1.5}, 0.7, 0.2, 0.9, 0, 0.f};
const Window straight = {{0.6, -0.8}, 0.7, 0.2, 0.9, 0, -0.f};

TEST(Window_operations, reflection_preserves_distances)
{
  for(const Window& window : {circular, straight})
  {
    const Window reflected = mirror(window, 1.);
    for(const double x : {0., 0.25, 0.5, 1.})
      EXPECT_NEAR(reflected.distance(1. - x), window.distance(x), round_off);
    const Window twice = mirror(reflected, 1.);
    EXPECT_NEAR(twice.begin, window.begin, round_off);
    EXPECT_NEAR(twice.end, window.end, round_off);
  }
}

TEST(Window_operations, clipped_window_has_the_same_source)
{
  const Vec2 apex_point = {0.8, 0.9};
  const double length = norm(apex_point);
  const Vec2 axis = (1. / length) * apex_point;
  const Window w = circular;
  const Window left = clip_through_left(w, side_of_apex_line(w, w.begin, apex_point),
                                        side_of_apex_line(w, w.end, apex_point), axis, length);
  EXPECT_GE(left.begin, 0.);
  EXPECT_LE(left.end, length);
  EXPECT_LT(left.begin, left.end);
  for(const double x : {left.begin, left.end})
    EXPECT_NEAR(left.distance(x), w.offset + norm(x * axis - w.source), round_off);
  // The line from the source to the first point crosses the edge at the begin of the window.
  const Vec2 direction = left.begin * axis - w.source;
  EXPECT_NEAR(w.source[0] - w.source[1] / direction[1] * direction[0], w.begin, round_off);
}

TEST(Window_operations, overlap_is_split_at_equal_distances)
{
  Window a = {{0.2, -1.}, 0., 0., 0.9, 0, 0.f}, b = {{0.8, -1.1}, 0., 0.05, 1., 1, 0.f};
  ASSERT_TRUE(split_overlap(a, b, 1e-13));
  // The position of equal distance is in both windows, so that no part of the minimum is lost.
  EXPECT_LE(a.distance(b.begin), b.distance(b.begin));
  EXPECT_GE(a.distance(a.end), b.distance(a.end));
  EXPECT_GE(a.end, b.begin);
  EXPECT_NEAR(a.end, b.begin, 0.01); // four steps
}

// Returns the distance at a position through the windows that contain it.
double minimum(const std::vector<Window>& windows, double position)
{
  double result = infinity;
  for(const Window& w : windows)
    if(position >= w.begin && position <= w.end)
      result = std::min(result, w.distance(position));
  return result;
}

// Whatever is cut off, the smaller distance remains at each position. A window of a larger offset
// can be closer in the middle of the overlap only.
TEST(Window_operations, smaller_distances_are_kept)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  const auto random_window = [&](Index origin)
  {
    const double height = 0.02 + 2. * uniform(random);
    // Similar distances, whatever the height
    const double offset = 2. - height + 0.4 * uniform(random);
    Window w = {{2. * uniform(random) - 0.5, -height},
                offset,
                0.4 * uniform(random),
                1. - 0.4 * uniform(random),
                origin,
                random() % 4 == 0 ? -0.f : 0.f};
    if(w.is_straight())
      w.source = (1. / norm(w.source)) * w.source;
    return w;
  };
  int closer_in_the_middle = 0;
  for(int repetition = 0; repetition < 20000; ++repetition)
  {
    Window a = random_window(0), b = random_window(1);
    if(a.begin + a.end > b.begin + b.end)
      std::swap(a, b);
    const std::vector<Window> before = {a, b};
    const double begin = std::max(a.begin, b.begin), end = std::min(a.end, b.end);
    const auto difference = [&](double x) { return before[0].distance(x) - before[1].distance(x); };
    bool has_two_crossings = false;
    std::vector<Window> split, trimmed = before;
    if(split_overlap(a, b, 1e-13))
      split.push_back(a);
    split.push_back(b);
    trim_dominated(trimmed[0], trimmed[1]);
    for(double x = begin; x <= end; x += 0.01)
    {
      EXPECT_NEAR(minimum(split, x), minimum(before, x), round_off);
      EXPECT_NEAR(minimum(trimmed, x), minimum(before, x), round_off);
      has_two_crossings = has_two_crossings || (difference(begin) * difference(end) > 0. &&
                                                difference(begin) * difference(x) < 0.);
    }
    closer_in_the_middle += has_two_crossings;
  }
  EXPECT_GT(closer_in_the_middle, 30);
}

TEST(Window_operations, windows_of_one_source_are_merged)
{
  Window a = circular, b = circular;
  a.end = b.begin = 0.5;
  EXPECT_FALSE(split_overlap(a, b, 1e-13));
  EXPECT_EQ(b.begin, 0.2);
  EXPECT_EQ(b.end, 0.9);
}

TEST(Window_operations, dominated_ends_are_trimmed)
{
  Window w = circular;
  Window other = circular;
  other.offset -= 0.1;
  other.end = 0.5;
  trim_dominated(w, other);
  EXPECT_EQ(w.begin, 0.5);
  other.offset = w.offset + 0.1;
  other.end = 0.9;
  trim_dominated(w, other);
  EXPECT_EQ(w.begin, 0.5);
}

} // namespace window_operations_test
