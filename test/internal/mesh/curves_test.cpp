// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/curves.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The spacing of each side in the caller's unit.
std::vector<Point> spread(const Glued_surface& surface, std::vector<double> spacing)
{
  for(double& s : spacing)
    s /= surface.scale();
  std::vector<Point> result;
  for(const Location& place : spread_on_curves(surface.t(), spacing))
    result.push_back(coordinates(surface.t(), place));
  return result;
}

std::vector<Point> spread(const Glued_surface& surface, double spacing,
                          const std::vector<bool>& is_curve)
{
  std::vector<double> spacings;
  for(const bool is_one : is_curve)
    spacings.push_back(is_one ? spacing : 0.);
  return spread(surface, std::move(spacings));
}

std::vector<Point> spread_on_border(const Glued_surface& surface, double spacing)
{
  return spread(surface, spacing, border_and_sharp_sides(surface.t()));
}

bool has(const std::vector<Point>& points, const Point& p)
{
  // Roundings of numbers up to one.
  return std::any_of(points.begin(), points.end(),
                     [&](const Point& q) { return distance(p, q) < 1e-14; });
}

TEST(Curves, of_a_square_have_its_corners)
{
  const Glued_surface surface(square(20, 0.2));
  for(const auto& [spacing, number] :
      std::vector<std::pair<double, std::size_t>>{{0.07, 56}, {0.25, 16}, {0.3, 12}, {0.9, 4}})
  {
    const std::vector<Point> places = spread_on_border(surface, spacing);
    EXPECT_EQ(places.size(), number);
    for(std::size_t i = 0; i <= number / 4; ++i)
    {
      const double x = double(i) / double(number / 4);
      EXPECT_TRUE(has(places, {x, 0., 0.}) && has(places, {0., x, 0.}));
      EXPECT_TRUE(has(places, {x, 1., 0.}) && has(places, {1., x, 0.}));
    }
  }
  // Too far from each other for more than the sharpest: one corner and two places between.
  EXPECT_EQ(spread_on_border(surface, 10.).size(), 3u);
}

TEST(Curves, of_a_cylinder_are_two_loops)
{
  const Glued_surface surface(cylinder(48, 10, 1., 1.));
  for(const double spacing : {0.1, 0.5, 100.})
  {
    std::size_t low = 0;
    const std::vector<Point> places = spread_on_border(surface, spacing);
    for(const Point& p : places)
    {
      EXPECT_TRUE(p[2] == 0. || p[2] == 1.);
      low += p[2] == 0.;
    }
    const double length = 48. * 2. * std::sin(pi / 48.);
    EXPECT_EQ(low, std::max(3., std::round(length / spacing)));
    EXPECT_EQ(places.size(), 2 * low);
  }
}

TEST(Curves, of_a_cube_are_its_edges)
{
  const Glued_surface cube(blocks(4, 4, 4, [](int, int, int) { return true; }));
  const std::vector<bool> sharp = border_and_sharp_sides(cube.t(), 60.);
  EXPECT_EQ(std::count(sharp.begin(), sharp.end(), true), 2 * 12 * 4);
  EXPECT_EQ(border_and_sharp_sides(cube.t()), std::vector<bool>(sharp.size(), false));
  const std::vector<Point> places = spread(cube, 2., sharp);
  EXPECT_EQ(std::set<Point>(places.begin(), places.end()).size(), 8u + 12u);
  EXPECT_EQ(places.size(), 8u + 12u);
  for(const Point& p : places)
    EXPECT_GE((p[0] == 0. || p[0] == 4.) + (p[1] == 0. || p[1] == 4.) + (p[2] == 0. || p[2] == 4.),
              2);
}

TEST(Curves, are_denser_where_the_spacing_is_small)
{
  const Glued_surface surface(square(10));
  const std::vector<bool> border = border_and_sharp_sides(surface.t());
  std::vector<double> spacing(border.size(), 0.);
  for(Index side = 0; side < spacing.size(); ++side)
    if(border[side])
      spacing[side] =
          coordinates(surface.t(), {side / 3, none, on_side(side, 0.5)})[0] < 0.5 ? 0.025 : 0.1;
  const std::vector<Point> places = spread(surface, spacing);
  const auto left =
      std::count_if(places.begin(), places.end(), [](const Point& p) { return p[0] < 0.5 - 1e-9; });
  // One side and two halves take 40, 20 and 20 steps, of which the last place is in the middle; the
  // others 5, 5 and 10.
  EXPECT_EQ(left, 79);
  EXPECT_EQ(places.size(), 100u);
}

TEST(Curves, end_in_the_middle_of_a_surface)
{
  // Three points of a line along sides.
  const Glued_surface surface(square(4));
  std::vector<bool> is_curve(surface.t().corner.size(), false);
  const Index a = surface.site(6), b = surface.site(7), c = surface.site(8);
  for(Index side = 0; side < is_curve.size(); ++side)
  {
    const std::pair<Index, Index> ends = {surface.t().corner[side],
                                          surface.t().corner[next_side(side)]};
    for(const auto& [x, z] : {std::pair{a, b}, std::pair{b, c}})
      if(ends == std::pair{x, z} || ends == std::pair{z, x})
        is_curve[side] = true;
  }
  EXPECT_EQ(spread(surface, 0.26, is_curve).size(), 3u);
  EXPECT_EQ(spread(surface, 10., is_curve).size(), 2u);
  EXPECT_TRUE(spread(surface, 1., std::vector<bool>(is_curve.size(), false)).empty());
}

} // namespace
