// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The interior point method, ADMM and Weiszfeld iterations on problems that are solved by hand.
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace transport_methods_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr Transport_method all_methods[] = {Transport_method::interior_point,
                                            Transport_method::admm, Transport_method::weiszfeld};

// Sums of some hundred terms of size 1, each with a relative error of 1e-16; measured are 1e-14.
constexpr double round_off = 1e-13;

// A surface with the transport problem on it. Results are in the unit of the coordinates.
struct Problem
{
  Array_surface surface;
  Transport_solver solver;

  explicit Problem(const Triangulation& shape) : surface(shape), solver(operators(surface.t())) {}

  Vector masses(const std::vector<double>& values) const
  {
    Vector result(values.size());
    for(Index i = 0; i < values.size(); ++i)
      result[surface.vertex(i)] = values[i];
    return result;
  }
  Transport_result solve(const std::vector<double>& values, const Transport_options& options,
                         const std::vector<Exit>& exits = {}) const
  {
    Transport_result result = solver.solve(masses(values), options, exits);
    rescale(result, surface.scale());
    return result;
  }
};

Transport_options with(Transport_method method, double tolerance)
{
  Transport_options result;
  result.method = method;
  result.tolerance = tolerance;
  return result;
}

// In the triangle (0, 0), (1, 0), (0, 1), the masses of the vertices determine the constant flow:
// (2 b, 2 c) for the masses b and c of the last two vertices. Its integral is hypot(b, c).
TEST(Transport_methods, flow_in_one_triangle_is_determined_by_masses)
{
  const Problem triangle(one_triangle());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mass(-1., 1.);
  for(const Transport_method method : all_methods)
    for(int i = 0; i < 10; ++i)
    {
      const double b = mass(random), c = mass(random);
      const Transport_result found = triangle.solve({-b - c, b, c}, with(method, 1e-6));
      EXPECT_TRUE(found.is_converged);
      EXPECT_NEAR(found.upper, std::hypot(b, c), round_off);
      EXPECT_NEAR(found.lower, std::hypot(b, c), round_off);
      EXPECT_NEAR(norm(found.flow[0]), 2. * std::hypot(b, c), 10. * round_off);
    }
}

// A unit square whose diagonal joins the vertices 0 and 2.
Triangulation two_triangles()
{
  return {{{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}}, {0, 1, 2, 0, 2, 3}};
}

// Returns the smallest cost of the masses a, b, c, d of the square. The feasible flows are a line.
// In the triangle 0, 1, 2 the flow is (s, s - 2 b), because half of the difference of its
// components enters vertex 1. Vertices 0 and 2 then determine the flow (2 c - s + 2 b, -2 a - s) of
// the triangle 0, 2, 3.
double min_cost(double a, double b, double c)
{
  const auto cost = [&](double s)
  { return 0.5 * std::hypot(s, s - 2. * b) + 0.5 * std::hypot(2. * c - s + 2. * b, -2. * a - s); };
  double low = -10., high = 10.;
  // The cost is convex. Its error is the square of that of s.
  while(high - low > 1e-8)
  {
    const double left = low + 0.382 * (high - low), right = high - 0.382 * (high - low);
    if(cost(left) < cost(right))
      high = right;
    else
      low = left;
  }
  return cost(low);
}

TEST(Transport_methods, flow_across_two_triangles_minimizes_sum_of_two_lengths)
{
  const Problem square(two_triangles());
  EXPECT_NEAR(min_cost(0., -1., 0.), std::sqrt(2.), round_off); // along the other diagonal
  std::mt19937 random(1);
  std::uniform_real_distribution<double> mass(-1., 1.);
  for(const Transport_method method : all_methods)
    for(int i = 0; i < 20; ++i)
    {
      const double a = mass(random), b = mass(random), c = mass(random);
      constexpr double tolerance = 1e-3; // Weiszfeld iterations do not reach much smaller gaps
      const Transport_result found = square.solve({a, b, c, -a - b - c}, with(method, tolerance));
      const double expected = min_cost(a, b, c);
      EXPECT_LE(found.lower, expected * (1. + round_off));
      EXPECT_GE(found.upper, expected * (1. - round_off));
      EXPECT_TRUE(found.is_converged) << int(method);
      EXPECT_LE(found.upper - found.lower, tolerance * found.upper);
    }
}

