// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/heat.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <CGAL/Geodesic_processing/internal/operators/operators.h>

#include "Array_surface.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <gtest/gtest.h>

#include <thread>

namespace heat_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::vector<double> heat_distances(const Array_surface& surface,
                                   const std::vector<internal::Front_source>& sources)
{
  Heat_solver solver(surface.triangles());
  EXPECT_TRUE(solver.run(sources));
  return surface.distances(solver);
}

// Round-off errors of back substitutions and of sums of distances near 4.
constexpr double round_off = 1e-12;

TEST(Heat, error_decreases_under_refinement)
{
  double error[3];
  for(const unsigned level : {3u, 4u, 5u})
  {
    const Triangulation sphere = icosphere(level);
    const Array_surface surface(sphere);
    const auto d = heat_distances(surface, {surface.source(100)});
    error[level - 3] = mean_relative_error(
        d, 0.05 * pi, [&](Index i) { return great_circle(sphere.points[100], sphere.points[i]); });
  }
  // The time step is the squared edge length: the error decreases, but without a fixed order.
  EXPECT_LT(error[1], error[0]);
  EXPECT_LT(error[2], error[1]);
  EXPECT_LT(error[2], 0.01); // CGAL's Surface_mesh_geodesic_distances_3: 0.0064
}

TEST(Heat, is_accurate_for_several_sources)
{
  // Each pole is the nearest source of half of the sphere.
  const Triangulation sphere = icosphere(5);
  const Array_surface surface(sphere);
  const std::vector<Index> poles = {0, 3}; // opposite vertices of the icosahedron
  ASSERT_NEAR(distance(sphere.points[0], sphere.points[3]), 2., 1e-15);
  const auto d = heat_distances(surface, {surface.source(0), surface.source(3)});
  EXPECT_LT(mean_relative_error(d, 0.1,
                                [&](Index i)
                                {
                                  return std::min(great_circle(sphere.points[0], sphere.points[i]),
                                                  great_circle(sphere.points[3], sphere.points[i]));
                                }),
            0.03); // the method is smooth at the equator, the distance is not
}

// Solves both systems of Crane et al. with dense matrices. Subtracts the value at the source. The
// surface is a Delaunay triangulation whose widths admit the time step.
std::vector<double> dense_heat_distances(const Array_surface& surface, Index source,
                                         double time_step)
{
  const Surface_arrays& t = surface.t();
  double mean = 0.;
  for(const double length : t.length)
    mean += length / double(t.length.size());
  const Operators o = operators(t);
  Eigen::MatrixXd laplacian =
      Eigen::MatrixXd(Laplacian(o).matrix(o)).selfadjointView<Eigen::Lower>();
  Eigen::MatrixXd heat = time_step * mean * mean * laplacian;
  heat.diagonal() += lumped_mass(o);
  const Vector u = heat.ldlt().solve(Vector::Unit(heat.rows(), source));
  Field direction = gradient(o, u);
  for(Vec2& v : direction)
    v = (-1. / norm(v)) * v;
  laplacian += Eigen::MatrixXd::Ones(laplacian.rows(), laplacian.cols());
  const Vector distance = laplacian.ldlt().solve(minus_divergence(o, direction));
  std::vector<double> result;
  for(Index i = 0; i < surface.size(); ++i)
    result.push_back(surface.scale() *
                     std::max(0., distance[surface.vertex(i)] - distance[source]));
  return result;
}

TEST(Heat, time_step_is_in_squared_mean_edge_lengths)
{
  for(const double scale : {1., 1e-6, 1e6})
  {
    const Array_surface surface(scaled(icosphere(2), scale));
    for(const double time_step : {0.5, 1., 10., 100., 1000.})
    {
      Heat_solver solver(surface.triangles(), time_step);
      ASSERT_TRUE(solver.run({surface.source(7)}));
      const auto expected = dense_heat_distances(surface, surface.vertex(7), time_step);
      EXPECT_LT(largest_error(surface.distances(solver), [&](Index i) { return expected[i]; }),
                1e-9 * scale) // round-off errors of dense matrices of 162 rows
          << time_step;
    }
  }
}

