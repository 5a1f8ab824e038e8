// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangulate_polygon.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace triangulate_polygon_test {

using namespace CGAL::Geodesic_processing::internal;

double area(const std::vector<Vec3>& points, const std::vector<std::array<Index, 3>>& triangles)
{
  double sum = 0.;
  for(const auto& [a, b, c] : triangles)
    sum += norm(cross(points[b] - points[a], points[c] - points[a])) / 2.;
  return sum;
}

TEST(Triangulate_polygon, keeps_area_of_concave_polygons)
{
  // A star-shaped polygon with ten corners, in planes orthogonal to each axis. The scales cover
  // extremely small and large units.
  for(const double scale : {1., 1e-160, 1e160})
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      std::vector<Vec3> points, scaled;
      double expected = 0.;
      for(Index i = 0; i < 10; ++i)
      {
        const double r = i % 2 == 0 ? 1. : 0.3, angle = pi / 5. * i;
        Vec3 p;
        p[axis] = 0.25;
        p[(axis + 1) % 3] = r * std::cos(angle);
        p[(axis + 2) % 3] = r * std::sin(angle);
        points.push_back(p);
        scaled.push_back(scale * p);
        expected += 0.3 * std::sin(pi / 5.) / 2.;
      }
      const auto triangles = triangulate_polygon(scaled);
      EXPECT_EQ(triangles.size(), 8u);
      // round-off errors of ten products of order one
      EXPECT_NEAR(area(points, triangles), expected, 1e-14);
    }
}

TEST(Triangulate_polygon, of_n_corners_has_n_minus_2_triangles)
{
  // Self-intersecting, degenerate and single-point polygons are also accepted.
  std::mt19937 random(7);
  for(int round = 0; round < 200; ++round)
  {
    std::vector<Vec3> points(3 + random() % 12);
    for(Vec3& p : points)
      for(double& x : p)
        x = random() % (round % 5 + 1);
    const auto triangles = triangulate_polygon(points);
    EXPECT_EQ(triangles.size(), points.size() - 2);
    for(const auto& [a, b, c] : triangles)
    {
      EXPECT_TRUE(a != b && b != c && c != a);
      EXPECT_TRUE(a < points.size() && b < points.size() && c < points.size());
    }
  }
}

TEST(Triangulate_polygon, divides_quadrilateral_by_shorter_diagonal)
{
  const std::vector<Vec3> points = {{0, 0, 0}, {3, -1, 0}, {6, 0, 0}, {3, 1, 0}};
  for(const auto& [a, b, c] : triangulate_polygon(points))
    EXPECT_TRUE((a + b + c == 0 + 1 + 3) || (a + b + c == 1 + 2 + 3)); // diagonal 1-3, not 0-2
}

} // namespace triangulate_polygon_test
