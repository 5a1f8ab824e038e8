// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Barycenter_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace Barycenter_solver_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of sums over some thousand triangles.
constexpr double round_off = 1e-9;

Barycenter_options with_tolerance(double tolerance)
{
  Barycenter_options result;
  result.tolerance = tolerance;
  return result;
}

Vector at(const Array_surface& surface, const std::vector<Index>& points)
{
  Vector result = Vector::Zero(surface.size());
  for(const Index i : points)
    result[surface.vertex(i)] += 1. / double(points.size());
  return result;
}

// Returns a Gaussian mass distribution around a vertex, with a total mass of one.
Vector gaussian(const Array_surface& surface, const Operators& o, Index center, double width)
{
  const Vector lumped = lumped_mass(o);
  Vector result(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double d = test::distance(surface.point(i), surface.point(center)) / width;
    result[surface.vertex(i)] = lumped[surface.vertex(i)] * std::exp(-d * d);
  }
  return result / result.sum();
}

// Recomputes the bounds from the flows and potentials that certify them.
void expect_certified(const Operators& o, const std::vector<Vector>& masses,
                      const std::vector<double>& weights, const Barycenter_result& found)
{
  const double total = masses[0].sum();
  double upper = 0., squared_slopes = 0., integral = 0.;
  Vector sum = Vector::Zero(masses[0].size());
  EXPECT_GE(found.masses.minCoeff(), 0.);
  for(std::size_t i = 0; i < masses.size(); ++i)
  {
    const Vector moved = masses[i] - found.masses;
    EXPECT_LT((minus_divergence(o, found.flows[i]) - moved).lpNorm<Eigen::Infinity>(),
              round_off * total);
    double length = 0., slope = 0.;
    const Field gradients = gradient(o, found.potentials[i]);
    for(std::size_t f = 0; f < o.number_of_triangles(); ++f)
    {
      length += o.area[f] * norm(found.flows[i][f]);
      slope = std::max(slope, norm(gradients[f]));
    }
    EXPECT_NEAR(length, found.distances[i], round_off * length);
    upper += weights[i] * length * length;
    squared_slopes += weights[i] * slope * slope;
    integral += weights[i] * found.potentials[i].dot(masses[i]);
    sum += weights[i] * found.potentials[i];
  }
  EXPECT_NEAR(upper, found.upper, round_off * upper);
  const auto [component, number_of_components] = components(o);
  std::vector<double> max_potential(number_of_components, -infinity),
      component_mass(number_of_components, 0.);
  for(std::size_t vertex = 0; vertex < component.size(); ++vertex)
  {
    max_potential[component[vertex]] = std::max(max_potential[component[vertex]], sum[vertex]);
    component_mass[component[vertex]] += masses[0][vertex];
  }
  for(std::size_t c = 0; c < number_of_components; ++c)
    integral -= component_mass[c] * max_potential[c];
  // The sum of 2 <phi_i, m_i - m> - t_i^2, minimized over m.
  EXPECT_NEAR(2. * integral - squared_slopes, found.lower, round_off * found.upper);
  EXPECT_LE(found.lower, found.value);
  EXPECT_LE(found.value, found.upper);
  EXPECT_LT(found.residual, round_off);
}

TEST(Barycenter_solver, bounds_are_certified)
{
  for(const Triangulation& shape :
      {jittered(icosphere(3), 0.02), cylinder(24, 8, 1., 2.), scaled(torus(24, 12), 1e5)})
  {
    const Array_surface surface(shape);
    const Barycenter_solver solver(operators(surface.t()));
    const Index n = surface.size();
    const std::vector<Vector> masses = {at(surface, {0}), at(surface, {n / 2, n / 3}),
                                        gaussian(surface, solver.operators(), n / 4, 0.3)};
    const std::vector<double> weights = {1., 0.5, 2.};
    const Barycenter_result found = solver.solve(masses, weights, with_tolerance(0.01));
    EXPECT_TRUE(found.is_converged);
    EXPECT_GE(found.lower, 0.99 * found.upper); // the requested gap
    expect_certified(solver.operators(), masses, weights, found);
    Barycenter_options few_iterations = with_tolerance(1e-6);
    few_iterations.maximum_iterations = 10;
    const Barycenter_result rough = solver.solve(masses, weights, few_iterations);
    EXPECT_FALSE(rough.is_converged);
    EXPECT_EQ(rough.number_of_iterations, 10u);
    expect_certified(solver.operators(), masses, weights, rough);
    EXPECT_LE(rough.lower, found.upper);
    EXPECT_LE(found.lower, rough.upper);
  }
}

