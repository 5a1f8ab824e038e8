// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Base_parameterization.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <random>

namespace Base_parameterization_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

template <typename AnyMesh>
void expect_round_trip(const AnyMesh& mesh)
{
  const GP::Base_parameterization<AnyMesh> base(mesh, 30);
  EXPECT_GE(base.number_of_base_vertices(), 30u);
  EXPECT_EQ(base.number_of_flips(), 0u);
  for(const auto v : vertices(mesh))
  {
    const auto p = base.point(base(v)), q = get(CGAL::vertex_point, mesh, v);
    // The height of image triangles is at least 1e-8 of an edge length.
    EXPECT_LT(CGAL::squared_distance(p, q), 1e-14);
  }
  for(std::size_t i = 0; i < base.number_of_base_vertices(); ++i)
  {
    const GP::Base_location base_location = base(base.base_vertex(i));
    double weight = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      if(base.base_face(base_location.face)[k] == i)
        weight = base_location.barycentric[k];
    // Round-off errors of coordinates in a triangle that is subdivided.
    EXPECT_NEAR(weight, 1., 1e-9);
  }
}

TEST(Base_parameterization, round_trip_is_identity_on_all_mesh_types)
{
  expect_round_trip(mesh_of(icosphere(3)));
  expect_round_trip(mesh_of(annulus(24, 8, 1., 3.)));
  Numbered<CGAL::Polyhedron_3<Kernel>> polyhedron;
  fill(polyhedron, torus(24, 16));
  expect_round_trip(polyhedron.mesh);
}

TEST(Base_parameterization, uses_requested_coordinates)
{
  const Mesh mesh = mesh_of(icosphere(2));
  const auto with = [&](GP::Base_coordinates kind)
  { return GP::Base_parameterization<Mesh>(mesh, 20, GP::parameters::base_coordinates(kind)); };
  const auto heron = with(GP::Base_coordinates::heron),
             uniform = with(GP::Base_coordinates::uniform);
  EXPECT_EQ(uniform.number_of_repaired_faces(), 0u);
  bool is_different = false;
  for(const Vertex v : mesh.vertices())
    is_different = is_different || heron(v).barycentric != uniform(v).barycentric;
  EXPECT_TRUE(is_different);
}

TEST(Base_parameterization, throws_on_invalid_locations)
{
  const Mesh mesh = mesh_of(icosphere(2));
  const GP::Base_parameterization<Mesh> base(mesh, 20);
  EXPECT_THROW(base.point({base.number_of_base_faces(), {1., 0., 0.}}), GP::Invalid_argument_error);
  EXPECT_THROW(base.base_face(base.number_of_base_faces()), GP::Invalid_argument_error);
  EXPECT_THROW(base.base_vertex(base.number_of_base_vertices()), GP::Invalid_argument_error);
  EXPECT_THROW(base.point({0, {1., 1., 0.}}), GP::Invalid_argument_error);
  EXPECT_THROW(base.point({0, {2., -1., 0.}}), GP::Invalid_argument_error);
  EXPECT_THROW(GP::Base_parameterization<Mesh>(Mesh(), 20), GP::Invalid_argument_error);
  const std::function<bool(double)> cancel = [](double) { return false; };
  EXPECT_THROW(GP::Base_parameterization<Mesh>(mesh, 20, GP::parameters::callback(cancel)),
               GP::Cancelled);
  Mesh with_isolated = mesh;
  const Vertex isolated = with_isolated.add_vertex(Kernel::Point_3(0., 0., 0.));
  const GP::Base_parameterization<Mesh> other(with_isolated, 20);
  EXPECT_THROW(other(isolated), GP::Invalid_argument_error);
}

TEST(Base_parameterization, maps_surfels_of_cloud)
{
  const Surfels surfels = sphere_surfels(3);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const GP::Base_parameterization<Surfels> base(surfels, 30, maps),
      of_domain(GP::make_domain(surfels, maps), 30);
  EXPECT_EQ(base.number_of_flips(), 0u);
  EXPECT_EQ(base.number_of_base_faces(), 2 * base.number_of_base_vertices() - 4); // a sphere
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    const GP::Base_location location = base(i);
    EXPECT_EQ(of_domain(i).barycentric, location.barycentric);
    // Surfels are vertices of the reconstructed mesh. The height of image triangles is at least
    // 1e-8 of an edge length.
    EXPECT_LT(CGAL::squared_distance(base.point(location), surfels[i].first), 1e-14);
    const auto round_trip = base.inverse(location);
    EXPECT_EQ(round_trip.surfel, i);
    EXPECT_NEAR(std::hypot(round_trip.offset[0], round_trip.offset[1]), 0., 1e-7); // the same error
  }
}

} // namespace Base_parameterization_test
