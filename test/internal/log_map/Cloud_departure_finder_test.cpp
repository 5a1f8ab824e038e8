// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Cloud_departure_finder.h>

#include "clouds.h"
#include "torus_geodesic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace Cloud_departure_finder_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Cloud_path_finder finder_of(const Cloud& cloud)
{
  return Cloud_path_finder(std::make_shared<const Fitted_cloud>(
      cloud.points, cloud.normals, std::vector<double>(), Cloud_path_options()));
}

// Returns the locations of surfels in the frame of the cloud.
std::vector<Tangent_location> locations_of(const Cloud_path_finder& finder,
                                           const std::vector<Index>& surfels)
{
  std::vector<Tangent_location> result;
  for(const Index i : surfels)
    result.push_back({finder.fitted_cloud()->cloud().internal_vertex[i], {0., 0.}});
  return result;
}

// The fitted surface is the sphere up to round-off errors.
TEST(Cloud_departure_finder, matches_great_circles)
{
  const Cloud cloud = octahedron_sphere(4);
  const Cloud_path_finder finder = finder_of(cloud);
  const double scale = finder.fitted_cloud()->cloud().frame.scale;
  const std::vector<Index> surfels = {0, 7, 100, 200, 300, 400};
  const auto locations = locations_of(finder, surfels);
  const Cloud_departure_finder departures(finder, locations, 1);
  const Projection from = finder.fitted_cloud()->project(locations[1]);
  const auto check = [&](const std::vector<Cloud_departure>& found, const Vec3& p)
  {
    for(std::size_t i = 0; i < surfels.size(); ++i)
    {
      const Vec3& q = cloud.points[surfels[i]];
      const double angle = std::acos(std::min(1., dot(p, q)));
      if(angle > 2.5) // the geodesics of antipodal points are not unique
        continue;
      ASSERT_TRUE(found[i].is_connected);
      const Vec3 across = q - dot(p, q) * p;
      const Vec3 expected = angle / std::max(norm(across), 1e-300) * across;
      // Steps of half the spacing of 0.06 have errors of about 1e-9. Shots end at misses of 1e-11.
      EXPECT_LT(norm(scale * found[i].vector - expected), 1e-7);
      EXPECT_GT(found[i].spreading, 0.);
    }
  };
  const std::vector<Cloud_departure> first = departures(from);
  check(first, cloud.points[7]);
  EXPECT_EQ(norm(first[1].vector), 0.);
  // After a motion.
  Cloud_motion motion;
  const Projection to = departures.move(from, 0.1 * first[2].vector, motion);
  EXPECT_LT(norm(motion.transported(motion.step) - norm(motion.step) * motion.to_x), 1e-12);
  const Vec3 moved = finder.fitted_cloud()->cloud().frame.origin + scale * to.point;
  check(departures(to, first, motion), moved);
  // The result does not depend on the number of threads.
  const auto parallel = Cloud_departure_finder(finder, locations, 3)(from);
  for(std::size_t i = 0; i < surfels.size(); ++i)
    EXPECT_EQ(parallel[i].vector, first[i].vector);
}

// Around a corner of the boundary no geodesic ends at the location: the path is used.
TEST(Cloud_departure_finder, follows_paths_along_the_boundary)
{
  const Cloud full = square_cloud(41);
  Cloud cloud;
  std::vector<Index> surfels;
  for(std::size_t i = 0; i < full.size(); ++i)
  {
    const Vec3& p = full.points[i];
    if(p[0] > 0.31 && p[1] > 0.31)
      continue;
    if(norm(p - Vec3{1., 0.3, 0.}) < 1e-9 || norm(p - Vec3{0.3, 1., 0.}) < 1e-9)
      surfels.push_back(Index(cloud.size()));
    cloud.add(p, full.normals[i]);
  }
  ASSERT_EQ(surfels.size(), 2u);
  const Cloud_path_finder finder = finder_of(cloud);
  const auto locations = locations_of(finder, surfels);
  const auto found =
      Cloud_departure_finder(finder, locations, 1)(finder.fitted_cloud()->project(locations[0]));
  ASSERT_TRUE(found[1].is_connected);
  // The straight distance is 0.99, the path around the corner 1.4. It may leave the surfels by 1.5
  // radii, 0.05.
  EXPECT_NEAR(finder.fitted_cloud()->cloud().frame.scale * norm(found[1].vector), 1.4, 0.1);
}

TEST(Cloud_departure_finder, reports_unconnected_locations)
{
  Cloud cloud = square_cloud(15);
  const std::size_t n = cloud.size();
  for(std::size_t i = 0; i < n; ++i)
    cloud.add(cloud.points[i] + Vec3{5., 0., 0.}, cloud.normals[i]);
  const Cloud_path_finder finder = finder_of(cloud);
  const auto locations = locations_of(finder, {0, Index(n)});
  const auto found =
      Cloud_departure_finder(finder, locations, 1)(finder.fitted_cloud()->project(locations[0]));
  EXPECT_TRUE(found[0].is_connected);
  EXPECT_FALSE(found[1].is_connected);
}

} // namespace Cloud_departure_finder_test
