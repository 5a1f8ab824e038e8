// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/Earth_movers.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Of the sums of some hundred numbers.
constexpr double rounding = 1e-9;

Earth_movers_options within(double tolerance, bool do_bound_from_above = false)
{
  Earth_movers_options result;
  result.transport.tolerance = tolerance;
  result.do_bound_from_above = do_bound_from_above;
  return result;
}

Mass_distribution at(const Location& location, double mass = 1.)
{
  Mass_distribution result;
  result.at_locations = {{location, mass}};
  return result;
}

double exact_distance(const Glued_surface& surface, const Location& from, const Location& to)
{
  Window_propagation windows(surface.triangles());
  windows.run({surface.source(from)});
  return surface.scale() * windows.distance(to);
}

TEST(Earth_movers, encloses_distances_between_locations)
{
  for(const Triangulation& shape : {shaken(icosphere(2), 0.03), cylinder(16, 6, 1., 1.5)})
  {
    const Glued_surface surface(shape);
    const Earth_movers kernel(surface.triangles());
    const Location from = surface.in(3, {0.2, 0.5, 0.3});
    for(const Location& to : {surface.in(40, {0.1, 0.1, 0.8}), surface.in(90, {1., 0., 0.}),
                              surface.on(77, 1, 0.4), surface.at(20)})
    {
      const double exact = exact_distance(surface, from, to);
      const Earth_movers_result found = kernel.solve(at(from), at(to), within(1e-4, true));
      EXPECT_LE(found.lower, exact * (1. + rounding));
      EXPECT_GE(found.upper_continuous, exact);
      EXPECT_GT(found.value, 0.85 * exact); // a surface of ten sides loses so much around points
      EXPECT_EQ(found.estimate, found.value);
    }
    // Nobody asked.
    EXPECT_EQ(kernel.solve(at(from), at(surface.at(20))).upper_continuous, infinity);
  }
}

TEST(Earth_movers, finds_more_on_refined_surfaces)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Location from = surface.in(3, {0.2, 0.5, 0.3}), to = surface.in(250, {0.1, 0.1, 0.8});
  const double exact = exact_distance(surface, from, to);
  double loss = infinity, excess = infinity;
  for(const unsigned refinements : {0u, 1u, 2u, 3u})
  {
    const Earth_movers kernel(surface.triangles(), refinements);
    const Earth_movers_result found = kernel.solve(at(from), at(to), within(1e-5, true));
    EXPECT_LE(found.lower, exact * (1. + rounding));
    EXPECT_LT(exact - found.lower, loss);
    EXPECT_LT(found.upper_continuous - exact, excess);
    loss = exact - found.lower;
    excess = found.upper_continuous - exact;

    // Means of flows move the same masses; the potential is that of some of the fine sites.
    const Operators o = operators(surface.t());
    Vector masses = Vector::Zero(surface.size());
    for(std::size_t k = 0; k < 3; ++k)
    {
      masses[surface.t().corner[3 * from.triangle + k]] -= from.barycentric[k];
      masses[surface.t().corner[3 * to.triangle + k]] += to.barycentric[k];
    }
    const Vector error = surface.scale() * divergence(o, found.flow) - masses;
    EXPECT_LT(error.lpNorm<Eigen::Infinity>(), rounding);
    for(Index side = 0; side < surface.t().corner.size(); ++side)
      EXPECT_LE(found.potential[surface.t().corner[next_side(side)]] -
                    found.potential[surface.t().corner[side]],
                surface.scale() * surface.t().length[side] * (1. + rounding));
  }
}

// What is lost at sites is halved by each refinement; within triangles it depends on where.
TEST(Earth_movers, extrapolates_between_sites)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Earth_movers kernel(surface.triangles(), 1);
  for(const Index to : {20u, 70u, 120u})
  {
    const double exact = exact_distance(surface, surface.at(0), surface.at(to));
    const Earth_movers_result found =
        kernel.solve(at(surface.at(0)), at(surface.at(to)), within(1e-5));
    EXPECT_LT(std::abs(found.estimate - exact), 0.5 * (exact - found.value) + 1e-5 * exact);
  }
}

