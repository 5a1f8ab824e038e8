// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/vertex_fans.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <memory>

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
    const Vertex_fans s = build_vertex_fans(t);
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      // The triangles of the one-ring, in its order.
      Index i = t.ring_begin[vertex];
      for(Index j = s.begin[vertex]; j < s.begin[vertex + 1]; ++j)
      {
        if(s.edges[j].corner == none)
          continue;
        ASSERT_LT(i, t.ring_begin[vertex + 1]);
        const Index corner = t.ring[i++];
        EXPECT_EQ(s.edges[j].corner, corner);
        EXPECT_EQ(s.edges[j].vertex, t.corner[next_halfedge(corner)]);
        EXPECT_EQ(s.edges[j + 1].vertex, t.corner[previous_halfedge(corner)]);
        EXPECT_EQ(s.edges[j].length, t.length[corner]);
        EXPECT_EQ(s.edges[j + 1].length, t.length[previous_halfedge(corner)]);
        EXPECT_EQ(s.edges[j].opening, corner_angle(t, corner));
      }
      EXPECT_EQ(i, t.ring_begin[vertex + 1]);
      if(i != t.ring_begin[vertex])
      {
        EXPECT_EQ(s.edges[s.begin[vertex + 1] - 1].corner, none);
      }
    }
  }
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
