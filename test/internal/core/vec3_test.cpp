// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vec3_test {

using namespace CGAL::Geodesic_processing::internal;

TEST(Vec3, tangent_frame_is_positively_oriented_and_orthonormal)
{
  for(const Vec3& direction : {Vec3{0., 0., 1.}, Vec3{0., 0., -1.}, Vec3{1., 2., -3.},
                               Vec3{-1e-9, 1e-9, -1.}, Vec3{1., 0., 0.}})
  {
    const Vec3 n = unit(direction);
    const auto [u, v] = tangent_frame(n);
    const double round_off = 1e-15; // a few errors of numbers up to one
    EXPECT_NEAR(norm(u), 1., round_off);
    EXPECT_NEAR(norm(v), 1., round_off);
    EXPECT_NEAR(dot(u, v), 0., round_off);
    EXPECT_NEAR(norm(cross(u, v) - n), 0., 2. * round_off);
  }
}

TEST(Vec3, nearest_point_of_triangle_is_inside_or_on_boundary)
{
  const Vec3 a = {0., 0., 0.}, b = {2., 0., 0.}, c = {0., 2., 0.};
  using Barycentric = std::array<double, 3>;
  EXPECT_EQ(nearest_in_triangle(a, b, c, {0.5, 0.5, 3.}), (Barycentric{0.5, 0.25, 0.25}));
  EXPECT_EQ(nearest_in_triangle(a, b, c, {1., -1., 1.}), (Barycentric{0.5, 0.5, 0.}));
  EXPECT_EQ(nearest_in_triangle(a, b, c, {2., 2., 0.}), (Barycentric{0., 0.5, 0.5}));
  EXPECT_EQ(nearest_in_triangle(a, b, c, {-1., -1., 0.}), (Barycentric{1., 0., 0.}));
}

TEST(Vec3, largest_cosine_is_that_of_smallest_angle)
{
  // Angles of 90, 60 and 30 degrees.
  EXPECT_NEAR(largest_cosine({0., 0., 0.}, {1., 0., 0.}, {0., std::sqrt(3.), 0.}), std::sqrt(0.75),
              1e-15);
}

} // namespace vec3_test