// Linear densities on a square, which move to the right: along each line the integral of the difference
// of what lies on the left of x before and after, which is 2 x - 2 x^2.
TEST(Earth_movers, moves_densities)
{
  const Glued_surface surface(square(16, 0.24));
  Mass_distribution from, to;
  from.density.resize(surface.size());
  to.density.resize(surface.size());
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double x = surface.point(i)[0];
    from.density[surface.site(i)] = 2. * (1. - x);
    to.density[surface.site(i)] = 2. * x;
  }
  for(const unsigned refinements : {0u, 1u})
  {
    const Earth_movers_result found =
        Earth_movers(surface.triangles(), refinements).solve(from, to, within(1e-5, true));
    EXPECT_LE(found.lower, 1. / 3. * (1. + rounding));
    EXPECT_GE(found.upper_continuous, 1. / 3.);
    EXPECT_NEAR(found.value, 1. / 3.,
                2e-4); // the gap, and the square of a side, 1/16, by a twentieth
    EXPECT_LT(found.upper_continuous, 0.5);
  }
  // Any unit of mass, when it is normalized.
  to.density *= 7.;
  Earth_movers_options options = within(1e-5);
  options.do_normalize = true;
  EXPECT_NEAR(Earth_movers(surface.triangles()).solve(from, to, options).value, 1. / 3., 2e-4);
}

TEST(Earth_movers, adds_masses_of_all_kinds)
{
  const Glued_surface surface(square(8, 0.24));
  Mass_distribution all;
  all.at_sites = Vector::Zero(surface.size());
  all.at_sites[surface.site(4)] = 0.25;
  all.at_locations = {{surface.in(9, {0.5, 0.25, 0.25}), 0.25}};
  all.density = Vector::Constant(surface.size(), 0.5);
  // To a corner of the unit square: the mean distance of a uniform density is (sqrt(2) + asinh(1)) / 3.
  const auto way = [&](const Point& p) { return test::distance(p, surface.point(80)); };
  Point inner = {0., 0., 0.};
  const auto& corners = square(8, 0.24).corners;
  for(std::size_t c = 0; c < 3; ++c)
    inner[c] = 0.5 * surface.point(corners[27])[c] + 0.25 * surface.point(corners[28])[c] +
               0.25 * surface.point(corners[29])[c];
  const double exact = 0.25 * way(surface.point(4)) + 0.25 * way(inner) +
                       0.5 * (std::sqrt(2.) + std::asinh(1.)) / 3.;
  // Towards a point to which masses come from everywhere a side's part is lost at each distance of one,
  // two, four and so on sides.
  for(const unsigned refinements : {0u, 2u})
  {
    const Earth_movers_result found =
        Earth_movers(surface.triangles(), refinements).solve(all, at(surface.at(80)), within(1e-4));
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.lower, exact);
    const double side = 0.125 / double(1 << refinements);
    EXPECT_GE(found.value, exact - 0.12 * side * std::log2(1. / side));
  }
}

TEST(Earth_movers, measures_lengths_as_told)
{
  const Glued_surface surface(square(12, 0.24));
  const Location from = surface.at(0), to = surface.at(168);
  const std::size_t n = surface.t().number_of_triangles();
  const auto value = [&](std::vector<Tensor> measure)
  {
    return Earth_movers(surface.triangles(), 0, std::move(measure))
        .solve(at(from), at(to), within(1e-6))
        .value;
  };
  EXPECT_NEAR(value({}), std::sqrt(2.), 1e-5);
  EXPECT_NEAR(value(std::vector<Tensor>(n, {3., 0., 3.})), 3. * std::sqrt(2.), 3e-5);
  // Twice as long along x: the diagonal of a rectangle.  The planes of the triangles are turned.
  std::vector<Tensor> measure;
  for(std::size_t f = 0; f < n; ++f)
  {
    const Spatial side = unit(surface.t().point[surface.t().corner[3 * f + 1]] -
                              surface.t().point[surface.t().corner[3 * f]]);
    const double c = side[0], s = side[1];
    measure.push_back({1. + c * c, -c * s, 1. + s * s});
  }
  EXPECT_NEAR(value(measure), std::sqrt(5.), 1e-4);
  const Earth_movers_result bounded =
      Earth_movers(surface.triangles(), 1, measure).solve(at(from), at(to), within(1e-6, true));
  EXPECT_NEAR(bounded.value, std::sqrt(5.), 1e-4);
  EXPECT_GE(bounded.upper_continuous, std::sqrt(5.));
  EXPECT_LE(bounded.upper_continuous, 1.5 * std::sqrt(5.));
}

