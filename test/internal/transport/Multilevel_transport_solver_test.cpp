// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Multilevel_transport_solver.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace Multilevel_transport_solver_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative round-off error of sums of some hundred terms.
constexpr double round_off = 1e-9;

Transport_options with_tolerance(double tolerance, bool do_bound_from_above = false)
{
  Transport_options result;
  result.tolerance = tolerance;
  result.do_bound_from_above = do_bound_from_above;
  return result;
}

Mass_distribution at(const Surface_location& location, double mass = 1.)
{
  Mass_distribution result;
  result.at_locations = {{location, mass}};
  return result;
}

double exact_distance(const Array_surface& surface, const Surface_location& from,
                      const Surface_location& to)
{
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  return surface.scale() * windows.distance(to);
}

TEST(Multilevel_transport_solver, bounds_enclose_exact_distance)
{
  for(const Triangulation& shape : {jittered(icosphere(2), 0.03), cylinder(16, 6, 1., 1.5)})
  {
    const Array_surface surface(shape);
    const Multilevel_transport_solver solver(surface.triangles());
    const Surface_location from = surface.in(3, {0.2, 0.5, 0.3});
    for(const Surface_location& to : {surface.in(40, {0.1, 0.1, 0.8}), surface.in(90, {1., 0., 0.}),
                                      surface.on(77, 1, 0.4), surface.at(20)})
    {
      const double exact = exact_distance(surface, from, to);
      const Transport_result found = solver.solve(at(from), at(to), with_tolerance(1e-4, true));
      EXPECT_LE(found.lower, exact * (1. + round_off));
      EXPECT_GE(found.upper_continuous, exact);
      EXPECT_GT(found.value, 0.85 * exact); // discretization error around points, ten edges apart
      EXPECT_EQ(found.estimate, found.value);
    }
    // The continuous bound is computed on request only.
    EXPECT_EQ(solver.solve(at(from), at(surface.at(20))).upper_continuous, infinity);
  }
}

// All points except one are on a line, so that the flow does not move most of the masses.
TEST(Multilevel_transport_solver, bounds_contain_the_distance_between_triangles_without_area)
{
  Triangulation strip;
  for(Index i = 0; i < 30; ++i)
  {
    strip.points.push_back({0.1 * i, 0.03 * i, -0.02 * i});
    if(i > 1)
      strip.corners.insert(strip.corners.end(),
                           {i - 2, i % 2 == 0 ? i - 1 : i, i % 2 == 0 ? i : i - 1});
  }
  strip.points.push_back({2.9, 1., 0.});
  strip.corners.insert(strip.corners.end(), {28, 29, 30});
  const Array_surface surface(strip);
  const Multilevel_transport_solver solver(surface.triangles(), 0);
  for(const Index to : {Index(1), Index(7), Index(29)})
  {
    const double exact = double(to) * std::sqrt(0.1 * 0.1 + 0.03 * 0.03 + 0.02 * 0.02);
    const Transport_result found =
        solver.solve(at(surface.at(0)), at(surface.at(to)), with_tolerance(1e-4, true));
    // Slopes have relative errors up to the round-off errors of heights.
    EXPECT_LE(found.lower, exact * (1. + 1e-6));
    EXPECT_LE(found.lower, found.upper);
    EXPECT_GE(found.upper_continuous, exact * (1. - round_off));
  }
}

// Each diagonal of a grid has a vertex near its end, which only one of its triangles uses. The gap
// is a triangle without area.
TEST(Multilevel_transport_solver, converges_across_triangles_without_area)
{
  for(const double distance : {0., 1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 0.3})
  {
    const Index n = 10;
    Triangulation plane = square(n);
    const std::vector<Index> corners = std::exchange(plane.corners, {});
    for(std::size_t f = 0; f < corners.size(); f += 6)
    {
      const Index a = corners[f], b = corners[f + 1], c = corners[f + 2], d = corners[f + 5];
      ASSERT_EQ(corners[f + 3], a);
      ASSERT_EQ(corners[f + 4], c);
      const Index p = Index(plane.points.size());
      plane.points.push_back(plane.points[a] + distance * (plane.points[c] - plane.points[a]));
      plane.corners.insert(plane.corners.end(), {a, b, c, a, p, d, p, c, d, a, c, p});
    }
    const Array_surface surface(plane);
    const Index from = 1, to = (n + 1) * n;
    const double exact = test::distance(plane.points[from], plane.points[to]);
    for(const unsigned refinements : {0u, 1u})
    {
      const Multilevel_transport_solver solver(surface.triangles(), refinements);
      const Transport_result found =
          solver.solve(at(surface.at(from)), at(surface.at(to)), with_tolerance(1e-3, true));
      EXPECT_TRUE(found.is_converged) << distance << ' ' << refinements;
      // Thickened triangles are crossed, at most two in each cell.
      EXPECT_LE(found.lower, exact * (1. + 1e-6)) << distance;
      EXPECT_GE(found.upper_continuous, exact * (1. - round_off)) << distance;
      // The cost of masses that the flow does not move is part of the gap.
      EXPECT_LT(found.residual, 1e-3) << distance;
    }
  }
}

