// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "triangulations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace morton_order_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using test::Point;

std::vector<Point> random_points(std::size_t n, const Point& center, double size)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1., 1.);
  std::vector<Point> points(n);
  for(Point& p : points)
    for(int k = 0; k < 3; ++k)
      p[k] = center[k] + size * (k == 1 ? 0.3 : 1.) * unit(random);
  return points;
}

TEST(Morton_order, frame_scales_half_extent_to_one_to_two)
{
  for(const double size : {1e-300, 1e-160, 1e-30, 1., 3., 1e30, 1e160, 1e300})
  {
    auto points = random_points(100, {size, -2. * size, 0.}, size);
    const Frame frame = unit_frame(points);
    int exponent = 0;
    EXPECT_EQ(std::frexp(frame.scale, &exponent), 0.5); // a power of two
    to_frame(points, frame);
    double low = infinity, high = 0.;
    for(int k = 0; k < 3; ++k)
    {
      double smallest = infinity, largest = -infinity;
      for(const Point& p : points)
      {
        smallest = std::min(smallest, p[k]);
        largest = std::max(largest, p[k]);
      }
      EXPECT_NEAR(smallest, -largest, 1e-15); // half an ulp of the center of the bounding box
      low = std::min(low, largest);
      high = std::max(high, largest);
    }
    EXPECT_GE(high, 1. - 1e-15); // units in the last place
    EXPECT_LT(high, 2. + 1e-15);
  }
}

TEST(Morton_order, frame_is_invertible)
{
  const auto points = random_points(100, {1e8, 0., 5.}, 3.);
  const Frame frame = unit_frame(points);
  auto scaled = points;
  to_frame(scaled, frame);
  for(std::size_t i = 0; i < points.size(); ++i)
    for(int k = 0; k < 3; ++k)
      // One ulp of the given coordinates.
      EXPECT_NEAR(frame.origin[k] + frame.scale * scaled[i][k], points[i][k],
                  2e-16 * (std::abs(points[i][k]) + 1.));
}

TEST(Morton_order, frame_of_degenerate_input_has_unit_scale)
{
  EXPECT_EQ(unit_frame({}).scale, 1.);
  const Frame frame = unit_frame({{3., 4., 5.}, {3., 4., 5.}});
  EXPECT_EQ(frame.scale, 1.);
  EXPECT_EQ(frame.origin, (Point{3., 4., 5.}));
}

TEST(Morton_order, frame_throws_on_nonfinite_or_overflowing_points)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(int k = 0; k < 3; ++k)
    for(const double invalid : {nan, infinity, -infinity})
    {
      std::vector<Point> points = {{0., 0., 0.}, {1., 1., 1.}};
      points[1][k] = invalid;
      EXPECT_THROW(unit_frame(points), Invalid_argument_error);
    }
  EXPECT_THROW(unit_frame({{-1.7e308, 0., 0.}, {1.7e308, 0., 0.}}), Invalid_argument_error);
}

TEST(Morton_order, is_permutation_that_keeps_locality)
{
  const std::size_t n = 20000;
  const auto points = random_points(n, {0., 0., 0.}, 1.9);
  const auto order = morton_order(points);
  auto sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> all(n);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  // In a box of 3.8 x 1.1 x 3.8 the mean distance of two random points is 1.9. Along a curve
  // through cells of one point each it is about the size of a cell, 0.1, plus some jumps.
  double sum = 0.;
  for(std::size_t i = 1; i < n; ++i)
    sum += test::distance(points[order[i - 1]], points[order[i]]);
  EXPECT_LT(sum / double(n), 0.25);
  // Ties are in the order of indices.
  EXPECT_EQ(morton_order({{1., 1., 1.}, {-1., 0., 0.}, {1., 1., 1.}}),
            (std::vector<Index>{1, 0, 2}));
}

TEST(Morton_order, does_not_depend_on_threads)
{
  const auto points = random_points(40000, {3., 0., -1.}, 5.);
  const std::vector<Index> used = {0, 7, 39999};
  const Frame frame = unit_frame(points), frame_of_used = unit_frame(points, used);
  const std::vector<Index> order = morton_order(points, frame);
  auto scaled = points;
  to_frame(scaled, frame);
  for(const unsigned number_of_threads : {2u, 5u})
  {
    EXPECT_EQ(unit_frame(points, {}, number_of_threads).origin, frame.origin);
    EXPECT_EQ(unit_frame(points, {}, number_of_threads).scale, frame.scale);
    EXPECT_EQ(unit_frame(points, used, number_of_threads).origin, frame_of_used.origin);
    EXPECT_EQ(unit_frame(points, used, number_of_threads).scale, frame_of_used.scale);
    EXPECT_EQ(morton_order(points, frame, number_of_threads), order);
    auto scaled_here = points;
    to_frame(scaled_here, frame, number_of_threads);
    EXPECT_EQ(scaled_here, scaled);
  }
}

} // namespace morton_order_test
