// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace base_points_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

Base_points farthest_base_points(const Array_surface& surface, std::size_t number,
                                 std::size_t nearest)
{
  const Front front(surface.triangles(), Front_kind::euclidean);
  Sampling sampling(surface.triangles(), front, Sample_location::vertex);
  Sampling_options options;
  options.number_of_samples = number;
  sample_farthest_points(sampling, options, [](double) {});
  return nearest_base_points(surface.t(), sampling, front, nearest);
}

double euclidean_distance(const Array_surface& surface, Index a, Index b)
{
  return distance(surface.point(surface.caller_vertex(a)), surface.point(surface.caller_vertex(b)));
}

TEST(base_points, spacing_is_below_surface_width)
{
  for(const double scale : {1e-9, 1., 1e6})
  {
    const auto strip = [&](std::size_t length)
    {
      const auto position = [&](double u, double v) { return Point{double(length) * u, v, 0.}; };
      return Array_surface(scaled(grid(length, 1, position), scale));
    };
    EXPECT_EQ(suitable_number_of_base_points(Array_surface(scaled(square(10), scale)).t()), 200u);
    EXPECT_EQ(suitable_number_of_base_points(strip(100).t()), 200u);
    // The mean width is 800 / 802. A hexagon with 0.85 of that between opposite edges has the area
    // 0.6226.
    EXPECT_EQ(suitable_number_of_base_points(strip(400).t()), 642u);
    EXPECT_EQ(suitable_number_of_base_points(strip(2000).t()), 1000u);
    EXPECT_EQ(suitable_number_of_base_points(Array_surface(scaled(tetrahedron(), scale)).t()),
              200u);
  }
}

TEST(base_points, stores_nearest_points_of_each_vertex)
{
  const Array_surface surface(square(40, 0.25));
  const Base_points base = farthest_base_points(surface, 60, 12);
  ASSERT_EQ(base.size(), 60u);
  ASSERT_EQ(base.number_of_nearest, 12u);
  for(Index vertex = 0; vertex < surface.size(); ++vertex)
  {
    std::vector<double> expected;
    for(const Index point : base.vertices)
      expected.push_back(euclidean_distance(surface, vertex, point));
    std::sort(expected.begin(), expected.end());
    for(std::size_t k = 0; k < 12; ++k)
    {
      // At its end, a front can be too long by some thousandths of an edge, but not farther inside.
      const double error = k < 8 ? 1e-9 : 0.01 / 40.;
      EXPECT_NEAR(surface.scale() * base.distance[12 * vertex + k], expected[k], error);
      EXPECT_NEAR(
          euclidean_distance(surface, vertex, base.vertices[base.neighbor[12 * vertex + k]]),
          expected[k], error);
    }
  }
}

TEST(base_points, pair_distances_of_close_points_are_exact)
{
  const Array_surface surface(square(40, 0.25));
  const Base_points base = farthest_base_points(surface, 60, 16);
  for(Index vertex = 0; vertex < surface.size(); ++vertex)
    for(std::size_t a = 0; a < 8; ++a)
      for(std::size_t b = 0; b < 8; ++b)
      {
        const Index i = base.neighbor[16 * vertex + a], j = base.neighbor[16 * vertex + b];
        // Sums of distances in a plane; measured are 2e-16.
        EXPECT_NEAR(surface.scale() * base.distance_between(i, j),
                    euclidean_distance(surface, base.vertices[i], base.vertices[j]), 1e-9);
        EXPECT_EQ(base.distance_between(i, j), base.distance_between(j, i));
      }
}

TEST(base_points, few_points_are_all_stored)
{
  const Array_surface surface(square(10, 0.25));
  const Base_points base = farthest_base_points(surface, 5, 16);
  EXPECT_EQ(base.number_of_nearest, 5u);
  EXPECT_TRUE(std::none_of(base.distance.begin(), base.distance.end(),
                           [](double d) { return d == infinity; }));
  for(Index i = 0; i < 5; ++i)
    for(Index j = 0; j < 5; ++j)
      // Fronts are exact in the plane.
      EXPECT_NEAR(surface.scale() * base.distance_between(i, j),
                  euclidean_distance(surface, base.vertices[i], base.vertices[j]), 1e-12);
}

TEST(base_points, distance_between_components_is_infinite)
{
  const Triangulation component = square(6, 0.2);
  Triangulation other = component;
  for(Point& p : other.points)
    p[2] += 3.;
  const Array_surface surface(disjoint_union(component, other));
  const Base_points base = farthest_base_points(surface, 10, 8);
  std::size_t number_of_infinite_pairs = 0;
  for(Index i = 0; i < 10; ++i)
    for(Index j = 0; j < 10; ++j)
      number_of_infinite_pairs += base.distance_between(i, j) == infinity;
  EXPECT_EQ(number_of_infinite_pairs, 50u); // five samples each
  EXPECT_GT(std::count(base.neighbor.begin(), base.neighbor.end(), none), 0);
}

TEST(base_points, is_empty_when_cancelled)
{
  const Array_surface surface(square(6, 0.2));
  const Front front(surface.triangles(), Front_kind::euclidean);
  Sampling sampling(surface.triangles(), front, Sample_location::vertex);
  sampling.add(surface.at(0));
  EXPECT_EQ(
      nearest_base_points(surface.t(), sampling, front, 3, [](double) { return false; }).size(),
      0u);
}

} // namespace base_points_test