TEST(Multilevel_transport_solver, converges_under_refinement)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Surface_location from = surface.in(3, {0.2, 0.5, 0.3}),
                         to = surface.in(250, {0.1, 0.1, 0.8});
  const double exact = exact_distance(surface, from, to);
  double lower_error = infinity, upper_error = infinity;
  for(const unsigned refinements : {0u, 1u, 2u, 3u})
  {
    const Multilevel_transport_solver solver(surface.triangles(), refinements);
    const Transport_result found = solver.solve(at(from), at(to), with_tolerance(1e-5, true));
    EXPECT_LE(found.lower, exact * (1. + round_off));
    EXPECT_LT(exact - found.lower, lower_error);
    EXPECT_LT(found.upper_continuous - exact, upper_error);
    lower_error = exact - found.lower;
    upper_error = found.upper_continuous - exact;

    // Coarsened flows move the same masses. The potential is restricted to the coarse vertices.
    const Operators o = operators(surface.t());
    Vector masses = Vector::Zero(surface.size());
    for(std::size_t k = 0; k < 3; ++k)
    {
      masses[surface.t().corner[3 * from.triangle + k]] -= from.barycentric[k];
      masses[surface.t().corner[3 * to.triangle + k]] += to.barycentric[k];
    }
    const Vector error = surface.scale() * minus_divergence(o, found.flow) - masses;
    EXPECT_LT(error.lpNorm<Eigen::Infinity>(), round_off);
    for(Index h = 0; h < surface.t().corner.size(); ++h)
      EXPECT_LE(found.potential[surface.t().corner[next_halfedge(h)]] -
                    found.potential[surface.t().corner[h]],
                surface.scale() * surface.t().length[h] * (1. + round_off));
  }
}

// Refinement halves the error around masses at vertices. Around masses inside triangles, the
// error depends on their positions.
TEST(Multilevel_transport_solver, estimate_extrapolates)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Multilevel_transport_solver solver(surface.triangles(), 1);
  for(const Index to : {20u, 70u, 120u})
  {
    const double exact = exact_distance(surface, surface.at(0), surface.at(to));
    const Transport_result found =
        solver.solve(at(surface.at(0)), at(surface.at(to)), with_tolerance(1e-5));
    // The last term is the gap.
    EXPECT_LT(std::abs(found.estimate - exact), 0.5 * (exact - found.value) + 1e-5 * exact);
  }
}

// Linear densities on a square, moved to the right. On each line, the cost is the integral of
// the difference of the cumulative masses before and after, 2 x - 2 x^2.
TEST(Multilevel_transport_solver, transports_densities)
{
  const Array_surface surface(square(16, 0.24));
  Mass_distribution from, to;
  from.density.resize(surface.size());
  to.density.resize(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double x = surface.point(i)[0];
    from.density[surface.vertex(i)] = 2. * (1. - x);
    to.density[surface.vertex(i)] = 2. * x;
  }
  // The gap, and a twentieth of the squared edge length (1/16)^2.
  const double error = 2e-4;
  for(const unsigned refinements : {0u, 1u})
  {
    const Transport_result found = Multilevel_transport_solver(surface.triangles(), refinements)
                                       .solve(from, to, with_tolerance(1e-5, true));
    EXPECT_LE(found.lower, 1. / 3. * (1. + round_off));
    EXPECT_GE(found.upper_continuous, 1. / 3.);
    EXPECT_NEAR(found.value, 1. / 3., error);
    EXPECT_LT(found.upper_continuous, 0.5);
  }
  // With normalization, the total mass does not matter.
  to.density *= 7.;
  Transport_options options = with_tolerance(1e-5);
  options.do_normalize = true;
  EXPECT_NEAR(Multilevel_transport_solver(surface.triangles()).solve(from, to, options).value,
              1. / 3., error);
}

