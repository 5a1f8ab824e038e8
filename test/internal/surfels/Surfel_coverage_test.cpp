// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_coverage.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace Surfel_coverage_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns the distance to the nearest point divided by the 95th percentile of the spacing, by brute
// force.
double distance_to_spacing_ratio(const std::vector<Vec3>& points, const Vec3& p)
{
  const auto sorted_distances = [&](const Vec3& from)
  {
    std::vector<std::pair<double, std::size_t>> result;
    for(std::size_t i = 0; i < points.size(); ++i)
      result.emplace_back(norm(points[i] - from), i);
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto neighbors = sorted_distances(p);
  std::vector<double> spacings;
  for(std::size_t i = 0; i < 60; ++i)
    spacings.push_back(sorted_distances(points[neighbors[i].second])[6].first);
  std::sort(spacings.begin(), spacings.end());
  return neighbors[0].first / spacings[57];
}

// Random points of the unit square with a hole, whose density increases with x.
Cloud uneven_square()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  Cloud cloud;
  while(cloud.size() < 600)
  {
    const Vec3 p = {1. - std::pow(uniform(random), 3), uniform(random), 0.02 * uniform(random)};
    if(std::hypot(p[0] - 0.6, p[1] - 0.5) > 0.2)
      cloud.add(p, {0., 0., 1.});
  }
  return cloud;
}

TEST(Surfel_coverage, matches_brute_force)
{
  const Cloud square = uneven_square();
  const Surfel_cloud cloud = make_cloud(square.points, square.normals);
  const Surfel_coverage coverage(cloud);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> offset(-0.4, 0.4);
  std::size_t number_of_covered = 0;
  for(int i = 0; i < 200; ++i)
  {
    const Index vertex = Index(random() % cloud.number_of_vertices());
    const Vec3 p = cloud.point[vertex] + Vec3{offset(random), offset(random), offset(random)};
    const double r = distance_to_spacing_ratio(cloud.point, p);
    // No point is close to the threshold.
    ASSERT_GT(std::abs(r - 1.), 1e-6);
    EXPECT_EQ(coverage.is_covered(p, vertex), r < 1.) << r;
    number_of_covered += r < 1.;
    const Vec3 clamped = coverage.clamped_to_coverage(p, vertex);
    EXPECT_LT(distance_to_spacing_ratio(cloud.point, clamped), 1.);
    if(r < 1.)
    {
      EXPECT_EQ(clamped, p);
    }
  }
  EXPECT_GT(number_of_covered, 40u);
  EXPECT_LT(number_of_covered, 160u);
}

TEST(Surfel_coverage, radius_is_neighbor_spacing)
{
  // On a lattice, the spacing is the diagonal of a cell.
  const Surfel_cloud cloud = make_cloud(square_cloud(21).points, square_cloud(21).normals);
  const Surfel_coverage coverage(cloud);
  const double diagonal = std::sqrt(2.) / 20. / cloud.frame.scale;
  for(Index vertex = 0; vertex < cloud.number_of_vertices(); ++vertex)
  {
    const Vec3& p = cloud.point[vertex];
    if(std::max(std::abs(p[0]), std::abs(p[1])) < 0.7 / 2. / cloud.frame.scale)
      EXPECT_NEAR(coverage.radius(vertex), diagonal, 2e-6 * diagonal); // smaller by 1e-6
    else
      EXPECT_GT(coverage.radius(vertex), diagonal * (1. - 2e-6));
  }
}

TEST(Surfel_coverage, handles_few_surfels)
{
  for(const std::size_t n : {std::size_t(1), std::size_t(2), std::size_t(5)})
  {
    const Cloud square = square_cloud(3);
    const Surfel_cloud cloud = make_cloud({square.points.begin(), square.points.begin() + n},
                                          {square.normals.begin(), square.normals.begin() + n});
    const Surfel_coverage coverage(cloud);
    EXPECT_TRUE(coverage.is_covered(cloud.point[0], 0));
    const Vec3 far = {5., 5., 5.};
    EXPECT_FALSE(coverage.is_covered(far, 0));
    EXPECT_TRUE(coverage.is_covered(coverage.clamped_to_coverage(far, 0), 0));
  }
}

TEST(Surfel_coverage, does_not_depend_on_number_of_threads)
{
  const Cloud torus = torus_cloud(5000, 0.4);
  const Surfel_cloud cloud = make_cloud(torus.points, torus.normals);
  const Surfel_coverage one(cloud), three(cloud, 3);
  for(Index vertex = 0; vertex < cloud.number_of_vertices(); ++vertex)
    EXPECT_EQ(one.radius(vertex), three.radius(vertex));
}

} // namespace Surfel_coverage_test
