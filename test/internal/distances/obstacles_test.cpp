// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/obstacles.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace obstacles_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(uniform_slowness, ignores_obstacles)
{
  EXPECT_EQ(uniform_slowness({2., infinity, 2.}), 2.);
  EXPECT_EQ(uniform_slowness({infinity, infinity}), 1.);
  EXPECT_EQ(uniform_slowness({2., 2. * (1. + 1e-15)}), 2.);
  EXPECT_EQ(uniform_slowness({2., 2.5, infinity}), std::nullopt);
}

struct Obstacles : testing::Test
{
  Array_surface surface{square(6, 0.24)};
  const Surface_arrays& mesh = surface.t();
  std::vector<double> slowness = std::vector<double>(mesh.number_of_triangles(), 1.);

  Obstacles()
  {
    for(std::size_t f = 0; f < slowness.size(); f += 5)
      slowness[f] = infinity;
  }
  bool is_obstacle(Index h) const { return slowness[h / 3] == infinity; }
};

TEST_F(Obstacles, lose_twins_lengths_and_corners)
{
  const auto copy = without_obstacles(mesh, slowness);
  EXPECT_EQ(copy->corner, mesh.corner);
  EXPECT_EQ(copy->number_of_vertices(), mesh.number_of_vertices());
  for(Index h = 0; h < mesh.corner.size(); ++h)
  {
    const bool is_beside_obstacle =
        is_obstacle(h) || (mesh.twin[h] != none && is_obstacle(mesh.twin[h]));
    EXPECT_EQ(copy->twin[h], is_beside_obstacle ? none : mesh.twin[h]);
    EXPECT_EQ(copy->length[h], is_obstacle(h) ? 0. : mesh.length[h]);
  }
}

TEST_F(Obstacles, leave_complete_rings)
{
  const auto copy = without_obstacles(mesh, slowness);
  for(Index vertex = 0; vertex < mesh.number_of_vertices(); ++vertex)
  {
    std::vector<Index> kept, ring(copy->ring.begin() + copy->ring_begin[vertex],
                                  copy->ring.begin() + copy->ring_begin[vertex + 1]);
    for(Index i = mesh.ring_begin[vertex]; i < mesh.ring_begin[vertex + 1]; ++i)
      if(!is_obstacle(mesh.ring[i]))
        kept.push_back(mesh.ring[i]);
    EXPECT_TRUE(std::is_permutation(ring.begin(), ring.end(), kept.begin(), kept.end()));
    // Within a fan, each corner follows the previous one counterclockwise.
    for(std::size_t i = 1; i < ring.size(); ++i)
    {
      const Index next = copy->twin[previous_halfedge(ring[i - 1])];
      EXPECT_TRUE(next == none || next == ring[i]);
    }
  }
}

TEST_F(Obstacles, move_locations_to_the_other_triangle)
{
  const auto copy = without_obstacles(mesh, slowness);
  int number_moved = 0;
  for(Index h = 0; h < mesh.corner.size(); ++h)
    if(is_obstacle(h) && mesh.twin[h] != none && !is_obstacle(mesh.twin[h]))
    {
      Surface_location location{h / 3, none, {0., 0., 0.}};
      location.barycentric[h % 3] = 0.25;
      location.barycentric[next_halfedge(h) % 3] = 0.75;
      const Surface_location moved = outside_obstacles(mesh, *copy, location);
      EXPECT_EQ(moved.triangle, mesh.twin[h] / 3);
      EXPECT_TRUE(is_same_point(mesh, moved, location));
      ++number_moved;
    }
  EXPECT_GT(number_moved, 10);
  const Surface_location inside = {0, none, {0.2, 0.3, 0.5}}; // triangle 0 is an obstacle
  EXPECT_EQ(outside_obstacles(mesh, *copy, inside).triangle, 0u);
  for(Index vertex = 0; vertex < mesh.number_of_vertices(); ++vertex)
    EXPECT_EQ(vertex_of(*copy, outside_obstacles(mesh, *copy, vertex_location(mesh, vertex))),
              vertex);
}

} // namespace obstacles_test
