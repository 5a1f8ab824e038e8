// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/transport.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// What is left of the divergence after some tens of solutions, and of the bounds when they are found
// again.
constexpr double rounding = 1e-9;

Transport_options within(double tolerance)
{
  Transport_options result;
  result.tolerance = tolerance;
  return result;
}

// A mass at one point to another.
Vector from_to(const Glued_surface& surface, Index from, Index to)
{
  Vector result = Vector::Zero(surface.size());
  result[surface.site(from)] -= 1.;
  result[surface.site(to)] += 1.;
  return result;
}

double exact_distance(const Glued_surface& surface, Index from, Index to)
{
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  return windows.distance(surface.site(to));
}

Vector random_masses(const Operators& operators, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> mass(-1., 1.);
  Vector result(operators.number_of_sites);
  for(double& x : result)
    x = mass(random);
  const auto [component, number] = components(operators);
  std::vector<double> sum(number, 0.), count(number, 0.);
  for(std::size_t site = 0; site < component.size(); ++site)
  {
    sum[component[site]] += result[site];
    ++count[component[site]];
  }
  for(std::size_t site = 0; site < component.size(); ++site)
    result[site] -= sum[component[site]] / count[component[site]];
  return result;
}

// That the bounds are what flow and potential say.
void expect_certified(const Operators& o, const Vector& masses, const Transport& transport)
{
  const double moved = 0.5 * masses.lpNorm<1>();
  EXPECT_LE(transport.lower, transport.value);
  EXPECT_LE(transport.value, transport.upper);
  EXPECT_LT(transport.residual, rounding);
  EXPECT_LT((divergence(o, transport.flow) - masses).lpNorm<Eigen::Infinity>(), rounding * moved);
  double cost = 0.;
  for(std::size_t f = 0; f < transport.flow.size(); ++f)
    cost += o.area[f] * norm(transport.flow[f]);
  EXPECT_NEAR(cost, transport.upper, rounding * cost);
  EXPECT_NEAR(masses.dot(transport.potential), transport.lower, rounding * cost);
  for(const Planar& slope : gradient(o, transport.potential))
    EXPECT_LT(norm(slope), 1. + rounding);
}

// A unit square with a wall one cell thick up to three quarters of its height.
Triangulation walled_square(std::size_t n)
{
  Triangulation result = square(n);
  std::vector<Index> corners;
  for(std::size_t f = 0; f < result.corners.size(); f += 3)
  {
    double x = 0., y = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      x += result.points[result.corners[f + k]][0] / 3.;
      y += result.points[result.corners[f + k]][1] / 3.;
    }
    if(x < 0.5 || x > 0.5 + 1. / double(n) || y > 0.75)
      corners.insert(corners.end(), &result.corners[f], &result.corners[f] + 3);
  }
  result.corners = std::move(corners);
  return result;
}

TEST(Transport, bounds_are_certified)
{
  for(const Triangulation& surface :
      {tetrahedron(), square(8, 0.24), cylinder(12, 4, 1., 1.), torus(12, 8), double_ring(1),
       shaken(icosphere(2), 0.03), apart(icosphere(1), torus(12, 8))})
  {
    const Transport_solver solver(operators(Glued_surface(surface).t()));
    const Vector masses = random_masses(solver.operators(), 1);
    for(const double tolerance : {0.1, 1e-3, 1e-5})
    {
      const Transport transport = solver.solve(masses, within(tolerance));
      EXPECT_TRUE(transport.converged);
      EXPECT_LE(transport.upper - transport.lower, tolerance * transport.upper);
      EXPECT_LE(transport.iterations, 30u);
      expect_certified(solver.operators(), masses, transport);
    }
  }
}

TEST(Transport, never_proves_more_than_the_distance)
{
  for(const Triangulation& shape : {shaken(icosphere(3), 0.02), torus(40, 16), double_ring(2),
                                    cylinder(24, 8, 1., 2.), cone(12, 6, 4.), cone(12, 6, 8.)})
  {
    const Glued_surface surface(shape);
    const Transport_solver solver(operators(surface.t()));
    for(const Index to : {1u, 7u, surface.size() / 2, surface.size() - 1})
    {
      const double exact = exact_distance(surface, 0, to);
      const Transport transport = solver.solve(from_to(surface, 0, to), within(1e-4));
      EXPECT_LE(transport.lower, exact * (1. + rounding));
      EXPECT_GE(transport.upper,
                0.9 * exact); // what a coarse surface loses around masses at points
    }
  }
}

