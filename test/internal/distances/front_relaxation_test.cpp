// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_relaxation.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace front_relaxation_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Front_state state_of(const Array_surface& surface, Front_kind kind)
{
  Front_state front;
  front.triangles = surface.triangles();
  front.kind = kind;
  front.vertices.resize(surface.size());
  front.sources.resize(surface.size(), none);
  front.directions.resize(surface.size());
  front.queue = Vertex_queue(surface.size());
  front.offsets = {0.};
  front.has_single_source = true;
  return front;
}

TEST(Front_relaxation, keeps_the_smallest_distance)
{
  const Array_surface surface(square(4));
  Front_state front = state_of(surface, Front_kind::euclidean);
  EXPECT_TRUE(relax(front, 3, {2., {1., 0.}, 0, 0, 0.}, 0));
  EXPECT_FALSE(relax(front, 3, {2.5, {1., 0.}, 1, 0, 0.}, 0));
  EXPECT_TRUE(relax(front, 3, {1.5, {0., 1.}, 2, 0, 0.}, 0));
  EXPECT_EQ(front.vertices[3].distance, 1.5);
  EXPECT_EQ(front.vertices[3].corner, Index(2));
  EXPECT_EQ(front.reached, std::vector<Index>{3});
  EXPECT_EQ(front.queue.front().key, 1.5);
}

TEST(Front_relaxation, equal_distance_replaces_tentative_one)
{
  const Array_surface surface(square(4));
  Front_state front = state_of(surface, Front_kind::euclidean);
  relax(front, 3, {2., {1., 0.}, 0, tentative_flag, 0.5}, 0);
  EXPECT_EQ(front.queue.front().key, 2.5);
  EXPECT_FALSE(relax(front, 3, {2., {1., 0.}, 1, tentative_flag, 0.5}, 0));
  EXPECT_TRUE(relax(front, 3, {2., {1., 0.}, 1, 0, 0.}, 0));
  EXPECT_FALSE(front.vertices[3].state & tentative_flag);
  EXPECT_EQ(front.queue.front().key, 2.);
}

TEST(Front_relaxation, corrects_final_vertices_beyond_round_off)
{
  const Array_surface surface(square(4));
  Front_state front = state_of(surface, Front_kind::euclidean);
  relax(front, 3, {2., {1., 0.}, 0, 0, 0.}, 0);
  front.vertices[3].state |= final_flag;
  EXPECT_FALSE(relax(front, 3, {2. - 1e-13, {1., 0.}, 0, 0, 0.}, 0));
  EXPECT_TRUE(front.corrected_vertices.empty());
  EXPECT_TRUE(relax(front, 3, {1.9, {1., 0.}, 0, 0, 0.}, 0));
  EXPECT_EQ(front.corrected_vertices, std::vector<Index>{3});
  EXPECT_EQ(front.vertices[3].state / correction_unit, Index(1));
}

TEST(Front_relaxation, final_vertices_of_planar_fronts_do_not_change)
{
  const Array_surface surface(square(4));
  Front_state front = state_of(surface, Front_kind::planar);
  relax(front, 3, {2., {1., 0.}, none, 0, 0.}, 0);
  front.vertices[3].state |= final_flag;
  EXPECT_FALSE(relax(front, 3, {1., {1., 0.}, none, 0, 0.}, 0));
}

// On a flat surface, a front that is fitted to an overestimate has wrong descendants. On a curved one
// it is not exact anyway.
TEST(Front_relaxation, small_corrections_invalidate_descendants_on_flat_surfaces_only)
{
  const auto number_of_flat_vertices = [](const Triangulation& triangulation)
  {
    const Array_surface surface(triangulation);
    const Front_state front = state_of(surface, Front_kind::euclidean);
    std::size_t result = 0;
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      EXPECT_TRUE(needs_invalidation(front, vertex, 1.));
      result += needs_invalidation(front, vertex, 1e-9) ? 1 : 0;
    }
    return result;
  };
  const Triangulation sphere = icosphere(2), plane = square(10, 0.25);
  EXPECT_EQ(number_of_flat_vertices(plane), plane.points.size());
  // Vertices on straight creases and on the boundary are flat; cone and saddle vertices are not.
  const auto fold = [](double u, double v) { return Point{u, v, std::abs(u - 0.5)}; };
  const Triangulation folded = grid(10, 10, fold);
  EXPECT_EQ(number_of_flat_vertices(folded), folded.points.size());
  for(const double angle : {5., 7.})
  {
    const Triangulation disk = cone(8, 3, angle);
    EXPECT_EQ(number_of_flat_vertices(disk), disk.points.size() - 1);
  }
  EXPECT_EQ(number_of_flat_vertices(sphere), 0u);
}

} // namespace front_relaxation_test
