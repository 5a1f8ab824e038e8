// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/straightest_geodesic.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "meshes.h"

#include <gtest/gtest.h>

namespace straightest_geodesic_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

constexpr double round_off = 1e-12; // sums of some tens of lengths
using Vector_3 = Kernel::Vector_3;

TEST(Straightest_geodesic, is_straight_in_plane)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto domain = make_domain(mesh.mesh);
  const Point center = plane.points[60];
  for(int i = 0; i < 36; ++i)
  {
    const double angle = i * pi / 18.;
    const auto path = straightest_geodesic(
        domain, mesh.vertices[60], Vector_3(3. * std::cos(angle), 3. * std::sin(angle), 7.), 0.4);
    EXPECT_FALSE(path.is_cut_by_boundary);
    EXPECT_NEAR(path.length, 0.4, round_off);
    const Point end = {center[0] + 0.4 * std::cos(angle), center[1] + 0.4 * std::sin(angle), 0.};
    EXPECT_LT(distance(to_array(path.points.back()), end), round_off);
  }
}

TEST(Straightest_geodesic, ends_at_boundary)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  const auto from = location_in(mesh, plane, 87, {0.2, 0.3, 0.5});
  const Point start = point_of(mesh.mesh, from);
  const auto path = straightest_geodesic(mesh.mesh, from, Vector_3(1., 0., 0.), 5.);
  EXPECT_TRUE(path.is_cut_by_boundary);
  EXPECT_NEAR(path.length, 1. - start[0], round_off);
  EXPECT_LT(distance(to_array(path.points.back()), {1., start[1], 0.}), round_off);
}

TEST(Straightest_geodesic, closes_around_tetrahedron)
{
  // A geodesic parallel to an edge passes the midpoints of the four adjacent edges. It closes
  // after two edge lengths.
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const Triangulation shape = tetrahedron();
  const auto from = location_in(mesh, shape, 0, {0.5, 0.5, 0.});
  const Point a = shape.points[0], b = shape.points[1], c = shape.points[2];
  const double edge_length = distance(a, b);
  // To the midpoint of the next edge of face 0.
  const Vector_3 direction(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  const auto path = straightest_geodesic(mesh.mesh, from, direction, 2. * edge_length);
  EXPECT_NEAR(path.length, 2. * edge_length, round_off);
  EXPECT_LT(distance(to_array(path.points.back()), point_of(mesh.mesh, from)), round_off);
}

TEST(Straightest_geodesic, is_single_point_for_zero_length)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  const auto path = straightest_geodesic(mesh.mesh, mesh.vertices[1], Vector_3(1., 0.3, 0.2), 0.);
  EXPECT_EQ(path.length, 0.);
  ASSERT_FALSE(path.empty());
  EXPECT_LT(distance(to_array(path.points.front()), tetrahedron().points[1]), round_off);
}

TEST(Straightest_geodesic, throws_on_invalid_direction_or_length)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, square(2));
  const auto trace = [&](const Vector_3& direction, double length)
  { return straightest_geodesic(mesh.mesh, mesh.vertices[4], direction, length); };
  EXPECT_THROW(trace(Vector_3(0., 0., 0.), 1.), Invalid_argument_error);
  EXPECT_THROW(trace(Vector_3(0., 0., 1.), 1.), Invalid_argument_error); // along the normal
  EXPECT_THROW(trace(Vector_3(1., 0., 0.), -1.), Invalid_argument_error);
  EXPECT_THROW(trace(Vector_3(1., 0., 0.), std::nan("")), Invalid_argument_error);
  EXPECT_NO_THROW(trace(Vector_3(1., 0., 0.), 0.1));
}

} // namespace straightest_geodesic_test
