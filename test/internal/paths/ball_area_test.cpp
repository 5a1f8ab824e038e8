// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/ball_area.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace ball_area_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of areas of order one, divided by the heights of the triangles.
constexpr double round_off = 1e-11;

// Measures a ball with these distances of the points, in the unit of the points.
Ball measured(const Array_surface& surface, const std::vector<double>& given, double radius)
{
  std::vector<double> distances(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
    distances[surface.vertex(i)] = given[i] / surface.scale();
  Ball ball = measure_ball(surface.t(), distances, radius / surface.scale());
  ball.area *= surface.scale() * surface.scale();
  return ball;
}

std::vector<double> distances_from(const Array_surface& surface, const Point& center)
{
  std::vector<double> result;
  for(Index i = 0; i < surface.size(); ++i)
    result.push_back(distance(surface.point(i), center));
  return result;
}

TEST(ball_area, is_that_of_a_disk_in_one_triangle)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Array_surface surface(
        scaled({{{0., 0., 0.}, {4., 0., 0.}, {0., 4., 0.}}, {0, 1, 2}}, scale));
    const auto area = [&](const Point& center, double radius)
    {
      const Point c = {scale * center[0], scale * center[1], 0.};
      return measured(surface, distances_from(surface, c), scale * radius).area / (scale * scale);
    };
    EXPECT_NEAR(area({1., 1., 0.}, 0.5), pi / 4., round_off); // inside
    EXPECT_NEAR(area({2., 0., 0.}, 1.), pi / 2., round_off);  // on an edge
    EXPECT_NEAR(area({0., 0., 0.}, 1.), pi / 4., round_off);  // at a corner
    EXPECT_NEAR(area({2., -1., 0.}, 1.), 0., round_off);      // touches an edge
    EXPECT_NEAR(area({1., 1., 0.}, 4.), 8., round_off);       // contains the triangle
    // The segment that an edge at the distance 1 from the center cuts off a disk of radius 2.
    EXPECT_NEAR(area({2., -1., 0.}, std::sqrt(2.)), pi / 2. - 1., round_off);
    EXPECT_EQ(area({2., -3., 0.}, 1.), 0.);
  }
}

TEST(ball_area, of_disks_in_a_triangulated_square_is_that_of_disks)
{
  const Array_surface surface(square(9, 0.24));
  for(const Point& center : {Point{0.52, 0.47, 0.}, Point{0.4, 0.61, 0.}})
    for(const double radius : {0.001, 0.03, 0.1, 0.25, 0.38})
      EXPECT_NEAR(measured(surface, distances_from(surface, center), radius).area,
                  pi * radius * radius, round_off);
  // The boundary cuts the disk.
  EXPECT_NEAR(measured(surface, distances_from(surface, {0., 0., 0.}), 0.8).area, pi * 0.16,
              round_off);
}

// These are not the distances from one point in the plane of the triangle.
TEST(ball_area, is_bounded_by_a_chord_if_distances_are_not_those_of_a_point)
{
  const Array_surface surface({{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 1, 2}});
  // Along the edges from corner 0 of length 1, the squared distance is t^2 + 3 t. It is 7/4 for
  // t = 1/2.
  const double radius = std::sqrt(1.75);
  EXPECT_NEAR(measured(surface, {0., 2., 2.}, radius).area, 1. / 8., round_off);
  // With the ends exchanged, it is 4 - 5 t + t^2: 7/4 for t = 1/2.
  EXPECT_NEAR(measured(surface, {2., 0., 0.}, radius).area, 3. / 8., round_off);
  // The offset of a source can be negative. Then distances are linear along edges.
  EXPECT_NEAR(measured(surface, {-1., 1., 3.}, 0.).area, 0.5 / 8., round_off);
}

TEST(ball_area, has_the_triangles_with_all_corners_inside)
{
  const Array_surface surface(square(2));
  std::vector<double> distances(surface.size(), 1.);
  distances[8] = 3.;
  const Ball ball = measured(surface, distances, 1.);
  std::size_t expected = 0;
  for(Index f = 0; f < 8; ++f)
  {
    const Index* corner = &surface.t().corner[3 * f];
    expected += std::count(corner, corner + 3, surface.vertex(8)) == 0;
  }
  EXPECT_EQ(ball.triangles.size(), expected);
  for(const Index f : ball.triangles)
    for(Index k = 0; k < 3; ++k)
      EXPECT_NE(surface.t().corner[3 * f + k], surface.vertex(8));
}

TEST(ball_area, ignores_triangles_with_infinite_distances)
{
  const Array_surface surface(one_triangle());
  EXPECT_EQ(measured(surface, {0., infinity, 0.}, 1.).area, 0.);
  EXPECT_TRUE(measured(surface, {0., infinity, 0.}, 1.).triangles.empty());
}

} // namespace ball_area_test