TEST(Multilevel_transport_solver, accepts_all_kinds_of_masses)
{
  const Array_surface surface(square(8, 0.24));
  Mass_distribution all;
  all.at_vertices = Vector::Zero(surface.size());
  all.at_vertices[surface.vertex(4)] = 0.25;
  all.at_locations = {{surface.in(9, {0.5, 0.25, 0.25}), 0.25}};
  all.density = Vector::Constant(surface.size(), 0.5);
  // The mean distance from the unit square to one of its corners is (sqrt(2) + asinh(1)) / 3.
  const auto distance_to_target = [&](const Point& p)
  { return test::distance(p, surface.point(80)); };
  Point inner = {0., 0., 0.};
  const auto& corners = square(8, 0.24).corners;
  for(std::size_t c = 0; c < 3; ++c)
    inner[c] = 0.5 * surface.point(corners[27])[c] + 0.25 * surface.point(corners[28])[c] +
               0.25 * surface.point(corners[29])[c];
  const double exact = 0.25 * distance_to_target(surface.point(4)) +
                       0.25 * distance_to_target(inner) +
                       0.5 * (std::sqrt(2.) + std::asinh(1.)) / 3.;
  // If masses arrive at a point from all directions, the discretization error is a fraction of an
  // edge length in each annulus of radii 1, 2, 4, ... edge lengths.
  for(const unsigned refinements : {0u, 2u})
  {
    const Transport_result found = Multilevel_transport_solver(surface.triangles(), refinements)
                                       .solve(all, at(surface.at(80)), with_tolerance(1e-4));
    EXPECT_TRUE(found.is_converged);
    EXPECT_LE(found.lower, exact);
    const double edge_length = 0.125 / double(1 << refinements);
    EXPECT_GE(found.value, exact - 0.12 * edge_length * std::log2(1. / edge_length));
  }
}

TEST(Multilevel_transport_solver, respects_metric)
{
  const Array_surface surface(square(12, 0.24));
  const Surface_location from = surface.at(0), to = surface.at(168);
  const std::size_t n = surface.t().number_of_triangles();
  const auto value = [&](std::vector<Metric_tensor> metric)
  {
    return Multilevel_transport_solver(surface.triangles(), 0, std::move(metric))
        .solve(at(from), at(to), with_tolerance(1e-6))
        .value;
  };
  // The gap; the errors measured are 6e-8 of the length.
  const double gap = 1e-6;
  EXPECT_NEAR(value({}), std::sqrt(2.), gap * std::sqrt(2.));
  EXPECT_NEAR(value(std::vector<Metric_tensor>(n, {3., 0., 3.})), 3. * std::sqrt(2.),
              3. * gap * std::sqrt(2.));
  // Doubling lengths along x gives the diagonal of a rectangle. Tensors are given in the frame
  // of each triangle.
  std::vector<Metric_tensor> metric;
  for(std::size_t f = 0; f < n; ++f)
  {
    const Vec3 direction = unit(surface.t().point[surface.t().corner[3 * f + 1]] -
                                surface.t().point[surface.t().corner[3 * f]]);
    const double c = direction[0], s = direction[1];
    metric.push_back({1. + c * c, -c * s, 1. + s * s});
  }
  EXPECT_NEAR(value(metric), std::sqrt(5.), gap * std::sqrt(5.));
  const Transport_result bounded = Multilevel_transport_solver(surface.triangles(), 1, metric)
                                       .solve(at(from), at(to), with_tolerance(1e-6, true));
  EXPECT_NEAR(bounded.value, std::sqrt(5.), gap * std::sqrt(5.));
  EXPECT_GE(bounded.upper_continuous, std::sqrt(5.));
  EXPECT_LE(bounded.upper_continuous, 1.5 * std::sqrt(5.));
}

