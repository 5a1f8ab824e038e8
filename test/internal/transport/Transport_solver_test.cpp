// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Transport_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

namespace Transport_solver_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of divergences after some tens of back substitutions, and of
// recomputed bounds.
constexpr double round_off = 1e-9;

Transport_options with_tolerance(double tolerance)
{
  Transport_options result;
  result.tolerance = tolerance;
  return result;
}

// Returns the masses that move a unit mass from one vertex to another.
Vector point_to_point(const Array_surface& surface, Index from, Index to)
{
  Vector result = Vector::Zero(surface.size());
  result[surface.vertex(from)] -= 1.;
  result[surface.vertex(to)] += 1.;
  return result;
}

double exact_distance(const Array_surface& surface, Index from, Index to)
{
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  return windows.distance(surface.vertex(to));
}

Vector random_masses(const Operators& operators, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> mass(-1., 1.);
  Vector result(operators.number_of_vertices);
  for(double& x : result)
    x = mass(random);
  const auto [component, number_of_components] = components(operators);
  std::vector<double> sum(number_of_components, 0.), count(number_of_components, 0.);
  for(std::size_t vertex = 0; vertex < component.size(); ++vertex)
  {
    sum[component[vertex]] += result[vertex];
    ++count[component[vertex]];
  }
  for(std::size_t vertex = 0; vertex < component.size(); ++vertex)
    result[vertex] -= sum[component[vertex]] / count[component[vertex]];
  return result;
}

// Checks the bounds against the flow and the potential that certify them.
void expect_certified(const Operators& o, const Vector& masses, const Transport_result& transport)
{
  const double moved_mass = 0.5 * masses.lpNorm<1>();
  EXPECT_LE(transport.lower, transport.value);
  EXPECT_LE(transport.value, transport.upper);
  EXPECT_LT(transport.residual, round_off);
  EXPECT_LT((minus_divergence(o, transport.flow) - masses).lpNorm<Eigen::Infinity>(),
            round_off * moved_mass);
  double cost = 0.;
  for(std::size_t f = 0; f < transport.flow.size(); ++f)
    cost += o.area[f] * norm(transport.flow[f]);
  EXPECT_NEAR(cost, transport.upper, round_off * cost);
  EXPECT_NEAR(masses.dot(transport.potential), transport.lower, round_off * cost);
  for(const Vec2& slope : gradient(o, transport.potential))
    EXPECT_LT(norm(slope), 1. + round_off);
}

// The linear systems of needles are so ill-conditioned that flows do not move all masses.
TEST(Transport_solver, bounds_contain_the_errors_of_needles)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const double shortest : {1e-9, 1e-6, 1e-3})
    {
      SCOPED_TRACE("scale " + std::to_string(scale) + ", edge " + std::to_string(shortest));
      const Array_surface surface(Triangulation{{{0., 0., 0.},
                                                 {scale, 0., 0.},
                                                 {scale * (1. + shortest), 0., 0.},
                                                 {2. * scale, 1e-4 * scale, 0.},
                                                 {0., scale, 0.}},
                                                {0, 1, 2, 1, 3, 2, 0, 2, 4}});
      const Transport_solver solver(operators(surface.t(), Degenerate_triangles::thickened));
      for(const Transport_method method :
          {Transport_method::interior_point, Transport_method::admm, Transport_method::weiszfeld})
        for(const unsigned iterations : {1u, 2u, 100u})
        {
          Transport_options options;
          options.method = method;
          options.maximum_iterations = iterations;
          const Transport_result result = solver.solve(point_to_point(surface, 1, 4), options);
          EXPECT_LE(result.lower, result.upper);
          // The shortest path is straight. Slopes of needles have relative errors up to 1e-7.
          const double distance = std::sqrt(2.) * scale / surface.scale();
          EXPECT_LE(result.lower, distance * (1. + 1e-6));
        }
    }
}

