// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/surfels/vertex_regions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace vertex_regions_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns a torus and a patch of a few surfels, which are not connected.
Surfel_cloud torus_and_patch()
{
  Cloud cloud = torus_cloud(3000, 0.4);
  const Cloud patch = square_cloud(4);
  for(std::size_t i = 0; i < patch.size(); ++i)
    cloud.add(0.1 * patch.points[i] + Vec3{3., 0., 0.}, patch.normals[i]);
  return make_cloud(cloud.points, cloud.normals);
}

TEST(make_regions, regions_are_connected)
{
  const Surfel_cloud cloud = torus_and_patch();
  const Vertex_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  // Regions have 32 vertices. In each of two components, the last region is incomplete.
  EXPECT_NEAR(double(regions.size()), double(cloud.number_of_vertices()) / 32., 2.);
  // Without the edges between regions, the number of connected components is the number of regions.
  std::vector<Index> component(regions.size(), none), reached(cloud.number_of_vertices(), none),
      stack;
  Index number_of_components = 0;
  for(Index seed = 0; seed < reached.size(); ++seed)
  {
    Index& label = component[regions.region[seed]];
    EXPECT_TRUE(label == none || label == cloud.component[seed]);
    label = cloud.component[seed];
    if(reached[seed] != none)
      continue;
    reached[seed] = number_of_components++;
    for(stack = {seed}; !stack.empty();)
    {
      const Index v = stack.back();
      stack.pop_back();
      for(Index e = cloud.graph.begin[v]; e < cloud.graph.begin[v + 1]; ++e)
      {
        const Index other = cloud.graph.target[e];
        if(regions.region[other] != regions.region[v] || reached[other] != none)
          continue;
        reached[other] = reached[v];
        stack.push_back(other);
      }
    }
  }
  EXPECT_EQ(number_of_components, regions.size());
}

TEST(make_regions, edge_lengths_bound_shortest_paths)
{
  const Surfel_cloud cloud = torus_and_patch();
  const Vertex_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point);
  const auto seed = [&](Index region)
  { return cloud.tree.nearest(cloud.point, regions.point[region]); };
  for(Index region = 0; region < regions.size(); ++region)
    for(Index e = regions.graph.begin[region]; e < regions.graph.begin[region + 1]; ++e)
    {
      const Index other = regions.graph.target[e];
      const std::vector<Index> path = search(seed(region), seed(other), Surfel_search::dijkstra);
      double shortest = 0.;
      for(std::size_t i = 0; i + 1 < path.size(); ++i)
        shortest += norm(cloud.point[path[i + 1]] - cloud.point[path[i]]);
      // The edge is the length of a path, so the shortest path is not longer. Both parts of this
      // path are shortest paths, so it is less than twice as long in practice.
      EXPECT_GT(regions.graph.length[e], shortest * (1. - 1e-12));
      EXPECT_LT(regions.graph.length[e], 2. * shortest);
      const auto begin = regions.graph.target.begin() + regions.graph.begin[other],
                 end = regions.graph.target.begin() + regions.graph.begin[other + 1];
      const auto back = std::find(begin, end, region);
      ASSERT_NE(back, end);
      // The reverse edge has the same length up to the order of summation.
      EXPECT_NEAR(regions.graph.length[std::size_t(back - regions.graph.target.begin())],
                  regions.graph.length[e], 1e-14);
    }
}

} // namespace vertex_regions_test
