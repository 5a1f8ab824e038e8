// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/degenerate_triangles.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace degenerate_triangles_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A square in which two vertices are on sides of their triangles.
Triangulation flat_triangles()
{
  Triangulation result = square(8);
  result.points[10] = {0.0625, 0., 0.};
  result.points[30] = {0.375, 0.3125, 0.};
  return result;
}

TEST(Degenerate_triangles, satisfy_triangle_inequality_afterwards)
{
  const Array_surface surface(flat_triangles());
  const auto result = without_degenerate_triangles(surface.triangles());
  ASSERT_NE(result, surface.triangles());
  EXPECT_EQ(result->corner, surface.t().corner);
  EXPECT_EQ(result->twin, surface.t().twin);
  for(Index h = 0; h < result->corner.size(); ++h)
  {
    EXPECT_GT(result->length[next_halfedge(h)] + result->length[previous_halfedge(h)],
              result->length[h]);
    // A pass adds at most 1e-15 of the longest edge.
    EXPECT_GE(result->length[h], surface.t().length[h]);
    EXPECT_LT(result->length[h], surface.t().length[h] + 1e-14);
    if(result->twin[h] != none)
    {
      EXPECT_EQ(result->length[result->twin[h]], result->length[h]);
    }
  }
}

TEST(Degenerate_triangles, other_meshes_are_not_copied)
{
  const Array_surface surface(square(8, 0.24));
  EXPECT_EQ(without_degenerate_triangles(surface.triangles()), surface.triangles());
}

// The vertex v = (0, 0) is on the side AB of the triangle above it, which is joined to it by a flat
// triangle. Below v, the wedge DvE is missing, so that paths from D bend at v into all directions
// between those of Dv and vB.
TEST(Degenerate_triangles, paths_spread_from_vertex_on_an_edge)
{
  const Index A = 0, B = 1, v = 2, D = 3, E = 4, first = 5, last = 13;
  Triangulation surface;
  surface.points = {{-1., 0., 0.}, {1., 0., 0.}, {0., 0., 0.}, {-1., -1., 0.}, {1., -1., 0.}};
  for(Index i = first; i <= last; ++i)
    surface.points.push_back({1. - 0.25 * (i - first), 1., 0.});
  surface.corners = {v, A, D, B, v, E, B, A, v, A, B, first};
  for(Index i = first; i < last; ++i)
    surface.corners.insert(surface.corners.end(), {A, i, i + 1});
  const Array_surface arrays(surface);
  Window_propagation windows(arrays.triangles());
  windows.run({arrays.source(D)});
  for(Index i = 0; i < surface.points.size(); ++i)
  {
    const Point& p = surface.points[i];
    const double expected =
        p[0] <= p[1] ? std::hypot(p[0] + 1., p[1] + 1.) : std::sqrt(2.) + std::hypot(p[0], p[1]);
    // The flat triangle has a height of sqrt(1e-15) times its longest edge.
    EXPECT_NEAR(arrays.scale() * windows.distance(arrays.vertex(i)), expected, 7e-8) << i;
  }
}

// A square whose central vertex is in the middle of the opposite edge of one of its triangles.
Triangulation flat_triangle_inside()
{
  Triangulation result = square(8);
  const Index center = 40;
  const std::size_t c =
      std::find(result.corners.begin(), result.corners.end(), center) - result.corners.begin();
  const Point &p = result.points[result.corners[c - c % 3 + (c + 1) % 3]],
              &q = result.points[result.corners[c - c % 3 + (c + 2) % 3]];
  result.points[center] = {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.};
  return result;
}