// At an optimum, the flow and the gradient of the potential have the same direction, and the
// gradient has length 1 where the flow is not zero: |flow| - flow * gradient is zero in each
// triangle. Its integral is the gap between the bounds.
TEST(Transport_methods, gap_is_the_violation_of_complementary_slackness)
{
  const Problem problem(jittered(icosphere(2), 0.05));
  const Operators& o = problem.solver.operators();
  std::vector<double> masses(problem.surface.size(), 0.);
  masses[0] = -1.;
  masses[5] = 0.75;
  masses[100] = 0.25;
  for(const Transport_method method : {Transport_method::interior_point, Transport_method::admm})
    for(const double tolerance : {0.1, 1e-2, 1e-3})
    {
      const Transport_result found =
          problem.solver.solve(problem.masses(masses), with(method, tolerance));
      EXPECT_TRUE(found.is_converged);
      EXPECT_LE(found.upper - found.lower, tolerance * found.upper);
      const Field slope = gradient(o, found.potential);
      double violation = 0.;
      for(std::size_t f = 0; f < slope.size(); ++f)
      {
        EXPECT_LE(norm(slope[f]), 1. + round_off);
        const double part = norm(found.flow[f]) - dot(found.flow[f], slope[f]);
        EXPECT_GE(part, -round_off * norm(found.flow[f]));
        violation += o.area[f] * part;
      }
      EXPECT_NEAR(violation, found.upper - found.lower, round_off * found.upper);
    }
}

TEST(Transport_methods, interior_point_reaches_small_gaps)
{
  const Problem square(two_triangles());
  for(const double tolerance : {1e-4, 1e-6, 1e-8})
  {
    const Transport_result found =
        square.solve({0.3, -1., 0.2, 0.5}, with(Transport_method::interior_point, tolerance));
    EXPECT_TRUE(found.is_converged);
    EXPECT_LE(found.upper - found.lower, tolerance * found.upper);
    EXPECT_NEAR(found.value, min_cost(0.3, -1., 0.2), tolerance * found.upper);
  }
}

// A unit mass leaves the triangle (0, 0), (1, 0), (0, 1) from its first vertex through the other
// two. For outflows x and 1 - x the cost is hypot(x, 1 - x) plus the prices.
TEST(Transport_methods, exits_share_mass_up_to_their_capacity)
{
  const Problem triangle(one_triangle());
  constexpr double tolerance = 1e-7;
  const auto solve = [&](double first_capacity, double price)
  {
    return triangle.solver.solve(
        triangle.masses({-1., 0., 0.}), with(Transport_method::interior_point, tolerance),
        {{triangle.surface.vertex(1), first_capacity, price / triangle.surface.scale()},
         {triangle.surface.vertex(2), 1., price / triangle.surface.scale()}});
  };
  for(const double price : {0., 0.5, 2.})
  {
    const Transport_result equal = solve(1., price);
    EXPECT_NEAR(triangle.surface.scale() * equal.value, std::sqrt(0.5) + price / 4., tolerance);
    EXPECT_NEAR(equal.outflow[0], 0.5, round_off); // by symmetry
    const Transport_result full = solve(0.3, price);
    EXPECT_NEAR(triangle.surface.scale() * full.value,
                std::hypot(0.3, 0.7) + 0.5 * price * (0.3 * 0.3 + 0.7 * 0.7), tolerance);
    EXPECT_NEAR(full.outflow[0], 0.3, tolerance); // the cost decreases linearly up to the capacity
  }
}

} // namespace transport_methods_test
