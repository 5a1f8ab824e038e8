// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Spanning_forest.h"

#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Spanning_forest_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of a sum of some ten lengths.
constexpr double round_off = 1e-12;

// Returns the cost in the unit of the coordinates.
double cost(const Array_surface& surface, const Operators& operators, const Vector& masses)
{
  return surface.scale() * Spanning_forest(operators).cost(masses);
}

double cost(const Array_surface& surface, const Vector& masses)
{
  return cost(surface, operators(surface.t()), masses);
}

Vector masses(const Array_surface& surface, Index from, Index to, double mass = 1.)
{
  Vector result = Vector::Zero(surface.size());
  result[surface.vertex(from)] -= mass;
  result[surface.vertex(to)] += mass;
  return result;
}

// Vertices 0 to 4 are on a line at distance 1, vertex 5 is at distance 10 of it.
Triangulation fan()
{
  return {{{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {3., 0., 0.}, {4., 0., 0.}, {2., 10., 0.}},
          {0, 1, 5, 1, 2, 5, 2, 3, 5, 3, 4, 5}};
}

TEST(Spanning_forest, masses_move_along_edges)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Triangulation triangulation = fan();
    for(auto& point : triangulation.points)
      for(double& coordinate : point)
        coordinate *= scale;
    const Array_surface surface(triangulation);
    EXPECT_EQ(cost(surface, Vector::Zero(6)), 0.);
    // Each edge with the root is in the tree.
    EXPECT_NEAR(cost(surface, masses(surface, 0, 1)), scale, round_off * scale);
    EXPECT_NEAR(cost(surface, masses(surface, 1, 0, 2.5)), 2.5 * scale, 2.5 * round_off * scale);
    // Masses do not interfere, and opposite masses on a path cancel.
    const double from_4 = cost(surface, masses(surface, 4, 0));
    EXPECT_NEAR(cost(surface, masses(surface, 4, 1) + masses(surface, 1, 0)), from_4,
                round_off * from_4);
    // A path of at most three edges, none longer than 11
    EXPECT_GE(from_4, 4. * scale);
    EXPECT_LE(from_4, 3. * 11. * scale);
  }
}

TEST(Spanning_forest, lengths_are_those_of_the_metric)
{
  const Array_surface surface(fan());
  const std::vector<Metric_tensor> metric(4, Metric_tensor{3., 0., 3.});
  const Operators o = metric_operators(surface.t(), metric);
  EXPECT_NEAR(cost(surface, o, masses(surface, 0, 1)), 3., 3. * round_off);
}

TEST(Spanning_forest, cost_bounds_transport_on_each_component)
{
  const Array_surface surface(disjoint_union(icosphere(1), torus(12, 8)));
  const Operators o = operators(surface.t());
  const Spanning_forest forest(o);
  const Transport_solver solver(o);
  const Vector both = masses(surface, 0, 20) + masses(surface, 50, 90) + masses(surface, 61, 44);
  EXPECT_GE(forest.cost(both), solver.solve(both).lower);
}

TEST(Spanning_forest, vertices_without_triangles_are_roots)
{
  Triangulation triangulation = fan();
  triangulation.points.push_back({0., 0., 9.});
  const Array_surface surface(triangulation);
  EXPECT_NEAR(cost(surface, masses(surface, 0, 1)), 1., round_off);
}

} // namespace Spanning_forest_test
