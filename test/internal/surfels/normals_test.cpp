// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/normals.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace normals_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(normals, converge_on_a_torus)
{
  double error[2];
  for(const std::size_t n : {1000u, 4000u})
  {
    const Cloud cloud = torus_cloud(n, 0.4);
    const std::vector<Vec3> normals = estimate_normals(cloud.points, 18, true);
    double& largest = error[n == 4000u];
    largest = 0.;
    for(std::size_t i = 0; i < normals.size(); ++i)
      largest = std::max(largest, norm(normals[i] - cloud.normals[i]));
  }
  // The error of a quadric fit is proportional to the square of its radius, which is halved.
  EXPECT_LT(error[0], 0.1);
  EXPECT_LT(error[1], 0.35 * error[0]);
}

TEST(normals, are_oriented_consistently_in_each_component)
{
  // The spheres are too far apart to be connected. The highest point of each has an upward normal,
  // so all normals point outward.
  const Cloud sphere = ellipsoid_cloud(500, {1., 1., 1.});
  std::vector<Vec3> points;
  for(const double offset : {-10., 0., 10.})
    for(const Vec3& p : sphere.points)
      points.push_back(p + Vec3{offset, 0., 0.5 * offset});
  const std::vector<Vec3> normals = estimate_normals(points, 18, true);
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_GT(dot(normals[i], sphere.normals[i % 500]), 0.99) << i; // up to the error of the fit
}

TEST(normals, are_equal_at_coincident_points)
{
  std::vector<Vec3> points = torus_cloud(500, 0.4).points;
  const std::vector<Vec3> once = estimate_normals(points, 18, true);
  points.insert(points.end(), 40, points[7]);
  const std::vector<Vec3> often = estimate_normals(points, 18, true);
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(often[i], once[i < once.size() ? i : 7]) << i;
}

TEST(normals, are_unit_vectors_for_degenerate_input)
{
  const std::vector<std::vector<Vec3>> clouds = {
      {},
      {{1., 2., 3.}},
      {{0., 0., 0.}, {1., 1., 1.}},
      std::vector<Vec3>(50, {1e8, 0., 0.}),
      {{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {3., 0., 0.}, {1e300, 0., 0.}}};
  for(const std::vector<Vec3>& points : clouds)
  {
    const std::vector<Vec3> normals = estimate_normals(points, 18, true);
    EXPECT_EQ(normals.size(), points.size());
    for(const Vec3& normal : normals)
      EXPECT_NEAR(norm(normal), 1., 1e-14); // round-off error of a unit vector
  }
}

TEST(normals, do_not_depend_on_number_of_threads)
{
  const std::vector<Vec3> points = torus_cloud(3000, 0.4).points;
  EXPECT_EQ(estimate_normals(points, 18, true, 1), estimate_normals(points, 18, true, 3));
}

TEST(normals, throws_on_non_finite_points)
{
  EXPECT_THROW(estimate_normals({{0., 0., NAN}}, 18, true), Invalid_argument_error);
}

} // namespace normals_test
