// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace Graph_search_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double round_off = 1e-12; // sums of some hundred lengths

bool has_edge(const Proximity_graph& graph, Index from, Index to)
{
  const auto begin = graph.target.begin();
  const auto end = begin + graph.begin[from + 1];
  return std::find(begin + graph.begin[from], end, to) != end;
}

// Expects a path of graph edges between two vertices.
void expect_chain(const Proximity_graph& graph, const std::vector<Index>& chain, Index from,
                  Index to)
{
  ASSERT_FALSE(chain.empty());
  EXPECT_EQ(chain.front(), from);
  EXPECT_EQ(chain.back(), to);
  for(std::size_t k = 0; k + 1 < chain.size(); ++k)
    EXPECT_TRUE(has_edge(graph, chain[k], chain[k + 1]));
}

double chain_length(const Surfel_cloud& cloud, const std::vector<Index>& chain)
{
  double sum = 0.;
  for(std::size_t i = 0; i + 1 < chain.size(); ++i)
    sum += norm(cloud.point[chain[i + 1]] - cloud.point[chain[i]]);
  return sum;
}

TEST(Graph_search, agrees_between_search_methods)
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
    visited[0] += search.number_of_visited_vertices();
    EXPECT_EQ(search(a, b, Surfel_search::bidirectional), expected);
    visited[1] += search.number_of_visited_vertices();
    EXPECT_EQ(search(a, b, Surfel_search::a_star), expected);
    visited[2] += search.number_of_visited_vertices();
  }
  EXPECT_LT(visited[1], visited[0]);
  EXPECT_LT(visited[2], visited[1]);
}

TEST(Graph_search, finds_equally_short_paths_on_lattices)
{
  // On a lattice, shortest paths are not unique.
  const Cloud square = square_cloud(30);
  const Surfel_cloud cloud = make_cloud(square.points, square.normals);
  Graph_search search(cloud.graph, cloud.point);
  for(Index a = 0; a < 900; a += 37)
    for(Index b = 0; b < 900; b += 41)
    {
      const double expected = chain_length(cloud, search(a, b, Surfel_search::dijkstra));
      // Sums of at most 60 lengths.
      EXPECT_NEAR(chain_length(cloud, search(a, b, Surfel_search::bidirectional)), expected, 1e-14);
      EXPECT_NEAR(chain_length(cloud, search(a, b, Surfel_search::a_star)), expected, 1e-14);
    }
}

TEST(Graph_search, finds_short_paths_with_coarse_to_fine_search)
{
  const Cloud sphere = ellipsoid_cloud(20000, {1., 1., 1.}), torus = torus_cloud(20000, 0.4);
  const Cloud noisy = with_noise(torus, std::vector<double>(torus.size(), 0.02), 0.5, 1);
  for(const Cloud& surfels : {sphere, torus, noisy})
  {
    const Surfel_cloud cloud = make_cloud(surfels.points, surfels.normals);
    const Vertex_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
    Graph_search search(cloud.graph, cloud.point, &regions);
    std::mt19937 random(1);
    double sum = 0.;
    std::size_t visited = 0, number_visited_by_a_star = 0;
    for(int i = 0; i < 100; ++i)
    {
      const Index a = Index(random() % cloud.number_of_vertices()),
                  b = Index(random() % cloud.number_of_vertices());
      const double shortest_length = chain_length(cloud, search(a, b, Surfel_search::a_star));
      number_visited_by_a_star += search.number_of_visited_vertices();
      const std::vector<Index> chain = search(a, b, Surfel_search::coarse_to_fine);
      visited += search.number_of_visited_vertices();
      expect_chain(cloud.graph, chain, a, b);
      // The length of a coarse path of 16 regions or more has an error of some percent, because
      // each step has an error of 10 %. So the corridor may follow a path that is longer by this.
      const double excess = chain_length(cloud, chain) / shortest_length - 1.;
      EXPECT_LT(excess, 0.06);
      EXPECT_GT(excess, -round_off);
      sum += excess;
    }
    EXPECT_LT(sum / 100., 0.002); // measured: up to 0.0009
    EXPECT_LT(visited, number_visited_by_a_star);
  }
}

TEST(Graph_search, is_guided_on_long_paths)
{
  // Half of the circumference is 350 surfels or 60 regions.
  const Cloud torus = torus_cloud(100000, 0.4);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  const Vertex_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point, &regions);
  std::mt19937 random(1);
  double sum = 0.;
  std::size_t number_of_pairs = 0, visited = 0, number_visited_by_a_star = 0;
  while(number_of_pairs < 30)
  {
    const Index a = Index(random() % cloud.number_of_vertices()),
                b = Index(random() % cloud.number_of_vertices());
    if(norm(cloud.point[a] - cloud.point[b]) * cloud.frame.scale < 2.2)
      continue;
    ++number_of_pairs;
    const double shortest_length = chain_length(cloud, search(a, b, Surfel_search::a_star));
    number_visited_by_a_star += search.number_of_visited_vertices();
    const std::vector<Index> chain = search(a, b, Surfel_search::coarse_to_fine);
    visited += search.number_of_visited_vertices();
    expect_chain(cloud.graph, chain, a, b);
    const double excess = chain_length(cloud, chain) / shortest_length - 1.;
    // The error of the coarse path, and a similar one because distances are scaled by 1.1.
    EXPECT_LT(excess, 0.1);
    EXPECT_GT(excess, -round_off);
    sum += excess;
  }
  EXPECT_LT(sum / 30., 0.015); // measured: 0.006
  EXPECT_LT(3 * visited, number_visited_by_a_star);
}

TEST(Graph_search, is_exact_between_adjacent_vertices)
{
  const Cloud torus = torus_cloud(3000, 0.4);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  const Vertex_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point, &regions);
  for(Index a = 0; a < cloud.number_of_vertices(); a += 10)
    for(Index e = cloud.graph.begin[a]; e < cloud.graph.begin[a + 1]; ++e)
    {
      const Index b = cloud.graph.target[e];
      EXPECT_EQ(search(a, b, Surfel_search::coarse_to_fine), search(a, b, Surfel_search::a_star));
    }
}

TEST(Graph_search, is_empty_when_not_connected)
{
  Cloud two = square_cloud(5);
  for(std::size_t i = 0; i < 25; ++i)
    two.add(two.points[i] + Vec3{9., 0., 0.}, two.normals[i]);
  const Surfel_cloud cloud = make_cloud(two.points, two.normals);
  const Vertex_regions regions = make_regions(cloud.graph, cloud.point, cloud.component);
  Graph_search search(cloud.graph, cloud.point, &regions);
  for(const Surfel_search method : {Surfel_search::dijkstra, Surfel_search::bidirectional,
                                    Surfel_search::a_star, Surfel_search::coarse_to_fine})
  {
    EXPECT_TRUE(search(cloud.internal_vertex[0], cloud.internal_vertex[30], method).empty());
    EXPECT_EQ(search(3, 3, method), std::vector<Index>{3});
  }
}

} // namespace Graph_search_test