// Splits each triangle at a location close to a corner. `fraction`: of the edges at this corner.
Triangulation with_needles(Triangulation surface, double fraction)
{
  const std::vector<Index> corners = std::exchange(surface.corners, {});
  for(std::size_t c = 0; c < corners.size(); c += 3)
  {
    Point split;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double x = surface.points[corners[c]][k];
      split[k] = x + fraction * (surface.points[corners[c + 1]][k] +
                                 surface.points[corners[c + 2]][k] - 2. * x);
    }
    const Index vertex = Index(surface.points.size());
    surface.points.push_back(split);
    for(std::size_t k = 0; k < 3; ++k)
      surface.corners.insert(surface.corners.end(),
                             {corners[c + k], corners[c + (k + 1) % 3], vertex});
  }
  return surface;
}

TEST(Transport_solver, converges_on_needles)
{
  for(const double fraction : {1e-6, 1e-8, 1e-9})
  {
    SCOPED_TRACE(fraction);
    const Array_surface surface(with_needles(torus(24, 12), fraction));
    const Transport_solver solver(operators(surface.t(), Degenerate_triangles::thickened));
    const Transport_result result =
        solver.solve(point_to_point(surface, 20, 150), with_tolerance(1e-5));
    EXPECT_TRUE(result.is_converged);
    // Without needles, seven iterations suffice.
    EXPECT_LT(result.number_of_iterations, 20u);
  }
}

// Returns a unit square without the triangles of a wall, which is one cell thick and 3/4 high.
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

TEST(Transport_solver, bounds_are_certified)
{
  for(const Triangulation& surface :
      {tetrahedron(), square(8, 0.24), cylinder(12, 4, 1., 1.), torus(12, 8), double_torus(1),
       jittered(icosphere(2), 0.03), disjoint_union(icosphere(1), torus(12, 8))})
  {
    const Transport_solver solver(operators(Array_surface(surface).t()));
    const Vector masses = random_masses(solver.operators(), 1);
    for(const double tolerance : {0.1, 1e-3, 1e-5})
    {
      const Transport_result transport = solver.solve(masses, with_tolerance(tolerance));
      EXPECT_TRUE(transport.is_converged);
      EXPECT_LE(transport.upper - transport.lower,
                tolerance * transport.upper); // the requested gap
      EXPECT_LE(transport.number_of_iterations, 30u);
      expect_certified(solver.operators(), masses, transport);
    }
  }
}

// The flow on a triangle between two of its corners is known up to round-off errors, so the bounds
// agree except for their last digit.
TEST(Transport_solver, bounds_are_ordered_on_single_triangles)
{
  std::mt19937 random(0);
  std::uniform_real_distribution<double> coordinate(0., 1.);
  for(int i = 0; i < 50; ++i)
  {
    std::vector<Vec3> corners(3);
    for(Vec3& p : corners)
      p = {coordinate(random), coordinate(random), coordinate(random)};
    const Array_surface surface({corners, {0, 1, 2}});
    const Transport_solver solver(operators(surface.t()));
    for(const Index to : {1u, 2u})
    {
      const Transport_result transport = solver.solve(point_to_point(surface, 0, to));
      EXPECT_LE(transport.lower, transport.value);
      EXPECT_LE(transport.value, transport.upper);
    }
  }
}

TEST(Transport_solver, lower_bound_is_at_most_exact_distance)
{
  for(const Triangulation& shape : {jittered(icosphere(3), 0.02), torus(40, 16), double_torus(2),
                                    cylinder(24, 8, 1., 2.), cone(12, 6, 4.), cone(12, 6, 8.)})
  {
    const Array_surface surface(shape);
    const Transport_solver solver(operators(surface.t()));
    for(const Index to : {1u, 7u, surface.size() / 2, surface.size() - 1})
    {
      const double exact = exact_distance(surface, 0, to);
      const Transport_result transport =
          solver.solve(point_to_point(surface, 0, to), with_tolerance(1e-4));
      EXPECT_LE(transport.lower, exact * (1. + round_off));
      EXPECT_GE(transport.upper,
                0.9 * exact); // a coarse mesh loses up to 10 % around point masses
    }
  }
}

