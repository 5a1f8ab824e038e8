// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/surfel_geodesic_path.h>

#include <CGAL/Geodesic_processing/make_domain.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace surfel_geodesic_path_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());

TEST(surfel_geodesic_path, is_straight_in_plane)
{
  const Surfels surfels = flat_surfels(1500);
  const auto path = GP::surfel_geodesic_path(surfels, std::size_t(4), std::size_t(5), maps);
  const double expected = std::sqrt(CGAL::squared_distance(surfels[4].first, surfels[5].first));
  // Round-off errors: all fits are the plane of the surfels.
  EXPECT_NEAR(path.front_distance, expected, 1e-12 * expected);
}

TEST(surfel_geodesic_path, is_independent_of_number_of_threads)
{
  const Surfels surfels = sphere_surfels(3);
  const GP::Surfel_path_finder<Surfels> finder(surfels, maps);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for(std::size_t i = 0; i < 40; ++i)
    pairs.emplace_back(i, 600 - 7 * i);
  const auto one = GP::surfel_geodesic_paths(finder, pairs),
             three = GP::surfel_geodesic_paths<CGAL::Parallel_tag>(
                 finder, pairs, GP::parameters::number_of_threads(3u));
  auto copy = finder;
  ASSERT_EQ(one.size(), pairs.size());
  for(std::size_t i = 0; i < pairs.size(); ++i)
  {
    EXPECT_EQ(one[i].points, three[i].points);
    EXPECT_EQ(one[i].points, copy(pairs[i].first, pairs[i].second).points);
    EXPECT_EQ(one[i].front_distance, three[i].front_distance);
  }
}

TEST(surfel_geodesic_path, is_empty_between_components)
{
  Surfels surfels = flat_surfels(200);
  for(std::size_t i = 0; i < 200; ++i)
    surfels.emplace_back(surfels[i].first + Kernel::Vector_3(9., 0., 0.), surfels[i].second);
  const auto path = GP::surfel_geodesic_path(surfels, std::size_t(0), std::size_t(250), maps);
  EXPECT_TRUE(path.empty());
  EXPECT_TRUE(path.points.empty());
  EXPECT_EQ(path.front_distance, std::numeric_limits<double>::infinity());
}

TEST(surfel_geodesic_path, throws_on_invalid_surfels)
{
  const Surfels surfels = flat_surfels(100);
  EXPECT_THROW(GP::surfel_geodesic_path(surfels, std::size_t(0), std::size_t(100), maps),
               GP::Invalid_argument_error);
}

TEST(surfel_geodesic_path, accepts_domain)
{
  const Surfels surfels = sphere_surfels(2);
  const auto path = GP::surfel_geodesic_path(surfels, std::size_t(4), std::size_t(50), maps);
  const auto of_domain =
      GP::surfel_geodesic_path(GP::make_domain(surfels, maps), std::size_t(4), std::size_t(50));
  ASSERT_EQ(of_domain.points.size(), path.points.size());
  for(std::size_t i = 0; i < path.points.size(); ++i) // round-off errors of the domain's scale
    // The square of a round-off error.
    EXPECT_LT(CGAL::squared_distance(of_domain.points[i], path.points[i]), 1e-26);
}

} // namespace surfel_geodesic_path_test