// Lengths in the upper half of a square count three times.
TEST(Multilevel_transport_solver, obeys_snells_law)
{
  const std::size_t columns = 24;
  const Array_surface surface(square(columns));
  std::vector<Metric_tensor> metric;
  for(std::size_t f = 0; f < surface.t().number_of_triangles(); ++f)
  {
    double y = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      y += surface.t().point[surface.t().corner[3 * f + k]][1];
    const double slowness = y * surface.scale() / 3. + surface.t().origin[1] > 0.5 ? 3. : 1.;
    metric.push_back({slowness, 0., slowness});
  }
  // The shortest path from a corner to the opposite one crosses (x, 0.5).
  double exact = infinity;
  for(double x = 0.; x < 1.; x += 1e-5)
    exact = std::min(exact, std::hypot(x, 0.5) + 3. * std::hypot(1. - x, 0.5));
  const Multilevel_transport_solver solver(surface.triangles(), 0, metric);
  const Transport_result found = solver.solve(at(surface.at(0)), at(surface.at(surface.size() - 1)),
                                              with_tolerance(1e-5, true));
  EXPECT_LE(found.lower, exact * (1. + 1e-9));   // the squared step of x, and round-off errors
  EXPECT_NEAR(found.value, exact, 4e-3 * exact); // the flow is constant in each triangle
  EXPECT_GE(found.upper_continuous, exact * (1. - round_off));
}

TEST(Multilevel_transport_solver, avoids_obstacles)
{
  const std::size_t n = 16;
  const Triangulation shape = square(n);
  const Array_surface surface(shape);
  std::vector<Metric_tensor> metric(surface.t().number_of_triangles(), {1., 0., 1.});
  for(Index f = 0; f < metric.size(); ++f)
  {
    double x = 0., y = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      x += shape.points[shape.corners[3 * f + k]][0] / 3.;
      y += shape.points[shape.corners[3 * f + k]][1] / 3.;
    }
    if(x > 0.5 && x < 0.5 + 1. / double(n) && y < 0.75)
      metric[surface.triangle(f)] = {infinity, 0., infinity};
  }
  const Multilevel_transport_solver solver(surface.triangles(), 0, metric);
  const Transport_result found =
      solver.solve(at(surface.at(0)), at(surface.at(Index(n))), with_tolerance(1e-6, true));
  // The shortest path passes both corners of the end of the wall.
  const double exact =
      std::hypot(0.5, 0.75) + 1. / double(n) + std::hypot(0.5 - 1. / double(n), 0.75);
  EXPECT_NEAR(found.value, exact, 1e-5 * exact);
  EXPECT_GE(found.upper_continuous, exact);
  EXPECT_LE(found.upper_continuous, 1.3 * exact);

  // A density has no mass in obstacles: here, in 1/16 of the cells in 3/4 of the rows.
  Mass_distribution uniform;
  uniform.density = Vector::Ones(surface.size());
  const Mass_distribution point_mass = at(surface.at(0), 1. - 0.75 / double(n));
  const Transport_result spread = Multilevel_transport_solver(surface.triangles(), 1, metric)
                                      .solve(uniform, point_mass, with_tolerance(1e-4, true));
  EXPECT_TRUE(spread.is_converged);
  EXPECT_GT(spread.upper_continuous, spread.upper);
}

// The third triangle is degenerate: its corners are collinear, on an edge of the first one.
TEST(Multilevel_transport_solver, lower_bound_holds_across_degenerate_triangles)
{
  Triangulation shape;
  shape.points = {{0., 0., 0.}, {1., 0., 0.}, {0.5, 1., 0.}, {0.5, 0., 0.}, {0.5, -1., 0.}};
  shape.corners = {0, 1, 2, 0, 3, 1, 0, 4, 3, 4, 1, 3};
  const Array_surface surface(shape);
  for(const unsigned refinements : {0u, 2u})
  {
    const Multilevel_transport_solver solver(surface.triangles(), refinements);
    const Transport_result found =
        solver.solve(at(surface.at(2)), at(surface.at(3)), with_tolerance(1e-4, true));
    EXPECT_TRUE(found.is_converged);
    EXPECT_LE(found.lower, 1. + 1e-6);  // ten times the height of the thickened degenerate triangle
    EXPECT_NEAR(found.value, 1., 1e-4); // the gap
    EXPECT_GE(found.upper_continuous, 1.);
  }
}

