// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/property_map.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

namespace semi_regular_remeshing_test {

namespace GP = CGAL::Geodesic_processing;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace GP::test;

TEST(semi_regular_remeshing, accepts_domain)
{
  const Mesh mesh = mesh_of(icosphere(3));
  Mesh of_mesh, of_domain;
  GP::semi_regular_remeshing(mesh, 30, 2, of_mesh);
  GP::semi_regular_remeshing(GP::make_domain(mesh), 30, 2, of_domain);
  ASSERT_EQ(num_vertices(of_domain), num_vertices(of_mesh));
  EXPECT_EQ(num_faces(of_domain), num_faces(of_mesh));
  for(const Vertex v : of_mesh.vertices())
    EXPECT_EQ(of_domain.point(v), of_mesh.point(v));
}

TEST(semi_regular_remeshing, reconstructs_cloud)
{
  const Surfels surfels = sphere_surfels(3);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  CGAL::Polyhedron_3<Kernel> output;
  const auto result = GP::semi_regular_remeshing(surfels, 30, 2, output, maps);
  EXPECT_EQ(result.number_of_flips, 0u);
  EXPECT_EQ(num_faces(output), 16 * result.number_of_base_faces);
  EXPECT_EQ(num_faces(output), 2 * num_vertices(output) - 4); // a sphere
  for(const auto v : vertices(output))
    // Triangles between 642 surfels are 0.006 below the sphere.
    EXPECT_NEAR(std::sqrt((v->point() - CGAL::ORIGIN).squared_length()), 1., 0.01);
}

TEST(semi_regular_remeshing, has_subdivision_connectivity)
{
  const Mesh mesh = mesh_of(icosphere(3));
  Mesh output;
  CGAL::Unique_hash_map<Vertex, std::size_t> level;
  const auto result = GP::semi_regular_remeshing(
      mesh, 30, 3, output, GP::parameters::level_map(boost::make_assoc_property_map(level)));
  EXPECT_EQ(result.number_of_levels, 3u);
  EXPECT_EQ(result.number_of_flips, 0u);
  EXPECT_EQ(num_faces(output), 64 * result.number_of_base_faces);
  EXPECT_TRUE(output.is_valid());
  std::size_t last = 0;
  for(const Vertex v : output.vertices())
  {
    EXPECT_GE(level[v], last);
    last = level[v];
    EXPECT_TRUE(last == 0 || output.degree(v) == 6);
  }
  EXPECT_EQ(last, 3u);
}

TEST(semi_regular_remeshing, writes_quads_on_request)
{
  CGAL::Polyhedron_3<Kernel> output;
  const Mesh mesh = mesh_of(torus(24, 16));
  const auto quads = GP::parameters::subdivision_scheme(GP::Subdivision_scheme::quads);
  const auto result = GP::semi_regular_remeshing(mesh, 40, 1, output, quads);
  EXPECT_EQ(output.size_of_facets(), 12 * result.number_of_base_faces);
  EXPECT_TRUE(output.is_pure_quad());
  EXPECT_TRUE(output.is_closed());
  EXPECT_THROW(GP::semi_regular_remeshing(mesh, 40, 1, output, quads.maximum_deviation(1.)),
               GP::Invalid_argument_error);
}

TEST(semi_regular_remeshing, stops_at_maximum_deviation)
{
  const Mesh mesh = mesh_of(icosphere(3));
  Mesh coarse, fine;
  const auto few =
      GP::semi_regular_remeshing(mesh, 30, 5, coarse, GP::parameters::maximum_deviation(0.3));
  const auto more =
      GP::semi_regular_remeshing(mesh, 30, 5, fine, GP::parameters::maximum_deviation(0.03));
  EXPECT_LT(few.number_of_levels, more.number_of_levels);
  EXPECT_LT(more.number_of_levels, 5u);
  // The requested deviations.
  EXPECT_LE(few.deviation, 0.3);
  EXPECT_LE(more.deviation, 0.03);
  EXPECT_GT(more.deviation, 0.);
  EXPECT_THROW(
      GP::semi_regular_remeshing(mesh, 30, 5, fine, GP::parameters::maximum_deviation(-1.)),
      GP::Invalid_argument_error);
}

// Returns the surface of [0, 1]^3 with 2 n^2 triangles per cube face.
Mesh cube(int n)
{
  Mesh result;
  std::map<std::array<int, 3>, Vertex> vertex;
  const auto at = [&](std::array<int, 3> p)
  {
    const auto [found, is_new] = vertex.try_emplace(p);
    if(is_new)
      found->second =
          result.add_vertex(Kernel::Point_3(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n));
    return found->second;
  };
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(const int level : {0, n})
      for(int i = 0; i < n; ++i)
        for(int j = 0; j < n; ++j)
        {
          std::array<Vertex, 4> corner;
          constexpr std::array<int, 4> across = {0, 1, 1, 0}, along = {0, 0, 1, 1};
          for(std::size_t k = 0; k < 4; ++k)
          {
            std::array<int, 3> p;
            p[axis] = level;
            p[(axis + 1) % 3] = i + across[k];
            p[(axis + 2) % 3] = j + along[k];
            corner[level == 0 ? 3 - k : k] = at(p);
          }
          result.add_face(corner[0], corner[1], corner[2]);
          result.add_face(corner[0], corner[2], corner[3]);
        }
  return result;
}

// Returns the number of cube faces that contain a point.
int number_of_cube_faces_at(const Kernel::Point_3& p)
{
  int result = 0;
  for(int k = 0; k < 3; ++k)
    result += std::abs(p[k]) < 1e-12 || std::abs(p[k] - 1.) < 1e-12;
  return result;
}

template <typename NamedParameters>
void expect_cube_edges_preserved(const Mesh& mesh, const NamedParameters& np)
{
  Mesh output;
  GP::semi_regular_remeshing(mesh, 60, 2, output, np);
  // Output edges on the cube's edges have the same total length as the cube's edges.
  double length = 0.;
  for(const auto e : output.edges())
  {
    const auto &p = output.point(output.vertex(e, 0)), &q = output.point(output.vertex(e, 1));
    if(number_of_cube_faces_at(p) > 1 && number_of_cube_faces_at(q) > 1 &&
       number_of_cube_faces_at(CGAL::midpoint(p, q)) > 1)
      length += PMP::edge_length(e, output);
  }
  EXPECT_NEAR(length, 12., 1e-10); // round-off errors of sums of some hundred terms
  EXPECT_NEAR(PMP::area(output), 6., 1e-10);
  EXPECT_NEAR(PMP::volume(output), 1., 1e-10);
}

TEST(semi_regular_remeshing, preserves_sharp_and_constrained_edges)
{
  Mesh mesh = cube(6);
  expect_cube_edges_preserved(mesh, GP::parameters::sharp_angle(60.));
  const auto is_kept = mesh.add_property_map<Mesh::Edge_index, bool>("e:kept", false).first;
  for(const auto e : mesh.edges())
    is_kept[e] = number_of_cube_faces_at(CGAL::midpoint(mesh.point(mesh.vertex(e, 0)),
                                                        mesh.point(mesh.vertex(e, 1)))) > 1;
  expect_cube_edges_preserved(mesh, GP::parameters::edge_is_constrained_map(is_kept));
}

TEST(semi_regular_remeshing, density_follows_speed)
{
  Mesh mesh = mesh_of(icosphere(3)), output;
  const auto speed = vertex_map(mesh);
  for(const Vertex v : mesh.vertices())
    speed[v] = mesh.point(v).z() > 0. ? 0.25 : 1.;
  GP::semi_regular_remeshing(mesh, 60, 1, output, GP::parameters::speed_map(speed));
  int above = 0, below = 0;
  for(const Vertex v : output.vertices())
    ++(output.point(v).z() > 0. ? above : below);
  EXPECT_GT(above, 4 * below);
}

TEST(semi_regular_remeshing, starts_with_first_samples)
{
  const Mesh mesh = mesh_of(icosphere(3));
  const Vertex first(100);
  Mesh output;
  GP::semi_regular_remeshing(mesh, 30, 1, output, GP::parameters::first_samples(first));
  EXPECT_EQ(output.point(Vertex(0)), mesh.point(first));
}

} // namespace semi_regular_remeshing_test
