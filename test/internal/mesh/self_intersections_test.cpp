// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/self_intersections.h"

#include "triangulations.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace self_intersections_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using Point = CGAL::Geodesic_processing::test::Point;
using Pairs = std::vector<std::array<Index, 2>>;

Pairs find_pairs(const Triangulation& surface, std::size_t max_pairs = 1000)
{
  std::vector<std::array<Index, 3>> corners;
  for(std::size_t i = 0; i < surface.corners.size(); i += 3)
    corners.push_back({surface.corners[i], surface.corners[i + 1], surface.corners[i + 2]});
  return self_intersections(surface.points, corners, max_pairs);
}

// Returns the intersecting pairs of the triangle (0,0,0), (1,0,0), (0,1,0) and another triangle,
// whose corners are these points and `more_points`.
Pairs pairs_with_triangle(const std::vector<Point>& more_points, const std::vector<Index>& corners)
{
  Triangulation triangles = one_triangle();
  triangles.points.insert(triangles.points.end(), more_points.begin(), more_points.end());
  triangles.corners.insert(triangles.corners.end(), corners.begin(), corners.end());
  return find_pairs(triangles);
}

TEST(Self_intersections, finds_crossing_of_two_triangles)
{
  const Pairs crossing_pair = {{0, 1}};
  EXPECT_EQ(pairs_with_triangle({{0.2, 0.2, -1.}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}}, {3, 4, 5}),
            crossing_pair);
  // A corner touches the interior of the other triangle.
  EXPECT_EQ(pairs_with_triangle({{0.25, 0.25, 0.}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}}, {3, 4, 5}),
            crossing_pair);
  EXPECT_EQ(pairs_with_triangle({{0.25, 0.25, 1e-300}, {0.3, 0.2, 1.}, {0.2, 0.3, 1.}}, {3, 4, 5}),
            Pairs());
  EXPECT_EQ(pairs_with_triangle({{2., 2., 0.}, {3., 2., 1.}, {2., 3., 1.}}, {3, 4, 5}), Pairs());
}

TEST(Self_intersections, ignores_shared_corners_and_edges)
{
  const Pairs crossing_pair = {{0, 1}};
  // One common corner; the opposite edge is above the triangle or intersects it.
  EXPECT_EQ(pairs_with_triangle({{1., 0.2, 1.}, {0.2, 1., 1.}}, {0, 3, 4}), Pairs());
  EXPECT_EQ(pairs_with_triangle({{0.3, 0.3, -1.}, {0.3, 0.3, 1.}}, {0, 3, 4}), crossing_pair);
  // The opposite edge touches an edge, misses it by 1e-300, or is on the other side of the corner.
  EXPECT_EQ(pairs_with_triangle({{0.5, 0., 0.}, {0.5, -1., 1.}}, {0, 3, 4}), crossing_pair);
  EXPECT_EQ(pairs_with_triangle({{0.5, -1e-300, 0.}, {0.5, -1., 1.}}, {0, 3, 4}), Pairs());
  EXPECT_EQ(pairs_with_triangle({{-1., -1e-300, 0.}, {-1e-300, -1., 0.}}, {0, 3, 4}), Pairs());
  // One common edge; the other corner is outside, above or inside the triangle.
  EXPECT_EQ(pairs_with_triangle({{1., 1., 0.}}, {1, 3, 2}), Pairs());
  EXPECT_EQ(pairs_with_triangle({{0.2, 0.2, 1e-9}}, {1, 3, 2}), Pairs());
  EXPECT_EQ(pairs_with_triangle({{0.2, 0.2, 0.}}, {1, 3, 2}), crossing_pair);
  EXPECT_EQ(pairs_with_triangle({}, {0, 2, 1}), crossing_pair);
}

TEST(Self_intersections, reports_degenerate_triangle)
{
  EXPECT_EQ(pairs_with_triangle({{2., 0., 0.}}, {0, 1, 3}), (Pairs{{1, 1}}));
  EXPECT_EQ(pairs_with_triangle({}, {0, 0, 1}), (Pairs{{1, 1}}));
}

TEST(Self_intersections, embedded_surfaces_have_none_at_any_scale)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const Triangulation& surface : {icosphere(3), torus(30, 12), square(20, 0.3)})
      EXPECT_EQ(find_pairs(scaled(surface, scale)), Pairs());
}

// A triangle intersects the plane z = 0 if it has corners on both sides. No corner is in the
// plane.
TEST(Self_intersections, finds_intersection_of_sphere_and_plane)
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
    EXPECT_EQ(find_pairs(scaled(disjoint_union(sphere, plane), scale)), expected);
  EXPECT_EQ(find_pairs(disjoint_union(sphere, plane), 7).size(), 7u);
}

} // namespace self_intersections_test
