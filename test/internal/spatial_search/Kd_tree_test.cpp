// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace CGAL::Geodesic_processing::internal {
namespace Kd_tree_test {

std::vector<Vec3> random_points(std::size_t n, unsigned seed, double step)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<Vec3> points(n);
  for(Vec3& p : points)
    for(double& x : p)
      x = step > 0. ? step * std::round(coordinate(random) / step) : coordinate(random);
  return points;
}

std::vector<Kd_tree::Neighbor> by_distance(const std::vector<Vec3>& points, const Vec3& query)
{
  std::vector<Kd_tree::Neighbor> all(points.size());
  for(Index i = 0; i < points.size(); ++i)
    all[i] = {dot(points[i] - query, points[i] - query), i};
  std::sort(all.begin(), all.end());
  return all;
}

TEST(Kd_tree, returns_permutation_of_points)
{
  const std::vector<Vec3> input = random_points(1000, 1, 0.);
  std::vector<Vec3> points = input;
  std::vector<Index> order;
  const Kd_tree tree(points, order);
  EXPECT_EQ(tree.size(), input.size());
  for(std::size_t i = 0; i < input.size(); ++i)
    EXPECT_EQ(points[i], input[order[i]]);
  std::sort(order.begin(), order.end());
  for(Index i = 0; i < input.size(); ++i)
    EXPECT_EQ(order[i], i);
}

// The points of a coarse grid have many equal distances, and many of them coincide.
TEST(Kd_tree, nearest_points_are_sorted_with_ties_by_index)
{
  for(const double step : {0., 0.25})
    for(const std::size_t n : {1, 2, 12, 13, 100, 777})
    {
      std::vector<Vec3> points = random_points(n, 2, step);
      std::vector<Index> order;
      const Kd_tree tree(points, order);
      std::vector<Kd_tree::Neighbor> found;
      for(const Vec3& query : random_points(50, 3, step))
      {
        const auto all = by_distance(points, query);
        for(const std::size_t k : {1, 5, 30})
        {
          tree.nearest(points, query, k, found);
          ASSERT_EQ(found.size(), std::min(k, n));
          for(std::size_t i = 0; i < found.size(); ++i)
            EXPECT_EQ(found[i].point, all[i].point);
          // The squared distance of the last neighbor as the bound does not change the result.
          const double bound = found.back().squared_distance;
          const auto unbounded = found;
          tree.nearest(points, query, k, found, bound);
          ASSERT_EQ(found.size(), unbounded.size());
          for(std::size_t i = 0; i < found.size(); ++i)
            EXPECT_EQ(found[i].point, unbounded[i].point);
        }
        EXPECT_EQ(tree.nearest(points, query), all[0].point);

        const double squared_radius = all[n / 2].squared_distance;
        std::vector<Index> within, expected;
        tree.within(points, query, squared_radius, within);
        for(const Kd_tree::Neighbor& neighbor : all)
          if(neighbor.squared_distance <= squared_radius)
            expected.push_back(neighbor.point);
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(within, expected);
      }
    }
}

TEST(Kd_tree, scaling_keeps_queries)
{
  std::vector<Vec3> points = random_points(500, 6, 0.);
  std::vector<Index> order;
  Kd_tree tree(points, order);
  const std::vector<Vec3> queries = random_points(50, 7, 0.);
  std::vector<Index> before;
  for(const Vec3& query : queries)
    before.push_back(tree.nearest(points, query));
  tree.scale(32.);
  for(Vec3& p : points)
    p = 32. * p;
  for(std::size_t i = 0; i < queries.size(); ++i)
    EXPECT_EQ(tree.nearest(points, 32. * queries[i]), before[i]);
}

TEST(Kd_tree, is_empty_without_points)
{
  std::vector<Vec3> points;
  std::vector<Index> order;
  const Kd_tree tree(points, order);
  std::vector<Kd_tree::Neighbor> found;
  tree.nearest(points, {0., 0., 0.}, 3, found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(tree.nearest(points, {0., 0., 0.}), none);
}

TEST(Kd_tree, order_is_independent_of_input_order_and_threads)
{
  for(const double step : {0., 0.05})
  {
    std::vector<Vec3> points = random_points(5000, 4, step);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Vec3> shuffled = points;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
    std::vector<Index> order;
    const Kd_tree one(points, order, 1), many(shuffled, order, 3);
    EXPECT_EQ(points, shuffled);
    EXPECT_EQ(one.size(), many.size());
  }
}

} // namespace Kd_tree_test
} // namespace CGAL::Geodesic_processing::internal
