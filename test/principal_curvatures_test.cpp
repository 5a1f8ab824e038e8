// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/principal_curvatures.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace principal_curvatures_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(Principal_curvatures, are_equal_on_spheres)
{
  const Triangulation sphere = icosphere(4);
  const Mesh mesh = mesh_of(sphere);
  std::map<Vertex, GP::Principal_curvatures<Mesh>> on_mesh;
  GP::principal_curvatures(mesh, boost::make_assoc_property_map(on_mesh));
  for(const auto& [vertex, curvature] : on_mesh)
  {
    // Same tolerances as in the test of the kernel.
    EXPECT_NEAR(curvature.min_curvature, 1., 0.05);
    EXPECT_NEAR(curvature.max_curvature, 1., 0.05);
    EXPECT_NEAR(curvature.min_direction * curvature.max_direction, 0., 1e-12); // round-off errors
    // The angle between the estimated normal and the exact one; measured: 0.004.
    EXPECT_NEAR(curvature.max_direction * (mesh.point(vertex) - CGAL::ORIGIN), 0., 0.01);
  }
  ASSERT_EQ(on_mesh.size(), sphere.points.size());

  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Numbered<Polyhedron> polyhedron;
  fill(polyhedron, sphere);
  std::map<Numbered<Polyhedron>::Vertex, GP::Principal_curvatures<Polyhedron>> on_polyhedron;
  GP::principal_curvatures(polyhedron.mesh, boost::make_assoc_property_map(on_polyhedron));
  for(Index i = 0; i < sphere.points.size(); ++i)
    EXPECT_EQ(on_polyhedron[polyhedron.vertices[i]].max_curvature,
              on_mesh[Vertex(i)].max_curvature);

  const Surfels surfels = sphere_surfels(4);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  std::vector<GP::Principal_curvatures<Surfels>> on_cloud(surfels.size());
  GP::principal_curvatures(surfels, CGAL::make_property_map(on_cloud), maps);
  for(const auto& curvature : on_cloud)
  {
    // A quadratic surface deviates from the sphere by the fourth power of the ball radius.
    EXPECT_NEAR(curvature.min_curvature, 1., 0.02);
    EXPECT_NEAR(curvature.max_curvature, 1., 0.02);
  }
}

TEST(Principal_curvatures, have_opposite_signs_on_a_saddle)
{
  Surfels surfels = flat_surfels(1200);
  for(auto& [point, normal] : surfels)
  {
    const double x = 2. * point.x() - 1., y = 2. * point.y() - 1.;
    point = Kernel::Point_3(x, y, x * y);
    normal = Kernel::Vector_3(-y, -x, 1.) / std::sqrt(1. + x * x + y * y);
  }
  surfels[0] = {Kernel::Point_3(0., 0., 0.), Kernel::Vector_3(0., 0., 1.)};
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  for(const double scale : {1., 1e-6, 1e6})
  {
    Surfels scaled = surfels;
    for(auto& [point, normal] : scaled)
      point = CGAL::ORIGIN + scale * (point - CGAL::ORIGIN);
    std::vector<GP::Principal_curvatures<Surfels>> found(surfels.size());
    GP::principal_curvatures<CGAL::Parallel_tag>(
        scaled, CGAL::make_property_map(found),
        maps.ball_radius(0.25 * scale).number_of_threads(2));
    // x y is quadratic. A ball of radius 0.25 adds errors of fourth order.
    EXPECT_NEAR(scale * found[0].min_curvature, -1., 0.03);
    EXPECT_NEAR(scale * found[0].max_curvature, 1., 0.03);
    // Seen from above, the surface is convex along x = -y, where it descends to both sides.
    const auto& d = found[0].max_direction;
    EXPECT_NEAR(std::abs(d.x() - d.y()), std::sqrt(2.), 1e-3);
  }
}

TEST(Principal_curvatures, throws_on_invalid_radius)
{
  const Mesh mesh = mesh_of(tetrahedron());
  std::map<Vertex, GP::Principal_curvatures<Mesh>> found;
  for(const double radius : {-1., std::nan("")})
    EXPECT_THROW(GP::principal_curvatures(mesh, boost::make_assoc_property_map(found),
                                          GP::parameters::ball_radius(radius)),
                 GP::Invalid_argument_error);
}

} // namespace principal_curvatures_test
