// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/noncontractible_loop.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include "core/unfold.h"
#include "distances/Cover.h"
#include "paths/Homotopy.h"

#include "Array_surface.h"
#include "path_checks.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace noncontractible_loop_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Lengths are sums of at most a few thousand terms.
constexpr double round_off = 1e-11;

// Returns the length of the loop, and checks that it is a noncontractible loop through a location.
double loop_length(const Array_surface& surface, const Surface_location& through)
{
  const Surface_arrays& t = surface.t();
  const auto loop = shortest_noncontractible_loop(t, through);
  expect_path_on_surface(t, loop, through, through);
  const auto crossed = crossed_halfedges(t, loop);
  EXPECT_TRUE(crossed.has_value());
  EXPECT_FALSE(Homotopy(t).is_contractible(*crossed));
  return t.scale * path_length(t, loop);
}

// Returns the shortest distance in the universal cover between two copies of a location. The part
// of the cover contains all triangles with a vertex that is closer than `max_length`, and more.
double shortest_length_in_cover(const Array_surface& surface, const Surface_location& through,
                                double max_length)
{
  const Surface_arrays& t = surface.t();
  const Homotopy homotopy(t);
  const Surface_location location = canonical(t, through);
  Cover cover(t, homotopy, location.triangle);
  double factor = 1.;
  for(bool has_grown = true; has_grown;)
  {
    // Grows by one layer within the exact distance.
    has_grown = false;
    const auto arrays = cover.arrays(factor);
    Window_propagation windows(arrays);
    Surface_location source = location;
    source.triangle = 0;
    windows.run({{{source}, 0., 0}});
    const Index size = cover.size();
    for(Index h = 0; h < 3 * size; ++h)
    {
      const double nearest = std::min(windows.distance(arrays->corner[h]),
                                      windows.distance(arrays->corner[next_halfedge(h)]));
      if(cover.is_open(h) && factor * nearest <= max_length / t.scale + t.length[cover.base(h)])
      {
        cover.add_across(h);
        has_grown = true;
      }
    }
    if(has_grown)
      continue;
    double result = infinity;
    for(const Index copy : cover.copies(location.triangle))
    {
      source.triangle = copy;
      if(copy != 0)
        result = std::min(result, windows.distance(canonical(*arrays, source)));
    }
    return t.scale * factor * result;
  }
  return infinity;
}

TEST(Shortest_noncontractible_loop, is_circumference_of_cylinder)
{
  const std::size_t n = 24;
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Array_surface surface(scaled(cylinder(n, 12, 1., 5.), scale));
    std::mt19937 random(1);
    for(int i = 0; i < 10; ++i)
      EXPECT_NEAR(loop_length(surface, random_location(surface.t(), random)) / scale,
                  2. * n * std::sin(pi / n), round_off);
    EXPECT_NEAR(loop_length(surface, surface.at(5 * n + 3)) / scale, 2. * n * std::sin(pi / n),
                round_off);
  }
}

// The loop is the boundary of the convex hull of the point and the hole.
TEST(Shortest_noncontractible_loop, is_taut_around_hole_of_annulus)
{
  const std::size_t n = 36;
  const Array_surface surface(annulus(n, 10, 0.5, 2.));
  std::mt19937 random(1);
  for(int i = 0; i < 20; ++i)
  {
    const Surface_location location = random_location(surface.t(), random);
    const Point p = point_at(surface.t(), location);
    // The hole is a regular polygon. An edge is not on the boundary of the hull if the point is on
    // its outer side. Both ends of the chain of these edges are joined to the point.
    std::vector<Point> hole;
    for(Index k = 0; k < n; ++k)
      hole.push_back(surface.point(Index(10 * n + k)));
    double expected = 0.;
    for(Index k = 0; k < n; ++k)
    {
      const Point &a = hole[k], &b = hole[(k + 1) % n], &c = hole[(k + 2) % n];
      const auto is_visible = [&](const Point& q, const Point& r)
      { return (r[0] - q[0]) * (p[1] - q[1]) - (r[1] - q[1]) * (p[0] - q[0]) < 0.; };
      if(!is_visible(a, b))
        expected += distance(a, b);
      if(is_visible(a, b) != is_visible(b, c))
        expected += distance(b, p);
    }
    EXPECT_NEAR(loop_length(surface, location), expected, round_off);
  }
}

TEST(Shortest_noncontractible_loop, is_shortest_in_universal_cover)
{
  const std::vector<Triangulation> surfaces = {
      torus(9, 6), jittered(torus(12, 9), 0.05), double_torus(1), jittered(double_torus(1), 0.2),
      jittered(blocks(7, 3, 1, [](int i, int j, int) { return j != 1 || i % 2 == 0; }), 0.1),
      // plates with boundary and holes
      jittered(rings(
                   8, 3, [](double s) { return 1. + s; }, [](double s) { return s * s; }),
               0.05)};
  for(const Triangulation& triangulation : surfaces)
  {
    const Array_surface surface(triangulation);
    std::mt19937 random(1);
    for(int i = 0; i < 4; ++i)
    {
      const Surface_location location = i < 2 ? random_location(surface.t(), random)
                                              : surface.at(Index(random() % surface.size()));
      const double length = loop_length(surface, location);
      EXPECT_NEAR(length, shortest_length_in_cover(surface, location, length), round_off);
    }
  }
}

TEST(Shortest_noncontractible_loop, does_not_exist_on_spheres_and_disks)
{
  for(const Triangulation& triangulation :
      {icosphere(2), square(5), one_triangle(), disjoint_union(icosphere(1), torus(12, 8))})
  {
    const Array_surface surface(triangulation);
    EXPECT_TRUE(shortest_noncontractible_loop(surface.t(), surface.at(0)).empty());
  }
}

} // namespace noncontractible_loop_test
