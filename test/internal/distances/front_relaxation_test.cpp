// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_relaxation.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

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
  front.fans = shared_vertex_fans(surface.t(), false);
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

} // namespace front_relaxation_test
