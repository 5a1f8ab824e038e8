// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace surfel_estimation_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(surfel_estimation, does_not_depend_on_number_of_threads)
{
  const std::vector<Vec3> points = torus_cloud(3000, 0.4).points;
  const Estimated_surfels one = estimate_surfels(points, 18, 1., 1);
  EXPECT_EQ(one.removed.size(), 30u);
  const Estimated_surfels three = estimate_surfels(points, 18, 1., 3);
  EXPECT_EQ(one.normals, three.normals);
  EXPECT_EQ(one.radii, three.radii);
  EXPECT_EQ(one.removed, three.removed);
}

TEST(surfel_estimation, scales_with_input)
{
  const Cloud cloud = torus_cloud(1000, 0.4);
  const Estimated_surfels unit = estimate_surfels(cloud.points, 18, 0.);
  for(const double scale : {0x1p-20, 0x1p20}) // powers of two cause no round-off errors
  {
    std::vector<Vec3> points = cloud.points;
    for(Vec3& p : points)
      p = scale * p;
    const Estimated_surfels found = estimate_surfels(points, 18, 0.);
    for(std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_EQ(found.radii[i], scale * unit.radii[i]);
      EXPECT_EQ(found.normals[i], unit.normals[i]);
    }
  }
}

TEST(surfel_estimation, handles_coincident_points)
{
  std::vector<Vec3> points(40, {1., 2., 3.});
  for(int i = 0; i < 40; ++i)
    points.push_back({i % 7 - 3., i / 7 - 3., 0.});
  for(const double percentage : {0., 10.})
    for(const Vec3& normal : estimate_surfels(points, 18, percentage).normals)
      EXPECT_NEAR(norm(normal), 1., 1e-14); // round-off error of a unit vector
}

TEST(surfel_estimation, throws_on_too_few_points)
{
  EXPECT_THROW(estimate_surfels({}, 18, 0.), Unsupported_surface_error);
  EXPECT_THROW(estimate_surfels({{0., 0., 0.}}, 5, 0.), Invalid_argument_error);
  EXPECT_THROW(estimate_surfels(torus_cloud(100, 0.4).points, 18, 90.), Unsupported_surface_error);
}

} // namespace surfel_estimation_test