// Proposition 3 of Solomon and others 2014 holds for the exact minimum, so that only bounds are
// compared.
TEST(Multilevel_transport_solver, satisfies_triangle_inequality)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const Multilevel_transport_solver solver(surface.triangles());
  constexpr std::size_t n = 9;
  std::array<std::array<Transport_result, n>, n> cost;
  for(Index i = 0; i < n; ++i)
    for(Index j = 0; j < n; ++j)
    {
      cost[i][j] = solver.solve(at(surface.at(70 * i)), at(surface.at(70 * j)));
      if(j < i)
      {
        EXPECT_EQ(cost[i][j].value, cost[j][i].value);
      }
    }
  for(std::size_t i = 0; i < n; ++i)
  {
    EXPECT_EQ(cost[i][i].value, 0.);
    for(std::size_t j = 0; j < n; ++j)
      for(std::size_t k = 0; k < n; ++k)
        EXPECT_LE(cost[i][k].lower, cost[i][j].upper + cost[j][k].upper);
  }
}

// Proposition 2 of Solomon and others 2014: if a uniform mass on a ball moves to another point,
// the distance converges as the radius of the ball decreases.
TEST(Multilevel_transport_solver, ball_converges_to_point)
{
  const Array_surface surface(square(24, 0.24));
  const Index from = 5 * 25 + 5, to = 18 * 25 + 16;
  const double exact = test::distance(surface.point(from), surface.point(to));
  for(const double radius : {0.25, 0.12, 0.06})
  {
    Mass_distribution ball;
    std::vector<Index> inside;
    for(Index i = 0; i < surface.size(); ++i)
      if(test::distance(surface.point(i), surface.point(to)) <= radius)
        inside.push_back(i);
    for(const Index i : inside)
      ball.at_locations.emplace_back(surface.at(i), 1. / double(inside.size()));
    const Transport_result found =
        Multilevel_transport_solver(surface.triangles()).solve(at(surface.at(from)), ball);
    EXPECT_LE(std::abs(found.value - exact), radius);
  }
}

TEST(Multilevel_transport_solver, methods_agree)
{
  const Array_surface surface(jittered(icosphere(2), 0.03));
  const Multilevel_transport_solver solver(surface.triangles());
  const Mass_distribution from = at(surface.at(0)), to = at(surface.at(50));
  const double value = solver.solve(from, to, with_tolerance(1e-5)).value;
  Transport_options options = with_tolerance(0.01);
  options.method = Transport_method::admm;
  const Transport_result cold_start = solver.solve(from, to, options);
  EXPECT_TRUE(cold_start.is_converged);
  // `value` has a gap of 1e-5.
  EXPECT_LE(cold_start.lower, value * (1. + 1e-5));
  EXPECT_GE(cold_start.upper, value * (1. - 1e-5));
  // From the final state, with the same masses.
  options.warm_start = cold_start.state;
  const Transport_result warm_started = solver.solve(from, to, options);
  EXPECT_TRUE(warm_started.is_converged);
  EXPECT_LE(warm_started.number_of_iterations, 20u);
  EXPECT_LT(warm_started.number_of_iterations, cold_start.number_of_iterations);

  options = with_tolerance(0.02);
  options.method = Transport_method::weiszfeld;
  const Transport_result reweighted = solver.solve(from, to, options);
  // `value` has a gap of 1e-5.
  EXPECT_LE(reweighted.lower, value * (1. + 1e-5));
  EXPECT_GE(reweighted.upper, value * (1. - 1e-5));
  EXPECT_TRUE(reweighted.is_converged);
}

// Returns the exact distance of each point to the nearest point of a region.
std::vector<double> distances_to(const Array_surface& surface, const std::vector<Index>& region)
{
  std::vector<internal::Front_source> sources;
  for(const Index i : region)
    sources.push_back(surface.source(i));
  Window_propagation windows(surface.triangles());
  windows.run(sources);
  std::vector<double> result;
  for(Index i = 0; i < surface.size(); ++i)
    result.push_back(surface.scale() * windows.distance(surface.vertex(i)));
  return result;
}

std::vector<Index> internal_vertices(const Array_surface& surface, const std::vector<Index>& points)
{
  std::vector<Index> result;
  for(const Index i : points)
    result.push_back(surface.vertex(i));
  return result;
}

