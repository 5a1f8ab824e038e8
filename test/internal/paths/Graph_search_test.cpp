// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double rounding = 1e-12; // sums of some hundreds of lengths

bool has_arc(const Site_graph& graph, Index from, Index to)
{
  const auto begin = graph.target.begin();
  const auto end = begin + graph.first[from + 1];
  return std::find(begin + graph.first[from], end, to) != end;
}

// Of arcs, between these two.
void expect_chain(const Site_graph& graph, const std::vector<Index>& chain, Index from, Index to)
{
  ASSERT_FALSE(chain.empty());
  EXPECT_EQ(chain.front(), from);
  EXPECT_EQ(chain.back(), to);
  for(std::size_t k = 0; k + 1 < chain.size(); ++k)
    EXPECT_TRUE(has_arc(graph, chain[k], chain[k + 1]));
}

double length(const Surfel_cloud& cloud, const std::vector<Index>& chain)
{
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    sum += norm(cloud.point[chain[i + 1]] - cloud.point[chain[i]]);
  return sum;
}

TEST(Graph_search, finds_the_same_chains_by_all_methods)
{
  const Cloud torus = with_noise(torus_cloud(3000, 0.4), std::vector<double>(3200, 0.05), 0.2, 1);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  Graph_search search(cloud.graph, cloud.point);
  std::mt19937 random(1);
  std::size_t visited[3] = {0, 0, 0};
  for(int i = 0; i < 100; ++i)
  {
    const Index a = Index(random() % torus.size()), b = Index(random() % torus.size());
    const std::vector<Index> expected = search(a, b, Surfel_search::dijkstra);
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(expected.front(), a);
    EXPECT_EQ(expected.back(), b);
    visited[0] += search.visited();
    EXPECT_EQ(search(a, b, Surfel_search::bidirectional), expected);
    visited[1] += search.visited();
    EXPECT_EQ(search(a, b, Surfel_search::a_star), expected);
    visited[2] += search.visited();
  }
  EXPECT_LT(visited[1], visited[0]);
  EXPECT_LT(visited[2], visited[1]);
}

TEST(Graph_search, finds_chains_of_one_length_on_lattices)
{
  // Many chains are as short there.
  const Cloud square = square_cloud(30);
  const Surfel_cloud cloud = make_cloud(square.points, square.normals);
  Graph_search search(cloud.graph, cloud.point);
  for(Index a = 0; a < 900; a += 37)
    for(Index b = 0; b < 900; b += 41)
    {
      const double expected = length(cloud, search(a, b, Surfel_search::dijkstra));
      // Sums of at most 60 roundings.
      EXPECT_NEAR(length(cloud, search(a, b, Surfel_search::bidirectional)), expected, 1e-14);
      EXPECT_NEAR(length(cloud, search(a, b, Surfel_search::a_star)), expected, 1e-14);
    }
}

TEST(Graph_search, finds_short_chains_from_coarse_to_fine)
{
  const Cloud sphere = ellipsoid_cloud(20000, {1., 1., 1.}), torus = torus_cloud(20000, 0.4);
  const Cloud noisy = with_noise(torus, std::vector<double>(torus.size(), 0.02), 0.5, 1);
  for(const Cloud& surfels : {sphere, torus, noisy})
  {
    const Surfel_cloud cloud = make_cloud(surfels.points, surfels.normals);
    const Site_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
    Graph_search search(cloud.graph, cloud.point, &regions);
    std::mt19937 random(1);
    double sum = 0.;
    std::size_t visited = 0, visited_all = 0;
    for(int i = 0; i < 100; ++i)
    {
      const Index a = Index(random() % cloud.number_of_sites()),
                  b = Index(random() % cloud.number_of_sites());
      const double shortest = length(cloud, search(a, b, Surfel_search::a_star));
      visited_all += search.visited();
      const std::vector<Index> chain = search(a, b, Surfel_search::coarse_to_fine);
      visited += search.visited();
      expect_chain(cloud.graph, chain, a, b);
      // Lengths of 16 regions or more, each a tenth too long or too short, are known to some percent:
      // by so much may the chain be the shortest of another way round.
      const double excess = length(cloud, chain) / shortest - 1.;
      EXPECT_LT(excess, 0.06);
      EXPECT_GT(excess, -rounding);
      sum += excess;
    }
    EXPECT_LT(sum / 100., 0.005);
    EXPECT_LT(visited, visited_all);
  }
}

TEST(Graph_search, is_led_along_long_ways)
{
  // Once half around are 350 surfels, or 60 regions.
  const Cloud torus = torus_cloud(100000, 0.4);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  const Site_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point, &regions);
  std::mt19937 random(1);
  double sum = 0.;
  std::size_t number = 0, visited = 0, visited_all = 0;
  while(number < 30)
  {
    const Index a = Index(random() % cloud.number_of_sites()),
                b = Index(random() % cloud.number_of_sites());
    if(norm(cloud.point[a] - cloud.point[b]) * cloud.frame.scale < 2.2)
      continue;
    ++number;
    const double shortest = length(cloud, search(a, b, Surfel_search::a_star));
    visited_all += search.visited();
    const std::vector<Index> chain = search(a, b, Surfel_search::coarse_to_fine);
    visited += search.visited();
    expect_chain(cloud.graph, chain, a, b);
    const double excess = length(cloud, chain) / shortest - 1.;
    // What the chain of leaders is too long by, and as much because distances count a tenth more.
    EXPECT_LT(excess, 0.1);
    EXPECT_GT(excess, -rounding);
    sum += excess;
  }
  EXPECT_LT(sum / 30., 0.03);
  EXPECT_LT(3 * visited, visited_all);
}

TEST(Graph_search, leaves_nothing_out_between_near_sites)
{
  const Cloud torus = torus_cloud(3000, 0.4);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  const Site_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point, &regions);
  for(Index a = 0; a < cloud.number_of_sites(); a += 10)
    for(Index arc = cloud.graph.first[a]; arc < cloud.graph.first[a + 1]; ++arc)
    {
      const Index b = cloud.graph.target[arc];
      EXPECT_EQ(search(a, b, Surfel_search::coarse_to_fine), search(a, b, Surfel_search::a_star));
    }
}

TEST(Graph_search, says_when_there_is_no_chain)
{
  Cloud two = square_cloud(5);
  for(std::size_t i = 0; i < 25; ++i)
    two.add(two.points[i] + Spatial{9., 0., 0.}, two.normals[i]);
  const Surfel_cloud cloud = make_cloud(two.points, two.normals);
  const Site_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point, &regions);
  for(const Surfel_search method : {Surfel_search::dijkstra, Surfel_search::bidirectional,
                                    Surfel_search::a_star, Surfel_search::coarse_to_fine})
  {
    EXPECT_TRUE(search(cloud.site_of_surfel[0], cloud.site_of_surfel[30], method).empty());
    EXPECT_EQ(search(3, 3, method), std::vector<Index>{3});
  }
}

} // namespace