TEST(Transport_solver, error_is_below_one_percent_on_sphere)
{
  const Array_surface surface(icosphere(4));
  const Transport_solver solver(operators(surface.t()));
  const auto value = [&](Index from, Index to)
  { return solver.solve(point_to_point(surface, from, to)).value; };
  for(const Index from : {0u, 700u})
    for(const Index to : {1u, 100u, 1000u, 1500u, 2000u})
    {
      const double exact = exact_distance(surface, from, to);
      // Discretization error; see the name of the test.
      EXPECT_GT(value(from, to), 0.99 * exact);
      EXPECT_LT(value(from, to), exact * (1. + 0.5e-3)); // half the gap
    }
  // Between the poles the flow leaves in all directions. In a fan of five triangles, a function
  // of slope one with equal values at the neighbors changes by at most 0.81 of an edge length.
  EXPECT_GT(value(0, 3), 0.98 * exact_distance(surface, 0, 3));
}

TEST(Transport_solver, is_exact_in_plane)
{
  const Array_surface convex(square(20, 0.24)), walled(walled_square(20));
  for(const Array_surface* surface : {&convex, &walled})
  {
    const Transport_solver solver(operators(surface->t()));
    // From the lower left corner to the other corners, and to a vertex in the right half.
    for(const Index to : {20u, 420u, 440u, 225u})
    {
      const double exact = exact_distance(*surface, 0, to);
      const Transport_result transport =
          solver.solve(point_to_point(*surface, 0, to), with_tolerance(1e-6));
      EXPECT_NEAR(transport.value, exact, 1e-6 * exact); // the gap
    }
  }
}

TEST(Transport_solver, transports_square_side_to_opposite_side)
{
  const std::size_t n = 12;
  const Array_surface surface(square(n, 0.24));
  Vector masses = Vector::Zero(surface.size());
  for(std::size_t j = 0; j <= n; ++j)
  {
    masses[surface.vertex(Index(j * (n + 1)))] = -double(j);
    masses[surface.vertex(Index(j * (n + 1) + n))] = double(j);
  }
  const Transport_solver solver(operators(surface.t()));
  const Transport_result transport = solver.solve(masses, with_tolerance(1e-6));
  EXPECT_NEAR(transport.value * surface.scale(), n * (n + 1) / 2.,
              1e-5 * n * n); // each mass moves by one
}

TEST(Transport_solver, is_symmetric_and_unit_invariant)
{
  const Triangulation shape = jittered(icosphere(2), 0.03);
  const Array_surface surface(shape);
  const Transport_solver solver(operators(surface.t()));
  const Vector masses = point_to_point(surface, 0, 50) + 0.3 * point_to_point(surface, 7, 120);
  const double value = solver.solve(masses).value;
  EXPECT_EQ(solver.solve(-masses).value, value);
  for(const double factor : {1e-6, 1e6})
  {
    EXPECT_NEAR(solver.solve(factor * masses).value, factor * value, round_off * factor * value);
    const Array_surface other(scaled(shape, factor));
    const Transport_solver other_solver(operators(other.t()));
    // Scaling changes the order of the vertices.
    const Vector same = point_to_point(other, 0, 50) + 0.3 * point_to_point(other, 7, 120);
    EXPECT_NEAR(other_solver.solve(same).value * other.scale(), factor * value * surface.scale(),
                round_off * factor * value * surface.scale());
  }
}

TEST(Transport_solver, zero_masses_cost_nothing)
{
  const Transport_solver solver(operators(Array_surface(torus(12, 8)).t()));
  const Transport_result transport = solver.solve(Vector::Zero(96));
  EXPECT_TRUE(transport.is_converged);
  EXPECT_EQ(transport.upper, 0.);
  EXPECT_EQ(transport.value, 0.);
  EXPECT_EQ(transport.potential, Vector::Zero(96));
  EXPECT_EQ(transport.flow, Field(192, Vec2{0., 0.}));
}

