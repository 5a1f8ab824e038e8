// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

void expect_plane(const Triangulation& plane)
{
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  std::mt19937 random(1);
  for(int i = 0; i < 50; ++i)
  {
    const Location from = random_location(t, random), to = random_location(t, random);
    const std::vector<internal::Source> sources = {surface.source(to)};
    internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
    front.run(sources);
    const double truth = distance(point_at(t, from), point_at(t, to));
    EXPECT_LT(largest_error(surface.distances(front),
                            [&](Index v) { return distance(plane.points[v], point_at(t, to)); }),
              rounding);
    EXPECT_NEAR(surface.scale() * front.distance(from), truth, rounding);
    const auto straight = path(t, front, sources, from);
    expect_path_on_surface(t, straight, from, to);
    EXPECT_NEAR(surface.scale() * internal::path_length(t, straight), truth, rounding);
  }
  for(const Method method : all_methods)
    for(Index source = 0; source < surface.size(); ++source)
      for(const double value : distances(surface, method, {surface.source(source)}))
        EXPECT_TRUE(value >= 0. && value < internal::infinity) << method;
}

TEST(Two_triangles, are_exact) { expect_plane(square(1)); }

TEST(Two_triangles, are_exact_alone) { expect_plane(one_triangle()); }

TEST(Two_triangles, are_exact_when_thin)
{
  expect_plane({{{0., 0., 0.}, {1., 0., 0.}, {0.5, 0.1, 0.}, {0.5, -0.1, 0.}}, {0, 1, 2, 1, 0, 3}});
}

TEST(Two_triangles, are_unfolded_over_their_side)
{
  // Folded by a right angle; corner 3 unfolds to (0.5, -1).
  const Triangulation folded = {{{0., 0., 0.}, {1., 0., 0.}, {0.5, 1., 0.}, {0.5, 0., 1.}},
                                {0, 1, 2, 1, 0, 3}};
  const Glued_surface surface(folded);
  for(const Method method : {Method::fast_marching, Method::euclidean_front})
  {
    const auto d = distances(surface, method, {surface.source(2)});
    EXPECT_NEAR(d[0], std::hypot(0.5, 1.), rounding) << method;
    EXPECT_NEAR(d[1], std::hypot(0.5, 1.), rounding) << method;
    // A first-order front takes the shared side to be all as far as its ends.
    EXPECT_NEAR(d[3], method == Method::euclidean_front ? 2. : std::hypot(0.5, 1.) + 1., rounding)
        << method;
  }
}

} // namespace
