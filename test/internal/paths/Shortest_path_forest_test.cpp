// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/Shortest_path_forest.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace shortest_path_forest_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Lengths are sums of some tens of terms.
constexpr double round_off = 1e-12;

TEST(Shortest_path_forest, has_distances_of_dijkstra)
{
  const Array_surface surface(jittered(disjoint_union(square(8), torus(12, 8)), 0.02));
  const Surface_arrays& t = surface.t();
  const Fans all_fans = fans(t);
  const Index root = all_fans.fan[t.ring[t.ring_begin[surface.vertex(20)]]];
  const Shortest_path_forest forest(t, all_fans, root);
  Front front(surface.triangles(), Front_kind::dijkstra);
  front.run({surface.source(20)});
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    const double expected = front.distance(t.corner[corner]),
                 distance = forest.distance(all_fans.fan[corner]);
    EXPECT_EQ(distance < infinity, expected < infinity);
    if(distance < infinity)
    {
      EXPECT_NEAR(distance, expected, round_off);
    }
  }
}

TEST(Shortest_path_forest, loops_have_their_length_and_close_in_edges)
{
  // With three points around the tube, edges of different lengths join the same vertices.
  for(const Triangulation& triangulation : {torus(12, 8), torus(3, 3), cylinder(3, 2, 1., 1.)})
  {
    const Array_surface surface(triangulation);
    const Surface_arrays& t = surface.t();
    const Shortest_path_forest forest(t, fans(t));
    for(Index h = 0; h < t.corner.size(); ++h)
    {
      if(forest.contains(h))
        continue;
      std::vector<Surface_location> from_root = forest.loop_from_root(h), loop = forest.loop(h);
      from_root.push_back(from_root.front());
      loop.push_back(loop.front());
      EXPECT_NEAR(path_length(t, from_root), forest.loop_length(h), round_off);
      EXPECT_LE(path_length(t, loop), forest.loop_length(h) * (1. + round_off));
    }
  }
}

} // namespace shortest_path_forest_test
