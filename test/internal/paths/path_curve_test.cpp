// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_curve.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace path_curve_test {

using namespace CGAL::Geodesic_processing::internal;

// The plane z = 0.
struct Plane : Path_surface
{
  Projection project(const Vec3& p, Index) const override
  {
    return {{p[0], p[1], 0.}, {0., 0., 1.}, {0., 0., 0.}, 0};
  }
};

TEST(path_curve, arc_lengths_are_exact_on_circle)
{
  std::vector<Projection> arc(11);
  for(std::size_t i = 0; i < arc.size(); ++i)
  {
    arc[i].point = {std::cos(0.1 * double(i)), std::sin(0.1 * double(i)), 0.};
    arc[i].normal = arc[i].point;
  }
  EXPECT_NEAR(curve_length(arc), 1., 1e-14); // exact on circles
  // Round-off errors, measured 1e-16.
  EXPECT_NEAR(polyline_length(arc), 20. * std::sin(0.05), 1e-14);
  EXPECT_NEAR(arc_length(arc[0], arc[3]), 0.3, 1e-14);
}

TEST(path_curve, arc_length_unfolds_sharp_edge)
{
  // The points are on two orthogonal planes; the path also has a component along their edge.
  const Projection from = {{-1., 0., 0.}, {0., 0., 1.}, {0., 0., 0.}, 0},
                   to = {{0., 2., -3.}, {1., 0., 0.}, {0., 0., 0.}, 0};
  // A few round-off errors.
  EXPECT_NEAR(arc_length(from, to), std::hypot(4., 2.), 1e-14);
}

TEST(path_curve, subdivision_reproduces_cubic_polynomials)
{
  std::vector<Projection> cubic(8);
  for(std::size_t i = 0; i < cubic.size(); ++i)
  {
    const double x = 0.2 * double(i);
    cubic[i].point = {x, 0.25 * x * x * x, 0.};
  }
  const std::vector<Projection> result = subdivide_curve(Plane(), cubic);
  ASSERT_EQ(result.size(), 15u);
  for(std::size_t i = 0; i < cubic.size(); ++i)
    EXPECT_EQ(result[2 * i].point, cubic[i].point);
  // The new points of segments with two neighbors.
  for(std::size_t i = 3; i + 3 < result.size(); i += 2)
  {
    const double x = result[i].point[0];
    // Round-off errors of numbers near 1.
    EXPECT_NEAR(result[i].point[1], 0.25 * x * x * x, 1e-14);
  }
}

TEST(path_curve, subdivision_of_uneven_segments_does_not_reverse)
{
  // Segments as they are refined at a hole: each one is 16 times as long as the next, or as short.
  // With equal parameter intervals, the new point of the first short one would be far behind it.
  std::vector<Projection> line;
  double x = 0.;
  for(const double length : {16., 16., 1., 1., 16., 16., 1., 0., 1.})
  {
    line.emplace_back().point = {x, 0., 0.};
    x += length;
  }
  const std::vector<Projection> result = subdivide_curve(Plane(), line);
  ASSERT_EQ(result.size(), 17u);
  for(std::size_t i = 1; i < result.size(); i += 2)
  {
    const Vec3 middle = 0.5 * (result[i - 1].point + result[i + 1].point);
    EXPECT_LT(norm(result[i].point - middle), 1e-13); // round-off errors of numbers near 50
  }
}

TEST(path_curve, subdivision_keeps_corners)
{
  std::vector<Projection> path(5);
  for(std::size_t i = 0; i < path.size(); ++i)
    path[i].point = {std::min(double(i), 2.), std::max(double(i) - 2., 0.), 0.};
  const std::vector<Projection> result = subdivide_curve(Plane(), path);
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    EXPECT_EQ(result[2 * i + 1].point, 0.5 * (path[i].point + path[i + 1].point));
}

TEST(path_curve, sharp_edge_is_inserted_between_different_normals_only)
{
  const Projection from = {{-1., 0., 0.}, {0., 0., 1.}, {0., 0., 0.}, 0},
                   on_edge_side = {{-0.5, 1., 0.}, {0., 0., 1.}, {0., 0., 0.}, 0},
                   to = {{0., 2., -0.5}, {1., 0., 0.}, {0., 0., 0.}, 0};
  const std::vector<Projection> path = insert_sharp_edges({from, on_edge_side, to});
  ASSERT_EQ(path.size(), 4u);
  // The edge is the y-axis; both points are 0.5 away from it.
  EXPECT_NEAR(norm(path[2].point - Vec3{0., 1.5, 0.}), 0., 1e-15);
}

} // namespace path_curve_test