// On needles, the flows do not move all masses. The distances contain the cost of the remaining
// ones.
TEST(Barycenter_solver, distances_of_needles_are_upper_bounds)
{
  for(const double height : {1e-3, 1e-6, 1e-9})
  {
    const Array_surface surface(Triangulation{
        {{0., 0., 0.}, {1., 0., 0.}, {0., height, 0.}, {1., height, 0.}}, {0, 1, 3, 0, 3, 2}});
    const Barycenter_result found = Barycenter_solver(operators(surface.t()))
                                        .solve({at(surface, {0}), at(surface, {1})}, {1., 1.});
    const double sum_of_squares =
        found.distances[0] * found.distances[0] + found.distances[1] * found.distances[1];
    // The minimum is attained by the midpoint of two points at distance one.
    EXPECT_GE(sum_of_squares, 0.5 - round_off) << height;
    EXPECT_NEAR(sum_of_squares, found.upper, round_off) << height;
  }
}

// Computes the distances from the barycenter to the masses by the interior point method.
TEST(Barycenter_solver, agrees_with_transport_distances)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const Barycenter_solver solver(operators(surface.t()));
  const Transport_solver distances(operators(surface.t()));
  const Index n = surface.size();
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {n / 2}), at(surface, {n / 3})};
  const std::vector<double> weights = {1., 2., 3.};
  const Barycenter_result found = solver.solve(masses, weights, with_tolerance(0.005));
  Transport_options options;
  options.tolerance = 1e-5;
  double lower = 0., upper = 0.;
  for(std::size_t i = 0; i < masses.size(); ++i)
  {
    const Transport_result moved = distances.solve(masses[i] - found.masses, options);
    lower += weights[i] * moved.lower * moved.lower;
    upper += weights[i] * moved.upper * moved.upper;
  }
  EXPECT_LE(found.lower, upper);
  EXPECT_LE(lower, found.upper);
  EXPECT_GE(lower, 0.995 * found.upper); // the gap of the barycenter
}

// In the plane the discretization is exact: linear potentials certify the squared distances to the
// centroid.
TEST(Barycenter_solver, matches_centroid_cost_in_plane)
{
  const Index n = 20;
  const Array_surface surface(square(n, 0.2));
  const Barycenter_solver solver(operators(surface.t()));
  const double unit = surface.scale();
  const auto point = [&](Index x, Index y) { return y * (n + 1) + x; };
  for(const std::vector<Index>& points : std::vector<std::vector<Index>>{
          {point(0, 0), point(n, n)},
          {point(2, 5), point(17, 9)},
          {point(0, 0), point(n, 0), point(n / 2, n)},
          {point(0, 0), point(n, 0), point(0, n), point(n, n), point(3, 8)}})
  {
    std::vector<Vector> masses;
    std::vector<double> weights;
    double weight = 0.;
    Point mean = {0., 0., 0.};
    for(const Index i : points)
    {
      masses.push_back(at(surface, {i}));
      weights.push_back(1. + double(weights.size()));
      weight += weights.back();
      for(int c = 0; c < 3; ++c)
        mean[c] += weights.back() * surface.point(i)[c];
    }
    for(double& c : mean)
      c /= weight;
    double exact = 0.;
    for(std::size_t i = 0; i < points.size(); ++i)
      exact += weights[i] * std::pow(test::distance(surface.point(points[i]), mean) / unit, 2);
    const Barycenter_result found = solver.solve(masses, weights, with_tolerance(0.003));
    EXPECT_TRUE(found.is_converged);
    EXPECT_LE(found.lower, exact * (1. + round_off));
    EXPECT_GE(found.upper, exact * (1. - round_off));
    // By Jensen's inequality, the cost of a distribution is at least that of its center of mass.
    Point mean_position = {0., 0., 0.};
    for(Index i = 0; i < surface.size(); ++i)
      for(int c = 0; c < 3; ++c)
        mean_position[c] += found.masses[surface.vertex(i)] * surface.point(i)[c];
    // The sum of w_i |x - p_i|^2 grows by (sum of w_i) |x - mean|^2 away from the mean.
    EXPECT_LE(std::pow(test::distance(mean_position, mean) / unit, 2) * weight,
              found.upper - exact + round_off * exact);
  }
}

TEST(Barycenter_solver, barycenter_of_equal_masses_is_the_mass)
{
  const Array_surface surface(icosphere(2));
  const Barycenter_solver solver(operators(surface.t()));
  const Vector masses = gaussian(surface, solver.operators(), 5, 0.4);
  const Barycenter_result found = solver.solve({masses, masses, masses}, {1., 1., 1.});
  EXPECT_LT(found.upper, round_off * round_off);
  EXPECT_TRUE(found.is_converged);
  EXPECT_LT((found.masses - masses).lpNorm<1>(), round_off);
  const Barycenter_result single = solver.solve({masses}, {3.});
  EXPECT_LT(single.upper, round_off * round_off);
  EXPECT_LT((single.masses - masses).lpNorm<1>(), round_off);
}