TEST(Transport, loses_less_than_a_percent_on_a_sphere)
{
  const Glued_surface surface(icosphere(4));
  const Transport_solver solver(operators(surface.t()));
  const auto value = [&](Index from, Index to)
  { return solver.solve(from_to(surface, from, to)).value; };
  for(const Index from : {0u, 700u})
    for(const Index to : {1u, 100u, 1000u, 1500u, 2000u})
    {
      const double exact = exact_distance(surface, from, to);
      EXPECT_GT(value(from, to), 0.99 * exact);
      EXPECT_LT(value(from, to), exact * (1. + 0.5e-3)); // half of the gap
    }
  // Between poles the flow leaves in all directions, and a fan of five triangles around each lets no
  // function of slope one grow by more than 0.81 of a side.
  EXPECT_GT(value(0, 3), 0.98 * exact_distance(surface, 0, 3));
}

TEST(Transport, is_exact_in_the_plane)
{
  const Glued_surface convex(square(20, 0.24)), walled(walled_square(20));
  for(const Glued_surface* surface : {&convex, &walled})
  {
    const Transport_solver solver(operators(surface->t()));
    // From the lower left corner to the others, and to a point in the middle of the right half.
    for(const Index to : {20u, 420u, 440u, 225u})
    {
      const double exact = exact_distance(*surface, 0, to);
      const Transport transport = solver.solve(from_to(*surface, 0, to), within(1e-6));
      EXPECT_NEAR(transport.value, exact, 1e-5 * exact);
    }
  }
}

TEST(Transport, moves_a_side_of_a_square_to_the_other)
{
  const std::size_t n = 12;
  const Glued_surface surface(square(n, 0.24));
  Vector masses = Vector::Zero(surface.size());
  for(std::size_t j = 0; j <= n; ++j)
  {
    masses[surface.site(Index(j * (n + 1)))] = -double(j);
    masses[surface.site(Index(j * (n + 1) + n))] = double(j);
  }
  const Transport_solver solver(operators(surface.t()));
  const Transport transport = solver.solve(masses, within(1e-6));
  EXPECT_NEAR(transport.value * surface.scale(), n * (n + 1) / 2.,
              1e-5 * n * n); // each goes by one
}

TEST(Transport, is_symmetric_and_does_not_know_units)
{
  const Triangulation shape = shaken(icosphere(2), 0.03);
  const Glued_surface surface(shape);
  const Transport_solver solver(operators(surface.t()));
  const Vector masses = from_to(surface, 0, 50) + 0.3 * from_to(surface, 7, 120);
  const double value = solver.solve(masses).value;
  EXPECT_EQ(solver.solve(-masses).value, value);
  for(const double factor : {1e-6, 1e6})
  {
    EXPECT_NEAR(solver.solve(factor * masses).value, factor * value, rounding * factor * value);
    const Glued_surface other(scaled(shape, factor));
    const Transport_solver other_solver(operators(other.t()));
    // The sites are in another order.
    const Vector same = from_to(other, 0, 50) + 0.3 * from_to(other, 7, 120);
    EXPECT_NEAR(other_solver.solve(same).value * other.scale(), factor * value * surface.scale(),
                rounding * factor * value * surface.scale());
  }
}

TEST(Transport, does_nothing_where_nothing_is_to_be_moved)
{
  const Transport_solver solver(operators(Glued_surface(torus(12, 8)).t()));
  const Transport transport = solver.solve(Vector::Zero(96));
  EXPECT_TRUE(transport.converged);
  EXPECT_EQ(transport.upper, 0.);
  EXPECT_EQ(transport.value, 0.);
  EXPECT_EQ(transport.potential, Vector::Zero(96));
  EXPECT_EQ(transport.flow, Field(192, Planar{0., 0.}));
}