// Returns a square of 24 by 24 cells without the cells of two walls, each with an opening at one
// end.
Triangulation square_with_walls()
{
  Triangulation result = square(24);
  std::vector<Index> open;
  for(std::size_t f = 0; f < result.corners.size(); f += 3)
  {
    const Point &p = result.points[result.corners[f]], &q = result.points[result.corners[f + 1]],
                &r = result.points[result.corners[f + 2]];
    const double x = (p[0] + q[0] + r[0]) / 3., y = (p[1] + q[1] + r[1]) / 3.;
    if(!(x > 1. / 3. && x < 3. / 8. && y < 0.75) && !(x > 2. / 3. && x < 17. / 24. && y > 0.25))
      open.insert(open.end(), &result.corners[f], &result.corners[f] + 3);
  }
  result.corners = std::move(open);
  return result;
}

TEST(Multilevel_transport_solver, finds_nearest_exit)
{
  const Array_surface surface(square_with_walls());
  const std::vector<Index> exits = {24, 3 * 25 + 24, 24 * 25, 24 * 25 + 24};
  const std::vector<double> distance = distances_to(surface, exits);
  for(const unsigned refinements : {0u, 1u})
  {
    const Multilevel_transport_solver solver(surface.triangles(), refinements, {},
                                             internal_vertices(surface, exits));
    for(const Index from : {0u, 12u * 25u + 12u, 25u * 25u - 3u, 5u * 25u + 7u})
    {
      const double exact = distance[from];
      const Transport_result found =
          solver.solve_to_region(at(surface.at(from), 2.), with_tolerance(1e-6));
      EXPECT_TRUE(found.is_converged);
      EXPECT_NEAR(found.value, 2. * exact, 1e-5);  // in the plane the only error is the gap
      EXPECT_NEAR(found.arrivals.sum(), 2., 1e-8); // round-off errors of many steps
      EXPECT_NEAR(-2. * found.potential[surface.vertex(from)], found.lower, round_off);
      for(const Index exit : exits)
      {
        EXPECT_EQ(found.potential[surface.vertex(exit)], 0.);
        // All mass takes the shortest path. Within the gap, a small fraction can take another
        // exit.
        const bool is_nearest =
            exact_distance(surface, surface.at(from), surface.at(exit)) < exact + round_off;
        // The gap of 1e-6 of the cost, which the next exit exceeds by some percent.
        EXPECT_NEAR(found.arrivals[surface.vertex(exit)], is_nearest ? 2. : 0., 1e-3);
      }
    }
  }
}

// For a uniform source density, the potential is a lower bound of the distance everywhere, and
// close to it.
TEST(Multilevel_transport_solver, potential_bounds_distance_to_region)
{
  for(const Triangulation& shape : {jittered(icosphere(3), 0.02), square(16, 0.24)})
  {
    const Array_surface surface(shape);
    const std::vector<Index> region = {3, 8, 90};
    Mass_distribution uniform;
    uniform.density = Vector::Ones(surface.size());
    const std::vector<double> exact = distances_to(surface, region);
    double previous_error = 1.;
    for(const unsigned refinements : {0u, 1u})
    {
      const Multilevel_transport_solver solver(surface.triangles(), refinements, {},
                                               internal_vertices(surface, region));
      const Transport_result found = solver.solve_to_region(uniform, with_tolerance(1e-4));
      double lower_error = 0.;
      for(Index i = 0; i < surface.size(); ++i)
      {
        const double distance = -found.potential[surface.vertex(i)];
        EXPECT_LE(distance, exact[i] * (1. + round_off));
        lower_error += (exact[i] - distance) / double(surface.size());
      }
      EXPECT_LT(lower_error, 0.7 * previous_error); // the error is O(edge length)
      previous_error = lower_error;
    }
    EXPECT_LT(previous_error, 0.03); // 1/5 of an edge length on the sphere, 1/2 on the square
  }
}

