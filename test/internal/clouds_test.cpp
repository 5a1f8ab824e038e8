// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Checks that the noise of test clouds is that of the paper.

namespace clouds_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Five standard deviations of the mean of n numbers: exceeded with a probability of 1e-6.
double statistical_tolerance(double deviation, std::size_t n)
{
  return 5. * deviation / std::sqrt(double(n));
}

TEST(clouds, noise_offsets_are_uniform_along_normals)
{
  const Cloud sphere = octahedron_sphere(5);
  std::vector<double> radii(sphere.size());
  for(std::size_t i = 0; i < radii.size(); ++i)
    radii[i] = i % 2 == 0 ? 0.01 : 0.03;
  for(const double level : {0.5, 1.})
  {
    const Cloud noisy = with_noise(sphere, radii, level, 1);
    ASSERT_EQ(noisy.size(), sphere.size());
    double sum = 0., squares = 0., largest = 0.;
    for(std::size_t i = 0; i < noisy.size(); ++i)
    {
      const Vec3 offset_vector = noisy.points[i] - sphere.points[i];
      const double offset = dot(offset_vector, sphere.normals[i]);
      EXPECT_LT(norm(offset_vector - offset * sphere.normals[i]), 1e-15); // round-off errors
      const double relative_offset = offset / (level * radii[i]);
      EXPECT_LE(std::abs(relative_offset), 1. + 1e-12); // round-off error
      largest = std::max(largest, std::abs(relative_offset));
      sum += relative_offset;
      squares += relative_offset * relative_offset;
    }
    // Uniform between -1 and 1: the variance is 1/3, that of the squares 1/5 - 1/9.
    const double n = double(noisy.size());
    EXPECT_NEAR(sum / n, 0., statistical_tolerance(std::sqrt(1. / 3.), noisy.size()));
    EXPECT_NEAR(squares / n, 1. / 3., statistical_tolerance(std::sqrt(4. / 45.), noisy.size()));
    EXPECT_GT(largest, 0.99); // 4,098 numbers are all smaller with a probability of 1e-18
  }
}

TEST(clouds, normals_are_perturbed_by_at_most_ten_degrees)
{
  const Cloud square = square_cloud(60);
  const Cloud noisy = with_noise(square, std::vector<double>(square.size(), 0.01), 1., 2);
  double sum = 0.;
  Vec3 directions = {0., 0., 0.};
  for(const Vec3& n : noisy.normals)
  {
    EXPECT_NEAR(norm(n), 1., 1e-15); // round-off error of a unit vector
    const double angle = std::atan2(std::hypot(n[0], n[1]), n[2]);
    EXPECT_LE(angle, pi / 18. * (1. + 1e-12)); // round-off error
    sum += angle;
    directions = directions + unit({n[0], n[1], 0.});
  }
  // The tolerances are those of an angle between 0 and 10 degrees and of the cosine of a uniformly
  // distributed angle.
  EXPECT_NEAR(sum / 3600., pi / 36., statistical_tolerance(pi / 18. / std::sqrt(12.), 3600));
  for(int k = 0; k < 2; ++k)
    EXPECT_NEAR(directions[k] / 3600., 0., statistical_tolerance(std::sqrt(0.5), 3600));
}

TEST(clouds, outlier_fraction_is_exact)
{
  const Cloud square = square_cloud(60);
  const std::vector<double> radii(square.size(), 0.01);
  const Cloud noisy = with_noise(square, radii, 0.5, 1),
              worse = with_outliers(noisy, square, radii, 0.05, 2., 2);
  ASSERT_EQ(worse.size(), noisy.size() + 180);
  EXPECT_TRUE(std::equal(noisy.points.begin(), noisy.points.end(), worse.points.begin()));
  EXPECT_TRUE(std::equal(noisy.normals.begin(), noisy.normals.end(), worse.normals.begin()));
  std::size_t outside = 0;
  for(std::size_t i = noisy.size(); i < worse.size(); ++i)
  {
    Vec3 point = worse.points[i];
    EXPECT_LE(std::abs(point[2]), 0.02 * (1. + 1e-12)); // round-off error
    outside += std::abs(point[2]) > 0.005;
    // Above or below a surfel of the square.
    point[2] = 0.;
    EXPECT_NE(std::find(square.points.begin(), square.points.end(), point), square.points.end());
  }
  // Three quarters of the outliers are farther away than noise of level 0.5.
  EXPECT_NEAR(double(outside) / 180., 0.75, statistical_tolerance(std::sqrt(3. / 16.), 180));
}

TEST(clouds, scan_noise_is_per_stripe_and_point)
{
  const Cloud scan = scanned_square(94, 70, 3), truth = scanned_square(94, 70, 0);
  ASSERT_EQ(scan.size(), truth.size());
  const double spacing = 1. / 93.;
  double squares = 0., stripes = 0.;
  for(std::size_t i = 0; i < 94; ++i)
  {
    double sum = 0.;
    for(std::size_t j = 70 * i; j < 70 * (i + 1); ++j)
    {
      EXPECT_EQ(truth.points[j][2], 0.);
      EXPECT_EQ(scan.points[j][0], truth.points[j][0]);
      // The noise tilts the planes of the nearest points; measured are up to 10 degrees.
      EXPECT_GT(scan.normals[j][2], 0.97);
      // A multiple of the step of the camera.
      const double steps = scan.points[j][2] / (0.04 * spacing);
      EXPECT_NEAR(steps, std::round(steps), 1e-12);
      sum += scan.points[j][2];
      squares += scan.points[j][2] * scan.points[j][2];
    }
    stripes += sum / 70. * sum / 70.;
  }
  // Relative to the spacing, the standard deviations are 0.04 per stripe, 0.08 per point, and 0.04
  // / sqrt(12) of the rounding to steps.
  const double own = std::hypot(0.08, 0.04 / std::sqrt(12.)), all = std::hypot(0.04, own);
  // Five standard deviations of the mean of 94 squares.
  const double known = 5. * std::sqrt(2. / 94.);
  EXPECT_NEAR(squares / 6580. / (spacing * spacing), all * all, known * 0.04 * 0.04);
  // The mean of a stripe has the error of the stripe and a small part of the errors of its points.
  const double expected = 0.04 * 0.04 + own * own / 70.;
  EXPECT_NEAR(stripes / 94. / (spacing * spacing), expected, known * expected);
}

TEST(clouds, are_deterministic_for_seed)
{
  const Cloud square = square_cloud(10);
  const std::vector<double> radii(square.size(), 0.1);
  EXPECT_EQ(with_noise(square, radii, 1., 5).points, with_noise(square, radii, 1., 5).points);
  EXPECT_NE(with_noise(square, radii, 1., 5).points, with_noise(square, radii, 1., 6).points);
}

} // namespace clouds_test
