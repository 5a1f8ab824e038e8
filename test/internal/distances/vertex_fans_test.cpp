// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vertex_fans_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Vertex_fans, contain_incident_edges_and_triangles)
{
  // A non-manifold vertex, boundaries, and a closed surface.
  const Triangulation bowtie = {
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}}, {0, 1, 2, 0, 3, 4}};
  for(const Triangulation& triangulation : {bowtie, square(5), icosphere(2)})
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = *surface.triangles();
    const Vertex_fans s = build_vertex_fans(t, true);
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      // The triangles of the one-ring, in its order.
      Index i = t.ring_begin[vertex];
      for(Index j = s.begin[vertex].edge; j < s.begin[vertex + 1].edge; ++j)
      {
        if(!(s.edges[j].flags & Vertex_fans::Fan_edge::has_triangle))
          continue;
        ASSERT_LT(i, t.ring_begin[vertex + 1]);
        const Index corner = t.ring[i++];
        EXPECT_EQ(s.edges[j].vertex, t.corner[next_halfedge(corner)]);
        EXPECT_EQ(s.edges[j + 1].vertex, t.corner[previous_halfedge(corner)]);
        EXPECT_EQ(s.edges[j].length, t.length[corner]);
        EXPECT_EQ(s.edges[j + 1].length, t.length[previous_halfedge(corner)]);
        EXPECT_EQ(s.edges[j].opening, corner_angle(t, corner));
        EXPECT_EQ(fan_position(t, s, vertex, corner).edge, j);
        EXPECT_EQ(fan_position(t, s, vertex, corner).ring, i - 1);
      }
      EXPECT_EQ(i, t.ring_begin[vertex + 1]);
      if(i == t.ring_begin[vertex])
        continue;
      EXPECT_FALSE(s.edges[s.begin[vertex + 1].edge - 1].flags &
                   Vertex_fans::Fan_edge::has_triangle);
    }
  }
}

TEST(Vertex_fans, split_obtuse_corners_into_acute_ones)
{
  // In the plane, unfolded vertices keep their positions.
  const Triangulation plane = grid(
      20, 20,
      [](double u, double v) {
        return Point{u, 0.3 * v, 0.};
      },
      0.24);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  const Vertex_fans s = build_vertex_fans(t, true);
  const auto position_of = [&](Index vertex)
  { return surface.point(surface.caller_vertex(vertex)); };
  // Each split has two halves, each stored at both ends of its base.
  std::vector<int> number_of_views(t.corner.size(), 0);
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    for(Index i = s.begin[vertex].split; i < s.begin[vertex + 1].split; ++i)
    {
      const Vertex_fans::Split& split = s.splits[i];
      ++number_of_views[split.corner];
      EXPECT_LT(corner_angle(t, split.corner)[0], 0.);
      EXPECT_EQ(split.target, t.corner[split.corner]);
      const Index splitting_vertex = split.neighbor == vertex ? split.along : vertex;
      const Point x = position_of(t.corner[split.corner]), position = position_of(splitting_vertex);
      EXPECT_TRUE(split.neighbor == t.corner[next_halfedge(split.corner)] ||
                  split.neighbor == t.corner[previous_halfedge(split.corner)]);
      EXPECT_TRUE(split.neighbor == vertex || split.neighbor == split.along);
      const double round_off = 1e-12; // of a few unfoldings
      EXPECT_NEAR(surface.scale() * split.base,
                  distance(position_of(vertex), position_of(split.along)), round_off);
      const Vec2 to_along = split.apex - Vec2{split.base, 0.};
      EXPECT_NEAR(surface.scale() * norm(split.apex), distance(position_of(vertex), x), round_off);
      EXPECT_NEAR(surface.scale() * norm(to_along), distance(position_of(split.along), x),
                  round_off);
      const Point a = position_of(split.neighbor);
      EXPECT_GT(dot(Point{a[0] - x[0], a[1] - x[1], 0.},
                    Point{position[0] - x[0], position[1] - x[1], 0.}),
                0.);
    }
  std::size_t split_corners = 0;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    const bool is_obtuse_split = number_of_views[corner] != 0;
    EXPECT_TRUE(number_of_views[corner] == 0 || number_of_views[corner] == 4);
    split_corners += is_obtuse_split;
    // No vertex splits a corner if the boundary or the limit of 20 triangles comes first.
    const Point p = position_of(t.corner[corner]);
    const bool is_inner = p[0] > 0.2 && p[0] < 0.8 && p[1] > 0.12 && p[1] < 0.18;
    EXPECT_TRUE(is_obtuse_split || !is_inner || corner_angle(t, corner)[0] >= 0.);
  }
  EXPECT_GT(split_corners, 100u);
  // A split corner is reached only through its halves.
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    Index i = t.ring_begin[vertex];
    for(Index j = s.begin[vertex].edge; j < s.begin[vertex + 1].edge; ++j)
      if(const Index flags = s.edges[j].flags; flags & Vertex_fans::Fan_edge::has_triangle)
      {
        const Index corner = t.ring[i++];
        EXPECT_EQ((flags & Vertex_fans::Fan_edge::is_obtuse_split) != 0,
                  number_of_views[next_halfedge(corner)] != 0);
        EXPECT_EQ((flags & Vertex_fans::Fan_edge::is_next_obtuse_split) != 0,
                  number_of_views[previous_halfedge(corner)] != 0);
      }
  }
}