TEST(Transport_solver, is_additive_over_components)
{
  const Triangulation first_shape = icosphere(2), second_shape = scaled(torus(12, 8), 3.);
  const Array_surface both(disjoint_union(first_shape, second_shape)), one(first_shape),
      two(second_shape);
  const Index n = one.size();
  const Vector masses = point_to_point(both, 0, 50) + 2. * point_to_point(both, n, n + 40);
  const double sum = one.scale() * Transport_solver(operators(one.t()))
                                       .solve(point_to_point(one, 0, 50), with_tolerance(1e-6))
                                       .value +
                     2. * two.scale() *
                         Transport_solver(operators(two.t()))
                             .solve(point_to_point(two, 0, 40), with_tolerance(1e-6))
                             .value;
  const Transport_solver solver(operators(both.t()));
  // The gaps of the three results are at most 1e-6.
  EXPECT_NEAR(solver.solve(masses, with_tolerance(1e-6)).value * both.scale(), sum, 1e-6 * sum);
  // No mass on one of the components.
  const Transport_result transport =
      solver.solve(point_to_point(both, 0, 50), with_tolerance(1e-5));
  EXPECT_TRUE(transport.is_converged);
  EXPECT_THROW(solver.solve(point_to_point(both, 0, n)), Invalid_argument_error);
}

TEST(Transport_solver, throws_on_invalid_masses)
{
  Triangulation shape = square(4);
  shape.points.push_back({2., 2., 0.}); // isolated
  const Array_surface surface(shape);
  const Transport_solver solver(operators(surface.t()));
  EXPECT_THROW(solver.solve(Vector::Zero(3)), Invalid_argument_error);
  EXPECT_THROW(solver.solve(Vector::Ones(surface.size())), Invalid_argument_error);
  EXPECT_THROW(solver.solve(point_to_point(surface, 0, 25)), Invalid_argument_error);
  Vector masses = point_to_point(surface, 0, 24);
  EXPECT_NO_THROW(solver.solve(masses));
  for(const double tolerance : {0., -1., std::nan("")})
    EXPECT_THROW(solver.solve(masses, with_tolerance(tolerance)), Invalid_argument_error);
  for(const double invalid : {std::nan(""), infinity})
  {
    masses[0] = invalid;
    EXPECT_THROW(solver.solve(masses), Invalid_argument_error);
  }
  const Array_surface point({std::vector<Point>(4, Point{1., 2., 3.}), {0, 1, 2, 0, 2, 3}});
  EXPECT_THROW(Transport_solver(operators(point.t())), Unsupported_surface_error);
  const Array_surface flat({{{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}}, {0, 1, 2}});
  EXPECT_THROW(Transport_solver(operators(flat.t())), Unsupported_surface_error);
}

TEST(Transport_solver, handles_degenerate_triangles)
{
  Triangulation shape = square(20);
  for(const Index i : {210u, 211u, 212u})
    shape.points[i] = shape.points[210];
  shape.points[66] = {0.125, 0.15, 0.}; // collinear with its neighbors in the row
  const Array_surface surface(shape);
  const Transport_solver solver(operators(surface.t()));
  const Vector masses = point_to_point(surface, 0, 440);
  const Transport_result transport = solver.solve(masses);
  EXPECT_TRUE(transport.is_converged);
  EXPECT_LT(transport.residual, 1e-6); // needles of height 1e-9 amplify round-off errors
  EXPECT_NEAR(transport.value * surface.scale(), std::sqrt(2.), 1.5e-3); // the gap of 1e-3
}

// A unit mass and three exits in one row of a square. The potential is a function of the
// distances to the exits, whose kinks are along columns of vertices; so that the discretization
// is exact.
struct Exit_problem
{
  Array_surface surface{square(20)};
  Transport_solver solver{operators(surface.t())};
  std::vector<Index> to = {210, 222, 230};
  std::vector<double> distance;
  Vector masses = Vector::Zero(surface.size());

  Exit_problem()
  {
    for(const Index i : to)
      distance.push_back(exact_distance(surface, 218, i));
    masses[surface.vertex(218)] = -1.;
  }

  std::vector<Exit> exits(const std::vector<double>& capacity, double price) const
  {
    std::vector<Exit> result;
    for(std::size_t i = 0; i < to.size(); ++i)
      result.push_back({surface.vertex(to[i]), capacity[i], price});
    return result;
  }
  double cost(const Vector& outflow, double price) const
  {
    double result = 0.;
    for(std::size_t i = 0; i < to.size(); ++i)
      result += outflow[i] * (distance[i] + 0.5 * price * outflow[i]);
    return result;
  }
};

