// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fit_quadric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fit_quadric_test {

using namespace CGAL::Geodesic_processing::internal;

// Returns points of z = 0.3 x - 0.2 y + (2 x^2 - x y + 3 y^2) / 2 with |x|, |y| <= size, moved to
// the origin.
std::vector<Vec3> quadric_patch(double size, const Vec3& origin)
{
  std::vector<Vec3> points;
  for(int i = -3; i <= 3; ++i)
    for(int j = -3; j <= 3; ++j)
    {
      const double x = size * i / 3., y = size * j / 3.;
      points.push_back(origin +
                       Vec3{x, y, 0.3 * x - 0.2 * y + 0.5 * (2. * x * x - x * y + 3. * y * y)});
    }
  return points;
}

TEST(fit_quadric, normal_converges_quadratically)
{
  const Vec3 origin = {5., -7., 2.}, normal = unit({-0.3, 0.2, 1.});
  // The fit uses the best-fit plane, over which the patch is a quadric up to terms of third order.
  double previous_sine = 0.;
  for(const double size : {0.1, 0.05, 0.025})
  {
    const Quadric found = fit_quadric(origin, quadric_patch(size, origin));
    const double sine = norm(cross(found.normal(), normal));
    // Half the size must reduce the error to a quarter, plus terms of higher order.
    EXPECT_LT(sine, size == 0.1 ? 0.02 : 0.3 * previous_sine);
    previous_sine = sine;
  }
}

TEST(fit_quadric, is_exact_for_planar_points)
{
  std::vector<Vec3> points;
  for(int i = 0; i < 20; ++i)
    points.push_back({std::cos(i), std::sin(1. + i), 0.5 * std::cos(i) + 2.});
  const Quadric found = fit_quadric(points.front(), points);
  // Round-off error, measured 2e-16.
  EXPECT_NEAR(std::abs(dot(found.normal(), unit({-0.5, 0., 1.}))), 1., 1e-14);
  for(const double c : found.coefficients)
    EXPECT_NEAR(c, 0., 1e-13); // round-off error of a least squares fit, measured 1e-15
}

TEST(fit_quadric, has_minimal_norm_if_underdetermined)
{
  // Points on a line determine only that the line is tangent to the surface.
  std::vector<Vec3> points;
  for(int i = 0; i < 10; ++i)
    points.push_back({double(i), 2. * i, 0.});
  const Quadric found = fit_quadric(points.front(), points);
  // A few round-off errors.
  EXPECT_NEAR(norm(found.normal()), 1., 1e-14);
  // square root of the round-off error
  EXPECT_NEAR(dot(found.normal(), unit({1., 2., 0.})), 0., 1e-7);
}

TEST(fit_quadric, is_empty_for_single_point)
{
  EXPECT_EQ(fit_quadric({1., 2., 3.}, {{1., 2., 3.}, {1., 2., 3.}}).length_unit, 0.);
}

} // namespace fit_quadric_test