TEST(Vertex_fans, mark_curved_vertices)
{
  const auto number_of_curved_vertices = [](const Triangulation& triangulation)
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = *surface.triangles();
    const Vertex_fans s = build_vertex_fans(t, false);
    std::size_t result = 0;
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
      result += (s.edges[s.begin[vertex].edge].flags & Vertex_fans::Fan_edge::is_curved) != 0;
    return result;
  };
  EXPECT_EQ(number_of_curved_vertices(square(10, 0.25)), 0u);
  // Vertices on straight creases and on the boundary are not marked; cone and saddle vertices are.
  const auto fold = [](double u, double v) { return Point{u, v, std::abs(u - 0.5)}; };
  EXPECT_EQ(number_of_curved_vertices(grid(10, 10, fold)), 0u);
  EXPECT_EQ(number_of_curved_vertices(cone(8, 3, 5.)), 1u);
  EXPECT_EQ(number_of_curved_vertices(cone(8, 3, 7.)), 1u);
  const Triangulation sphere = icosphere(2);
  EXPECT_EQ(number_of_curved_vertices(sphere), sphere.points.size());
}

TEST(Vertex_fans, have_no_splits_without_obtuse_corners_or_behind_boundary)
{
  EXPECT_TRUE(build_vertex_fans(*Array_surface(icosphere(2)).triangles(), true).splits.empty());
  EXPECT_TRUE(build_vertex_fans(*Array_surface(square(20)).triangles(), true)
                  .splits.empty()); // right angles
  const Triangulation obtuse = {{{0., 0., 0.}, {4., 0., 0.}, {2., 0.5, 0.}}, {0, 1, 2}};
  EXPECT_TRUE(build_vertex_fans(*Array_surface(obtuse).triangles(), true).splits.empty());
}

TEST(Vertex_fans, are_shared_while_referenced)
{
  const Array_surface surface(square(4, 0.2));
  const auto without_splits = shared_vertex_fans(surface.t(), false),
             with_splits = shared_vertex_fans(surface.t(), true);
  EXPECT_EQ(shared_vertex_fans(surface.t(), false), without_splits);
  EXPECT_EQ(shared_vertex_fans(surface.t(), true), with_splits);
  EXPECT_NE(without_splits, with_splits);
  // Copies do not share, because their lengths may be changed.
  Surface_arrays copy = surface.t();
  for(double& length : copy.length)
    length *= 2.;
  EXPECT_EQ(shared_vertex_fans(copy, false)->edges[0].length, 2. * without_splits->edges[0].length);
  Surface_arrays assigned = *Array_surface(square(2)).triangles();
  const auto old_fans = shared_vertex_fans(assigned, false);
  assigned = copy;
  EXPECT_NE(old_fans->edges.size(), without_splits->edges.size());
  EXPECT_EQ(shared_vertex_fans(assigned, false)->edges.size(), without_splits->edges.size());
  std::weak_ptr<const Vertex_fans> unshared = shared_vertex_fans(copy, false);
  EXPECT_TRUE(unshared.expired());
}

} // namespace vertex_fans_test
