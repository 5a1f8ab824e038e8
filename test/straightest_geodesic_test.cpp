// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/straightest_geodesic.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "meshes.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double rounding = 1e-12; // sums of some tens of lengths
using Vector_3 = Kernel::Vector_3;

TEST(Straightest_geodesic, is_a_straight_line_in_a_plane)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto domain = make_domain(mesh.mesh);
  const Point centre = plane.points[60];
  for(int i = 0; i < 36; ++i)
  {
    const double angle = i * pi / 18.;
    const auto line = straightest_geodesic(
        domain, mesh.vertices[60], Vector_3(3. * std::cos(angle), 3. * std::sin(angle), 7.), 0.4);
    EXPECT_FALSE(line.is_cut_by_border);
    EXPECT_NEAR(line.length, 0.4, rounding);
    const Point end = {centre[0] + 0.4 * std::cos(angle), centre[1] + 0.4 * std::sin(angle), 0.};
    EXPECT_LT(distance(to_array(line.points.back()), end), rounding);
  }
}

TEST(Straightest_geodesic, ends_at_a_border)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto from = location_in(mesh, plane, 87, {0.2, 0.3, 0.5});
  const Point start = point_of(mesh.mesh, from);
  const auto line = straightest_geodesic(mesh.mesh, from, Vector_3(1., 0., 0.), 5.);
  EXPECT_TRUE(line.is_cut_by_border);
  EXPECT_NEAR(line.length, 1. - start[0], rounding);
  EXPECT_LT(distance(to_array(line.points.back()), {1., start[1], 0.}), rounding);
}

TEST(Straightest_geodesic, goes_around_a_tetrahedron)
{
  // Parallel to an edge through the middles of the four others it closes, in the length of two sides.
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const Triangulation shape = tetrahedron();
  const auto from = location_in(mesh, shape, 0, {0.5, 0.5, 0.});
  const Point a = shape.points[0], b = shape.points[1], c = shape.points[2];
  const double side = distance(a, b);
  // To the middle of the next side of face 0.
  const Vector_3 direction(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  const auto line = straightest_geodesic(mesh.mesh, from, direction, 2. * side);
  EXPECT_NEAR(line.length, 2. * side, rounding);
  EXPECT_LT(distance(to_array(line.points.back()), point_of(mesh.mesh, from)), rounding);
}

TEST(Straightest_geodesic, of_no_length_is_a_point)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const auto line = straightest_geodesic(mesh.mesh, mesh.vertices[1], Vector_3(1., 0.3, 0.2), 0.);
  EXPECT_EQ(line.length, 0.);
  ASSERT_FALSE(line.empty());
  EXPECT_LT(distance(to_array(line.points.front()), tetrahedron().points[1]), rounding);
}

TEST(Straightest_geodesic, refuses_what_is_no_direction_or_length)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, square(2));
  const auto go = [&](const Vector_3& direction, double length)
  { return straightest_geodesic(mesh.mesh, mesh.vertices[4], direction, length); };
  EXPECT_THROW(go(Vector_3(0., 0., 0.), 1.), Invalid_argument_error);
  EXPECT_THROW(go(Vector_3(0., 0., 1.), 1.), Invalid_argument_error); // along the normal
  EXPECT_THROW(go(Vector_3(1., 0., 0.), -1.), Invalid_argument_error);
  EXPECT_THROW(go(Vector_3(1., 0., 0.), std::nan("")), Invalid_argument_error);
  EXPECT_NO_THROW(go(Vector_3(1., 0., 0.), 0.1));
}

} // namespace
