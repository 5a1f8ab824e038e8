// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Leaf_neighbors.h>

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace Leaf_neighbors_test {

using namespace CGAL::Geodesic_processing::internal;

// Expects the same neighbors and distances, bit by bit, as from queries of the tree.
void expect_same_as_tree(std::vector<Vec3> points, std::size_t k)
{
  std::vector<Index> order;
  const Kd_tree tree(points, order);
  Leaf_neighbors neighbors(points, tree, k);
  ASSERT_EQ(neighbors.size(), std::min(k, points.size()));
  std::vector<Kd_tree::Neighbor> expected;
  std::size_t seen = 0;
  for(Index i = 0, last; i < points.size(); i = last)
  {
    last = neighbors.leaf_end(i);
    ASSERT_GT(last, i);
    const auto& rows = neighbors.find(i, last);
    ASSERT_EQ(rows.size(), (last - i) * neighbors.size());
    for(Index j = i; j < last; ++j, ++seen)
    {
      tree.nearest(points, points[j], k, expected);
      for(std::size_t m = 0; m < expected.size(); ++m)
      {
        const Kd_tree::Neighbor& found = rows[(j - i) * neighbors.size() + m];
        ASSERT_EQ(found.point, expected[m].point) << j << " " << m << " of " << points.size();
        ASSERT_EQ(found.squared_distance, expected[m].squared_distance);
      }
    }
  }
  EXPECT_EQ(seen, points.size());
}

std::vector<Vec3> sphere(std::size_t n, unsigned seed, double size = 1.)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Vec3> result(n);
  for(Vec3& p : result)
    p = size * unit(Vec3{normal(random), normal(random), normal(random)});
  return result;
}

TEST(Leaf_neighbors, agree_with_tree_queries)
{
  for(const std::size_t n : {0, 1, 2, 12, 13, 30, 100, 3000})
    for(const std::size_t k : {0, 1, 2, 7, 21, 60, 200})
      expect_same_as_tree(sphere(n, 1), k);
  for(const double size : {1e-150, 1e-6, 1e6, 1e150}) // squares close to underflow and overflow
    expect_same_as_tree(sphere(1000, 2, size), 21);
}

TEST(Leaf_neighbors, ties_are_resolved_by_index)
{
  std::vector<Vec3> lattice;
  for(int i = 0; i < 40; ++i)
    for(int j = 0; j < 40; ++j)
      lattice.push_back({0.5 * i, 0.5 * j, 0.});
  expect_same_as_tree(lattice, 21);
  std::vector<Vec3> doubled_lattice = lattice;
  doubled_lattice.insert(doubled_lattice.end(), lattice.begin(), lattice.end());
  expect_same_as_tree(doubled_lattice, 21);
  expect_same_as_tree(std::vector<Vec3>(500, {1., 2., 3.}),
                      9); // more coincident points than candidates
}

TEST(Leaf_neighbors, outliers_do_not_change_neighbors)
{
  std::vector<Vec3> points = sphere(3000, 3);
  const std::vector<Vec3> far = sphere(300, 4, 1000.);
  points.insert(points.end(), far.begin(), far.end());
  points.push_back({1e12, 0., 0.});
  expect_same_as_tree(points, 21);
}

TEST(Leaf_neighbors, partial_leaf_query_agrees_with_full)
{
  std::vector<Vec3> points = sphere(100, 5);
  std::vector<Index> order;
  const Kd_tree tree(points, order);
  Leaf_neighbors neighbors(points, tree, 5);
  const Index end = neighbors.leaf_end(0);
  ASSERT_GT(end, 2);
  const std::vector<Kd_tree::Neighbor> full_leaf = neighbors.find(0, end);
  const std::vector<Kd_tree::Neighbor>& subset = neighbors.find(1, 2);
  ASSERT_EQ(subset.size(), 5);
  for(std::size_t m = 0; m < 5; ++m)
    EXPECT_EQ(subset[m].point, full_leaf[5 + m].point);
}

} // namespace Leaf_neighbors_test
