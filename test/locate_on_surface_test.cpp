// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/locate_on_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <limits>

namespace locate_on_surface_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Round-off errors of coordinates near 1.
constexpr double round_off = 1e-14;

Kernel::Point_3 to_point(const Point& p) { return {p[0], p[1], p[2]}; }

TEST(Locate_on_surface, mesh_locations_round_trip)
{
  for(const double scale : {1., 1e-160, 1e160})
  {
    const Triangulation surface = scaled(jittered(icosphere(3), 0.03), scale);
    const Mesh mesh = mesh_of(surface);
    const GP::Surface_locator<Mesh> locate(mesh);
    std::mt19937 random(1);
    for(int i = 0; i < 200; ++i)
    {
      const auto location = random_location_of(mesh, random);
      const Point p = point_of(mesh, location), q = point_of(mesh, locate(to_point(p)));
      for(int k = 0; k < 3; ++k)
        EXPECT_NEAR(p[k] / scale, q[k] / scale, round_off);
    }
    for(const Vertex v : mesh.vertices())
    {
      const Point q = point_of(mesh, locate(mesh.point(v)));
      for(int k = 0; k < 3; ++k)
        EXPECT_NEAR(q[k] / scale, mesh.point(v)[k] / scale, round_off);
    }
  }
}

TEST(Locate_on_surface, projects_points_off_surface)
{
  const Mesh mesh = mesh_of(square(8, 0.24));
  const auto projection = [&](double x, double y, double z)
  { return point_of(mesh, GP::locate_on_surface(mesh, Kernel::Point_3(x, y, z))); };
  EXPECT_LT(distance(projection(0.3, 0.4, 2.), {0.3, 0.4, 0.}), round_off);
  EXPECT_LT(distance(projection(-1., 0.4, 2.), {0., 0.4, 0.}), round_off);
  EXPECT_LT(distance(projection(7., 8., 9.), {1., 1., 0.}), round_off);
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  EXPECT_LT(distance(point_of(mesh, GP::locate_on_surface(mesh, Exact::Point_3(0.5, 0.5, 1.))),
                     {0.5, 0.5, 0.}),
            round_off);
}

TEST(Locate_on_surface, ignores_degenerate_faces)
{
  Triangulation surface = square(6, 0.24);
  surface.points[24] = surface.points[25];
  const Mesh mesh = mesh_of(surface);
  const GP::Surface_locator<Mesh> locate(mesh);
  for(const Vertex v : mesh.vertices())
    EXPECT_LT(distance(point_of(mesh, locate(mesh.point(v))), to_array(mesh.point(v))), round_off);
}

TEST(Locate_on_surface, locates_surfels_and_points_between_them)
{
  const Surfels cloud = flat_surfels(3000);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const GP::Surfel_domain<Surfels> domain(cloud, np);
  const GP::Surface_locator<Surfels> locate(domain);
  for(std::size_t i = 0; i < cloud.size(); ++i)
  {
    const auto location = locate(cloud[i].first);
    EXPECT_EQ(location.surfel, i);
    EXPECT_NEAR(std::hypot(location.offset[0], location.offset[1]), 0., round_off);
  }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> inside(0.1, 0.9);
  for(int i = 0; i < 300; ++i)
  {
    const Kernel::Point_3 p(inside(random), inside(random), 0.01);
    const auto found = domain.point(domain.inner(locate(p)));
    // The offset is measured from a surfel.
    EXPECT_LT(CGAL::squared_distance(found, Kernel::Point_3(p.x(), p.y(), 0.)),
              10000. * round_off * round_off);
  }
}

TEST(Locate_on_surface, throws_on_nonfinite_points_and_empty_surfaces)
{
  const Mesh mesh = mesh_of(square(2));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(GP::locate_on_surface(mesh, Kernel::Point_3(nan, 0., 0.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::locate_on_surface(mesh, Kernel::Point_3(0., infinity, 0.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::locate_on_surface(Mesh(), Kernel::Point_3(0., 0., 0.)),
               GP::Invalid_argument_error);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  EXPECT_THROW(GP::locate_on_surface(flat_surfels(50), Kernel::Point_3(nan, 0., 0.), np),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::locate_on_surface(Surfels(), Kernel::Point_3(0., 0., 0.), np),
               GP::Invalid_argument_error);
}

} // namespace locate_on_surface_test
