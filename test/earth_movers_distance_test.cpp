// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/earth_movers_distance.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace earth_movers_distance_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(earth_movers_distance, agrees_with_solver)
{
  Mesh mesh = mesh_of(jittered(icosphere(2), 0.03));
  const Vertex from(0), to(50);
  GP::Earth_movers_solver<Mesh> solver(mesh, GP::parameters::number_of_refinements(1u));
  const GP::Earth_movers_cost expected =
      solver.compute<GP::Alternating_directions>(from, to, GP::parameters::tolerance(0.01));
  const auto potential = vertex_map(mesh);
  const auto flow = mesh.add_property_map<Face, Kernel::Vector_3>().first;
  const GP::Earth_movers_cost cost = GP::earth_movers_distance<GP::Alternating_directions>(
      mesh, from, to,
      GP::parameters::tolerance(0.01).number_of_refinements(1u).potential_map(potential).flow_map(
          flow));
  EXPECT_EQ(cost.value, expected.value);
  EXPECT_EQ(cost.estimate, expected.estimate);
  for(const Vertex v : mesh.vertices())
    EXPECT_EQ(potential[v], solver.potential(v));
  const auto expected_flow = mesh.add_property_map<Face, Kernel::Vector_3>().first;
  solver.write_flow(expected_flow);
  for(const Face f : mesh.faces())
    EXPECT_EQ(flow[f], expected_flow[f]);
}

TEST(earth_movers_distance, accepts_domain)
{
  const Mesh mesh = mesh_of(square(4));
  EXPECT_EQ(GP::earth_movers_distance(GP::make_domain(mesh), Vertex(0), Vertex(24)).value,
            GP::earth_movers_distance(mesh, Vertex(0), Vertex(24)).value);
}

// The same distribution in two forms: unit mass at locations, and ten times its masses at vertices.
TEST(earth_movers_distance, is_zero_between_equal_distributions)
{
  Mesh mesh = mesh_of(jittered(icosphere(2), 0.03));
  const std::array<double, 3> barycentric = {0.1, 0.2, 0.7};
  std::vector<GP::Location<Mesh>> locations;
  const auto mass = vertex_map(mesh);
  for(const Face f : mesh.faces())
  {
    if(locations.size() == 30)
      break;
    locations.emplace_back(f, barycentric);
    const auto h = mesh.halfedge(f);
    mass[mesh.source(h)] += barycentric[0] / 3.;
    mass[mesh.target(h)] += barycentric[1] / 3.;
    mass[mesh.target(mesh.next(h))] += barycentric[2] / 3.;
  }
  const GP::Earth_movers_cost cost =
      GP::earth_movers_distance(mesh, locations, mass, GP::parameters::do_normalize(true));
  EXPECT_EQ(cost.value, 0.);
  EXPECT_EQ(cost.upper, 0.);
  EXPECT_TRUE(cost.is_converged);
}

// Round-off errors of coordinates give triangles on a line a tiny area.
TEST(Earth_movers_solver, rejects_surface_without_area)
{
  const Mesh line = mesh_of(grid(4, 4,
                                 [](double u, double v) {
                                   return Point{u + v, 0.3 * (u + v), 0.7 * (u + v)};
                                 }));
  EXPECT_THROW(GP::Earth_movers_solver<Mesh>{line}, GP::Unsupported_surface_error);
}

TEST(Earth_movers_solver, has_no_result_before_a_query)
{
  Mesh mesh = mesh_of(square(4));
  const GP::Earth_movers_solver<Mesh> solver(mesh);
  const auto values = vertex_map(mesh);
  const auto flow = mesh.add_property_map<Face, Kernel::Vector_3>().first;
  EXPECT_THROW(solver.potential(Vertex(0)), GP::Invalid_argument_error);
  EXPECT_THROW(solver.write_potential(values), GP::Invalid_argument_error);
  EXPECT_THROW(solver.write_flow(flow), GP::Invalid_argument_error);
  EXPECT_THROW(solver.write_likelihood(values), GP::Invalid_argument_error);
  EXPECT_THROW(solver.streamlines(), GP::Invalid_argument_error);
}

} // namespace earth_movers_distance_test
