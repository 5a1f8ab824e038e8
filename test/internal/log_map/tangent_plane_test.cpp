// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A few roundings of coordinates below 2.
constexpr double rounding = 1e-13;

TEST(tangent_plane, is_the_plane_itself)
{
  const Glued_surface surface(square(10, 0.25));
  const Index inner = 60; // in the middle of 11 x 11
  for(const Location& at :
      {surface.at(inner), surface.in(57, {0.2, 0.5, 0.3}), surface.on(57, 1, 0.3)})
  {
    const Tangent_plane plane(surface.t(), at);
    EXPECT_NEAR(norm(plane.x()), 1., rounding);
    EXPECT_NEAR(norm(cross(plane.x(), plane.y()) - Spatial{0., 0., 1.}), 0., rounding);
    EXPECT_NEAR(plane.opening(), 2. * pi, rounding);
    for(const double angle : {-3., -1., 0., 0.7, 2., 3.1, 5., 9.})
    {
      const double length = 0.1 / surface.scale();
      const Straightest_path path = plane.straight(angle, length);
      EXPECT_NEAR(path.length, length, rounding);
      const Spatial end = plane.point() + length * std::cos(angle) * plane.x() +
                          length * std::sin(angle) * plane.y();
      EXPECT_LT(norm(scaled_coordinates(surface.t(), path.locations.back()) - end), 1e-12);
      EXPECT_NEAR(std::remainder(plane.tangent_angle(end - plane.point()) - angle, 2. * pi), 0.,
                  1e-12);
    }
  }
}

TEST(tangent_plane, ends_at_a_border)
{
  const Glued_surface surface(square(4));
  const Tangent_plane corner(surface.t(), surface.at(0)), middle(surface.t(), surface.at(2));
  EXPECT_NEAR(corner.opening(), pi / 2., rounding);
  EXPECT_NEAR(middle.opening(), pi, rounding);
  const Straightest_path out = corner.straight(2., 0.1);
  EXPECT_EQ(out.length, 0.);
  EXPECT_EQ(out.end, Straightest_end::border);
  EXPECT_NEAR(corner.straight(0.5, 0.1).length, 0.1, rounding);
}

TEST(tangent_plane, stretches_angles_around_a_cone)
{
  // Three quarters of the plane, rolled up.
  const Glued_surface surface(cone(9, 3, 1.5 * pi));
  const Tangent_plane plane(surface.t(), surface.at(0));
  EXPECT_NEAR(plane.opening(), 2. * pi, rounding);
  EXPECT_NEAR(plane.tangent_angle(0.75 * pi), pi, rounding);
  // Nine sides leave the tip: along each, straight on.
  for(int i = 0; i < 9; ++i)
  {
    const double length = 0.01;
    const Straightest_path path = plane.straight(2. * pi * i / 9., length);
    const Spatial way = scaled_coordinates(surface.t(), path.locations.back()) - plane.point();
    EXPECT_NEAR(norm(way), length, rounding);
    // In space the sides are where the axes say, seen from the axis of the cone.
    EXPECT_NEAR(std::remainder(plane.tangent_angle(way) - 2. * pi * i / 9., 2. * pi), 0., 1e-9);
  }
}

TEST(tangent_plane, lies_across_the_normal)
{
  const Glued_surface surface(torus(30, 20));
  for(const Index i : {0u, 77u, 300u})
  {
    const Spatial normal = Tangent_plane(surface.t(), surface.at(i)).normal();
    EXPECT_LT(norm(normal - site_normal(surface.t(), surface.site(i))), rounding);
  }
  // By symmetry.
  const Triangulation sphere = icosphere(2);
  const Glued_surface round(sphere);
  EXPECT_LT(norm(site_normal(round.t(), round.site(0)) - sphere.points[0]), rounding);
}

TEST(tangent_plane, needs_a_triangle)
{
  Triangulation lonely = square(2);
  lonely.points.push_back({5., 5., 5.});
  const Glued_surface surface(lonely);
  EXPECT_THROW(Tangent_plane(surface.t(), surface.at(Index(lonely.points.size() - 1))),
               Invalid_argument_error);
}

} // namespace
