// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/crossings.h"

#include "triangulations.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using Point = CGAL::Geodesic_processing::test::Point;
using Pairs = std::vector<std::array<Index, 2>>;

Pairs crossings(const Triangulation& surface, std::size_t most = 1000)
{
  std::vector<std::array<Index, 3>> corners;
  for(std::size_t i = 0; i < surface.corners.size(); i += 3)
    corners.push_back({surface.corners[i], surface.corners[i + 1], surface.corners[i + 2]});
  return crossing_triangles(surface.points, corners, most);
}

// The triangle of (0,0,0), (1,0,0) and (0,1,0), and another one of these points and some more.
Pairs beside(const std::vector<Point>& more, const std::vector<Index>& corners)
{
  Triangulation two = one_triangle();
  two.points.insert(two.points.end(), more.begin(), more.end());
  two.corners.insert(two.corners.end(), corners.begin(), corners.end());
  return crossings(two);
}

TEST(Crossings, of_two_triangles)
{
  const Pairs both = {{0, 1}};
  EXPECT_EQ(beside({{0.2, 0.2, -1.}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}}, {3, 4, 5}), both);
  // A corner touches the other's inside.
  EXPECT_EQ(beside({{0.25, 0.25, 0.}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}}, {3, 4, 5}), both);
  EXPECT_EQ(beside({{0.25, 0.25, 1e-300}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}}, {3, 4, 5}), Pairs());
  EXPECT_EQ(beside({{2., 2., 0.}, {3., 2., 1.}, {2., 3., 1.}}, {3, 4, 5}), Pairs());
}

TEST(Crossings, leave_out_what_triangles_share)
{
  const Pairs both = {{0, 1}};
  // A corner, and the other's opposite side above or through the triangle.
  EXPECT_EQ(beside({{1., 0.2, 1.}, {0.2, 1., 1.}}, {0, 3, 4}), Pairs());
  EXPECT_EQ(beside({{0.3, 0.3, -1.}, {0.3, 0.3, 1.}}, {0, 3, 4}), both);
  // The opposite side touches a side, passes a hair beside it, or is on the other side of the corner.
  EXPECT_EQ(beside({{0.5, 0., 0.}, {0.5, -1., 1.}}, {0, 3, 4}), both);
  EXPECT_EQ(beside({{0.5, -1e-300, 0.}, {0.5, -1., 1.}}, {0, 3, 4}), Pairs());
  EXPECT_EQ(beside({{-1., -1e-300, 0.}, {-1e-300, -1., 0.}}, {0, 3, 4}), Pairs());
  // A side, and the other beside, above or upon the triangle.
  EXPECT_EQ(beside({{1., 1., 0.}}, {1, 3, 2}), Pairs());
  EXPECT_EQ(beside({{0.2, 0.2, 1e-9}}, {1, 3, 2}), Pairs());
  EXPECT_EQ(beside({{0.2, 0.2, 0.}}, {1, 3, 2}), both);
  EXPECT_EQ(beside({}, {0, 2, 1}), both);
}

TEST(Crossings, of_a_triangle_without_area)
{
  EXPECT_EQ(beside({{2., 0., 0.}}, {0, 1, 3}), (Pairs{{1, 1}}));
  EXPECT_EQ(beside({}, {0, 0, 1}), (Pairs{{1, 1}}));
}

TEST(Crossings, are_none_in_surfaces_at_any_scale)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const Triangulation& surface : {icosphere(3), torus(30, 12), square(20, 0.3)})
      EXPECT_EQ(crossings(scaled(surface, scale)), Pairs());
}

// A triangle crosses the plane z = 0 if it has corners on both sides: here none lies in it.
TEST(Crossings, of_a_sphere_and_a_plane)
{
  Triangulation sphere = icosphere(3);
  for(Point& p : sphere.points)
    p[2] += 0.01;
  const std::size_t faces = sphere.corners.size() / 3;
  Pairs expected;
  for(std::size_t f = 0; f < faces; ++f)
  {
    int above = 0;
    for(int k = 0; k < 3; ++k)
      above += sphere.points[sphere.corners[3 * f + k]][2] > 0.;
    if(above == 1 || above == 2)
      expected.push_back({Index(f), Index(faces)});
  }
  ASSERT_GT(expected.size(), 30u);
  const Triangulation plane = {{{-9., -9., 0.}, {9., -9., 0.}, {0., 18., 0.}}, {0, 1, 2}};
  for(const double scale : {1e-6, 1., 1e6})
    EXPECT_EQ(crossings(scaled(apart(sphere, plane), scale)), expected);
  EXPECT_EQ(crossings(apart(sphere, plane), 7).size(), 7u);
}

} // namespace