// A ray is bent where it becomes three times as slow: the sines of its angles are as the speeds.
TEST(Earth_movers, obeys_the_law_of_refraction)
{
  const std::size_t columns = 24;
  const Glued_surface surface(square(columns));
  std::vector<Tensor> measure;
  for(std::size_t f = 0; f < surface.t().number_of_triangles(); ++f)
  {
    double y = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      y += surface.t().point[surface.t().corner[3 * f + k]][1];
    const double slowness = y * surface.scale() / 3. + surface.t().origin[1] > 0.5 ? 3. : 1.;
    measure.push_back({slowness, 0., slowness});
  }
  // From a corner to the opposite one, through (x, 0.5).
  double exact = infinity;
  for(double x = 0.; x < 1.; x += 1e-5)
    exact = std::min(exact, std::hypot(x, 0.5) + 3. * std::hypot(1. - x, 0.5));
  const Earth_movers kernel(surface.triangles(), 0, measure);
  const Earth_movers_result found =
      kernel.solve(at(surface.at(0)), at(surface.at(surface.size() - 1)), within(1e-5, true));
  EXPECT_LE(found.lower, exact * (1. + 1e-9));   // the steps' square, and rounding
  EXPECT_NEAR(found.value, exact, 4e-3 * exact); // in one triangle the ray has one direction
  EXPECT_GE(found.upper_continuous, exact * (1. - 1e-9));
}

TEST(Earth_movers, goes_around_obstacles)
{
  const std::size_t n = 16;
  const Triangulation shape = square(n);
  const Glued_surface surface(shape);
  std::vector<Tensor> measure(surface.t().number_of_triangles(), {1., 0., 1.});
  for(Index f = 0; f < measure.size(); ++f)
  {
    double x = 0., y = 0.;
    for(std::size_t k = 0; k < 3; ++k)
    {
      x += shape.points[shape.corners[3 * f + k]][0] / 3.;
      y += shape.points[shape.corners[3 * f + k]][1] / 3.;
    }
    if(x > 0.5 && x < 0.5 + 1. / double(n) && y < 0.75)
      measure[surface.triangle(f)] = {infinity, 0., infinity};
  }
  const Earth_movers kernel(surface.triangles(), 0, measure);
  const Earth_movers_result found =
      kernel.solve(at(surface.at(0)), at(surface.at(Index(n))), within(1e-6, true));
  // Over both corners of the wall's end.
  const double exact =
      std::hypot(0.5, 0.75) + 1. / double(n) + std::hypot(0.5 - 1. / double(n), 0.75);
  EXPECT_NEAR(found.value, exact, 1e-5 * exact);
  EXPECT_GE(found.upper_continuous, exact);
  EXPECT_LE(found.upper_continuous, 1.3 * exact);

  // A density has mass where something can move, which is all but one in sixteen cells in three of four
  // rows; the sites in the wall have none.
  Mass_distribution even;
  even.density = Vector::Ones(surface.size());
  const Mass_distribution rest = at(surface.at(0), 1. - 0.75 / double(n));
  const Earth_movers_result spread =
      Earth_movers(surface.triangles(), 1, measure).solve(even, rest, within(1e-4, true));
  EXPECT_TRUE(spread.converged);
  EXPECT_GT(spread.upper_continuous, spread.upper);
}

// Two triangles below a third one that is flat: its corners lie on the side of the one above.
TEST(Earth_movers, proves_nothing_through_cracks)
{
  Triangulation shape;
  shape.points = {{0., 0., 0.}, {1., 0., 0.}, {0.5, 1., 0.}, {0.5, 0., 0.}, {0.5, -1., 0.}};
  shape.corners = {0, 1, 2, 0, 3, 1, 0, 4, 3, 4, 1, 3};
  const Glued_surface surface(shape);
  for(const unsigned refinements : {0u, 2u})
  {
    const Earth_movers kernel(surface.triangles(), refinements);
    const Earth_movers_result found =
        kernel.solve(at(surface.at(2)), at(surface.at(3)), within(1e-4, true));
    EXPECT_TRUE(found.converged);
    EXPECT_LE(found.lower, 1. + 1e-6); // ten times the height of the flat one
    EXPECT_NEAR(found.value, 1., 1e-4);
    EXPECT_GE(found.upper_continuous, 1.);
  }
}

