// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <memory>

namespace vertex_fans_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A non-manifold vertex with boundaries, an open and a closed surface.
std::vector<Triangulation> surfaces()
{
  const Triangulation bowtie = {
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}}, {0, 1, 2, 0, 3, 4}};
  return {bowtie, square(5), icosphere(2)};
}

TEST(Read_fan_edges, writes_incident_edges_and_triangles)
{
  for(const Triangulation& triangulation : surfaces())
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = *surface.triangles();
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      std::vector<Fan_edge> edges(2 * std::size_t(t.ring_begin[vertex + 1] - t.ring_begin[vertex]));
      edges.erase(edges.begin() + (read_fan_edges(t, vertex, edges.data()) - edges.data()),
                  edges.end());
      // The triangles of the one-ring, in its order.
      Index i = t.ring_begin[vertex];
      for(std::size_t j = 0; j < edges.size(); ++j)
      {
        if(edges[j].corner == none)
          continue;
        ASSERT_LT(i, t.ring_begin[vertex + 1]);
        const Index corner = t.ring[i++];
        EXPECT_EQ(edges[j].corner, corner);
        EXPECT_EQ(edges[j].vertex, t.corner[next_halfedge(corner)]);
        EXPECT_EQ(edges[j + 1].vertex, t.corner[previous_halfedge(corner)]);
        EXPECT_EQ(edges[j].length, t.length[corner]);
        EXPECT_EQ(edges[j + 1].length, t.length[previous_halfedge(corner)]);
      }
      EXPECT_EQ(i, t.ring_begin[vertex + 1]);
      if(!edges.empty())
      {
        EXPECT_EQ(edges.back().corner, none);
      }
    }
  }
}

TEST(Vertex_fans, contain_edges_of_all_vertices)
{
  for(const Triangulation& triangulation : surfaces())
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = *surface.triangles();
    const Obtuse_splits splits = split_obtuse_corners(t);
    const Vertex_fans fans = build_vertex_fans(t, splits);
    std::vector<Fan_edge> edges(t.ring.size());
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      const Fan_edge* edge = edges.data();
      const Fan_edge* const end = read_fan_edges(t, vertex, edges.data());
      for(Index i = fans.begin[vertex].edge; i < fans.begin[vertex + 1].edge; ++i, ++edge)
      {
        ASSERT_LT(edge, end);
        EXPECT_EQ(fans.edges[i].vertex, edge->vertex);
        EXPECT_EQ(fans.edges[i].length, edge->length);
        ASSERT_EQ(fans.edges[i].has_triangle(), edge->corner != none);
        if(edge->corner == none)
          continue;
        EXPECT_EQ(fans.edges[i].triangle(), edge->corner / 3);
        EXPECT_EQ(fans.edges[i].opening, corner_angle(t, edge->corner));
        EXPECT_EQ(fans.edges[i].is_split(), splits.is_split(next_halfedge(edge->corner)));
        EXPECT_EQ(fans.edges[i].is_next_split(), splits.is_split(previous_halfedge(edge->corner)));
      }
      EXPECT_EQ(edge, end);
    }
  }
}

// Each half of a split corner is a triangle whose edges at the corner have the lengths of the edge
// to the neighbor and of the straight line to the splitting vertex.
TEST(Vertex_fans, contain_halves_of_split_corners)
{
  const Array_surface surface(square(8, 0.4));
  const Surface_arrays& t = *surface.triangles();
  const Obtuse_splits splits = split_obtuse_corners(t);
  ASSERT_GT(splits.splits.size(), 10u);
  const Vertex_fans fans = build_vertex_fans(t, splits);
  ASSERT_EQ(fans.splits.size(), 4 * splits.splits.size());
  const auto distance = [&](Index a, Index b)
  { return norm(t.point[a] - t.point[b]); }; // the square is plane
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    for(Index i = fans.begin[vertex].split; i < fans.begin[vertex + 1].split; ++i)
    {
      const Obtuse_splits::Half& half = fans.splits[i];
      // Round-off errors of a few operations; lengths are about one.
      constexpr double tolerance = 1e-14;
      EXPECT_TRUE(splits.is_split(half.corner));
      EXPECT_EQ(half.target, t.corner[half.corner]);
      EXPECT_TRUE(half.neighbor == vertex || half.neighbor == half.along);
      EXPECT_NEAR(half.base, distance(vertex, half.along), tolerance);
      EXPECT_NEAR(norm(half.apex), distance(vertex, half.target), tolerance);
      EXPECT_NEAR(norm(half.apex - Vec2{half.base, 0.}), distance(half.along, half.target),
                  tolerance);
    }
}

TEST(Corner_angles, are_those_of_all_corners_and_shared)
{
  const Array_surface surface(square(5, 0.3));
  const Surface_arrays& t = surface.t();
  const auto angles = shared_corner_angles(t);
  EXPECT_EQ(shared_corner_angles(t), angles);
  ASSERT_EQ(angles->size(), t.corner.size());
  for(Index corner = 0; corner < t.corner.size(); ++corner)
    EXPECT_EQ((*angles)[corner], corner_angle(t, corner));
}

TEST(Vertex_fans, are_shared_while_referenced)
{
  const Array_surface surface(square(4, 0.2));
  const auto fans = shared_vertex_fans(surface.t());
  EXPECT_EQ(shared_vertex_fans(surface.t()), fans);
  // Copies do not share, because their lengths may be changed.
  Surface_arrays copy = surface.t();
  for(double& length : copy.length)
    length *= 2.;
  EXPECT_EQ(shared_vertex_fans(copy)->edges[0].length, 2. * fans->edges[0].length);
  Surface_arrays assigned = *Array_surface(square(2)).triangles();
  const auto old_fans = shared_vertex_fans(assigned);
  assigned = copy;
  EXPECT_NE(old_fans->edges.size(), fans->edges.size());
  EXPECT_EQ(shared_vertex_fans(assigned)->edges.size(), fans->edges.size());
  std::weak_ptr<const Vertex_fans> unshared = shared_vertex_fans(copy);
  EXPECT_TRUE(unshared.expired());
}

} // namespace vertex_fans_test
