// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths of the exact method on surfaces that unfold to a plane or to a cone.
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace Window_paths_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Unfolding adds an error of about 1e-16 of the length at each of ten edges; measured are 7e-16.
constexpr double round_off = 1e-14;

// Returns the path from a location to a source. Its length is the distance.
std::vector<Surface_location> path_of_expected_length(const Array_surface& surface,
                                                      const Surface_location& from,
                                                      const Surface_location& source,
                                                      double expected)
{
  Window_propagation windows(surface.triangles());
  EXPECT_TRUE(windows.run({surface.source(source)}));
  EXPECT_NEAR(surface.scale() * windows.distance(from), expected, round_off);
  const Bounded_path path = windows.path(from);
  EXPECT_NEAR(surface.scale() * path_length(surface.t(), path.locations), expected, round_off);
  EXPECT_LE(surface.scale() * path.lower, expected * (1. + round_off));
  EXPECT_TRUE(is_same_point(surface.t(), path.locations.front(), from));
  EXPECT_TRUE(is_same_point(surface.t(), path.locations.back(), source));
  return path.locations;
}

// Three unit squares in a row, folded by right angles at x = 1 and x = 2.
Triangulation folded_strip()
{
  return {{{0., 0., 0.},
           {1., 0., 0.},
           {1., 0., 1.},
           {0., 0., 1.},
           {0., 1., 0.},
           {1., 1., 0.},
           {1., 1., 1.},
           {0., 1., 1.}},
          {0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6}};
}

TEST(Window_paths, path_across_folds_is_a_line_of_the_plane)
{
  const Array_surface surface(folded_strip());
  // Squares are unfolded along u; the second coordinate remains.
  const auto unfolded = [](const Point& p) -> std::array<double, 2>
  {
    if(p[2] == 0.)
      return {p[0], p[1]};
    return {p[0] == 1. ? 1. + p[2] : 3. - p[0], p[1]};
  };
  // From (1/4, 1/2) in the first square to (3 - 1/8, 1/4) in the last.
  const Surface_location from = surface.in(1, {0.5, 0.25, 0.25}),
                         to = surface.in(4, {0.125, 0.625, 0.25});
  const auto p = unfolded(point_at(surface.t(), from)), q = unfolded(point_at(surface.t(), to));
  const auto path =
      path_of_expected_length(surface, from, to, std::hypot(q[0] - p[0], q[1] - p[1]));
  ASSERT_EQ(path.size(), 7u); // two folds and three diagonals
  for(const Surface_location& location : path)
  {
    const auto r = unfolded(point_at(surface.t(), location));
    EXPECT_NEAR((r[0] - p[0]) * (q[1] - p[1]), (r[1] - p[1]) * (q[0] - p[0]), round_off);
  }
}

// Three unit squares around the corner (1, 1), where the fourth is missing.
Triangulation l_shape()
{
  return {{{0., 0., 0.},
           {1., 0., 0.},
           {2., 0., 0.},
           {0., 1., 0.},
           {1., 1., 0.},
           {2., 1., 0.},
           {0., 2., 0.},
           {1., 2., 0.}},
          {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 3, 4, 7, 3, 7, 6}};
}

TEST(Window_paths, path_bends_at_the_corner_of_the_boundary)
{
  const Array_surface surface(l_shape());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0., 1.);
  int number_of_bends = 0;
  for(int i = 0; i < 100; ++i)
  {
    // From the triangle (1, 0), (2, 1), (1, 1) to the triangle (0, 1), (1, 1), (1, 2).
    const auto barycentric = [&]() -> std::array<double, 3>
    {
      const double a = unit(random), b = (1. - a) * unit(random);
      return {a, b, 1. - a - b};
    };
    const Surface_location from = surface.in(3, barycentric()), to = surface.in(4, barycentric());
    const Point p = point_at(surface.t(), from), q = point_at(surface.t(), to),
                corner = {1., 1., 0.};
    // The segment passes on the left or on the right of the corner.
    const bool is_blocked = (q[0] - p[0]) * (1. - p[1]) - (q[1] - p[1]) * (1. - p[0]) > 0.;
    const double expected = is_blocked ? distance(p, corner) + distance(corner, q) : distance(p, q);
    const auto path = path_of_expected_length(surface, from, to, expected);
    const auto passes_corner = std::any_of(
        path.begin(), path.end(),
        [&](const Surface_location& l) { return vertex_of(surface.t(), l) == surface.vertex(4); });
    EXPECT_EQ(passes_corner, is_blocked) << i;
    number_of_bends += is_blocked;
  }
  EXPECT_GT(number_of_bends, 10);
  EXPECT_LT(number_of_bends, 90);
}