// The longer heat flows, the more its directions depend on the boundary.
TEST(Heat, error_increases_with_time_step)
{
  const Triangulation plane = square(40, 0.24);
  const Array_surface surface(plane);
  double last = 0.;
  for(const double time_step : {1., 10., 100., 1000.})
  {
    Heat_solver solver(surface.triangles(), time_step);
    ASSERT_TRUE(solver.run({surface.source(420)}));
    const std::vector<double> found = surface.distances(solver);
    const double error = mean_relative_error(
        found, 0.1, [&](Index i) { return distance(plane.points[420], plane.points[i]); });
    EXPECT_GT(error, last) << time_step;
    last = error;
    if(time_step == 1.)
    {
      EXPECT_EQ(found, heat_distances(surface, {surface.source(420)}));
    }
  }
}

// The step is bounded such that the gradients of the heat are neither zero nor round-off errors.
TEST(Heat, time_step_is_bounded)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const auto distances = [&](double time_step)
  {
    Heat_solver solver(surface.triangles(), time_step);
    EXPECT_TRUE(solver.run({surface.source(100)}));
    return surface.distances(solver);
  };
  for(const double sign : {1., -1.})
  {
    const std::vector<double> d = distances(std::pow(10., 30. * sign));
    EXPECT_EQ(d, distances(std::pow(10., 300. * sign)));
    // A smooth distance is between zero and the length of the equator.
    for(Index i = 0; i < surface.size(); ++i)
      EXPECT_TRUE(d[i] >= 0. && d[i] < 2. * pi) << d[i];
  }
  // The limit of large steps differs by the square of the largest ratio.
  const std::vector<double> limit = distances(1e30);
  const std::vector<double> large = distances(1e5);
  EXPECT_LT(largest_error(large, [&](Index i) { return limit[i]; }), 0.01 * pi);
}

TEST(Heat, adds_offset_of_source)
{
  const Triangulation plane = square(40, 0.24);
  const Array_surface surface(plane);
  const auto d = heat_distances(surface, {surface.source(0)});
  const auto with_offset = heat_distances(surface, {surface.source(0, 3.)});
  EXPECT_LT(largest_error(with_offset, [&](Index i) { return 3. + d[i]; }), round_off);
  // Two corners, the second one with an offset of 0.25.
  const auto both = heat_distances(surface, {surface.source(0), surface.source(1680, 0.25)});
  EXPECT_LT(mean_relative_error(both, 0.1,
                                [&](Index i)
                                {
                                  return std::min(
                                      distance(plane.points[i], plane.points[0]),
                                      0.25 + distance(plane.points[i], plane.points[1680]));
                                }),
            0.05); // error of the method on a mesh of 40 x 40 cells
}

TEST(Heat, polyline_without_length_is_a_point)
{
  const Array_surface surface(icosphere(2));
  const Surface_location location = {5, none, {0.5, 0.25, 0.25}};
  const auto expected = heat_distances(surface, {Front_source{{location}, 0.5}});
  EXPECT_EQ(heat_distances(surface, {Front_source{{location, location}, 0.5}}), expected);
}

TEST(Heat, is_accurate_in_each_component)
{
  Triangulation surface = disjoint_union(square(20, 0.24), icosphere(3));
  surface.points.push_back({7., 7., 7.}); // isolated
  const Array_surface arrays(surface);
  const auto d = heat_distances(arrays, {arrays.source(0)});
  for(Index i = 0; i < d.size(); ++i)
  {
    EXPECT_EQ(d[i] < infinity, i < 441);
    EXPECT_FALSE(std::isnan(d[i]));
  }
  const Index isolated = Index(surface.points.size() - 1);
  const auto e =
      heat_distances(arrays, {arrays.source(0), arrays.source(441), arrays.source(isolated)});
  EXPECT_EQ(e[isolated], 0.);
  // The sources in other components do not change these distances.
  EXPECT_LT(largest_error(e, [&](Index i) { return i < 441 ? d[i] : e[i]; }), round_off);
  EXPECT_LT(mean_relative_error(e, 0.3,
                                [&](Index i) {
                                  return i < 441 || i == isolated
                                             ? 0.
                                             : great_circle(surface.points[441], surface.points[i]);
                                }),
            0.05);
}