// The region is one boundary edge of a square, given by its vertices. Mass moves perpendicular
// to it.
TEST(Multilevel_transport_solver, mass_arrives_along_region)
{
  const Array_surface surface(square(8));
  std::vector<Index> right_side;
  for(Index row = 0; row < 9; ++row)
    right_side.push_back(9 * row + 8);
  for(const unsigned refinements : {0u, 1u})
  {
    const Multilevel_transport_solver solver(surface.triangles(), refinements, {},
                                             internal_vertices(surface, right_side));
    Mass_distribution uniform;
    uniform.density = Vector::Ones(surface.size());
    const Transport_result found = solver.solve_to_region(uniform, with_tolerance(1e-6));
    EXPECT_NEAR(found.value, 0.5, 0.5e-6); // the gap
    for(Index row = 0; row < 9; ++row)
      EXPECT_NEAR(found.arrivals[surface.vertex(9 * row + 8)], row % 8 == 0 ? 1. / 16. : 1. / 8.,
                  1e-3); // the error that the gap allows
    // Mass inside the region does not move. Normalization scales the total mass of 0.5 to one.
    Mass_distribution some = at(surface.at(0), 0.25);
    some.at_locations.emplace_back(surface.at(8), 0.25);
    Transport_options options = with_tolerance(1e-6);
    options.do_normalize = true;
    const Transport_result at_exit = solver.solve_to_region(some, options);
    EXPECT_NEAR(at_exit.value, 0.5, 1e-6);                      // the gap
    EXPECT_NEAR(at_exit.arrivals[surface.vertex(8)], 1., 5e-3); // an offset x costs only O(x^2)
  }
}

// If the mass exceeds the capacity of the nearest exit, the rest moves to the next one.
TEST(Multilevel_transport_solver, respects_capacities)
{
  const Array_surface surface(square_with_walls());
  const std::vector<std::vector<Index>> exits = {{24, 49}, {24 * 25, 24 * 25 + 1}, {24 * 25 + 24}};
  std::vector<std::vector<double>> distance;
  Transport_region region;
  for(const std::vector<Index>& door : exits)
  {
    distance.push_back(distances_to(surface, door));
    region.exits.push_back(internal_vertices(surface, door));
  }
  for(const unsigned refinements : {0u, 1u})
    for(const Index from : {0u, 12u * 25u + 12u, 5u * 25u + 7u})
    {
      std::vector<std::size_t> order = {0, 1, 2};
      std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b)
                { return distance[a][from] < distance[b][from]; });
      region.capacity = {infinity, infinity, infinity};
      region.capacity[order[0]] = 1.2;
      region.capacity[order[1]] = 0.5;
      double exact = 0.3 * distance[order[2]][from];
      for(std::size_t i = 0; i < 2; ++i)
        exact += region.capacity[order[i]] * distance[order[i]][from];
      const Multilevel_transport_solver solver(surface.triangles(), refinements, {}, region);
      const Transport_result found =
          solver.solve_to_region(at(surface.at(from), 2.), with_tolerance(1e-6));
      EXPECT_TRUE(found.is_converged);
      EXPECT_LE(found.lower, exact * (1. + round_off));
      // Around a vertex from which flows leave in several directions, a fraction of an edge
      // length is lost.
      EXPECT_NEAR(found.value, exact, 2. * 0.2 / 24.);
      EXPECT_NEAR(found.arrivals.sum(), 2., 1e-8); // round-off errors of many steps
      for(std::size_t i = 0; i < 3; ++i)
      {
        double arrived_mass = 0.;
        for(const Index vertex : region.exits[order[i]])
          arrived_mass += found.arrivals[vertex];
        EXPECT_LE(arrived_mass, region.capacity[order[i]] * (1. + round_off));
        EXPECT_NEAR(arrived_mass,
                    i == 0   ? 1.2
                    : i == 1 ? 0.5
                             : 0.3,
                    1e-3); // as for exits without limits
      }
    }
}

// If distances are negligible, a uniform density of arrivals has the minimum cost.
TEST(Multilevel_transport_solver, spreading_weight_spreads_arrivals)
{
  for(const double scale : {1., 1e-3, 1e3})
  {
    const Array_surface surface(scaled(square(8), scale));
    Transport_region region;
    for(Index i = 0; i < surface.size(); ++i)
      region.exits.push_back({surface.vertex(i)});
    const double area = scale * scale, weight = 1e3 * scale * area; // moving is much cheaper
    region.spreading_weight = weight;
    const Multilevel_transport_solver solver(surface.triangles(), 0, {}, region);
    const Transport_result found =
        solver.solve_to_region(at(surface.at(40), 3.), with_tolerance(1e-7));
    // Moving a mass of 3 by at most 2 * scale costs at most 6 * scale.
    EXPECT_NEAR(found.value, weight * 9. / area, 6. * scale);
    // The error that the gap of 1e-7 allows.
    const double error = 1e-5;
    EXPECT_NEAR(found.arrivals[surface.vertex(30)], 3. / 64., error);
    EXPECT_NEAR(found.arrivals[surface.vertex(4)], 3. / 128., error);
  }
}

