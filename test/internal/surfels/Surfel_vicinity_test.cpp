// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_vicinity.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The distance from the nearest point over the 95th percentile of the spacing, by sorting all points.
double ratio(const std::vector<Spatial>& points, const Spatial& p)
{
  const auto sorted = [&](const Spatial& from)
  {
    std::vector<std::pair<double, std::size_t>> result;
    for(std::size_t i = 0; i < points.size(); ++i)
      result.emplace_back(norm(points[i] - from), i);
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto near = sorted(p);
  std::vector<double> there;
  for(std::size_t i = 0; i < 60; ++i)
    there.push_back(sorted(points[near[i].second])[6].first);
  std::sort(there.begin(), there.end());
  return near[0].first / there[57];
}

// Random points of the unit square, ever denser to the right, with a hole.
Cloud uneven_square()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0., 1.);
  Cloud cloud;
  while(cloud.size() < 600)
  {
    const Spatial p = {1. - std::pow(share(random), 3), share(random), 0.02 * share(random)};
    if(std::hypot(p[0] - 0.6, p[1] - 0.5) > 0.2)
      cloud.add(p, {0., 0., 1.});
  }
  return cloud;
}

TEST(Surfel_vicinity, knows_what_is_near)
{
  const Cloud square = uneven_square();
  const Surfel_cloud cloud = make_cloud(square.points, square.normals);
  const Surfel_vicinity vicinity(cloud);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> offset(-0.4, 0.4);
  std::size_t number_near = 0;
  for(int i = 0; i < 200; ++i)
  {
    const Index site = Index(random() % cloud.number_of_sites());
    const Spatial p = cloud.point[site] + Spatial{offset(random), offset(random), offset(random)};
    const double r = ratio(cloud.point, p);
    // What is near is so by a millionth.
    ASSERT_GT(std::abs(r - 1.), 1e-6);
    EXPECT_EQ(vicinity.is_near(p, site), r < 1.) << r;
    number_near += r < 1.;
    const Spatial drawn = vicinity.drawn_near(p, site);
    EXPECT_LT(ratio(cloud.point, drawn), 1.);
    if(r < 1.)
    {
      EXPECT_EQ(drawn, p);
    }
  }
  EXPECT_GT(number_near, 40u);
  EXPECT_LT(number_near, 160u);
}

TEST(Surfel_vicinity, reaches_as_far_as_neighbors_are)
{
  // On a lattice the sixth neighbour is a diagonal away.
  const Surfel_cloud cloud = make_cloud(square_cloud(21).points, square_cloud(21).normals);
  const Surfel_vicinity vicinity(cloud);
  const double diagonal = std::sqrt(2.) / 20. / cloud.frame.scale;
  for(Index site = 0; site < cloud.number_of_sites(); ++site)
  {
    const Spatial& p = cloud.point[site];
    if(std::max(std::abs(p[0]), std::abs(p[1])) < 0.7 / 2. / cloud.frame.scale)
      EXPECT_NEAR(vicinity.reach(site), diagonal, 2e-6 * diagonal); // less by a millionth
    else
      EXPECT_GT(vicinity.reach(site), diagonal * (1. - 2e-6));
  }
}

TEST(Surfel_vicinity, takes_the_fewest_surfels)
{
  for(const std::size_t n : {std::size_t(1), std::size_t(2), std::size_t(5)})
  {
    const Cloud square = square_cloud(3);
    const Surfel_cloud cloud = make_cloud({square.points.begin(), square.points.begin() + n},
                                          {square.normals.begin(), square.normals.begin() + n});
    const Surfel_vicinity vicinity(cloud);
    EXPECT_TRUE(vicinity.is_near(cloud.point[0], 0));
    const Spatial far = {5., 5., 5.};
    EXPECT_FALSE(vicinity.is_near(far, 0));
    EXPECT_TRUE(vicinity.is_near(vicinity.drawn_near(far, 0), 0));
  }
}

TEST(Surfel_vicinity, is_the_same_on_any_number_of_threads)
{
  const Cloud torus = torus_cloud(5000, 0.4);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  const Surfel_vicinity one(cloud), three(cloud, 3);
  for(Index site = 0; site < cloud.number_of_sites(); ++site)
    EXPECT_EQ(one.reach(site), three.reach(site));
}

} // namespace