TEST(Degenerate_triangles, lower_bounds_contain_the_error)
{
  const Triangulation square = flat_triangle_inside();
  const Array_surface surface(square);
  const auto euclidean = [&](Index from, Index to)
  {
    const Point &p = square.points[from], &q = square.points[to];
    return std::hypot(p[0] - q[0], p[1] - q[1]);
  };
  Window_propagation windows(surface.triangles());
  bool is_error_visible = false;
  for(Index from = 0; from < square.points.size(); ++from)
  {
    windows.run({surface.source(from)});
    for(Index to = 0; to < square.points.size(); ++to)
    {
      const double exact = euclidean(from, to);
      const double distance = surface.scale() * windows.distance(surface.vertex(to));
      const double lower = surface.scale() * windows.lower(surface.vertex(to));
      // Round-off errors of sums of ten lengths
      EXPECT_LE(lower, exact * (1. + 1e-14));
      EXPECT_GE(lower, distance - 7e-8); // the height of the triangle, as above
      is_error_visible = is_error_visible || distance > exact * (1. + 1e-12);
      const Surface_location location = surface.at(to);
      EXPECT_EQ(windows.bounds(location).lower * surface.scale(), lower);
      EXPECT_EQ(windows.distance(location) * surface.scale(), distance);
      const Bounded_path path = windows.path(location);
      EXPECT_LE(surface.scale() * path.lower, exact);
    }
  }
  EXPECT_TRUE(is_error_visible);
}

// Two vertices coincide. The edge between them gets the minimum length.
TEST(Degenerate_triangles, lower_bounds_contain_minimum_edge_lengths)
{
  const Array_surface surface(
      {{{0., 0., 0.}, {0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 2, 1, 1, 2, 3}});
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(0)});
  const double distance = surface.scale() * windows.distance(surface.vertex(3));
  EXPECT_GT(distance, 1. + 1e-12);
  EXPECT_LE(surface.scale() * windows.lower(surface.vertex(3)), 1.);
  EXPECT_LE(surface.scale() * windows.path(surface.at(3)).lower, 1.);
}

TEST(Degenerate_triangles, error_is_that_of_thin_triangles)
{
  const auto is_zero = [](const Distance_error& error)
  { return error.excess == 0. && error.shortfall == 0.; };
  EXPECT_TRUE(is_zero(distance_error_of_thin_triangles(Array_surface(square(8, 0.24)).t())));
  const auto lengthened = without_degenerate_triangles(Array_surface(flat_triangles()).triangles());
  const Distance_error error = distance_error_of_thin_triangles(*lengthened);
  // Three to four triangles whose longest edges are between 0.1 and 0.2 of the unit
  EXPECT_GT(error.excess, 1e-9);
  EXPECT_LT(error.excess, 4e-8);
}

// A square whose vertex 5, a corner, is so far away that its triangles are thin.
TEST(Degenerate_triangles, bounds_contain_the_error_of_thin_triangles)
{
  for(double length = 1e3; length < 1e11; length *= 3.)
  {
    Triangulation surface = square(5);
    for(Point& p : surface.points)
      p = {5. * p[0], 5. * p[1], 0.};
    surface.points[5] = {length, 0., 0.};
    const Array_surface arrays(surface);
    Window_propagation windows(arrays.triangles());
    for(Index from = 0; from < arrays.size(); ++from)
    {
      if(from == 5)
        continue;
      windows.run({arrays.source(from)});
      for(Index to = 0; to < arrays.size(); ++to)
      {
        if(to == 5 || (from < 5) != (to < 5))
          continue; // the segment is not on the surface, or crosses the triangles that changed
        const Point &p = surface.points[from], &q = surface.points[to];
        const double exact = std::hypot(p[0] - q[0], p[1] - q[1]),
                     lower = arrays.scale() * windows.lower(arrays.vertex(to)),
                     upper = arrays.scale() * windows.upper(arrays.vertex(to));
        // Round-off errors of sums of ten lengths
        EXPECT_LE(lower, exact * (1. + 1e-13)) << length;
        EXPECT_GE(upper, exact * (1. - 1e-13)) << length;
        EXPECT_EQ(arrays.scale() * windows.bounds(arrays.at(to)).upper, upper);
      }
    }
  }
}

} // namespace degenerate_triangles_test
