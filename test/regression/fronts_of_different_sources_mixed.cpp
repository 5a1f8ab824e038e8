// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fronts_of_different_sources_mixed {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Two fronts that arrive at two corners of a triangle must not be combined into one front that
// crosses it.

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
    EXPECT_NEAR(from_both_points[2], edge_length, round_off_tolerance) << method;
    // An edge as a line source: all of its points are sources.
    if(method == Method::dijkstra)
      continue;
    EXPECT_NEAR(distances(surface, method, {surface.line({0, 1})})[2], height, round_off_tolerance)
        << method;
  }
}

TEST(Fronts_of_different_sources, are_not_shorter_than_nearest_source)
{
  // In the plane, combining the fronts of two sources makes distances too short, by up to the
  // sagitta of an edge. A single front never makes them too short.
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
        // A Euclidean front fits circles to its own distances. If one of them is too long by a
        // fraction of an edge length, the fit errs near the meeting of fronts.
        const double undercut = method == Method::euclidean_front ? 0.02 / 24. : front_tolerance;
        EXPECT_GE(both[i], expected - undercut) << method;
        // Neither of two meeting fronts crosses the triangle between them. The error is a fraction
        // of an edge length.
        const double error = method == Method::dijkstra ? round_off_tolerance : 0.5 / 24.;
        EXPECT_NEAR(both[i], std::min(first[i], second[i]), error) << method;
      }
    }
}

TEST(Fronts_of_different_sources, are_separated_between_two_lines)
{
  // Two lines from one point. Between them, the distance is to the closer line.
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
    // Both fronts are straight, and their bisector consists of edges of the grid.
    EXPECT_LT(
        largest_error(d, [&](Index i) { return std::min(plane.points[i][0], plane.points[i][1]); }),
        front_tolerance)
        << method;
  }
}

} // namespace fronts_of_different_sources_mixed
