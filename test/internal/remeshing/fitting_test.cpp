// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/fitting.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace fitting_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A coarse mesh of two triangles over a square mesh. Its points are the corners of the square, and
// the cell of each vertex is the closest corner.
struct Square_fixture
{
  Array_surface fine;
  Coarse_mesh coarse;
  std::vector<Index> labels;

  explicit Square_fixture(const Triangulation& surface) : fine(surface)
  {
    const Surface_arrays& t = fine.t();
    const auto scaled = [&](const Point& p) { return (1. / t.scale) * (p - t.origin); };
    coarse.points = {scaled({0., 0., 0.}), scaled({1., 0., 0.}), scaled({0., 1., 0.}),
                     scaled({1., 1., 0.})};
    coarse.triangles = {{0, 1, 3}, {0, 3, 2}};
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      const Point p = t.origin + t.scale * t.point[vertex];
      labels.push_back((p[0] > 0.5 ? 1 : 0) + (p[1] > 0.5 ? 2 : 0));
    }
  }
};

TEST(Fitting, keeps_points_on_the_surface)
{
  Square_fixture fixture(square(10));
  const std::vector<Vec3> before = fixture.coarse.points;
  const double round_off = 1e-14; // of numbers below two
  EXPECT_TRUE(far_vertices(fixture.fine.t(), fixture.labels, fixture.coarse, round_off).empty());
  fit(fixture.fine.t(), fixture.labels, std::vector<bool>(4, false), fixture.coarse);
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_LT(norm(fixture.coarse.points[i] - before[i]), round_off);
}

TEST(Fitting, moves_points_to_offset_surface)
{
  Triangulation elevated = square(10);
  for(Point& p : elevated.points)
    p[2] = 0.1;
  Square_fixture fixture(elevated);
  const double scale = fixture.fine.scale();
  // All vertices have the same distance, so that each cell has a far vertex.
  EXPECT_EQ(far_vertices(fixture.fine.t(), fixture.labels, fixture.coarse, 0.09 / scale).size(),
            4u);
  EXPECT_TRUE(far_vertices(fixture.fine.t(), fixture.labels, fixture.coarse, 0.11 / scale).empty());
  Square_fixture with_fixed_point = fixture;
  fit(fixture.fine.t(), fixture.labels, std::vector<bool>(4, false), fixture.coarse);
  fit(with_fixed_point.fine.t(), with_fixed_point.labels, {true, false, false, false},
      with_fixed_point.coarse);
  const Vec3 first = with_fixed_point.coarse.points[0];
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scale * (fixture.coarse.points[i][2] - first[2]), 0.1, 1e-14); // round-off
  for(std::size_t i = 1; i < 4; ++i)
    // The other points compensate for the fixed one.
    EXPECT_GT(scale * (with_fixed_point.coarse.points[i][2] - first[2]), 0.1);

  Square_fixture limited(elevated);
  fit(limited.fine.t(), limited.labels, std::vector<bool>(4, false), limited.coarse, 0.04 / scale);
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scale * (limited.coarse.points[i][2] - first[2]), 0.04, 1e-14); // round-off
}

TEST(Fitting, finds_farthest_vertex_of_a_cell)
{
  // One vertex is moved off the plane.
  Triangulation bump = square(10);
  bump.points[3 * 11 + 8][2] = 0.3;
  bump.points[3 * 11 + 7][2] = 0.2;
  Square_fixture fixture(bump);
  const double scale = fixture.fine.scale();
  EXPECT_EQ(far_vertices(fixture.fine.t(), fixture.labels, fixture.coarse, 0.1 / scale),
            std::vector<Index>{fixture.fine.vertex(3 * 11 + 8)});
  fixture.labels[fixture.fine.vertex(3 * 11 + 8)] = none;
  EXPECT_EQ(far_vertices(fixture.fine.t(), fixture.labels, fixture.coarse, 0.1 / scale),
            std::vector<Index>{fixture.fine.vertex(3 * 11 + 7)});
}

TEST(Fitting, angle_preserving_steps_keep_small_angles)
{
  // A wavy surface of 40 x 40 quads, and a coarse mesh of 8 x 8 quads with random displacements.
  constexpr std::size_t n = 40, m = 8;
  const auto wave = [](double x, double y) -> Point {
    return {x, y, 0.08 * std::sin(9. * x) * std::cos(7. * y)};
  };
  const Array_surface fine(grid(n, n, wave));
  const double scale = fine.scale();
  const Triangulation planar_mesh = square(m, 0.25);
  Coarse_mesh coarse;
  for(const Point& p : planar_mesh.points)
    coarse.points.push_back((1. / scale) * (wave(p[0], p[1]) - fine.t().origin));
  for(std::size_t c = 0; c < planar_mesh.corners.size(); c += 3)
    coarse.triangles.push_back(
        {planar_mesh.corners[c], planar_mesh.corners[c + 1], planar_mesh.corners[c + 2]});
  std::vector<Index> labels;
  for(const Vec3& p : fine.t().point)
  {
    const auto is_closer = [&](const Vec3& a, const Vec3& b) { return norm(a - p) < norm(b - p); };
    labels.push_back(Index(std::min_element(coarse.points.begin(), coarse.points.end(), is_closer) -
                           coarse.points.begin()));
  }
  const std::vector<bool> is_fixed(coarse.points.size(), false);
  Coarse_mesh angle_preserving = coarse;
  fit(fine.t(), labels, is_fixed, coarse);
  fit(fine.t(), labels, is_fixed, angle_preserving, infinity, 5);
  std::size_t moved = 0;
  for(std::size_t i = 0; i < coarse.points.size(); ++i)
    moved += norm(angle_preserving.points[i] - coarse.points[i]) > 0.;
  EXPECT_GT(moved, 0u);
  EXPECT_LT(moved, coarse.points.size()); // points of triangles with small angles stay
  const double small = std::cos(42. * pi / 180.);
  for(const auto& [a, b, c] : coarse.triangles)
    // The cosine of 42 degrees in fitting.cpp has three digits.
    EXPECT_LE(
        largest_cosine(angle_preserving.points[a], angle_preserving.points[b],
                       angle_preserving.points[c]),
        std::max(small, largest_cosine(coarse.points[a], coarse.points[b], coarse.points[c])) +
            1e-3);
  const auto sum_of_squares = [&](const Coarse_mesh& mesh)
  {
    double sum = 0.;
    for(const Vec3& p : fine.t().point)
    {
      double min_squared_distance = infinity;
      for(const auto& [a, b, c] : mesh.triangles)
      {
        const std::array<Vec3, 3> corners = {mesh.points[a], mesh.points[b], mesh.points[c]};
        const auto barycentric = nearest_in_triangle(corners[0], corners[1], corners[2], p);
        const Vec3 offset = barycentric[0] * corners[0] + barycentric[1] * corners[1] +
                            barycentric[2] * corners[2] - p;
        min_squared_distance = std::min(min_squared_distance, dot(offset, offset));
      }
      sum += min_squared_distance;
    }
    return sum;
  };
  EXPECT_LT(sum_of_squares(angle_preserving), sum_of_squares(coarse));
}

} // namespace fitting_test
