// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/triangulate_hole.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace triangulate_hole_test {

using namespace CGAL::Geodesic_processing::internal;

// A regular polygon of n edges at height 0, in a plane (drop 0) or at the end of a prism (drop 1).
Hole_boundary polygon(std::size_t n, double drop, double scale = 1.)
{
  Hole_boundary hole;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double a = 2. * pi * double(i) / double(n), b = 2. * pi * (double(i) + 0.5) / double(n);
    hole.points.push_back({scale * std::cos(a), scale * std::sin(a), 0.});
    const double r = drop > 0. ? 1. : 1.5;
    hole.apexes.push_back({scale * r * std::cos(b), scale * r * std::sin(b), -scale * drop});
  }
  return hole;
}

double area(const Hole_boundary& hole, const Hole_triangles& triangles)
{
  double sum = 0.;
  for(const auto& [a, b, c] : triangles)
    sum += 0.5 * norm(cross(hole.points[b] - hole.points[a], hole.points[c] - hole.points[a]));
  return sum;
}

// Returns whether the triangles are a disk with the boundary of the hole.
bool is_disk(std::size_t n, const Hole_triangles& triangles)
{
  std::set<std::array<Index, 2>> edges;
  for(const auto& t : triangles)
    for(std::size_t k = 0; k < 3; ++k)
      if(!edges.insert({t[k], t[(k + 1) % 3]}).second)
        return false;
  for(Index i = 0; i < n; ++i)
    if(edges.count({i, Index((i + 1) % n)}) == 0)
      return false;
  // All other edges occur in both directions.
  return triangles.size() == n - 2 &&
         std::all_of(edges.begin(), edges.end(),
                     [&](const auto& e) {
                       return e[1] == (e[0] + 1) % n || edges.count({e[1], e[0]}) == 1;
                     });
}

TEST(triangulate_hole, fills_regular_polygons)
{
  for(const double scale : {1., 1e-160, 1e150})
    for(const double drop : {0., 1.})
      for(const std::size_t n : {3, 4, 20, 150, 400, 2000})
      {
        double steps = 1e8;
        Hole_boundary hole = polygon(n, drop, scale);
        const Hole_triangles triangles = triangulate_hole(hole, steps);
        EXPECT_TRUE(is_disk(n, triangles)) << n;
        hole = polygon(n, drop);
        // Round-off errors of n triangles
        EXPECT_NEAR(area(hole, triangles), 0.5 * double(n) * std::sin(2. * pi / double(n)),
                    1e-15 * double(n));
      }
}

TEST(triangulate_hole, existing_edges_are_not_repeated)
{
  for(const std::array<Index, 2> diagonal : {std::array<Index, 2>{0, 2}, {1, 3}})
  {
    Hole_boundary hole = polygon(4, 0.);
    hole.edges = {{diagonal[0], diagonal[1]}, {diagonal[1], diagonal[0]}};
    std::sort(hole.edges.begin(), hole.edges.end());
    double steps = 1e6;
    const Hole_triangles triangles = triangulate_hole(hole, steps);
    ASSERT_TRUE(is_disk(4, triangles));
    EXPECT_FALSE(checked_triangles(hole, triangles).empty());
    EXPECT_TRUE(
        checked_triangles(hole, {{diagonal[0], diagonal[1], (diagonal[1] + 1) % 4}}).empty());
  }
  // Both diagonals exist: there is no triangulation.
  Hole_boundary hole = polygon(4, 0.);
  hole.edges = {{0, 2}, {1, 3}, {2, 0}, {3, 1}};
  double steps = 1e6;
  EXPECT_TRUE(triangulate_hole(hole, steps).empty());

  // Many existing edges: all from vertex 0, and those between even vertices.
  hole = polygon(12, 0.);
  for(Index i = 0; i < 12; ++i)
    for(Index j = 0; j < 12; ++j)
    {
      const Index distance = std::min((i + 12 - j) % 12, (j + 12 - i) % 12);
      if(distance > 1 && (i == 0 || j == 0 || (i % 2 == 0 && j % 2 == 0 && distance > 2)))
        hole.edges.push_back({i, j});
    }
  const Hole_triangles triangles = triangulate_hole(hole, steps);
  EXPECT_TRUE(is_disk(12, triangles));
  EXPECT_EQ(checked_triangles(hole, triangles), triangles);
}

TEST(triangulate_hole, search_is_limited)
{
  double steps = 10.;
  EXPECT_TRUE(triangulate_hole(polygon(50, 0.), steps).empty());
  EXPECT_EQ(steps, 0.);
  // Without steps, only the projection to a plane is left, for large holes.
  EXPECT_TRUE(is_disk(500, triangulate_hole(polygon(500, 0.), steps)));
  EXPECT_TRUE(triangulate_hole(polygon(5001, 0.), steps).empty());
}

TEST(triangulate_hole, degenerate_holes_are_rejected)
{
  double steps = 1e6;
  EXPECT_TRUE(triangulate_hole({}, steps).empty());
  Hole_boundary hole = polygon(10, 0.);
  hole.points.assign(10, {1., 2., 3.});
  EXPECT_TRUE(triangulate_hole(hole, steps).empty());
  for(Index i = 0; i < 10; ++i)
    hole.points[i] = {double(i), 0., 0.};
  EXPECT_TRUE(triangulate_hole(hole, steps).empty());
  EXPECT_TRUE(checked_triangles(hole, {{0, 1, 2}}).empty());
}

} // namespace triangulate_hole_test
