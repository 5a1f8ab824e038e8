// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/unfold_hole.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <cmath>

namespace unfold_hole_test {

using namespace CGAL::Geodesic_processing::internal;

// Round-off errors of coordinates of order one; measured are at most 2e-15.
constexpr double round_off = 1e-13;

// Returns n points on a curve, given by the fraction of the turn.
template <typename Curve>
std::vector<Vec3> curve(std::size_t n, const Curve& position)
{
  std::vector<Vec3> points;
  for(std::size_t i = 0; i < n; ++i)
    points.push_back(position(2. * pi * double(i) / double(n)));
  return points;
}

// A star with n points on each of two circles.
std::vector<Vec3> star(std::size_t n, double inner_radius)
{
  std::vector<Vec3> points;
  for(std::size_t i = 0; i < 2 * n; ++i)
  {
    const double r = i % 2 == 0 ? 1. : inner_radius, a = pi * double(i) / double(n);
    points.push_back({r * std::cos(a), r * std::sin(a), 0.});
  }
  return points;
}

Hole_boundary hole_of(const std::vector<Vec3>& points) { return {points, points, {}}; }

TEST(unfold_hole, planar_boundary_is_preserved)
{
  // The plane is rotated. The distances between all pairs of points are preserved.
  const Vec3 normal = unit(Vec3{1., 2., 3.});
  const auto [u, v] = tangent_frame(normal);
  for(const double scale : {1., 1e-160, 1e150})
  {
    std::vector<Vec3> points = star(5, 0.4);
    for(Vec3& p : points)
      p = scale * (Vec3{7., 8., 9.} + p[0] * u + p[1] * v);
    const std::vector<Vec2> polygon = unfold_boundary(points);
    ASSERT_EQ(polygon.size(), points.size());
    // The unfolded polygon has a size of order one. All distances have the same ratio.
    const double ratio =
        norm(polygon[1] - polygon[0]) / norm((1. / scale) * (points[1] - points[0]));
    double area = 0.;
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      area += 0.5 * cross(polygon[i], polygon[(i + 1) % points.size()]);
      for(std::size_t j = 0; j < i; ++j)
        EXPECT_NEAR(norm(polygon[i] - polygon[j]),
                    ratio * norm((1. / scale) * (points[i] - points[j])), round_off);
    }
    // 5 isosceles kites
    EXPECT_NEAR(area, ratio * ratio * 5. * 0.4 * std::sin(pi / 5.), round_off);
  }
}

TEST(unfold_hole, closed_boundary_has_the_lengths_and_turns_once)
{
  // A saddle curve: its angles do not sum up to those of a planar polygon.
  for(const double height : {0.1, 0.3, 0.6})
  {
    const std::vector<Vec3> points =
        curve(60,
              [=](double a) {
                return Vec3{std::cos(a), std::sin(a), height * std::cos(2. * a)};
              });
    const std::vector<Vec2> polygon = unfold_boundary(points);
    double turn = 0., perimeter = 0., unfolded_perimeter = 0.;
    for(std::size_t i = 0; i < 60; ++i)
    {
      const Vec2 before = polygon[(i + 1) % 60] - polygon[i],
                 after = polygon[(i + 2) % 60] - polygon[(i + 1) % 60];
      turn += std::atan2(cross(before, after), dot(before, after));
      perimeter += norm(points[(i + 1) % 60] - points[i]);
      unfolded_perimeter += norm(before);
    }
    EXPECT_NEAR(turn, 2. * pi, round_off);
    // The curve is symmetric, so that the gap vanishes. Coordinates are divided by their largest
    // absolute value relative to the first point, after they are halved.
    double largest = 0.;
    for(const Vec3& p : points)
      for(int c = 0; c < 3; ++c)
        largest = std::max(largest, 0.5 * std::abs(p[c] - points[0][c]));
    EXPECT_NEAR(unfolded_perimeter, 0.5 * perimeter / largest, 1e-12); // 60 round-off errors
  }
}

