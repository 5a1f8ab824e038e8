// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/semi_regular_remeshing.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(semi_regular_remeshing, has_subdivision_connectivity)
{
  const Mesh mesh = mesh_of(icosphere(3));
  Mesh output;
  const auto level = output.add_property_map<Vertex, std::size_t>("v:level").first;
  const auto result =
      GP::semi_regular_remeshing(mesh, 30, 3, output, GP::parameters::level_map(level));
  EXPECT_EQ(result.levels, 3u);
  EXPECT_EQ(result.folds, 0u);
  EXPECT_EQ(num_faces(output), 64 * result.base_faces);
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

TEST(semi_regular_remeshing, has_quads_on_request)
{
  CGAL::Polyhedron_3<Kernel> output;
  const auto result =
      GP::semi_regular_remeshing(mesh_of(torus(24, 16)), 40, 1, output,
                                 GP::parameters::subdivision_scheme(GP::Subdivision_scheme::quads));
  EXPECT_EQ(output.size_of_facets(), 12 * result.base_faces);
  EXPECT_TRUE(output.is_pure_quad());
  EXPECT_TRUE(output.is_closed());
}

TEST(semi_regular_remeshing, ends_where_it_is_near_enough)
{
  const Mesh mesh = mesh_of(icosphere(3));
  Mesh coarse, fine;
  const auto few =
      GP::semi_regular_remeshing(mesh, 30, 5, coarse, GP::parameters::maximum_deviation(0.3));
  const auto more =
      GP::semi_regular_remeshing(mesh, 30, 5, fine, GP::parameters::maximum_deviation(0.03));
  EXPECT_LT(few.levels, more.levels);
  EXPECT_LT(more.levels, 5u);
  EXPECT_THROW(
      GP::semi_regular_remeshing(mesh, 30, 5, fine, GP::parameters::maximum_deviation(-1.)),
      GP::Invalid_argument_error);
}

} // namespace