// Proposition 3 of Solomon and others 2014: for the least costs, so that bounds may be compared.
TEST(Earth_movers, obeys_the_triangle_inequality)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  const Earth_movers kernel(surface.triangles());
  constexpr std::size_t n = 9;
  std::array<std::array<Earth_movers_result, n>, n> cost;
  for(Index i = 0; i < n; ++i)
    for(Index j = 0; j < n; ++j)
    {
      cost[i][j] = kernel.solve(at(surface.at(70 * i)), at(surface.at(70 * j)));
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

// Proposition 2 there: spread evenly over less and less around a place, a mass comes to be at the place.
TEST(Earth_movers, comes_from_points_to_the_limit)
{
  const Glued_surface surface(square(24, 0.24));
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
    const Earth_movers_result found =
        Earth_movers(surface.triangles()).solve(at(surface.at(from)), ball);
    EXPECT_LE(std::abs(found.value - exact), radius);
  }
}

TEST(Earth_movers, methods_agree)
{
  const Glued_surface surface(shaken(icosphere(2), 0.03));
  const Earth_movers kernel(surface.triangles());
  const Mass_distribution from = at(surface.at(0)), to = at(surface.at(50));
  const double value = kernel.solve(from, to, within(1e-5)).value;
  Earth_movers_options options = within(0.01);
  options.transport.method = Transport_method::splitting;
  const Earth_movers_result split = kernel.solve(from, to, options);
  EXPECT_TRUE(split.converged);
  EXPECT_LE(split.lower, value * (1. + 1e-5));
  EXPECT_GE(split.upper, value * (1. - 1e-5));
  // From where it ended, to much the same masses.
  options.transport.start = split.state;
  const Earth_movers_result again = kernel.solve(from, to, options);
  EXPECT_TRUE(again.converged);
  EXPECT_LE(again.iterations, 20u);
  EXPECT_LT(again.iterations, split.iterations);

  options = within(0.02);
  options.transport.method = Transport_method::weiszfeld;
  const Earth_movers_result reweighted = kernel.solve(from, to, options);
  EXPECT_LE(reweighted.lower, value * (1. + 1e-5));
  EXPECT_GE(reweighted.upper, value * (1. - 1e-5));
  EXPECT_TRUE(reweighted.converged);
}

// Of each point, to the nearest of some.
std::vector<double> distances_to(const Glued_surface& surface, const std::vector<Index>& region)
{
  std::vector<internal::Source> sources;
  for(const Index i : region)
    sources.push_back(surface.source(i));
  Window_propagation windows(surface.triangles());
  windows.run(sources);
  std::vector<double> result;
  for(Index i = 0; i < surface.size(); ++i)
    result.push_back(surface.scale() * windows.distance(surface.site(i)));
  return result;
}

std::vector<Index> sites(const Glued_surface& surface, const std::vector<Index>& points)
{
  std::vector<Index> result;
  for(const Index i : points)
    result.push_back(surface.site(i));
  return result;
}

// A square of 24 by 24 cells without those of two walls, which leave open what is beside them.
Triangulation maze()
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

TEST(Earth_movers, find_the_nearest_exit)
{
  const Glued_surface surface(maze());
  const std::vector<Index> exits = {24, 3 * 25 + 24, 24 * 25, 24 * 25 + 24};
  const std::vector<double> distance = distances_to(surface, exits);
  for(const unsigned refinements : {0u, 1u})
  {
    const Earth_movers kernel(surface.triangles(), refinements, {}, sites(surface, exits));
    for(const Index from : {0u, 12u * 25u + 12u, 25u * 25u - 3u, 5u * 25u + 7u})
    {
      const double exact = distance[from];
      const Earth_movers_result found =
          kernel.solve_to_region(at(surface.at(from), 2.), within(1e-6));
      EXPECT_TRUE(found.converged);
      EXPECT_NEAR(found.value, 2. * exact, 1e-5);  // in the plane nothing is lost but the gap
      EXPECT_NEAR(found.arrivals.sum(), 2., 1e-8); // a hundred masses' rounding in each step
      EXPECT_NEAR(-2. * found.potential[surface.site(from)], found.lower, rounding);
      for(const Index exit : exits)
      {
        EXPECT_EQ(found.potential[surface.site(exit)], 0.);
        // All go the one shortest way; what strays costs at least a side of a 24th more in a hundred.
        const bool is_nearest =
            exact_distance(surface, surface.at(from), surface.at(exit)) < exact + rounding;
        EXPECT_NEAR(found.arrivals[surface.site(exit)], is_nearest ? 2. : 0., 1e-3);
      }
    }
  }
}