TEST(Transport, adds_up_over_components)
{
  const Triangulation first = icosphere(2), second = scaled(torus(12, 8), 3.);
  const Glued_surface both(apart(first, second)), one(first), two(second);
  const Index n = one.size();
  const Vector masses = from_to(both, 0, 50) + 2. * from_to(both, n, n + 40);
  const double sum =
      one.scale() *
          Transport_solver(operators(one.t())).solve(from_to(one, 0, 50), within(1e-6)).value +
      2. * two.scale() *
          Transport_solver(operators(two.t())).solve(from_to(two, 0, 40), within(1e-6)).value;
  const Transport_solver solver(operators(both.t()));
  EXPECT_NEAR(solver.solve(masses, within(1e-6)).value * both.scale(), sum, 1e-6 * sum);
  // Nothing at all on one of the two.
  const Transport transport = solver.solve(from_to(both, 0, 50), within(1e-5));
  EXPECT_TRUE(transport.converged);
  EXPECT_THROW(solver.solve(from_to(both, 0, n)), Invalid_argument_error);
}

TEST(Transport, refuses_what_cannot_be_moved)
{
  Triangulation shape = square(4);
  shape.points.push_back({2., 2., 0.}); // of no triangle
  const Glued_surface surface(shape);
  const Transport_solver solver(operators(surface.t()));
  EXPECT_THROW(solver.solve(Vector::Zero(3)), Invalid_argument_error);
  EXPECT_THROW(solver.solve(Vector::Ones(surface.size())), Invalid_argument_error);
  EXPECT_THROW(solver.solve(from_to(surface, 0, 25)), Invalid_argument_error);
  Vector masses = from_to(surface, 0, 24);
  EXPECT_NO_THROW(solver.solve(masses));
  for(const double tolerance : {0., -1., std::nan("")})
    EXPECT_THROW(solver.solve(masses, within(tolerance)), Invalid_argument_error);
  for(const double bad : {std::nan(""), infinity})
  {
    masses[0] = bad;
    EXPECT_THROW(solver.solve(masses), Invalid_argument_error);
  }
  const Glued_surface point({std::vector<Point>(4, Point{1., 2., 3.}), {0, 1, 2, 0, 2, 3}});
  EXPECT_THROW(Transport_solver(operators(point.t())), Unsupported_surface_error);
  const Glued_surface flat({{{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}}, {0, 1, 2}});
  EXPECT_THROW(Transport_solver(operators(flat.t())), Unsupported_surface_error);
}

TEST(Transport, passes_triangles_without_area)
{
  Triangulation shape = square(20);
  for(const Index i : {210u, 211u, 212u})
    shape.points[i] = shape.points[210];
  shape.points[66] = {0.125, 0.15, 0.}; // between its neighbours in a row
  const Glued_surface surface(shape);
  const Transport_solver solver(operators(surface.t()));
  const Vector masses = from_to(surface, 0, 440);
  const Transport transport = solver.solve(masses);
  EXPECT_TRUE(transport.converged);
  EXPECT_LT(transport.residual, 1e-6); // needles of 1e-9 raise rounding by as much
  EXPECT_NEAR(transport.value * surface.scale(), std::sqrt(2.), 0.01);
}

// Exits in a row of a square for a mass of one in that row: distances there, of which the potential is a
// function, have kinks along columns alone, so that nothing is lost.
struct Ways
{
  Glued_surface surface{square(20)};
  Transport_solver solver{operators(surface.t())};
  std::vector<Index> to = {210, 222, 230};
  std::vector<double> distance;
  Vector masses = Vector::Zero(surface.size());

  Ways()
  {
    for(const Index i : to)
      distance.push_back(exact_distance(surface, 218, i));
    masses[surface.site(218)] = -1.;
  }

  std::vector<Exit> exits(const std::vector<double>& capacity, double price) const
  {
    std::vector<Exit> result;
    for(std::size_t i = 0; i < to.size(); ++i)
      result.push_back({surface.site(to[i]), capacity[i], price});
    return result;
  }
  double cost(const Vector& leaving, double price) const
  {
    double result = 0.;
    for(std::size_t i = 0; i < to.size(); ++i)
      result += leaving[i] * (distance[i] + 0.5 * price * leaving[i]);
    return result;
  }
};