// Checks that the bounds include the prices, and that all surplus mass leaves.
void expect_certified(const Exit_problem& problem, const std::vector<Exit>& exits,
                      const Transport_result& transport)
{
  EXPECT_TRUE(transport.is_converged);
  EXPECT_LE(transport.number_of_iterations, 30);
  EXPECT_NEAR(transport.outflow.sum(), -problem.masses.sum(), round_off);
  EXPECT_LT(transport.residual, round_off);
  Vector missing = problem.masses;
  double upper = 0.;
  for(std::size_t f = 0; f < transport.flow.size(); ++f)
    upper += problem.solver.operators().area[f] * norm(transport.flow[f]);
  double lower = transport.potential.dot(problem.masses);
  for(std::size_t i = 0; i < exits.size(); ++i)
  {
    const double x = transport.outflow[Eigen::Index(i)], capacity = exits[i].capacity,
                 price = exits[i].price, gain = -transport.potential[exits[i].vertex];
    EXPECT_GE(x, 0.);
    EXPECT_LE(x, capacity);
    upper += 0.5 * price * x * x;
    missing[exits[i].vertex] += x;
    // The potential is shifted such that the marginal cost is zero; the gain of an exit is minus
    // the potential.
    if(const double optimal_outflow = price > 0. ? std::min(gain / price, capacity) : capacity;
       gain > 0.)
      lower += optimal_outflow * (0.5 * price * optimal_outflow - gain);
  }
  EXPECT_NEAR(transport.upper, upper, round_off * upper);
  EXPECT_NEAR(transport.lower, lower, round_off * upper);
  EXPECT_LE(transport.lower, transport.upper);
  EXPECT_LT((minus_divergence(problem.solver.operators(), transport.flow) - missing)
                .lpNorm<Eigen::Infinity>(),
            round_off);
}

TEST(Transport_solver, fills_nearest_exits_first)
{
  const Exit_problem problem;
  std::vector<std::size_t> order = {0, 1, 2};
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b)
            { return problem.distance[a] < problem.distance[b]; });
  for(const std::vector<double>& capacity : {std::vector<double>{0.3, 0.3, 0.9},
                                             {0.5, 0.2, infinity},
                                             {2., 2., 2.},
                                             {infinity, infinity, infinity},
                                             {1e-3, 1e-3, 1.5},
                                             {0.3, 0.3, 0.4}})
  {
    const std::vector<Exit> exits = problem.exits(capacity, 0.);
    double remaining = 1., exact = 0.;
    Vector outflow = Vector::Zero(3);
    for(const std::size_t i : order)
    {
      outflow[i] = std::min(remaining, capacity[i]);
      remaining -= outflow[i];
    }
    exact = problem.cost(outflow, 0.);
    const Transport_result transport =
        problem.solver.solve(problem.masses, with_tolerance(1e-6), exits);
    expect_certified(problem, exits, transport);
    EXPECT_NEAR(transport.value, exact, 1e-6 * exact); // the gap
    // Mass that takes another exit costs at least a tenth more.
    EXPECT_LT((transport.outflow - outflow).lpNorm<Eigen::Infinity>(), 1e-4);
  }
}

TEST(Transport_solver, quadratic_prices_spread_outflow)
{
  const Exit_problem problem;
  for(const double price : {0.1, 1., 10., 1e3})
    for(const double capacity : {infinity, 0.45})
    {
      const std::vector<Exit> exits = problem.exits({capacity, capacity, capacity}, price);
      // All open exits have the same marginal cost, which is found by bisection.
      double low = 0., high = 100. + price;
      Vector outflow(3);
      for(int i = 0; i < 100; ++i)
      {
        const double midpoint = 0.5 * (low + high);
        for(std::size_t j = 0; j < 3; ++j)
          outflow[j] = std::clamp((midpoint - problem.distance[j]) / price, 0., capacity);
        (outflow.sum() < 1. ? low : high) = midpoint;
      }
      const double exact = problem.cost(outflow, price);
      const Transport_result transport =
          problem.solver.solve(problem.masses, with_tolerance(1e-6), exits);
      expect_certified(problem, exits, transport);
      EXPECT_NEAR(transport.value, exact, 1e-6 * exact); // the gap
      // The cost is quadratic around the minimum: a gap of 1e-6 bounds the error by its square
      // root.
      EXPECT_LT((transport.outflow - outflow).norm(), std::sqrt(4e-6 * exact / price) + 1e-6);
    }
}