// From everywhere at once: what each place pays is nowhere above its distance, and not far below.
TEST(Earth_movers, measure_distances_to_regions)
{
  for(const Triangulation& shape : {shaken(icosphere(3), 0.02), square(16, 0.24)})
  {
    const Glued_surface surface(shape);
    const std::vector<Index> region = {3, 8, 90};
    Mass_distribution even;
    even.density = Vector::Ones(surface.size());
    const std::vector<double> exact = distances_to(surface, region);
    double before = 1.;
    for(const unsigned refinements : {0u, 1u})
    {
      const Earth_movers kernel(surface.triangles(), refinements, {}, sites(surface, region));
      const Earth_movers_result found = kernel.solve_to_region(even, within(1e-4));
      double loss = 0.;
      for(Index i = 0; i < surface.size(); ++i)
      {
        const double distance = -found.potential[surface.site(i)];
        EXPECT_LE(distance, exact[i] * (1. + rounding));
        loss += (exact[i] - distance) / double(surface.size());
      }
      EXPECT_LT(loss, 0.7 * before); // of the order of a side
      before = loss;
    }
    EXPECT_LT(before, 0.03); // a fifth of the sphere's sides, half of the square's
  }
}

// To a side of a square, sites and sides between them: straight on.
TEST(Earth_movers, arrive_all_along_a_region)
{
  const Glued_surface surface(square(8));
  std::vector<Index> side;
  for(Index row = 0; row < 9; ++row)
    side.push_back(9 * row + 8);
  for(const unsigned refinements : {0u, 1u})
  {
    const Earth_movers kernel(surface.triangles(), refinements, {}, sites(surface, side));
    Mass_distribution even;
    even.density = Vector::Ones(surface.size());
    const Earth_movers_result found = kernel.solve_to_region(even, within(1e-6));
    EXPECT_NEAR(found.value, 0.5, 1e-6);
    for(Index row = 0; row < 9; ++row)
      EXPECT_NEAR(found.arrivals[surface.site(9 * row + 8)], row % 8 == 0 ? 1. / 16. : 1. / 8.,
                  1e-3); // the gap leaves so much room
    // What is in the region is there already; half of a mass, scaled to one, counts for one.
    Mass_distribution some = at(surface.at(0), 0.25);
    some.at_locations.emplace_back(surface.at(8), 0.25);
    Earth_movers_options options = within(1e-6);
    options.do_normalize = true;
    const Earth_movers_result there = kernel.solve_to_region(some, options);
    EXPECT_NEAR(there.value, 0.5, 1e-6);
    EXPECT_NEAR(there.arrivals[surface.site(8)], 1., 5e-3); // what strays by x costs x * x more
  }
}

// Doors of two sites in a maze, one too small: what does not fit goes on to the next one.
TEST(Earth_movers, fill_exits)
{
  const Glued_surface surface(maze());
  const std::vector<std::vector<Index>> doors = {{24, 49}, {24 * 25, 24 * 25 + 1}, {24 * 25 + 24}};
  std::vector<std::vector<double>> distance;
  Transport_region region;
  for(const std::vector<Index>& door : doors)
  {
    distance.push_back(distances_to(surface, door));
    region.exits.push_back(sites(surface, door));
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
      const Earth_movers kernel(surface.triangles(), refinements, {}, region);
      const Earth_movers_result found =
          kernel.solve_to_region(at(surface.at(from), 2.), within(1e-6));
      EXPECT_TRUE(found.converged);
      EXPECT_LE(found.lower, exact * (1. + rounding));
      // Where masses part in a fan of six triangles a part of a side is lost.
      EXPECT_NEAR(found.value, exact, 2. * 0.2 / 24.);
      EXPECT_NEAR(found.arrivals.sum(), 2., 1e-8); // a hundred masses' rounding in each step
      for(std::size_t i = 0; i < 3; ++i)
      {
        double there = 0.;
        for(const Index site : region.exits[order[i]])
          there += found.arrivals[site];
        EXPECT_LE(there, region.capacity[order[i]] * (1. + rounding));
        EXPECT_NEAR(there,
                    i == 0   ? 1.2
                    : i == 1 ? 0.5
                             : 0.3,
                    1e-3); // as among exits without limits
      }
    }
}