// Bounds are of what is paid, and everything that has to leave does.
void expect_certified(const Ways& ways, const std::vector<Exit>& exits, const Transport& transport)
{
  EXPECT_TRUE(transport.converged);
  EXPECT_LE(transport.iterations, 30);
  EXPECT_NEAR(transport.leaving.sum(), -ways.masses.sum(), rounding);
  EXPECT_LT(transport.residual, rounding);
  Vector missing = ways.masses;
  double upper = 0.;
  for(std::size_t f = 0; f < transport.flow.size(); ++f)
    upper += ways.solver.operators().area[f] * norm(transport.flow[f]);
  double lower = transport.potential.dot(ways.masses);
  for(std::size_t i = 0; i < exits.size(); ++i)
  {
    const double x = transport.leaving[Eigen::Index(i)], capacity = exits[i].capacity,
                 price = exits[i].price, gain = -transport.potential[exits[i].site];
    EXPECT_GE(x, 0.);
    EXPECT_LE(x, capacity);
    upper += 0.5 * price * x * x;
    missing[exits[i].site] += x;
    // The potential is zero where the last mass leaves: nothing is gained by more of it.
    if(const double most = price > 0. ? std::min(gain / price, capacity) : capacity; gain > 0.)
      lower += most * (0.5 * price * most - gain);
  }
  EXPECT_NEAR(transport.upper, upper, rounding);
  EXPECT_NEAR(transport.lower, lower, rounding);
  EXPECT_LE(transport.lower, transport.upper);
  EXPECT_LT(
      (divergence(ways.solver.operators(), transport.flow) - missing).lpNorm<Eigen::Infinity>(),
      rounding);
}

TEST(Transport, fills_the_nearest_exits_first)
{
  const Ways ways;
  std::vector<std::size_t> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ways.distance[a] < ways.distance[b]; });
  for(const std::vector<double>& capacity : {std::vector<double>{0.3, 0.3, 0.9},
                                             {0.5, 0.2, infinity},
                                             {2., 2., 2.},
                                             {infinity, infinity, infinity},
                                             {1e-3, 1e-3, 1.5},
                                             {0.3, 0.3, 0.4}})
  {
    const std::vector<Exit> exits = ways.exits(capacity, 0.);
    double rest = 1., exact = 0.;
    Vector leaving = Vector::Zero(3);
    for(const std::size_t i : order)
    {
      leaving[i] = std::min(rest, capacity[i]);
      rest -= leaving[i];
    }
    exact = ways.cost(leaving, 0.);
    const Transport transport = ways.solver.solve(ways.masses, within(1e-6), exits);
    expect_certified(ways, exits, transport);
    EXPECT_NEAR(transport.value, exact, 1e-5 * exact);
    // What goes elsewhere costs a tenth more at least.
    EXPECT_LT((transport.leaving - leaving).lpNorm<Eigen::Infinity>(), 1e-4);
  }
}

TEST(Transport, spreads_over_exits_that_cost_by_the_square)
{
  const Ways ways;
  for(const double price : {0.1, 1., 10., 1e3})
    for(const double capacity : {infinity, 0.45})
    {
      const std::vector<Exit> exits = ways.exits({capacity, capacity, capacity}, price);
      // Of all that cost the same at the margin, by bisection.
      double low = 0., high = 100. + price;
      Vector leaving(3);
      for(int i = 0; i < 100; ++i)
      {
        const double middle = 0.5 * (low + high);
        for(std::size_t j = 0; j < 3; ++j)
          leaving[j] = std::clamp((middle - ways.distance[j]) / price, 0., capacity);
        (leaving.sum() < 1. ? low : high) = middle;
      }
      const double exact = ways.cost(leaving, price);
      const Transport transport = ways.solver.solve(ways.masses, within(1e-6), exits);
      expect_certified(ways, exits, transport);
      EXPECT_NEAR(transport.value, exact, 1e-5 * exact);
      // By how much a sum of squares shows what is a millionth away.
      EXPECT_LT((transport.leaving - leaving).norm(), std::sqrt(4e-6 * exact / price) + 1e-6);
    }
}

