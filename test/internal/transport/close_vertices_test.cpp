// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/close_vertices.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace close_vertices_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off error of a few operations.
constexpr double round_off = 1e-13;

// Two triangles on both sides of a quadrilateral of width 1e-10, which consists of two triangles:
// vertices 0 and 1 are close to each other, and vertices 2 and 3 are.
Array_surface slit()
{
  return Array_surface(Triangulation{
      {{0., 0., 0.}, {1e-10, 0., 0.}, {0., 1.5, 0.}, {1e-10, 1.5, 0.}, {-1., 0., 0.}, {1., 0., 0.}},
      {0, 1, 3, 0, 3, 2, 4, 0, 2, 1, 5, 3}});
}

TEST(close_vertices, finds_groups_and_their_trees)
{
  const Array_surface surface = slit();
  EXPECT_TRUE(close_vertices(surface.t(), 1e-11).groups.empty());
  const Close_vertices close = close_vertices(surface.t(), 1e-9);
  ASSERT_EQ(close.groups.size(), 2u);
  for(const std::vector<Index>& group : close.groups)
  {
    ASSERT_EQ(group.size(), 2u);
    const Index a = surface.caller_vertex(group[0]), b = surface.caller_vertex(group[1]);
    EXPECT_EQ(a / 2, b / 2);
    EXPECT_EQ(close.parent[group[0]], none);
    EXPECT_EQ(close.parent[group[1]], group[0]);
    EXPECT_NEAR(close.parent_distance[group[1]] * surface.scale(), 1e-10, 1e-10 * round_off);
  }
  EXPECT_EQ(close.parent[surface.vertex(4)], none);
  Vector masses = Vector::Zero(6);
  masses[surface.vertex(0)] = 3.;
  masses[surface.vertex(1)] = -3.;
  EXPECT_NEAR(cost_between_close_vertices(close, masses) * surface.scale(), 3e-10,
              3e-10 * round_off);
}

TEST(close_vertices, triangles_become_edges)
{
  const Array_surface surface = slit();
  const Close_vertices close = close_vertices(surface.t(), 1e-9);
  const Operators original = operators(surface.t(), Degenerate_triangles::thickened);
  Operators merged = original;
  merge_close_vertices(surface.t(), close, merged);
  // The function that grows along the slit has slope 1 in all triangles.
  Vector height(6);
  for(Index i = 0; i < 6; ++i)
    height[surface.vertex(i)] = surface.point(i)[1] / surface.scale();
  for(const Vec2& slope : gradient(merged, height))
    EXPECT_NEAR(norm(slope), 1., 1e-9); // the width of the slit
  // A flow through one of the triangles carries the same mass between the merged vertices.
  for(const Index face : {Index(0), Index(1)})
  {
    Field flow(merged.number_of_triangles(), Vec2{0., 0.});
    flow[surface.triangle(face)] = {0.3, 0.1};
    Vector expected = minus_divergence(merged, flow);
    const double cost = integrated_length(merged, Field{flow}, 0.);
    separate_close_vertices(merged, original, flow);
    Vector found = minus_divergence(original, flow);
    merge_vertices(found, close.groups);
    EXPECT_GT(expected.lpNorm<Eigen::Infinity>(), 0.01);
    EXPECT_LT((found - expected).lpNorm<Eigen::Infinity>(), 1e-9);
    // The cost is that of the component along the edge.
    EXPECT_LE(integrated_length(original, flow, 0.), cost * (1. + 1e-9));
    EXPECT_NEAR(integrated_length(original, flow, 0.),
                expected.lpNorm<Eigen::Infinity>() * 1.5 / surface.scale(), 1e-9);
  }
}

TEST(close_vertices, triangle_with_three_close_corners_is_skipped)
{
  const Array_surface surface(
      Triangulation{{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {1e-10, 0., 0.}, {0., 1e-10, 0.}},
                    {0, 1, 2, 0, 4, 3}});
  Operators merged = operators(surface.t(), Degenerate_triangles::thickened);
  merge_close_vertices(surface.t(), close_vertices(surface.t(), 1e-9), merged);
  EXPECT_EQ(merged.area[surface.triangle(1)], 0.);
  EXPECT_GT(merged.area[surface.triangle(0)], 0.);
}

} // namespace close_vertices_test
