// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/denoise.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace denoise_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns the root mean squared distance of the surfels.
template <typename Distance>
double deviation(const Cloud& cloud, const Distance& distance)
{
  double sum = 0.;
  for(const Vec3& p : cloud.points)
    sum += std::pow(distance(p), 2);
  return std::sqrt(sum / double(cloud.size()));
}

Cloud denoised(Cloud cloud, unsigned number_of_threads = 1)
{
  denoise(cloud.points, cloud.normals, number_of_threads);
  return cloud;
}

TEST(denoise, noise_level_of_smooth_surfaces_is_small)
{
  for(const Cloud& cloud :
      {square_cloud(20), octahedron_sphere(3), cylinder_cloud(40, 20, 1., 3.),
       torus_cloud(1000, 0.4), ellipsoid_cloud(1000, {1., 0.7, 0.5}), cube_cloud(10)})
    EXPECT_LT(noise_level(cloud.points, cloud.normals), significant_noise_level);
}

TEST(denoise, noise_level_is_proportional_to_noise)
{
  const Cloud square = square_cloud(40);
  for(const double level : {0.1, 0.5, 1.})
  {
    const Cloud noisy = with_noise(square, std::vector<double>(1600, 1. / 39.), level, 1);
    const double found = noise_level(noisy.points, noisy.normals);
    EXPECT_GT(found, 0.4 * level);
    // The median difference of two random numbers from an interval of length 2 level is 0.586
    // level. The normals add up to 0.03.
    EXPECT_LT(found, 0.65 * level + 0.03);
  }
}

TEST(denoise, flattens_planes)
{
  const Cloud square = square_cloud(60);
  const Cloud noisy = with_noise(square, std::vector<double>(3600, 1. / 59.), 1., 1);
  const auto height = [](const Vec3& p) { return p[2]; };
  const double before = deviation(noisy, height), after = deviation(denoised(noisy), height);
  // The largest fits use about a quarter of the surfels, which divides the noise by the square root
  // of their number. The result is within a factor of 2 of this.
  EXPECT_LT(after, 2. * before / std::sqrt(3600. / 4.));
}

TEST(denoise, preserves_spheres_and_cylinders)
{
  const Cloud sphere = octahedron_sphere(5), cylinder = cylinder_cloud(100, 32, 1., 2.);
  const Cloud noisy_sphere = with_noise(sphere, std::vector<double>(sphere.size(), 0.055), 0.5, 1),
              noisy_cylinder =
                  with_noise(cylinder, std::vector<double>(cylinder.size(), 0.063), 0.5, 1);
  const auto sphere_distance = [](const Vec3& p) { return norm(p) - 1.; };
  const auto cylinder_distance = [](const Vec3& p) { return std::hypot(p[0], p[1]) - 1.; };
  // The curvature of both is constant, so fits extend until the normals differ by 60 degrees: about
  // 1,000 surfels. At the center of a quadric fit to 1,000 surfels, the error is 2 / sqrt(1000) of
  // the noise. Differences between neighboring fits add half of this.
  EXPECT_LT(deviation(denoised(noisy_sphere), sphere_distance),
            0.1 * deviation(noisy_sphere, sphere_distance));
  EXPECT_LT(deviation(denoised(noisy_cylinder), cylinder_distance),
            0.1 * deviation(noisy_cylinder, cylinder_distance));
}

TEST(denoise, preserves_tori)
{
  const Cloud torus = torus_cloud(5000, 0.4);
  const Cloud noisy = with_noise(torus, std::vector<double>(torus.size(), 0.05), 1., 1);
  const auto torus_distance = [](const Vec3& p)
  { return std::hypot(std::hypot(p[0], p[1]) - 1., p[2]) - 0.4; };
  // A tenth of the noise remains. With quadrics without higher-order terms, it would be a seventh.
  EXPECT_LT(deviation(denoised(noisy), torus_distance), 0.12 * deviation(noisy, torus_distance));
}

TEST(denoise, preserves_sharp_edges)
{
  const Cloud cube = cube_cloud(20);
  const Cloud noisy = with_noise(cube, std::vector<double>(cube.size(), 0.05), 0.3, 1);
  const auto cube_distance = [](const Vec3& p) {
    return std::max({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])}) - 0.5;
  };
  EXPECT_LT(deviation(denoised(noisy), cube_distance), 0.3 * deviation(noisy, cube_distance));
}

TEST(denoise, is_robust_to_outliers)
{
  const Cloud square = square_cloud(60);
  const std::vector<double> radii(3600, 1. / 59.);
  const Cloud noisy = with_noise(square, radii, 0.5, 1);
  Cloud noisy_with_outliers = with_outliers(noisy, square, radii, 0.05, 2., 2);
  const auto height = [](const Vec3& p) { return p[2]; };
  EXPECT_LT(deviation(denoised(noisy_with_outliers), height),
            2. * deviation(denoised(noisy), height));
}

TEST(denoise, does_not_depend_on_number_of_threads)
{
  const Cloud noisy = with_noise(torus_cloud(5000, 0.4), std::vector<double>(5200, 0.05), 0.5, 1);
  const Cloud one = denoised(noisy, 1), three = denoised(noisy, 3);
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.normals, three.normals);
}

TEST(denoise, handles_few_surfels)
{
  std::vector<Vec3> points, normals;
  denoise(points, normals);
  EXPECT_EQ(noise_level(points, normals), 0.);
  points = {{1., 2., 3.}, {1., 2., 3.}, {2., 2., 3.}};
  normals = {{0., 0., 2.}, {0., 0., 1.}, {0., 0., 1.}};
  denoise(points, normals);
  EXPECT_EQ(points, (std::vector<Vec3>{{1., 2., 3.}, {1., 2., 3.}, {2., 2., 3.}}));
  normals.pop_back();
  EXPECT_THROW(denoise(points, normals), Invalid_argument_error);
}

} // namespace denoise_test