// Between points of the first ring at an angle of at least pi on both sides, the shortest path
// passes through the center of a saddle. No shortest path passes through the apex of a cone.
TEST(Window_paths, path_passes_only_through_saddle_vertices)
{
  constexpr Index n = 16;
  for(const double total : {3., 5., 2. * pi, 7., 9., 12.})
  {
    const Array_surface surface(cone(n, 3, total));
    for(Index i = 0; i <= n; ++i)
      for(const Index other_ring : {0, 1})
      {
        const Index to = 1 + n * other_ring + i % n;
        const double angle = total * double(i) / double(n), radius = other_ring + 1.;
        const auto path = path_of_expected_length(surface, surface.at(1), surface.at(to),
                                                  distance_on_cone(1., radius, angle, total));
        const auto passes_center =
            std::any_of(path.begin(), path.end(),
                        [&](const Surface_location& location)
                        { return vertex_of(surface.t(), location) == surface.vertex(0); });
        if(const double smaller = std::min(angle, total - angle); std::abs(smaller - pi) > 1e-9)
        {
          EXPECT_EQ(passes_center, smaller > pi) << total << ' ' << i;
        }
      }
  }
}

// Returns the location of a point of a flat surface.
Surface_location location_in_plane(const Array_surface& surface, const Triangulation& triangulation,
                                   double x, double y)
{
  for(Index f = 0; f < triangulation.corners.size() / 3; ++f)
  {
    std::array<double, 3> twice_area;
    for(Index k = 0; k < 3; ++k)
    {
      const Point &p = triangulation.points[triangulation.corners[3 * f + (k + 1) % 3]],
                  &q = triangulation.points[triangulation.corners[3 * f + (k + 2) % 3]];
      twice_area[k] = (p[0] - x) * (q[1] - y) - (p[1] - y) * (q[0] - x);
    }
    const double sum = twice_area[0] + twice_area[1] + twice_area[2];
    if(*std::min_element(twice_area.begin(), twice_area.end()) >= 0.)
      return surface.in(f, {twice_area[0] / sum, twice_area[1] / sum, twice_area[2] / sum});
  }
  ADD_FAILURE() << "The point is not on the surface.";
  return {};
}

TEST(Window_paths, both_paths_around_a_square_hole_are_found)
{
  // Nine unit squares without the one in the center.
  Triangulation ring = grid(3, 3, [](double u, double v) { return Point{3. * u, 3. * v, 0.}; });
  ring.corners.erase(ring.corners.begin() + 6 * 4, ring.corners.begin() + 6 * 5);
  const Array_surface surface(ring);
  // The source is on an edge of the triangles around the corners of the hole, or inside of them.
  for(const double y : {3., 2.9, 2.5})
  {
    Window_propagation windows(surface.triangles());
    windows.run({surface.source(location_in_plane(surface, ring, 1.5, y))});
    const auto paths = windows.paths(location_in_plane(surface, ring, 1.5, 0.), 0.);
    EXPECT_EQ(paths.size(), 2u) << y;
    for(const auto& path : paths)
      EXPECT_NEAR(surface.scale() * path_length(surface.t(), path),
                  std::hypot(0.5, 1.) + 1. + std::hypot(0.5, y - 2.), round_off);
  }
}

TEST(Window_paths, path_is_empty_between_components)
{
  const Array_surface surface(disjoint_union(one_triangle(), folded_strip()));
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(0)}));
  EXPECT_TRUE(windows.path(surface.at(5)).locations.empty());
  EXPECT_TRUE(windows.paths(surface.at(5), 0.1).empty());
  EXPECT_EQ(windows.distance(surface.at(5)), infinity);
}

} // namespace Window_paths_test
