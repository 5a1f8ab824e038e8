// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_ball.h>

#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace geodesic_ball_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Ball = GP::Geodesic_ball<Mesh>;

// Round-off errors of areas and distances of order one.
constexpr double round_off = 1e-10;

double length_of_circles(const Ball& ball)
{
  double result = 0.;
  for(const auto& circle : ball.circles)
    result += circle.length;
  return result;
}

TEST(geodesic_ball, in_the_plane_is_a_disk)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(square(20, 0.24), scale));
    const Vertex center(10 * 21 + 10); // of an inner point
    for(const double radius : {0.004, 0.05, 0.2, 0.4})
    {
      const Ball ball = GP::geodesic_ball(mesh, center, scale * radius);
      EXPECT_NEAR(ball.area / (scale * scale), pi * radius * radius, round_off);
      ASSERT_EQ(ball.circles.size(), 1u);
      EXPECT_TRUE(ball.circles[0].is_closed);
      for(const auto& p : ball.circles[0].points)
        EXPECT_NEAR(std::sqrt(CGAL::squared_distance(p, mesh.point(center))), scale * radius,
                    round_off * scale);
      EXPECT_LT(length_of_circles(ball), 2. * pi * radius * scale);
      std::size_t number = 0;
      for(const Face face : mesh.faces())
      {
        bool is_inside = true;
        for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
          is_inside =
              is_inside && std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(center))) <=
                               scale * radius;
        number += is_inside;
        EXPECT_EQ(is_inside, std::count(ball.faces.begin(), ball.faces.end(), face) == 1);
      }
      EXPECT_EQ(ball.faces.size(), number);
    }
  }
}

// No vertex is in the smaller balls.
TEST(geodesic_ball, around_a_location_has_the_area_of_a_disk)
{
  const Mesh mesh = mesh_of(square(6, 0.2));
  const auto center = GP::locate_on_surface(mesh, Kernel::Point_3(0.52, 0.45, 0.));
  for(const double radius : {1e-4, 0.02, 0.1, 0.3})
    EXPECT_NEAR(GP::geodesic_ball(mesh, center, radius).area, pi * radius * radius, round_off);
  EXPECT_TRUE(GP::geodesic_ball(mesh, center, 1e-4).circles.empty());
}

TEST(geodesic_ball, is_cut_by_the_boundary)
{
  const Mesh mesh = mesh_of(square(10, 0.2));
  const Ball quarter = GP::geodesic_ball(mesh, Vertex(0), 0.7);
  EXPECT_NEAR(quarter.area, pi * 0.49 / 4., round_off);
  ASSERT_EQ(quarter.circles.size(), 1u);
  EXPECT_FALSE(quarter.circles[0].is_closed);
  EXPECT_NEAR(GP::geodesic_ball(mesh, Vertex(5), 0.45).area, pi * 0.45 * 0.45 / 2., round_off);
  // All of the square.
  const Ball all = GP::geodesic_ball(mesh, Vertex(0), 2.);
  EXPECT_NEAR(all.area, 1., round_off);
  EXPECT_EQ(all.faces.size(), num_faces(mesh));
  EXPECT_TRUE(all.circles.empty());
  EXPECT_EQ(GP::geodesic_ball(mesh, Vertex(0), 0.).area, 0.);
}

// The balls do not overlap, and no face of a circle has a corner that is closer to the other
// source.
TEST(geodesic_ball, of_two_sources_is_the_union)
{
  const Mesh mesh = mesh_of(square(12, 0.2));
  const std::vector<Vertex> centers = {Vertex(13 * 6 + 2), Vertex(13 * 6 + 10)};
  const double r = 0.15;
  const Ball ball = GP::geodesic_ball(mesh, centers, r);
  EXPECT_NEAR(ball.area, 2. * pi * r * r, round_off);
  EXPECT_EQ(ball.circles.size(), 2u);
}

TEST(geodesic_ball, on_a_prism_is_the_disk_of_the_unrolled_plane)
{
  const std::size_t n = 24, m = 16;
  const Mesh mesh = mesh_of(cylinder(n, m, 1., 4.));
  // Up to half of the perimeter and of the height.
  for(const double radius : {0.3, 1., 1.9})
    EXPECT_NEAR(GP::geodesic_ball(mesh, Vertex(Mesh::size_type(n * m / 2)), radius).area,
                pi * radius * radius, round_off);
}

TEST(geodesic_ball, around_the_apex_of_a_cone_is_a_sector)
{
  for(const double total : {3., 5., 8.})
  {
    const Mesh mesh = mesh_of(cone(10, 6, total));
    for(const double radius : {0.7, 2.5, 4.})
      EXPECT_NEAR(GP::geodesic_ball(mesh, Vertex(0), radius).area, 0.5 * total * radius * radius,
                  round_off * 100.); // areas of up to 64
  }
}

TEST(geodesic_ball, converges_to_the_cap_of_a_sphere)
{
  for(const unsigned level : {2u, 3u, 4u})
  {
    const Mesh mesh = mesh_of(icosphere(level));
    double h = 0.;
    for(const auto edge : mesh.edges())
      h = std::max(h, std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(edge, 0)),
                                                       mesh.point(mesh.vertex(edge, 1)))));
    for(const double radius : {0.5, 1.5, 2.5})
    {
      // The area of the cap is 2 pi (1 - cos r). A triangle of the inscribed polyhedron is smaller
      // than a spherical one by a fraction of at most h^2 / 8. A circle has the geodesic curvature
      // cot r, so that chords of length h cut off 2 pi |cos r| h^2 / 12.
      const double expected = 2. * pi * (1. - std::cos(radius));
      const double tolerance = h * h * (expected / 8. + 2. * pi * std::abs(std::cos(radius)) / 12.);
      EXPECT_NEAR(GP::geodesic_ball(mesh, Vertex(0), radius).area, expected, tolerance);
    }
  }
}

TEST(geodesic_ball, accepts_polyhedra_and_domains)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Numbered<Polyhedron> mesh;
  fill(mesh, square(8, 0.2));
  const auto center = mesh.vertices[4 * 9 + 4];
  const auto ball = GP::geodesic_ball(mesh.mesh, center, 0.3);
  EXPECT_NEAR(ball.area, pi * 0.09, round_off);
  EXPECT_EQ(GP::geodesic_ball(GP::make_domain(mesh.mesh), center, 0.3).area, ball.area);
}

TEST(geodesic_ball, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(2));
  EXPECT_THROW(GP::geodesic_ball(mesh, Vertex(0), -1.), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_ball(mesh, Vertex(0), GP::internal::infinity),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_ball(mesh, std::vector<Vertex>(), 1.), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_ball(mesh, Vertex(0), 1.,
                                 GP::parameters::callback([](double) { return false; })),
               GP::Cancelled);
}

} // namespace geodesic_ball_test