// Without a way to go, what spreads evenly over the region costs the least.
TEST(Earth_movers, spread_over_a_region)
{
  for(const double scale : {1., 1e-3, 1e3})
  {
    const Glued_surface surface(scaled(square(8), scale));
    Transport_region region;
    for(Index i = 0; i < surface.size(); ++i)
      region.exits.push_back({surface.site(i)});
    const double area = scale * scale, weight = 1e3 * scale * area; // far dearer than any way
    region.spreading_weight = weight;
    const Earth_movers kernel(surface.triangles(), 0, {}, region);
    const Earth_movers_result found = kernel.solve_to_region(at(surface.at(40), 3.), within(1e-7));
    // Ways cost a mass of three a part of two times the side.
    EXPECT_NEAR(found.value, weight * 9. / area, 6. * scale);
    EXPECT_NEAR(found.arrivals[surface.site(30)], 3. / 64., 1e-5);
    EXPECT_NEAR(found.arrivals[surface.site(4)], 3. / 128., 1e-5);
  }
}

TEST(Earth_movers, refuses_limits_that_make_no_sense)
{
  const Glued_surface surface(square(4));
  const auto make =
      [&](std::vector<std::vector<Index>> exits, std::vector<double> capacity, double weight = 0.)
  {
    Transport_region region;
    region.exits = std::move(exits);
    region.capacity = std::move(capacity);
    region.spreading_weight = weight;
    return Earth_movers(surface.triangles(), 0, {}, region);
  };
  EXPECT_THROW(make({{1, 2}, {2, 3}}, {1., 1.}), Invalid_argument_error);
  EXPECT_NO_THROW(make({{1, 2}, {2, 3}}, {})); // one anyway
  EXPECT_THROW(make({{1}, {3}}, {1.}), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {1., 0.}), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {1., std::nan("")}), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {}, -1.), Invalid_argument_error);
  EXPECT_THROW(make({{1}, {3}}, {}, infinity), Invalid_argument_error);
  const Earth_movers small = make({{surface.site(1)}, {surface.site(3)}}, {1., 0.5});
  EXPECT_THROW(small.solve_to_region(at(surface.at(0), 1.6)), Invalid_argument_error);
  EXPECT_NEAR(small.solve_to_region(at(surface.at(0), 1.5)).arrivals[surface.site(3)], 0.5, 1e-9);
  Earth_movers_options splitting;
  splitting.transport.method = Transport_method::splitting;
  EXPECT_THROW(small.solve_to_region(at(surface.at(0)), splitting), Invalid_argument_error);
}

TEST(Earth_movers, reach_regions_of_their_component)
{
  const Glued_surface surface(apart(square(4), square(4)));
  const Mass_distribution left = at(surface.at(0)), right = at(surface.at(25));
  const Earth_movers to_left(surface.triangles(), 0, {}, sites(surface, {4})),
      to_both(surface.triangles(), 0, {}, sites(surface, {4, 29}));
  EXPECT_NEAR(to_left.solve_to_region(left, within(1e-6)).value, 1., 1e-5);
  EXPECT_THROW(to_left.solve_to_region(right), Invalid_argument_error);
  Mass_distribution all = left;
  all.at_locations.emplace_back(surface.at(25), 3.);
  const Earth_movers_result found = to_both.solve_to_region(all, within(1e-6));
  EXPECT_NEAR(found.value, 4., 1e-5);
  EXPECT_NEAR(found.arrivals[surface.site(4)], 1., 1e-6);
  EXPECT_NEAR(found.arrivals[surface.site(29)], 3., 1e-6);
}

TEST(Earth_movers, refuses_what_cannot_be_moved)
{
  const Glued_surface surface(square(4));
  const Earth_movers kernel(surface.triangles());
  Mass_distribution nothing, bad = at(surface.at(3), std::nan("")),
                             none_at_all = at(surface.at(3), 0.);
  const Mass_distribution one = at(surface.at(0)), two = at(surface.at(5), 2.);
  EXPECT_THROW(kernel.solve(one, two), Invalid_argument_error);
  EXPECT_THROW(kernel.solve(one, bad), Invalid_argument_error);
  EXPECT_THROW(kernel.solve(one, nothing), Invalid_argument_error);
  EXPECT_EQ(kernel.solve(nothing, none_at_all).value, 0.);
  Earth_movers_options options;
  options.do_normalize = true;
  EXPECT_NO_THROW(kernel.solve(one, two, options));
  EXPECT_THROW(kernel.solve(one, none_at_all, options), Invalid_argument_error);
  EXPECT_THROW(kernel.solve(at(surface.at(0), -1.), one, options), Invalid_argument_error);
  EXPECT_THROW(Earth_movers(surface.triangles(), 20), Unsupported_surface_error);
}

} // namespace
