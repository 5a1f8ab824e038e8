// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace two_triangles {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

void expect_plane(const Triangulation& plane)
{
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  std::mt19937 random(1);
  for(int i = 0; i < 50; ++i)
  {
    const Surface_location from = random_location(t, random), to = random_location(t, random);
    const std::vector<internal::Front_source> sources = {surface.source(to)};
    internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
    front.run(sources);
    const double expected = distance(point_at(t, from), point_at(t, to));
    EXPECT_LT(largest_error(surface.distances(front),
                            [&](Index v) { return distance(plane.points[v], point_at(t, to)); }),
              round_off_tolerance);
    EXPECT_NEAR(surface.scale() * front.distance(from), expected, round_off_tolerance);
    const auto geodesic = path(t, front, sources, from);
    expect_path_on_surface(t, geodesic, from, to);
    EXPECT_NEAR(surface.scale() * internal::path_length(t, geodesic), expected,
                round_off_tolerance);
  }
  for(const Method method : all_methods)
    for(Index source = 0; source < surface.size(); ++source)
      for(const double value : distances(surface, method, {surface.source(source)}))
        EXPECT_TRUE(value >= 0. && value < internal::infinity) << method;
}

TEST(Two_triangles, distances_are_exact) { expect_plane(square(1)); }

TEST(Two_triangles, distances_are_exact_on_one_triangle) { expect_plane(one_triangle()); }

TEST(Two_triangles, distances_are_exact_on_thin_triangles)
{
  expect_plane({{{0., 0., 0.}, {1., 0., 0.}, {0.5, 0.1, 0.}, {0.5, -0.1, 0.}}, {0, 1, 2, 1, 0, 3}});
}

TEST(Two_triangles, are_unfolded_across_shared_edge)
{
  // Folded by a right angle. Unfolding maps corner 3 to (0.5, -1).
  const Triangulation folded = {{{0., 0., 0.}, {1., 0., 0.}, {0.5, 1., 0.}, {0.5, 0., 1.}},
                                {0, 1, 2, 1, 0, 3}};
  const Array_surface surface(folded);
  for(const Method method : {Method::fast_marching, Method::euclidean_front})
  {
    const auto d = distances(surface, method, {surface.source(2)});
    EXPECT_NEAR(d[0], std::hypot(0.5, 1.), round_off_tolerance) << method;
    EXPECT_NEAR(d[1], std::hypot(0.5, 1.), round_off_tolerance) << method;
    // A first-order front assumes that all points of the shared edge are as far as its ends.
    EXPECT_NEAR(d[3], method == Method::euclidean_front ? 2. : std::hypot(0.5, 1.) + 1.,
                round_off_tolerance)
        << method;
  }
}

} // namespace two_triangles