TEST(Heat, is_finite_on_degenerate_triangles)
{
  Triangulation surface = square(10, 0.24);
  for(Index i = 60; i < 63; ++i)
    surface.points[i] = surface.points[60];
  for(Index i = 12; i < 20; ++i)
    surface.points[i][1] = surface.points[12][1];
  const Array_surface arrays(surface);
  const auto d = heat_distances(arrays, {arrays.source(0)});
  for(Index i = 0; i < d.size(); ++i)
    EXPECT_TRUE(d[i] >= 0. && d[i] < 2.);
  // All vertices coincide.
  const Array_surface point({std::vector<Point>(4, Point{1., 2., 3.}), {0, 1, 2, 0, 2, 3}});
  for(const double x : heat_distances(point, {point.source(0)}))
    EXPECT_TRUE(std::abs(x) < 1e-3);
}

TEST(Heat, respects_limits)
{
  const Array_surface surface(icosphere(3));
  Heat_solver solver(surface.triangles());
  solver.run({surface.source(0)});
  const auto all = surface.distances(solver);
  Front_limits limits;
  limits.maximum_distance = 1. / surface.scale();
  solver.run({surface.source(0)}, limits);
  const auto within_limit = surface.distances(solver);
  std::size_t count = 0;
  for(Index i = 0; i < within_limit.size(); ++i)
  {
    EXPECT_EQ(within_limit[i], all[i] <= 1. ? all[i] : infinity);
    count += within_limit[i] < infinity;
  }
  EXPECT_EQ(solver.reached().size(), count);

  limits = {};
  double last = -1.;
  int calls = 0;
  limits.callback = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.);
    last = fraction;
    return ++calls < 2;
  };
  EXPECT_FALSE(solver.run({surface.source(0)}, limits));
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(solver.reached().empty());
  for(const double x : surface.distances(solver))
    EXPECT_EQ(x, infinity);

  limits = {};
  limits.slowness = std::make_shared<const std::vector<double>>(1280, 1.);
  EXPECT_THROW(solver.run({surface.source(0)}, limits), Unsupported_surface_error);
  solver.run({surface.source(0)});
  EXPECT_EQ(surface.distances(solver), all);
}

TEST(Heat, is_independent_of_previous_queries)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  Heat_solver reused(surface.triangles());
  for(const Index source : {5u, 100u, 5u})
  {
    reused.run({surface.source(source), surface.source(source + 300, 0.1)});
    EXPECT_EQ(surface.distances(reused),
              heat_distances(surface, {surface.source(source), surface.source(source + 300, 0.1)}));
  }
}

TEST(Heat, copies_run_concurrently)
{
  const Array_surface surface(icosphere(4));
  Heat_solver first(surface.triangles()), second = first;
  const auto expected_first = heat_distances(surface, {surface.source(0)}),
             expected_second = heat_distances(surface, {surface.source(1000)});
  std::thread other([&] { second.run({surface.source(1000)}); });
  first.run({surface.source(0)});
  other.join();
  EXPECT_EQ(surface.distances(first), expected_first);
  EXPECT_EQ(surface.distances(second), expected_second);
}

TEST(Heat, reports_sources_and_predecessors)
{
  const Array_surface surface(icosphere(3));
  Heat_solver solver(surface.triangles());
  solver.run({surface.source(0), surface.source(3)});
  for(Index i = 0; i < surface.size(); ++i)
  {
    const double to_first = great_circle(surface.point(0), surface.point(i)),
                 to_second = great_circle(surface.point(3), surface.point(i));
    // The source is the nearest one along edges, which may be either close to the equator.
    if(std::abs(to_first - to_second) > 0.3)
    {
      EXPECT_EQ(solver.source(surface.vertex(i)), to_first < to_second ? 0u : 1u);
    }
    Index current = surface.vertex(i);
    for(std::size_t number_of_steps = 0; solver.predecessor(current) != none;
        current = solver.predecessor(current))
      ASSERT_LT(++number_of_steps, surface.size());
  }
}

TEST(Heat, interpolates_linearly_in_triangles)
{
  const Array_surface surface(icosphere(2));
  Heat_solver solver(surface.triangles());
  solver.run({surface.source(0)});
  const Surface_arrays& t = *surface.triangles();
  double mean = 0.;
  for(int k = 0; k < 3; ++k)
    mean += solver.distance(t.corner[3 * 17 + k]) / 3.;
  // A few round-off errors of numbers below 8.
  EXPECT_NEAR(solver.distance(Surface_location{17, none, {1. / 3., 1. / 3., 1. / 3.}}), mean,
              1e-15 * 4);
  EXPECT_EQ(solver.distance(Surface_location{17, none, {0., 1., 0.}}),
            solver.distance(t.corner[52]));
}

} // namespace heat_test
