// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/transport_barycenter.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <vector>

namespace transport_barycenter_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(Transport_barycenter, agrees_with_solver)
{
  Mesh mesh = mesh_of(square(8, 0.24));
  const std::vector<Vertex> points = {Vertex(0), Vertex(8), Vertex(76)};
  auto masses = vertex_map(mesh);
  const std::vector<double> weights = {1., 2., 3.};
  const auto np = GP::parameters::weights(weights).number_of_refinements(0u);
  const GP::Transport_barycenter_cost cost = GP::transport_barycenter(mesh, points, masses, np);
  GP::Transport_barycenter_solver<Mesh> solver(mesh, np);
  EXPECT_EQ(solver.compute(points, np).value, cost.value);
  EXPECT_GT(cost.value, 0.);
  double sum = 0.;
  for(const Vertex v : vertices(mesh))
  {
    EXPECT_EQ(masses[v], solver.mass(v));
    EXPECT_GE(masses[v], 0.);
    sum += masses[v];
  }
  EXPECT_NEAR(sum, 1., 1e-9); // round-off error of a sum
  const auto domain = GP::make_domain(mesh);
  EXPECT_EQ(GP::transport_barycenter(domain, points, masses, np).value, cost.value);
}

TEST(Transport_barycenter_solver, has_no_masses_before_a_query)
{
  Mesh mesh = mesh_of(square(4));
  const GP::Transport_barycenter_solver<Mesh> solver(mesh);
  EXPECT_THROW(solver.mass(Vertex(0)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.write_masses(vertex_map(mesh)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.write_density(vertex_map(mesh)), GP::Invalid_argument_error);
}

} // namespace transport_barycenter_test
