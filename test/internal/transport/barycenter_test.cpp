// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/barycenter.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/transport/transport.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// What is left of sums over some thousand triangles, relative to them.
constexpr double rounding = 1e-9;

Barycenter_options within(double tolerance)
{
  Barycenter_options result;
  result.tolerance = tolerance;
  return result;
}

Vector at(const Glued_surface& surface, const std::vector<Index>& points)
{
  Vector result = Vector::Zero(surface.size());
  for(const Index i : points)
    result[surface.site(i)] += 1. / double(points.size());
  return result;
}

// Falls off from a point.
Vector blob(const Glued_surface& surface, const Operators& o, Index center, double width)
{
  const Vector lumped = lumped_mass(o);
  Vector result(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double d = test::distance(surface.point(i), surface.point(center)) / width;
    result[surface.site(i)] = lumped[surface.site(i)] * std::exp(-d * d);
  }
  return result / result.sum();
}

// That flows and potentials prove the bounds, by the formulas alone.
void expect_certified(const Operators& o, const std::vector<Vector>& masses,
                      const std::vector<double>& weights, const Barycenter& found)
{
  const double total = masses[0].sum();
  double upper = 0., slopes = 0., integral = 0.;
  Vector sum = Vector::Zero(masses[0].size());
  EXPECT_GE(found.masses.minCoeff(), 0.);
  for(std::size_t i = 0; i < masses.size(); ++i)
  {
    const Vector moved = masses[i] - found.masses;
    EXPECT_LT((divergence(o, found.flows[i]) - moved).lpNorm<Eigen::Infinity>(), rounding * total);
    double length = 0., slope = 0.;
    const Field gradients = gradient(o, found.potentials[i]);
    for(std::size_t f = 0; f < o.number_of_triangles(); ++f)
    {
      length += o.area[f] * norm(found.flows[i][f]);
      slope = std::max(slope, norm(gradients[f]));
    }
    EXPECT_NEAR(length, found.distances[i], rounding * length);
    upper += weights[i] * length * length;
    slopes += weights[i] * slope * slope;
    integral += weights[i] * found.potentials[i].dot(masses[i]);
    sum += weights[i] * found.potentials[i];
  }
  EXPECT_NEAR(upper, found.upper, rounding * upper);
  const auto [component, number] = components(o);
  std::vector<double> most(number, -infinity), part(number, 0.);
  for(std::size_t site = 0; site < component.size(); ++site)
  {
    most[component[site]] = std::max(most[component[site]], sum[site]);
    part[component[site]] += masses[0][site];
  }
  for(std::size_t c = 0; c < number; ++c)
    integral -= part[c] * most[c];
  // 2 <phi, m_i - m> - t^2, whatever m is.
  EXPECT_NEAR(2. * integral - slopes, found.lower, rounding * found.upper);
  EXPECT_LE(found.lower, found.value);
  EXPECT_LE(found.value, found.upper);
  EXPECT_LT(found.residual, rounding);
}

TEST(Barycenter_solver, certifies_its_bounds)
{
  for(const Triangulation& shape :
      {shaken(icosphere(3), 0.02), cylinder(24, 8, 1., 2.), scaled(torus(24, 12), 1e5)})
  {
    const Glued_surface surface(shape);
    const Barycenter_solver solver(operators(surface.t()));
    const Index n = surface.size();
    const std::vector<Vector> masses = {at(surface, {0}), at(surface, {n / 2, n / 3}),
                                        blob(surface, solver.operators(), n / 4, 0.3)};
    const std::vector<double> weights = {1., 0.5, 2.};
    const Barycenter found = solver.solve(masses, weights, within(0.01));
    EXPECT_TRUE(found.converged);
    EXPECT_GE(found.lower, 0.99 * found.upper);
    expect_certified(solver.operators(), masses, weights, found);
    Barycenter_options few = within(1e-6);
    few.maximum_iterations = 10;
    const Barycenter rough = solver.solve(masses, weights, few);
    EXPECT_FALSE(rough.converged);
    EXPECT_EQ(rough.iterations, 10u);
    expect_certified(solver.operators(), masses, weights, rough);
    EXPECT_LE(rough.lower, found.upper);
    EXPECT_LE(found.lower, rough.upper);
  }
}

// The distances between the barycenter that was found and the masses, by another method.
TEST(Barycenter_solver, agrees_with_distances_to_what_it_found)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  const Barycenter_solver solver(operators(surface.t()));
  const Transport_solver distances(operators(surface.t()));
  const Index n = surface.size();
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {n / 2}), at(surface, {n / 3})};
  const std::vector<double> weights = {1., 2., 3.};
  const Barycenter found = solver.solve(masses, weights, within(0.005));
  Transport_options options;
  options.tolerance = 1e-5;
  double lower = 0., upper = 0.;
  for(std::size_t i = 0; i < masses.size(); ++i)
  {
    const Transport moved = distances.solve(masses[i] - found.masses, options);
    lower += weights[i] * moved.lower * moved.lower;
    upper += weights[i] * moved.upper * moved.upper;
  }
  EXPECT_LE(found.lower, upper);
  EXPECT_LE(lower, found.upper);
  EXPECT_GE(lower, 0.995 * found.upper); // as those flows cost no less than the lower bound
}