TEST(Multilevel_transport_solver, throws_on_invalid_limits)
{
  const Array_surface surface(square(4));
  const auto make =
      [&](std::vector<std::vector<Index>> exits, std::vector<double> capacity, double weight = 0.)
  {
    Transport_region region;
    region.exits = std::move(exits);
    region.capacity = std::move(capacity);
    region.spreading_weight = weight;
    return Multilevel_transport_solver(surface.triangles(), 0, {}, region);
  };
  EXPECT_THROW(make({{1, 2}, {2, 3}}, {1., 1.}), Invalid_argument_error);
  EXPECT_NO_THROW(make({{1, 2}, {2, 3}}, {})); // exits are merged if there are no limits
  EXPECT_THROW(make({{1}, {3}}, {1.}), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {1., 0.}), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {1., std::nan("")}), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {}, -1.), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {}, infinity), Invalid_argument_error);
  const Multilevel_transport_solver limited =
      make({{surface.vertex(1)}, {surface.vertex(3)}}, {1., 0.5});
  EXPECT_THROW(limited.solve_to_region(at(surface.at(0), 1.6)), Invalid_argument_error);
  EXPECT_NEAR(limited.solve_to_region(at(surface.at(0), 1.5)).arrivals[surface.vertex(3)], 0.5,
              round_off);
  Transport_options admm;
  admm.method = Transport_method::admm;
  EXPECT_THROW(limited.solve_to_region(at(surface.at(0)), admm), Invalid_argument_error);
}

TEST(Multilevel_transport_solver, regions_serve_their_component)
{
  const Array_surface surface(disjoint_union(square(4), square(4)));
  const Mass_distribution left = at(surface.at(0)), right = at(surface.at(25));
  const Multilevel_transport_solver to_left(surface.triangles(), 0, {},
                                            internal_vertices(surface, {4})),
      to_both(surface.triangles(), 0, {}, internal_vertices(surface, {4, 29}));
  EXPECT_NEAR(to_left.solve_to_region(left, with_tolerance(1e-6)).value, 1., 1e-6); // the gap
  EXPECT_THROW(to_left.solve_to_region(right), Invalid_argument_error);
  Mass_distribution all = left;
  all.at_locations.emplace_back(surface.at(25), 3.);
  const Transport_result found = to_both.solve_to_region(all, with_tolerance(1e-6));
  EXPECT_NEAR(found.value, 4., 4e-6); // the gap
  EXPECT_NEAR(found.arrivals[surface.vertex(4)], 1., round_off);
  EXPECT_NEAR(found.arrivals[surface.vertex(29)], 3., round_off);
}

TEST(Multilevel_transport_solver, throws_on_invalid_masses)
{
  const Array_surface surface(square(4));
  const Multilevel_transport_solver solver(surface.triangles());
  Mass_distribution empty, invalid = at(surface.at(3), std::nan("")),
                           zero_mass = at(surface.at(3), 0.);
  const Mass_distribution one = at(surface.at(0)), two = at(surface.at(5), 2.);
  EXPECT_THROW(solver.solve(one, two), Invalid_argument_error);
  EXPECT_THROW(solver.solve(one, invalid), Invalid_argument_error);
  EXPECT_THROW(solver.solve(one, empty), Invalid_argument_error);
  EXPECT_EQ(solver.solve(empty, zero_mass).value, 0.);
  Transport_options options;
  options.do_normalize = true;
  EXPECT_NO_THROW(solver.solve(one, two, options));
  EXPECT_THROW(solver.solve(one, zero_mass, options), Invalid_argument_error);
  EXPECT_THROW(solver.solve(at(surface.at(0), -1.), one, options), Invalid_argument_error);
  EXPECT_THROW(Multilevel_transport_solver(surface.triangles(), 20), Unsupported_surface_error);
}

} // namespace Multilevel_transport_solver_test
