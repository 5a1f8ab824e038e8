// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_mds.h>

#include <CGAL/Geodesic_processing/distortion.h>
#include <CGAL/Geodesic_processing/exceptions.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geodesic_mds_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using UV = std::array<double, 2>;

// Round-off errors of eigenvectors of a matrix of squared distances.
constexpr double round_off = 1e-9;

TEST(geodesic_mds, is_isometric_on_square)
{
  Mesh mesh = mesh_of(square(20, 0.25));
  auto uv = vertex_map<UV>(mesh);
  const auto base =
      GP::geodesic_mds(mesh, uv, GP::parameters::number_of_base_points(std::size_t(30)));
  EXPECT_EQ(base.size(), 30u);
  for(const Vertex v : mesh.vertices())
    EXPECT_NEAR(std::hypot(uv[v][0] - uv[Vertex(9)][0], uv[v][1] - uv[Vertex(9)][1]),
                std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(Vertex(9)))), round_off);
  const auto distortion = GP::flattening_distortion(mesh, uv);
  EXPECT_EQ(distortion.number_of_flips, 0u);
  EXPECT_NEAR(distortion.symmetric_dirichlet, 4., round_off);
}

TEST(geodesic_mds, equals_classical_mds_with_all_vertices)
{
  Mesh mesh = mesh_of(square(4, 0.25));
  auto uv = vertex_map<UV>(mesh);
  const auto base =
      GP::geodesic_mds(mesh, uv, GP::parameters::number_of_base_points(std::size_t(25)));
  EXPECT_EQ(base.size(), mesh.number_of_vertices());
  for(const Vertex v : mesh.vertices())
    for(const Vertex w : mesh.vertices())
      EXPECT_NEAR(std::hypot(uv[v][0] - uv[w][0], uv[v][1] - uv[w][1]),
                  std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))), round_off);
}

TEST(geodesic_mds, throws_on_invalid_arguments)
{
  Mesh mesh = mesh_of(disjoint_union(square(3), icosphere(0)));
  auto uv = vertex_map<UV>(mesh);
  EXPECT_THROW(GP::geodesic_mds(mesh, uv), GP::Unsupported_surface_error);
  Mesh one = mesh_of(one_triangle());
  auto uv_of_one = vertex_map<UV>(one);
  EXPECT_THROW(
      GP::geodesic_mds(one, uv_of_one, GP::parameters::number_of_base_points(std::size_t(1))),
      GP::Invalid_argument_error);
  EXPECT_EQ(GP::geodesic_mds(one, uv_of_one).size(), 3u);
}

} // namespace geodesic_mds_test