// In the plane nothing is lost: potentials that are linear prove the centroid's squared distances.
TEST(Barycenter_solver, costs_in_the_plane_what_the_centroid_does)
{
  const Index n = 20;
  const Glued_surface surface(square(n, 0.2));
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
    const Barycenter found = solver.solve(masses, weights, within(0.003));
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.lower, exact * (1. + rounding));
    EXPECT_GE(found.upper, exact * (1. - rounding));
    // The mean of the distances from two points does not go below that from their mean.
    Point where = {0., 0., 0.};
    for(Index i = 0; i < surface.size(); ++i)
      for(int c = 0; c < 3; ++c)
        where[c] += found.masses[surface.site(i)] * surface.point(i)[c];
    // The sum of w_i |x - p_i|^2 grows by (sum of w_i) |x - mean|^2 away from the mean.
    EXPECT_LE(std::pow(test::distance(where, mean) / unit, 2) * weight,
              found.upper - exact + rounding * exact);
  }
}

TEST(Barycenter_solver, of_equal_masses_is_what_they_are)
{
  const Glued_surface surface(icosphere(2));
  const Barycenter_solver solver(operators(surface.t()));
  const Vector masses = blob(surface, solver.operators(), 5, 0.4);
  const Barycenter found = solver.solve({masses, masses, masses}, {1., 1., 1.});
  EXPECT_LT(found.upper, rounding * rounding);
  EXPECT_TRUE(found.converged);
  EXPECT_LT((found.masses - masses).lpNorm<1>(), rounding);
  const Barycenter alone = solver.solve({masses}, {3.});
  EXPECT_LT(alone.upper, rounding * rounding);
  EXPECT_LT((alone.masses - masses).lpNorm<1>(), rounding);
}

TEST(Barycenter_solver, is_one_of_the_masses_when_all_weight_is_there)
{
  const Glued_surface surface(icosphere(3));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {100}), at(surface, {200})};
  const Barycenter found = solver.solve(masses, {0., 2., 0.});
  EXPECT_EQ(found.value, 0.);
  EXPECT_TRUE(found.converged);
  EXPECT_LT((found.masses - masses[1]).lpNorm<1>(), rounding);
  // A mass of weight e costs at most e W^2, by staying.
  const Transport_solver distances(operators(surface.t()));
  const double distance = distances.solve(masses[0] - masses[1]).upper;
  const Barycenter nearly = solver.solve({masses[0], masses[1]}, {1e-3, 1.}, within(0.01));
  EXPECT_LE(nearly.lower, 1e-3 * distance * distance);
  // It is 1e-3 of the way; a cost above by 1 % of 1e-3 is 0.0032 of it farther at most.
  EXPECT_LE(nearly.distances[1], 0.0043 * distance);
}

TEST(Barycenter_solver, does_not_depend_on_units_and_order)
{
  const Glued_surface surface(shaken(icosphere(2), 0.05));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {100}), at(surface, {60})};
  const Barycenter found = solver.solve(masses, {1., 2., 3.});
  for(const double factor : {1e-6, 1e6})
  {
    const Barycenter heavy =
        solver.solve({factor * masses[0], factor * masses[1], factor * masses[2]}, {1., 2., 3.});
    EXPECT_NEAR(heavy.value / (factor * factor), found.value, rounding * found.value);
    EXPECT_LT((heavy.masses / factor - found.masses).lpNorm<1>(), rounding);
    const Barycenter weighty = solver.solve(masses, {factor, 2. * factor, 3. * factor});
    EXPECT_NEAR(weighty.value / factor, found.value, rounding * found.value);
  }
  const Barycenter turned = solver.solve({masses[2], masses[0], masses[1]}, {3., 1., 2.});
  EXPECT_NEAR(turned.value, found.value, rounding * found.value);
}

TEST(Barycenter_solver, keeps_the_masses_of_components)
{
  const Triangulation near = icosphere(2);
  Triangulation far = scaled(icosphere(2), 0.5);
  for(Point& p : far.points)
    p[0] += 5.;
  const Glued_surface surface(apart(near, far));
  const Barycenter_solver solver(operators(surface.t()));
  const Index n = Index(near.points.size());
  const std::vector<Vector> masses = {
      2. * at(surface, {0}) + at(surface, {n}),
      2. * at(surface, {30}) + at(surface, {n + 50}),
  };
  const std::vector<double> weights = {1., 1.};
  const Barycenter found = solver.solve(masses, weights);
  EXPECT_TRUE(found.converged);
  expect_certified(solver.operators(), masses, weights, found);
  double first = 0.;
  for(Index i = 0; i < n; ++i)
    first += found.masses[surface.site(i)];
  EXPECT_NEAR(first, 2., rounding);
  EXPECT_THROW(solver.solve({at(surface, {0}), at(surface, {n})}, weights), Invalid_argument_error);
}

TEST(Barycenter_solver, goes_on_from_where_it_ended)
{
  const Glued_surface surface(icosphere(3));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {100}), at(surface, {200})};
  const std::vector<double> weights = {1., 1., 1.};
  const Barycenter found = solver.solve(masses, weights);
  Barycenter_options options;
  options.start = found.state;
  const Barycenter again = solver.solve(masses, weights, options);
  EXPECT_TRUE(again.converged);
  EXPECT_LT(4 * again.iterations, found.iterations);
}

TEST(Barycenter_solver, ends_when_told)
{
  const Glued_surface surface(icosphere(3));
  const Barycenter_solver solver(operators(surface.t()));
  const std::vector<Vector> masses = {at(surface, {0}), at(surface, {200})};
  Barycenter_options options = within(1e-3);
  double last = 0.;
  options.callback = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    last = fraction;
    return fraction < 0.5;
  };
  const Barycenter found = solver.solve(masses, {1., 1.}, options);
  EXPECT_FALSE(found.converged);
  expect_certified(solver.operators(), masses, {1., 1.}, found);
}

TEST(Barycenter_solver, refuses_what_has_no_barycenter)
{
  const Glued_surface surface(icosphere(1));
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
  EXPECT_THROW(solver.solve({one, two}, {1., 1.}, within(0.)), Invalid_argument_error);
}

} // namespace
