// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include "parameterization/packing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace packing_test {

using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::Invalid_argument_error;

// Star-shaped polygons of all sizes.
std::vector<Outline> random_outlines(std::size_t number, double scale)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.3, 1.);
  std::vector<Outline> result(number);
  for(Outline& outline : result)
  {
    const double size = scale * radius(random) * radius(random);
    for(int i = 0; i < 12; ++i)
    {
      const double r = size * radius(random), angle = 2. * pi * i / 12.;
      outline.push_back({r * std::cos(angle), 2. * r * std::sin(angle)});
    }
  }
  return result;
}

double area(const Outline& outline)
{
  double double_area = 0.;
  for(std::size_t i = 0; i < outline.size(); ++i)
    double_area += cross(outline[i], outline[(i + 1) % outline.size()]);
  return double_area / 2.;
}

std::vector<Outline> placed(const std::vector<Outline>& outlines, const Packing& packing)
{
  std::vector<Outline> result(outlines.size());
  for(std::size_t i = 0; i < outlines.size(); ++i)
    for(const Vec2& p : outlines[i])
      result[i].push_back(packing(i, p));
  return result;
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b)
{
  bool inside;
  return norm(p - closest_point_on_segment(p, a, b, inside));
}

bool contains(const Outline& outline, const Vec2& p)
{
  bool result = false;
  for(std::size_t i = 0; i < outline.size(); ++i)
  {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if((a[1] > p[1]) != (b[1] > p[1]) && (cross(b - a, p - a) > 0.) == (b[1] > a[1]))
      result = !result;
  }
  return result;
}

// Returns the minimum distance between the corners of one polygon and the edges of another, for
// disjoint polygons.
double gap(const Outline& a, const Outline& b)
{
  double result = infinity;
  for(const auto& [p, q] : {std::make_pair(&a, &b), std::make_pair(&b, &a)})
    for(const Vec2& corner : *p)
    {
      if(contains(*q, corner))
        return 0.;
      for(std::size_t i = 0; i < q->size(); ++i)
        result = std::min(result, distance(corner, (*q)[i], (*q)[(i + 1) % q->size()]));
    }
  return result;
}

TEST(packing, keeps_gutter_and_covers_square)
{
  constexpr std::size_t texels = 512, gutter = 6;
  for(const double scale : {1e-6, 1., 1e6})
  {
    const std::vector<Outline> outlines = random_outlines(60, scale);
    const Packing packing = pack(outlines, texels, gutter, 1);
    const std::vector<Outline> all = placed(outlines, packing);
    double covered_area = 0.;
    for(std::size_t i = 0; i < all.size(); ++i)
    {
      EXPECT_NEAR(norm(packing.directions[i]), 1., 1e-14); // round-off error of a unit vector
      covered_area += area(all[i]);
      for(const Vec2& p : all[i])
        for(const double x : p)
        {
          EXPECT_GE(x, gutter / 2. - 1e-9); // tolerance of the rounding to cells
          // Round-off errors of coordinates of some hundred texels.
          EXPECT_LE(x, texels - gutter / 2. + 1e-9);
        }
      for(std::size_t j = 0; j < i; ++j)
        // Round-off errors of coordinates of some hundred texels.
        EXPECT_GE(gap(all[i], all[j]), gutter - 1e-9) << i << ' ' << j;
    }
    // These stars cover on average 64 % of their bounding boxes, and one twelfth of the square is
    // gutter.
    EXPECT_GT(covered_area / (texels * texels), 0.4);
  }
}

TEST(packing, single_square_fills_texture)
{
  const Packing packing = pack({{{0., 0.}, {2., 0.}, {2., 2.}, {0., 2.}}}, 256, 4, 1);
  // The search ends within 1 % of 252 texels; a cell is one texel.
  EXPECT_GT(2. * packing.scale, 0.98 * 252.);
  EXPECT_LE(2. * packing.scale, 252.);
}

TEST(packing, small_outlines_fill_gaps)
{
  // A frame that is open on one side, and squares that fit inside.
  std::vector<Outline> outlines = {
      {{0., 0.}, {10., 0.}, {10., 10.}, {0., 10.}, {0., 9.}, {9., 9.}, {9., 1.}, {0., 1.}}};
  for(int i = 0; i < 9; ++i)
    outlines.push_back({{0., 0.}, {2., 0.}, {2., 2.}, {0., 2.}});
  const Packing packing = pack(outlines, 512, 2, 1);
  const auto all = placed(outlines, packing);
  // If the bounding box of the frame were occupied, the squares would require a further strip of
  // width 2.
  EXPECT_GT(12. * packing.scale, 512. * 1.05);
}

TEST(packing, is_independent_of_threads)
{
  const std::vector<Outline> outlines = random_outlines(40, 1.);
  const Packing one = pack(outlines, 300, 3, 1), three = pack(outlines, 300, 3, 3);
  EXPECT_EQ(one.scale, three.scale);
  EXPECT_EQ(one.offsets, three.offsets);
  EXPECT_EQ(one.directions, three.directions);
}

TEST(packing, throws_if_it_does_not_fit)
{
  EXPECT_THROW(pack(random_outlines(100, 1.), 32, 8, 1), Invalid_argument_error);
  EXPECT_THROW(pack(random_outlines(1, 1.), 8, 2, 1), Invalid_argument_error);
  // Also charts of extent zero.
  EXPECT_THROW(pack(std::vector<Outline>(200, Outline(3, Vec2{0., 0.})), 16, 1, 1),
               Invalid_argument_error);
  EXPECT_THROW(pack(random_outlines(1, 1.), 20000, 2, 1), Invalid_argument_error);
  EXPECT_THROW(pack(random_outlines(1, 1.), 64, 65, 1), Invalid_argument_error);
  EXPECT_THROW(check_fits(257, 32, 2), Invalid_argument_error);
  check_fits(256, 32, 2);
  EXPECT_TRUE(pack({}, 64, 2, 1).offsets.empty());
}

} // namespace packing_test
