// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/normals.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(normals, are_those_of_a_torus)
{
  double error[2];
  for(const std::size_t n : {1000u, 4000u})
  {
    const Cloud cloud = torus_cloud(n, 0.4);
    const std::vector<Spatial> normals = estimate_normals(cloud.points, 18, true);
    double& largest = error[n == 4000u];
    largest = 0.;
    for(std::size_t i = 0; i < normals.size(); ++i)
      largest = std::max(largest, norm(normals[i] - cloud.normals[i]));
  }
  // A fit of second order errs by the square of its width, which is halved.
  EXPECT_LT(error[0], 0.1);
  EXPECT_LT(error[1], 0.35 * error[0]);
}

TEST(normals, look_to_one_side_of_each_part)
{
  // Spheres too far apart for any neighbour in common: the highest point of each looks up, and so outwards.
  const Cloud sphere = ellipsoid_cloud(500, {1., 1., 1.});
  std::vector<Spatial> points;
  for(const double place : {-10., 0., 10.})
    for(const Spatial& p : sphere.points)
      points.push_back(p + Spatial{place, 0., 0.5 * place});
  const std::vector<Spatial> normals = estimate_normals(points, 18, true);
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_GT(dot(normals[i], sphere.normals[i % 500]), 0.99) << i; // errors are those of the fit
}

TEST(normals, of_equal_points_are_equal)
{
  std::vector<Spatial> points = torus_cloud(500, 0.4).points;
  const std::vector<Spatial> once = estimate_normals(points, 18, true);
  points.insert(points.end(), 40, points[7]);
  const std::vector<Spatial> often = estimate_normals(points, 18, true);
  for(std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(often[i], once[i < once.size() ? i : 7]) << i;
}

TEST(normals, are_unit_vectors_where_points_span_nothing)
{
  const std::vector<std::vector<Spatial>> clouds = {
      {},
      {{1., 2., 3.}},
      {{0., 0., 0.}, {1., 1., 1.}},
      std::vector<Spatial>(50, {1e8, 0., 0.}),
      {{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {3., 0., 0.}, {1e300, 0., 0.}}};
  for(const std::vector<Spatial>& points : clouds)
  {
    const std::vector<Spatial> normals = estimate_normals(points, 18, true);
    EXPECT_EQ(normals.size(), points.size());
    for(const Spatial& normal : normals)
      EXPECT_NEAR(norm(normal), 1., 1e-14);
  }
}

TEST(normals, are_the_same_for_any_number_of_threads)
{
  const std::vector<Spatial> points = torus_cloud(3000, 0.4).points;
  EXPECT_EQ(estimate_normals(points, 18, true, 1), estimate_normals(points, 18, true, 3));
}

TEST(normals, refuse_what_is_not_finite)
{
  EXPECT_THROW(estimate_normals({{0., 0., NAN}}, 18, true), Invalid_argument_error);
}

} // namespace
