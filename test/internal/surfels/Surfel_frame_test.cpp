// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/Surfel_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Surfel_frame_test {

using namespace CGAL::Geodesic_processing::internal;

// Round-off errors of some operations on numbers of size 1; measured are 6e-16.
constexpr double round_off = 1e-14;

TEST(Surfel_frame, rejects_normals_that_differ_by_more_than_60_degrees)
{
  const Surfel_frame frame({0., 0., 0.}, {0., 0., 1.}, 1.);
  Surfel_frame::Sample sample;
  EXPECT_TRUE(frame.project({0.1, 0., 0.}, unit({1.7, 0., 1.}), sample));
  EXPECT_FALSE(frame.project({0.1, 0., 0.}, unit({1.8, 0., 1.}), sample));
  EXPECT_FALSE(frame.project({0.1, 0., 0.}, {0., 0., -1.}, sample));
}

TEST(Surfel_frame, spheres_are_quadratic_without_higher_order_terms)
{
  // The unit sphere around (0, 0, -1), in spacings of 0.1: its Hessian is -0.1.
  const Surfel_frame frame({0., 0., 0.}, {0., 0., 1.}, 0.1);
  const Quadric_fit::Coefficients c = {0., 0., 0., -0.1, 0., -0.1};
  for(const double angle : {0.1, 0.4, 0.8})
  {
    const Vec3 normal = {0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle)};
    Surfel_frame::Sample sample;
    ASSERT_TRUE(frame.project(normal - Vec3{0., 0., 1.}, normal, sample));
    Surfel_frame::remove_higher_order_terms(c, sample);
    EXPECT_NEAR(sample.height, Quadric_fit::height(c, sample.monomials), round_off);
    EXPECT_NEAR(sample.slope_x, -0.1 * sample.monomials.x, round_off);
    EXPECT_NEAR(sample.slope_y, -0.1 * sample.monomials.y, round_off);
  }
}

TEST(Surfel_frame, projects_points_to_planar_fits)
{
  const Surfel_frame frame({1., 2., 3.}, {0., 0., 1.}, 0.5);
  const Surfel moved = frame.moved_to_fit({1.2, 2.3, 3.7}, {0., 0., 0., 0., 0., 0.});
  EXPECT_NEAR(norm(moved.point - Vec3{1.2, 2.3, 3.}), 0., round_off / 10.);
  EXPECT_EQ(moved.normal, (Vec3{0., 0., 1.}));
}

} // namespace Surfel_frame_test
