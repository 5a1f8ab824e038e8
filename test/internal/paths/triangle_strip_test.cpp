// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/triangle_strip.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace triangle_strip_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// An L-shaped corridor of width 1 in the plane z = 0, whose reflex corner is vertex 3.
Triangulation corridor()
{
  Triangulation result;
  result.points = {{0., 0., 0.}, {0., 1., 0.}, {3., 0., 0.},
                   {2., 1., 0.}, {3., 3., 0.}, {2., 3., 0.}};
  result.corners = {0, 2, 1, 1, 2, 3, 3, 2, 4, 3, 4, 5};
  return result;
}

// The strip of consecutive faces.
Strip strip_of_faces(const Array_surface& surface, Index first, Index last)
{
  Strip strip;
  strip.triangle = surface.triangle(first);
  for(Index face = first; face < last; ++face)
    for(Index h = 3 * surface.triangle(face); h < 3 * surface.triangle(face) + 3; ++h)
      if(const Index twin = surface.t().twin[h];
         twin != none && twin / 3 == surface.triangle(face + 1))
        strip.append(surface.t(), h);
  return strip;
}

TEST(triangle_strip, unfolding_preserves_distances_in_plane)
{
  const Array_surface surface(corridor());
  const Strip strip = strip_of_faces(surface, 0, 3);
  ASSERT_EQ(strip.halfedges.size(), 3u);
  EXPECT_EQ(strip.last_triangle(surface.t()), surface.triangle(3));
  Unfolded_strip unfolded;
  const double round_off = 1e-14; // of numbers near 3
  // From (0.3, 0.5) to (2.2, 2.8).
  unfolded.unfold(surface.t(), strip, surface.in(0, {0.4, 0.1, 0.5}),
                  surface.in(3, {0.1, 0.2, 0.7}));
  EXPECT_NEAR(norm(unfolded.end) * surface.scale(), std::hypot(1.9, 2.3), round_off);
  for(const Vec2& left : {unfolded.left[1], unfolded.left[2]})
    EXPECT_NEAR(norm(left) * surface.scale(), std::hypot(1.7, 0.5), round_off);
}

TEST(triangle_strip, shortest_path_bends_at_reflex_corner_only)
{
  const Array_surface surface(corridor());
  const Strip strip = strip_of_faces(surface, 0, 3);
  Unfolded_strip unfolded;
  unfolded.unfold(surface.t(), strip, surface.in(0, {0.4, 0.1, 0.5}),
                  surface.in(3, {0.1, 0.2, 0.7}));
  Funnel funnel;
  const std::vector<Bend> bends = funnel.find_bends(surface.t(), strip, unfolded);
  ASSERT_EQ(bends.size(), 1u);
  EXPECT_TRUE(bends[0].is_left);
  const Index h = strip.halfedges[bends[0].strip_index];
  EXPECT_EQ(surface.t().corner[next_halfedge(h)], surface.vertex(3));
}

TEST(triangle_strip, straight_path_has_no_bends)
{
  const Array_surface surface(corridor());
  const Strip strip = strip_of_faces(surface, 0, 1);
  Unfolded_strip unfolded;
  unfolded.unfold(surface.t(), strip, surface.in(0, {0.4, 0.1, 0.5}),
                  surface.in(1, {0.3, 0.3, 0.4}));
  Funnel funnel;
  EXPECT_TRUE(funnel.find_bends(surface.t(), strip, unfolded).empty());
}

TEST(triangle_strip, going_back_removes_last_crossing)
{
  const Array_surface surface(corridor());
  Strip strip = strip_of_faces(surface, 0, 2);
  const Index last = strip.halfedges.back();
  strip.append(surface.t(), surface.t().twin[last]);
  EXPECT_EQ(strip.halfedges, strip_of_faces(surface, 0, 1).halfedges);
}

TEST(triangle_strip, trimming_removes_edges_that_contain_ends)
{
  const Array_surface surface(corridor());
  const Surface_arrays& t = surface.t();
  Strip strip = strip_of_faces(surface, 0, 3);
  // Vertex 2 is an endpoint of the first two edges; the last location is inside the third one.
  strip.trim(t, vertex_location(t, surface.vertex(2)), canonical(t, surface.on(3, 0, 0.5)));
  EXPECT_TRUE(strip.halfedges.empty());
  EXPECT_EQ(strip.triangle, surface.triangle(2));
}

} // namespace triangle_strip_test
