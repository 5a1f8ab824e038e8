// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/Transport_iteration.h"

#include "Array_surface.h"
#include "transport/Spanning_forest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace Transport_iteration_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of sums of some hundred terms.
constexpr double round_off = 1e-9;

// A unit mass that moves between two vertices of a square.
struct Square_problem
{
  Array_surface surface{square(8, 0.24)};
  Operators o = operators(surface.t());
  Laplacian laplacian{o};
  Sparse_matrix matrix = laplacian.matrix(o);
  std::unique_ptr<Sparse_solver> solver;
  Spanning_forest forest{o};
  Vector masses = Vector::Zero(surface.size());

  Square_problem()
  {
    laplacian.pin(matrix);
    solver = std::make_unique<Sparse_solver>(matrix, Elimination_order::low_fill);
    masses[surface.vertex(0)] = -1.;
    masses[surface.vertex(80)] = 1.;
  }
  Transport_problem problem() const { return {o, laplacian, matrix, *solver, forest, masses}; }
};

// Gives access to the functions that update the bounds.
struct Bounds : Transport_iteration
{
  using Transport_iteration::Transport_iteration;
  using Transport_iteration::update_lower_bound;
  using Transport_iteration::update_upper_bound;

  bool advance() override { return false; }
};

TEST(Transport_iteration, bounds_improve_in_each_step)
{
  const Square_problem square;
  for(const Transport_method method :
      {Transport_method::interior_point, Transport_method::admm, Transport_method::weiszfeld})
  {
    Transport_options options;
    options.method = method;
    const auto iteration = make_iteration(square.problem(), options);
    double lower = 0., upper = infinity;
    for(int i = 0; i < 5; ++i)
    {
      EXPECT_TRUE(iteration->advance());
      EXPECT_GE(iteration->best().lower, lower);
      EXPECT_LE(iteration->best().upper, upper);
      lower = iteration->best().lower;
      upper = iteration->best().upper;
      EXPECT_LE(lower, upper);
    }
    const Transport_result best = iteration->take_best();
    EXPECT_NEAR(integrated_length(square.o, best.flow), upper, round_off * upper);
    EXPECT_NEAR(best.potential.dot(square.masses), lower, round_off * upper);
    EXPECT_EQ(best.state.shrunk_flow.empty(), method != Transport_method::admm);
  }
}

TEST(Transport_iteration, keeps_best_bounds)
{
  const Square_problem square;
  Bounds bounds(square.problem());
  EXPECT_EQ(bounds.best().upper, infinity);
  EXPECT_EQ(bounds.best().lower, 0.);
  const Vector potential = square.solver->solve(square.masses);
  Field flow = gradient(square.o, potential);
  bounds.update_upper_bound(flow);
  bounds.update_lower_bound(7. * potential); // the bound does not depend on the slope
  const double lower = bounds.best().lower, upper = bounds.best().upper;
  EXPECT_GT(lower, 0.);
  EXPECT_LE(lower, upper);
  for(Vec2& vector : flow)
    vector = 2. * vector;
  bounds.update_upper_bound(flow);
  bounds.update_lower_bound(-potential);
  EXPECT_EQ(bounds.best().lower, lower);
  EXPECT_EQ(bounds.best().upper, upper);
}

TEST(Transport_iteration, corrects_flows_with_other_masses)
{
  const Square_problem square;
  const double cost =
      integrated_length(square.o, gradient(square.o, square.solver->solve(square.masses)));
  Bounds bounds(square.problem());
  bounds.update_upper_bound(Field(square.o.number_of_triangles(), Vec2{0., 0.}));
  EXPECT_NEAR(bounds.best().upper, cost, round_off * cost);
  const Vector error = minus_divergence(square.o, bounds.best().flow) - square.masses;
  EXPECT_LT(error.lpNorm<Eigen::Infinity>(), round_off);
}

// A solver of another matrix cannot correct the flow.
TEST(Transport_iteration, upper_bound_contains_the_cost_of_the_error)
{
  const Square_problem square;
  Sparse_matrix other_matrix = 1e6 * square.matrix;
  const Sparse_solver other_solver(other_matrix, Elimination_order::low_fill);
  const Transport_problem problem = {square.o,     square.laplacian, square.matrix,
                                     other_solver, square.forest,    square.masses};
  Bounds bounds(problem);
  bounds.update_upper_bound(Field(square.o.number_of_triangles(), Vec2{0., 0.}));
  EXPECT_EQ(bounds.best().upper, square.forest.cost(square.masses));
  EXPECT_GE(bounds.best().upper, std::sqrt(2.)); // the diagonal of the square
}

TEST(Transport_iteration, ignores_infeasible_outflow)
{
  Square_problem square;
  square.masses.setZero();
  square.masses[square.surface.vertex(8)] = -0.5;
  Transport_problem problem = square.problem();
  problem.exits = {{0, 1., {{square.surface.vertex(8), 0.75, 2.}}}};
  const Field flow(square.o.number_of_triangles(), Vec2{0., 0.});
  Bounds bounds(problem);
  bounds.update_upper_bound(flow, Vector::Constant(1, 1.));
  bounds.update_upper_bound(flow, Vector::Constant(1, -0.1));
  EXPECT_EQ(bounds.best().upper, infinity);
  bounds.update_upper_bound(flow, Vector::Constant(1, 0.5));
  EXPECT_EQ(bounds.best().upper, 0.25); // the price alone: 2 / 2 * 0.5^2
}

} // namespace Transport_iteration_test