TEST(Transport_solver, exits_serve_their_component)
{
  const Array_surface surface(disjoint_union(square(6), square(6)));
  const Transport_solver solver(operators(surface.t()));
  Vector masses = Vector::Zero(surface.size());
  masses[surface.vertex(0)] = -2.;
  masses[surface.vertex(49)] = -3.; // on the second component, from one corner to another
  masses[surface.vertex(55)] = 3.;
  const Transport_result transport = solver.solve(
      masses, with_tolerance(1e-6), {{surface.vertex(6), 5., 0.}, {surface.vertex(90), 1., 0.}});
  EXPECT_NEAR(transport.value * surface.scale(), 2. + 3., 5e-6); // the gap
  EXPECT_NEAR(transport.outflow[0], 2., round_off);
  EXPECT_EQ(transport.outflow[1], 0.);
  EXPECT_THROW(solver.solve(masses, {}, {{surface.vertex(6), 1.9, 0.}}), Invalid_argument_error);
  EXPECT_THROW(solver.solve(masses, {}, {{surface.vertex(90), 9., 0.}}), Invalid_argument_error);
  for(const Exit& invalid :
      {Exit{surface.vertex(6), 0., 0.}, Exit{surface.vertex(6), std::nan(""), 0.},
       Exit{surface.vertex(6), 3., -1.}, Exit{surface.vertex(6), 3., infinity}})
    EXPECT_THROW(solver.solve(masses, {}, {invalid}), Invalid_argument_error);
  Transport_options admm;
  admm.method = Transport_method::admm;
  EXPECT_THROW(solver.solve(masses, admm, {{surface.vertex(6), 5., 0.}}), Invalid_argument_error);
}

TEST(Transport_solver, works_on_clouds)
{
  const Cloud cloud = octahedron_sphere(4); // 1026 surfels
  const Surfel_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals);
  const Transport_solver solver(operators(sphere.arrays));
  for(const std::size_t to : {2u, 500u, 1000u}) // not opposite to vertex 0
  {
    Vector masses = Vector::Zero(Eigen::Index(cloud.size()));
    masses[sphere.internal_vertex[0]] = -1.;
    masses[sphere.internal_vertex[to]] = 1.;
    const double exact = great_circle(cloud.points[0], cloud.points[to]);
    const Transport_result transport = solver.solve(masses);
    // 2 percent: the discretization error around point masses, for edges of length 0.1.
    EXPECT_NEAR(transport.value * sphere.arrays.scale, exact, 0.02 * exact);
  }
}

TEST(Transport_solver, can_be_cancelled)
{
  const Array_surface surface(icosphere(3));
  const Transport_solver solver(operators(surface.t()));
  const Vector masses = point_to_point(surface, 0, 300);
  double last = 0.;
  unsigned calls = 0;
  Transport_options options = with_tolerance(1e-6);
  options.callback = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.);
    last = fraction;
    return ++calls < 4;
  };
  const Transport_result transport = solver.solve(masses, options);
  EXPECT_EQ(calls, 4u);
  EXPECT_EQ(transport.number_of_iterations, 3u);
  EXPECT_FALSE(transport.is_converged);
  expect_certified(solver.operators(), masses, transport);
}

TEST(Transport_solver, solves_concurrently)
{
  const Array_surface surface(icosphere(3));
  const Transport_solver solver(operators(surface.t()));
  const Transport_result expected = solver.solve(point_to_point(surface, 0, 300));
  std::vector<Transport_result> found(8);
  for_each_block(found.size(), 1, 4,
                 [&](std::size_t block, std::size_t, std::size_t)
                 { found[block] = solver.solve(point_to_point(surface, 0, 300)); });
  for(const Transport_result& transport : found)
  {
    EXPECT_EQ(transport.value, expected.value);
    EXPECT_EQ(transport.potential, expected.potential);
    EXPECT_EQ(transport.flow, expected.flow);
  }
}

} // namespace Transport_solver_test
