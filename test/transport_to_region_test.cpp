// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/transport_to_region.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <vector>

namespace transport_to_region_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

TEST(Transport_to_region, agrees_with_solver)
{
  Mesh mesh = mesh_of(square(8, 0.24));
  const std::vector<Vertex> region = {Vertex(8), Vertex(80)};
  auto arrivals = vertex_map(mesh), potential = vertex_map(mesh);
  auto flow = mesh.add_property_map<Face, Kernel::Vector_3>("flow").first;
  const auto np = GP::parameters::number_of_refinements(0u).tolerance(1e-4);
  const GP::Earth_movers_cost cost =
      GP::transport_to_region(mesh, Vertex(0), region,
                              GP::parameters::number_of_refinements(0u)
                                  .tolerance(1e-4)
                                  .arrival_map(arrivals)
                                  .potential_map(potential)
                                  .flow_map(flow));
  GP::Region_transport_solver<Mesh> solver(mesh, region, np);
  EXPECT_EQ(solver.compute(Vertex(0), np).value, cost.value);
  EXPECT_NEAR(cost.value, 1., 1e-4); // the requested gap
  Kernel::Vector_3 moment = CGAL::NULL_VECTOR;
  for(const Face f : faces(mesh))
  {
    const auto h = mesh.halfedge(f);
    moment = moment + 0.5 *
                          CGAL::cross_product(
                              mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)),
                              mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.source(h)))
                              .z() *
                          flow[f];
  }
  // The integral of the flow is the mean displacement of the mass.
  Kernel::Vector_3 mean_displacement = CGAL::NULL_VECTOR;
  for(const Vertex v : vertices(mesh))
  {
    EXPECT_EQ(arrivals[v], solver.arrival(v));
    EXPECT_EQ(potential[v], solver.potential(v));
    mean_displacement = mean_displacement + arrivals[v] * (mesh.point(v) - mesh.point(Vertex(0)));
  }
  // The square of the round-off errors of sums.
  EXPECT_LT((moment - mean_displacement).squared_length(), 1e-24);
}

} // namespace transport_to_region_test