TEST(Barycenter_solver, full_weight_selects_mass)
{
  const Array_surface surface(icosphere(3));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {100}), at(surface, {200})};
  const Barycenter_result found = solver.solve(masses, {0., 2., 0.});
  EXPECT_EQ(found.value, 0.);
  EXPECT_TRUE(found.is_converged);
  EXPECT_LT((found.masses - masses[1]).lpNorm<1>(), round_off);
  // If the barycenter is the second mass, the first one of weight e costs e W^2.
  const Transport_solver distances(operators(surface.t()));
  const double distance = distances.solve(masses[0] - masses[1]).upper;
  const Barycenter_result nearly_second =
      solver.solve({masses[0], masses[1]}, {1e-3, 1.}, with_tolerance(0.01));
  // A lower bound of a minimum.
  EXPECT_LE(nearly_second.lower, 1e-3 * distance * distance);
  // The optimum is at 1e-3 of the distance. A cost that is 1 % of 1e-3 too large moves it by at
  // most 0.0032 of the distance.
  EXPECT_LE(nearly_second.distances[1], 0.0043 * distance);
}

TEST(Barycenter_solver, is_invariant_to_units_and_order)
{
  const Array_surface surface(jittered(icosphere(2), 0.05));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {100}), at(surface, {60})};
  const Barycenter_result found = solver.solve(masses, {1., 2., 3.});
  for(const double factor : {1e-6, 1e6})
  {
    const Barycenter_result scaled_masses =
        solver.solve({factor * masses[0], factor * masses[1], factor * masses[2]}, {1., 2., 3.});
    EXPECT_NEAR(scaled_masses.value / (factor * factor), found.value, round_off * found.value);
    EXPECT_LT((scaled_masses.masses / factor - found.masses).lpNorm<1>(), round_off);
    const Barycenter_result scaled_weights =
        solver.solve(masses, {factor, 2. * factor, 3. * factor});
    EXPECT_NEAR(scaled_weights.value / factor, found.value, round_off * found.value);
  }
  const Barycenter_result permuted = solver.solve({masses[2], masses[0], masses[1]}, {3., 1., 2.});
  EXPECT_NEAR(permuted.value, found.value, round_off * found.value);
}

TEST(Barycenter_solver, preserves_component_masses)
{
  const Triangulation first_sphere = icosphere(2);
  Triangulation second_sphere = scaled(icosphere(2), 0.5);
  for(Point& p : second_sphere.points)
    p[0] += 5.;
  const Array_surface surface(disjoint_union(first_sphere, second_sphere));
  const Barycenter_solver solver(operators(surface.t()));
  const Index n = Index(first_sphere.points.size());
  const std::vector<Vector> masses = {
      2. * at(surface, {0}) + at(surface, {n}),
      2. * at(surface, {30}) + at(surface, {n + 50}),
  };
  const std::vector<double> weights = {1., 1.};
  const Barycenter_result found = solver.solve(masses, weights);
  EXPECT_TRUE(found.is_converged);
  expect_certified(solver.operators(), masses, weights, found);
  double mass_on_first = 0.;
  for(Index i = 0; i < n; ++i)
    mass_on_first += found.masses[surface.vertex(i)];
  EXPECT_NEAR(mass_on_first, 2., round_off);
  EXPECT_THROW(solver.solve({at(surface, {0}), at(surface, {n})}, weights), Invalid_argument_error);
}

TEST(Barycenter_solver, warm_start_continues)
{
  const Array_surface surface(icosphere(3));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {100}), at(surface, {200})};
  const std::vector<double> weights = {1., 1., 1.};
  const Barycenter_result found = solver.solve(masses, weights);
  Barycenter_options options;
  options.warm_start = found.state;
  const Barycenter_result warm_started = solver.solve(masses, weights, options);
  EXPECT_TRUE(warm_started.is_converged);
  EXPECT_LT(4 * warm_started.number_of_iterations, found.number_of_iterations);
}

TEST(Barycenter_solver, can_be_cancelled)
{
  const Array_surface surface(icosphere(3));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {200})};
  Barycenter_options options = with_tolerance(1e-3);
  double last = 0.;
  options.callback = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.5;
  };
  const Barycenter_result found = solver.solve(masses, {1., 1.}, options);
  EXPECT_FALSE(found.is_converged);
  expect_certified(solver.operators(), masses, {1., 1.}, found);
}

TEST(Barycenter_solver, throws_on_invalid_input)
{
  const Array_surface surface(icosphere(1));
  const Barycenter_solver solver(operators(surface.t()));
  const Vector one = at(surface, {0}), two = at(surface, {5});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(solver.solve({}, {}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two}, {1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two}, {1., -1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two}, {1., nan}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two}, {1., infinity}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two}, {0., 0.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, 2. * two}, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, nan * two}, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two - one + two}, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({0. * one, 0. * two}, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, Vector::Ones(3) / 3.}, {1., 1.}), Invalid_argument_error);
  EXPECT_THROW(solver.solve({one, two}, {1., 1.}, with_tolerance(0.)), Invalid_argument_error);
}

} // namespace Barycenter_solver_test