TEST(unfold_hole, degenerate_boundaries_are_rejected)
{
  EXPECT_TRUE(unfold_boundary({{0., 0., 0.}, {1., 0., 0.}, {1., 0., 0.}}).empty());
  EXPECT_TRUE(unfold_boundary({{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}}).empty());
  EXPECT_TRUE(unfold_boundary({{1., 1., 1.}, {1., 1., 1.}, {1., 1., 1.}}).empty());
  // A figure eight encloses no area in total.
  EXPECT_TRUE(unfold_boundary({{0., 0., 0.}, {1., 1., 0.}, {1., 0., 0.}, {0., 1., 0.}}).empty());
}

TEST(unfold_hole, triangles_cover_a_planar_hole)
{
  for(const std::size_t n : {2, 5, 100, 5000})
  {
    const std::vector<Vec3> points = star(n, 0.8);
    const Hole_triangles triangles = triangulate_unfolded_hole(hole_of(points));
    ASSERT_EQ(triangles.size(), 2 * n - 2);
    double area = 0.;
    for(const auto& [a, b, c] : triangles)
    {
      const double z = cross(points[b] - points[a], points[c] - points[a])[2];
      EXPECT_GT(z, 0.);
      area += 0.5 * z;
    }
    // 2 n triangles with edges of 1 and 0.8
    EXPECT_NEAR(area, double(n) * 0.8 * std::sin(pi / double(n)), round_off * double(n));
  }
}

TEST(unfold_hole, triangulation_of_a_planar_hole_is_delaunay)
{
  const std::vector<Vec3> points =
      curve(40,
            [](double a) {
              return Vec3{2. * std::cos(a), std::sin(a) + 0.3 * std::sin(3. * a), 0.};
            });
  const Hole_triangles triangles = triangulate_unfolded_hole(hole_of(points));
  ASSERT_EQ(triangles.size(), 38u);
  // The angles opposite to an inner edge sum up to at most pi.
  const auto angle_at = [&](Index a, Index b, Index c)
  {
    const Vec3 p = points[b] - points[a], q = points[c] - points[a];
    return std::atan2(norm(cross(p, q)), dot(p, q));
  };
  for(const auto& s : triangles)
    for(const auto& t : triangles)
      for(std::size_t i = 0; i < 3; ++i)
        for(std::size_t j = 0; j < 3; ++j)
          if(s[i] == t[(j + 1) % 3] && s[(i + 1) % 3] == t[j])
          {
            EXPECT_LE(angle_at(s[(i + 2) % 3], s[i], s[(i + 1) % 3]) +
                          angle_at(t[(j + 2) % 3], t[j], t[(j + 1) % 3]),
                      pi + round_off);
          }
}

TEST(unfold_hole, intersecting_boundaries_are_rejected)
{
  // A spike of a square crosses the opposite edge.
  for(const double depth : {0.5, -0.5})
    EXPECT_EQ(
        triangulate_unfolded_hole(
            hole_of({{0., 0., 0.}, {4., 0., 0.}, {4., 4., 0.}, {2., depth, 0.}, {0., 4., 0.}}))
            .size(),
        depth > 0. ? 3u : 0u);
}

TEST(unfold_hole, existing_edges_are_not_repeated)
{
  const std::vector<Vec3> square = {{0., 0., 0.}, {1., 0., 0.}, {1.1, 1.1, 0.}, {0., 1., 0.}};
  Hole_boundary hole = hole_of(square);
  EXPECT_EQ(triangulate_unfolded_hole(hole).size(), 2u);
  hole.edges = {{1, 3}, {3, 1}};
  EXPECT_TRUE(triangulate_unfolded_hole(hole).empty()); // the Delaunay diagonal
  hole.edges = {{0, 2}, {2, 0}};
  EXPECT_EQ(triangulate_unfolded_hole(hole).size(), 2u);
}

} // namespace unfold_hole_test
