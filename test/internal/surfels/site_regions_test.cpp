// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/surfels/site_regions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A torus, and beside it a few surfels that are not joined to it.
Surfel_cloud torus_and_patch()
{
  Cloud cloud = torus_cloud(3000, 0.4);
  const Cloud patch = square_cloud(4);
  for(std::size_t i = 0; i < patch.size(); ++i)
    cloud.add(0.1 * patch.points[i] + Spatial{3., 0., 0.}, patch.normals[i]);
  return make_cloud(cloud.points, cloud.normals);
}

TEST(make_regions, makes_connected_ones_of_one_component)
{
  const Surfel_cloud cloud = torus_and_patch();
  const Site_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  EXPECT_NEAR(double(regions.size()), double(cloud.number_of_sites()) / 32., 2.);
  // Without the arcs between regions there are as many components as regions.
  std::vector<Index> component(regions.size(), none), reached(cloud.number_of_sites(), none), stack;
  Index parts = 0;
  for(Index seed = 0; seed < reached.size(); ++seed)
  {
    Index& label = component[regions.region[seed]];
    EXPECT_TRUE(label == none || label == cloud.component[seed]);
    label = cloud.component[seed];
    if(reached[seed] != none)
      continue;
    reached[seed] = parts++;
    for(stack = {seed}; !stack.empty();)
    {
      const Index site = stack.back();
      stack.pop_back();
      for(Index arc = cloud.graph.first[site]; arc < cloud.graph.first[site + 1]; ++arc)
      {
        const Index other = cloud.graph.target[arc];
        if(regions.region[other] != regions.region[site] || reached[other] != none)
          continue;
        reached[other] = reached[site];
        stack.push_back(other);
      }
    }
  }
  EXPECT_EQ(parts, regions.size());
}

TEST(make_regions, joins_leaders_by_chains)
{
  const Surfel_cloud cloud = torus_and_patch();
  const Site_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point);
  const auto leader = [&](Index region)
  { return cloud.tree.nearest(cloud.point, regions.point[region]); };
  for(Index region = 0; region < regions.size(); ++region)
    for(Index arc = regions.graph.first[region]; arc < regions.graph.first[region + 1]; ++arc)
    {
      const Index other = regions.graph.target[arc];
      const std::vector<Index> chain =
          search(leader(region), leader(other), Surfel_search::dijkstra);
      double shortest = 0.;
      for(std::size_t i = 0; i + 1 < chain.size(); ++i)
        shortest += norm(cloud.point[chain[i + 1]] - cloud.point[chain[i]]);
      // No chain is shorter; and this one, both of whose halves are shortest, not twice as long.
      EXPECT_GT(regions.graph.length[arc], shortest * (1. - 1e-12));
      EXPECT_LT(regions.graph.length[arc], 2. * shortest);
      // The same from the other side, but for the order of a sum.
      const auto begin = regions.graph.target.begin() + regions.graph.first[other],
                 end = regions.graph.target.begin() + regions.graph.first[other + 1];
      const auto back = std::find(begin, end, region);
      ASSERT_NE(back, end);
      EXPECT_NEAR(regions.graph.length[std::size_t(back - regions.graph.target.begin())],
                  regions.graph.length[arc], 1e-14);
    }
}

} // namespace
