// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/shorten_polyline.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include "Mesh_of.h"

#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>
#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shorten_polyline_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Point_3 = Kernel::Point_3;

TEST(shorten_polyline, shortens_on_mesh_given_by_aabb_tree)
{
  using Tree =
      CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;
  const Mesh mesh = mesh_of(icosphere(4));
  const Tree tree(faces(mesh).begin(), faces(mesh).end(), mesh);
  // A polyline around the sphere that starts at a pole and has a bend.
  std::vector<Point_3> polyline;
  for(int i = 0; i <= 40; ++i)
  {
    const double a = 2. * i / 40., z = 0.3 * std::sin(GP::internal::pi * i / 40.);
    polyline.emplace_back(std::cos(a), std::sin(a), z);
  }
  const auto path =
      GP::shorten_polyline(polyline, [&](const Point_3& p) { return tree.squared_distance(p); });
  // Faces lie below the sphere by at most an eighth of the squared edge length 0.07.
  EXPECT_NEAR(path.distance, 2., 2. * 0.07 * 0.07 / 8. * 2.);
  // Shortening knows only distances. Measured are up to 4e-4 between points and faces.
  for(const Point_3& p : path.points)
    EXPECT_LT(tree.squared_distance(p), 1e-6);
}

TEST(shorten_polyline, crosses_sharp_edges)
{
  // Crosses the edge of a right-angled wedge and moves by 0.5 along it.
  const auto squared_distance = [](const Point_3& p)
  {
    const double x = p.x(), z = p.z();
    const double from_top = (x <= 0. ? 0. : x * x) + z * z,
                 from_side = x * x + (z <= 0. ? 0. : z * z);
    return std::min(from_top, from_side);
  };
  const std::vector<Point_3> polyline = {{-1., 0., 0.}, {0., 0., 0.}, {0., 0.5, -1.}};
  const auto path = GP::shorten_polyline(polyline, squared_distance);
  // The corner is cut by at most one of 76 segments, which was halved four times.
  const double expected = std::hypot(2., 0.5);
  EXPECT_NEAR(path.distance, expected, expected / 76. / 16.);
}

TEST(shorten_polyline, keeps_end_points)
{
  const std::vector<Point_3> polyline = {{0., 0., 0.}, {0.3, 0.8, 0.}, {1., 0., 0.}};
  const auto path = GP::shorten_polyline(polyline, [](const Point_3& p) { return p.z() * p.z(); });
  EXPECT_EQ(path.points.front(), polyline.front());
  EXPECT_EQ(path.points.back(), polyline.back());
  EXPECT_NEAR(path.distance, 1., 1e-9); // the energy is flat to 1e-11
}

TEST(shorten_polyline, shortens_on_mesh_and_cloud)
{
  // A polyline with a bend in the unit square, which is not straight at first.
  const std::vector<Point_3> polyline = {{0.1, 0.1, 0.}, {0.3, 0.8, 0.}, {0.9, 0.2, 0.}};
  const double expected = std::hypot(0.8, 0.1);
  const Mesh mesh = mesh_of(square(12, 0.2));
  const auto on_mesh = GP::shorten_polyline(mesh, polyline);
  EXPECT_NEAR(on_mesh.length, expected, 1e-12); // sums of some tens of lengths
  EXPECT_LT(CGAL::squared_distance(on_mesh.points.front(), polyline.front()), 1e-26);
  // The square of a round-off error.
  EXPECT_LT(CGAL::squared_distance(on_mesh.points.back(), polyline.back()), 1e-26);

  const auto domain = GP::make_domain(mesh);
  const GP::Surface_locator<Mesh> locate(domain);
  std::vector<GP::Location<Mesh>> locations;
  for(const Point_3& p : polyline)
    locations.push_back(locate(p));
  EXPECT_EQ(GP::shorten_polyline(domain, locations).points, on_mesh.points);

  Surfels cloud;
  for(int i = 0; i <= 30; ++i)
    for(int j = 0; j <= 30; ++j)
      cloud.emplace_back(Point_3(i / 30., j / 30., 0.), Kernel::Vector_3(0., 0., 1.));
  const auto on_cloud = GP::shorten_polyline(
      cloud, polyline,
      GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  EXPECT_NEAR(on_cloud.front_distance, expected, 1e-9); // the energy is flat to 1e-11
  EXPECT_FALSE(on_cloud.initial_path.empty());
  EXPECT_LT(CGAL::squared_distance(on_cloud.points.front(), polyline.front()), 1e-20);
}

TEST(shorten_polyline, keeps_the_long_way_around_cylinder_of_surfels)
{
  Surfels cylinder;
  for(int i = 0; i < 60; ++i)
    for(int j = 0; j <= 20; ++j)
    {
      const double a = 2. * GP::internal::pi * i / 60.;
      cylinder.emplace_back(Point_3(std::cos(a), std::sin(a), 0.1 * j),
                            Kernel::Vector_3(std::cos(a), std::sin(a), 0.));
    }
  std::vector<Point_3> polyline;
  for(int i = 0; i <= 8; ++i)
    polyline.emplace_back(std::cos(0.5 * i), std::sin(0.5 * i),
                          0.4 + 0.15 * i + 0.2 * std::sin(GP::internal::pi * i / 4.));
  const auto path = GP::shorten_polyline(
      cylinder, polyline,
      GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map()));
  // The height of the fitted quadrics has errors of the fourth order in the spacing of 0.1.
  EXPECT_NEAR(path.front_distance, std::hypot(4., 1.2), 1e-4 * std::hypot(4., 1.2));
}

TEST(shorten_polyline, throws_on_invalid_polyline)
{
  const auto plane_squared_distance = [](const Point_3& p) { return p.z() * p.z(); };
  EXPECT_THROW(GP::shorten_polyline(std::vector<Point_3>{{0., 0., 0.}}, plane_squared_distance),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::shorten_polyline(std::vector<Point_3>{{0., 0., 0.}, {1., 0., 0.}},
                                    [](const Point_3&) { return std::nan(""); }),
               GP::Invalid_argument_error);
  const Mesh mesh = mesh_of(square(2));
  EXPECT_THROW(GP::shorten_polyline(mesh, std::vector<Point_3>{{0., 0., 0.}}),
               GP::Invalid_argument_error);
  EXPECT_THROW(
      GP::shorten_polyline(mesh, std::vector<Point_3>{{0., 0., 0.}, {std::nan(""), 0., 0.}}),
      GP::Invalid_argument_error);
}

} // namespace shorten_polyline_test
