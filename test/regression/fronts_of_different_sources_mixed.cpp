// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Two fronts that arrive at two corners of a triangle must not be read as one that passes it.

//        2
//       / \.
//      /   \.
//     0-----1
TEST(Fronts_of_different_sources, are_not_combined_into_one_front)
{
  const Triangulation triangle = {{{0., 0., 0.}, {1., 0., 0.}, {0.5, 0.9, 0.}}, {0, 1, 2}};
  const Array_surface surface(triangle);
  const double edge_length = std::hypot(0.5, 0.9), height = 0.9;
  for(const Method method : fronts)
  {
    const auto from_both_points =
        distances(surface, method, {surface.source(0), surface.source(1, 0., 1)});
    EXPECT_NEAR(from_both_points[2], edge_length, rounding) << method;
    // A common edge is a line, whose points are all sources.
    if(method == Method::dijkstra)
      continue;
    EXPECT_NEAR(distances(surface, method, {surface.line({0, 1})})[2], height, rounding) << method;
  }
}

TEST(Fronts_of_different_sources, are_not_shorter_than_nearest_source)
{
  // Where fronts of two sources meet in the plane, mixing them is too short by up to the sagitta of
  // a side; each on its own is never too short.
  const Triangulation plane = square(24, 0.24, 2);
  const Array_surface surface(plane);
  for(const auto& [a, b] : {std::pair<Index, Index>(0, 24), {300, 310}, {300, 301}, {12, 612}})
    for(const Method method : fronts)
    {
      const auto both = distances(surface, method, {surface.source(a), surface.source(b, 0., 1)});
      const auto first = distances(surface, method, {surface.source(a)});
      const auto second = distances(surface, method, {surface.source(b)});
      for(Index i = 0; i < surface.size(); ++i)
      {
        const double expected = std::min(distance(plane.points[i], plane.points[a]),
                                         distance(plane.points[i], plane.points[b]));
        // A Euclidean front fits circles to distances of its own, of which one may have lost a part of
        // a side where the fronts meet.
        const double undercut = method == Method::euclidean_front ? 0.02 / 24. : front_tolerance;
        EXPECT_GE(both[i], expected - undercut) << method;
        // A triangle where they meet is passed by neither front: there a part of a side is lost.
        const double error = method == Method::dijkstra ? rounding : 0.5 / 24.;
        EXPECT_NEAR(both[i], std::min(first[i], second[i]), error) << method;
      }
    }
}

TEST(Fronts_of_different_sources, are_separated_between_two_lines)
{
  // Two lines from one point: between them the distance is to the nearer one.
  const Index n = 20;
  const Triangulation plane = square(n);
  const Array_surface surface(plane);
  std::vector<Index> along_x, along_y;
  for(Index i = 0; i <= n; ++i)
  {
    along_x.push_back(i);
    along_y.push_back(i * (n + 1));
  }
  for(const Method method : {Method::fast_marching, Method::euclidean_front})
  {
    const auto d = distances(surface, method, {surface.line(along_x), surface.line(along_y)});
    // Both waves are plane, and the grid has their bisector among its edges.
    EXPECT_LT(
        largest_error(d, [&](Index i) { return std::min(plane.points[i][0], plane.points[i][1]); }),
        front_tolerance)
        << method;
  }
}

} // namespace