TEST(Transport, lets_masses_leave_on_their_components)
{
  const Glued_surface surface(apart(square(6), square(6)));
  const Transport_solver solver(operators(surface.t()));
  Vector masses = Vector::Zero(surface.size());
  masses[surface.site(0)] = -2.;
  masses[surface.site(49)] = -3.; // on the second one, where it also goes from a corner to another
  masses[surface.site(55)] = 3.;
  const Transport transport =
      solver.solve(masses, within(1e-6), {{surface.site(6), 5., 0.}, {surface.site(90), 1., 0.}});
  EXPECT_NEAR(transport.value * surface.scale(), 2. + 3., 1e-5);
  EXPECT_NEAR(transport.leaving[0], 2., 1e-9);
  EXPECT_EQ(transport.leaving[1], 0.);
  EXPECT_THROW(solver.solve(masses, {}, {{surface.site(6), 1.9, 0.}}), Invalid_argument_error);
  EXPECT_THROW(solver.solve(masses, {}, {{surface.site(90), 9., 0.}}), Invalid_argument_error);
  for(const Exit& bad : {Exit{surface.site(6), 0., 0.}, Exit{surface.site(6), std::nan(""), 0.},
                         Exit{surface.site(6), 3., -1.}, Exit{surface.site(6), 3., infinity}})
    EXPECT_THROW(solver.solve(masses, {}, {bad}), Invalid_argument_error);
  Transport_options splitting;
  splitting.method = Transport_method::splitting;
  EXPECT_THROW(solver.solve(masses, splitting, {{surface.site(6), 5., 0.}}),
               Invalid_argument_error);
}

TEST(Transport, measures_clouds)
{
  const Cloud cloud = octahedron_sphere(4); // 1026 surfels
  const Glued_surfels sphere = glue_surfels(cloud.points, cloud.normals);
  const Transport_solver solver(operators(sphere.triangles));
  for(const std::size_t to : {2u, 500u, 1000u}) // no poles, as above
  {
    Vector masses = Vector::Zero(Eigen::Index(cloud.size()));
    masses[sphere.site_of_surfel[0]] = -1.;
    masses[sphere.site_of_surfel[to]] = 1.;
    const double exact = great_circle(cloud.points[0], cloud.points[to]);
    const Transport transport = solver.solve(masses);
    // 2 percent: what a side, of about 0.1, takes from the distance around a mass at a point.
    EXPECT_NEAR(transport.value * sphere.triangles.scale, exact, 0.02 * exact);
  }
}

TEST(Transport, can_be_cancelled)
{
  const Glued_surface surface(icosphere(3));
  const Transport_solver solver(operators(surface.t()));
  const Vector masses = from_to(surface, 0, 300);
  double last = 0.;
  unsigned calls = 0;
  Transport_options options = within(1e-6);
  options.callback = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.);
    last = fraction;
    return ++calls < 4;
  };
  const Transport transport = solver.solve(masses, options);
  EXPECT_EQ(calls, 4u);
  EXPECT_EQ(transport.iterations, 3u);
  EXPECT_FALSE(transport.converged);
  expect_certified(solver.operators(), masses, transport); // as far as it came
}

TEST(Transport, answers_in_threads)
{
  const Glued_surface surface(icosphere(3));
  const Transport_solver solver(operators(surface.t()));
  const Transport expected = solver.solve(from_to(surface, 0, 300));
  std::vector<Transport> found(8);
  for_each_block(found.size(), 1, 4,
                 [&](std::size_t block, std::size_t, std::size_t)
                 { found[block] = solver.solve(from_to(surface, 0, 300)); });
  for(const Transport& transport : found)
  {
    EXPECT_EQ(transport.value, expected.value);
    EXPECT_EQ(transport.potential, expected.potential);
    EXPECT_EQ(transport.flow, expected.flow);
  }
}

} // namespace
