// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/tangent_plane.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tangent_plane_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of a line across some triangles.
constexpr double path_tolerance = 1e-12;

// A few round-off errors of coordinates below 2.
constexpr double round_off_tolerance = 1e-13;

TEST(tangent_plane, is_exact_on_planes)
{
  const Array_surface surface(square(10, 0.25));
  const Index inner = 60; // the center of 11 x 11 vertices
  for(const Surface_location& at :
      {surface.at(inner), surface.in(57, {0.2, 0.5, 0.3}), surface.on(57, 1, 0.3)})
  {
    const Tangent_plane plane(surface.t(), at);
    EXPECT_NEAR(norm(plane.x()), 1., round_off_tolerance);
    EXPECT_NEAR(norm(cross(plane.x(), plane.y()) - Vec3{0., 0., 1.}), 0., round_off_tolerance);
    EXPECT_NEAR(plane.total_angle(), 2. * pi, round_off_tolerance);
    for(const double angle : {-3., -1., 0., 0.7, 2., 3.1, 5., 9.})
    {
      const double length = 0.1 / surface.scale();
      const Straightest_path path = plane.straightest_path(angle, length);
      EXPECT_NEAR(path.length, length, round_off_tolerance);
      const Vec3 end = plane.point() + length * std::cos(angle) * plane.x() +
                       length * std::sin(angle) * plane.y();
      EXPECT_LT(norm(scaled_coordinates(surface.t(), path.locations.back()) - end), path_tolerance);
      EXPECT_NEAR(std::remainder(plane.tangent_angle(end - plane.point()) - angle, 2. * pi), 0.,
                  path_tolerance);
    }
  }
}

TEST(tangent_plane, is_limited_at_boundary)
{
  const Array_surface surface(square(4));
  const Tangent_plane corner(surface.t(), surface.at(0)), middle(surface.t(), surface.at(2));
  EXPECT_NEAR(corner.total_angle(), pi / 2., round_off_tolerance);
  EXPECT_NEAR(middle.total_angle(), pi, round_off_tolerance);
  const Straightest_path path_outside = corner.straightest_path(2., 0.1);
  EXPECT_EQ(path_outside.length, 0.);
  EXPECT_EQ(path_outside.end, Straightest_path_end::boundary);
  EXPECT_NEAR(corner.straightest_path(0.5, 0.1).length, 0.1, round_off_tolerance);
}

TEST(tangent_plane, rescales_angles_around_a_cone)
{
  // The cone consists of three quarters of a disk.
  const Array_surface surface(cone(9, 3, 1.5 * pi));
  const Tangent_plane plane(surface.t(), surface.at(0));
  EXPECT_NEAR(plane.total_angle(), 2. * pi, round_off_tolerance);
  EXPECT_NEAR(plane.tangent_angle(0.75 * pi), pi, round_off_tolerance);
  // Trace a path along each of the nine edges at the apex.
  for(int i = 0; i < 9; ++i)
  {
    const double length = 0.01;
    const Straightest_path path = plane.straightest_path(2. * pi * i / 9., length);
    const Vec3 offset = scaled_coordinates(surface.t(), path.locations.back()) - plane.point();
    EXPECT_NEAR(norm(offset), length, round_off_tolerance);
    // By symmetry, the projected edges have exactly their tangent angles.
    EXPECT_NEAR(std::remainder(plane.tangent_angle(offset) - 2. * pi * i / 9., 2. * pi), 0., 1e-9);
  }
}

TEST(tangent_plane, is_orthogonal_to_vertex_normal)
{
  const Array_surface surface(torus(30, 20));
  for(const Index i : {0u, 77u, 300u})
  {
    const Vec3 normal = Tangent_plane(surface.t(), surface.at(i)).normal();
    EXPECT_LT(norm(normal - vertex_normal(surface.t(), surface.vertex(i))), round_off_tolerance);
  }
  // By symmetry, the vertex normal is radial.
  const Triangulation sphere = icosphere(2);
  const Array_surface sphere_surface(sphere);
  EXPECT_LT(norm(vertex_normal(sphere_surface.t(), sphere_surface.vertex(0)) - sphere.points[0]),
            round_off_tolerance);
}

TEST(tangent_plane, throws_on_isolated_vertex)
{
  Triangulation with_isolated_vertex = square(2);
  with_isolated_vertex.points.push_back({5., 5., 5.});
  const Array_surface surface(with_isolated_vertex);
  EXPECT_THROW(
      Tangent_plane(surface.t(), surface.at(Index(with_isolated_vertex.points.size() - 1))),
      Invalid_argument_error);
}

} // namespace tangent_plane_test
