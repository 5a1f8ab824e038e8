// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_energy.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/path_curve.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace path_energy_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::internal::operator-;

// A sphere around the origin.
struct Sphere : Path_surface
{
  double radius = 1.;

  Projection project(const Vec3& p, Index) const override
  {
    return {radius * unit(p), unit(p), {0., 0., 0.}, 0};
  }
};

// The squared distance to the torus of radii 1 and 0.4 around the z-axis.
double squared_distance_from_torus(const Vec3& p)
{
  const double distance_to_axis = std::hypot(p[0], p[1]) - 1.,
               distance = std::hypot(distance_to_axis, p[2]) - 0.4;
  return distance * distance;
}

Vec3 on_torus(double u, double v)
{
  const double r = 1. + 0.4 * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)};
}

// A path that oscillates around a great circle.
std::vector<Projection> perturbed_great_circle(std::size_t nodes, double angle)
{
  std::vector<Projection> path(nodes);
  for(std::size_t i = 0; i < nodes; ++i)
  {
    const double a = angle * double(i) / double(nodes - 1),
                 z = 0.2 * std::sin(7. * a) * std::sin(pi * double(i) / double(nodes - 1));
    path[i].point = unit({std::cos(a), std::sin(a), z});
    path[i].normal = path[i].point;
    path[i].vertex = 0;
  }
  return path;
}

Path_state evaluate_on_sphere(const Path_options& options,
                              const std::vector<double>& relative_length,
                              const std::vector<Vec3>& points)
{
  Path_state result{points,
                    std::vector<Projection>(points.size()),
                    std::vector<Projection>(points.size() - 1),
                    {}};
  evaluate_energy(Sphere(), options, relative_length, 0.3, result);
  return result;
}

TEST(path_energy, gradient_matches_finite_differences)
{
  Path_options options;
  options.constraint = Path_constraint::energy;
  options.alpha = 1.3;
  options.beta = 2.1;
  std::vector<Vec3> points;
  for(const Projection& projection : perturbed_great_circle(7, 2.))
    points.push_back(1.05 * projection.point);
  const std::vector<double> relative_length = {1., 1., 0.5, 0.5, 1., 2.};
  const Path_energy energy = evaluate_on_sphere(options, relative_length, points).energy;
  constexpr double step = 1e-5;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(int k = 0; k < 3; ++k)
    {
      std::vector<Vec3> ahead = points, behind = points;
      ahead[i][k] += step;
      behind[i][k] -= step;
      const double slope = (evaluate_on_sphere(options, relative_length, ahead).energy.value -
                            evaluate_on_sphere(options, relative_length, behind).energy.value) /
                           (2. * step);
      const bool is_end = i == 0 || i + 1 == points.size();
      // The error of the differences is of second order in the step, plus round-off errors divided
      // by it.
      EXPECT_NEAR(energy.gradient[i][k], is_end ? 0. : slope, 1e-8);
    }
}

TEST(path_energy, value_matches_equation_4_of_paper)
{
  Path_options options;
  options.constraint = Path_constraint::energy;
  options.alpha = 3.;
  options.beta = 5.;
  // Two segments of lengths 1 and 4. The node between them is at distance 1 from the unit sphere.
  const Path_state state =
      evaluate_on_sphere(options, {1., 1.}, {{1., 0., 0.}, {2., 0., 0.}, {2., 0., 4.}});
  const double distance_of_midpoint = std::sqrt(4. + 4.) - 1.,
               expected = 1. + 16. + 3. * 1. +
                          5. * 0.3 * 0.3 *
                              (0.5 * 0.5 / 1. + distance_of_midpoint * distance_of_midpoint / 16.);
  EXPECT_NEAR(state.energy.value, expected, 1e-13); // round-off errors of numbers near 20
}

TEST(path_energy, converges_to_great_circle)
{
  for(const Path_constraint constraint : {Path_constraint::projected, Path_constraint::energy})
  {
    Path_options options;
    options.constraint = constraint;
    std::vector<Projection> path = perturbed_great_circle(40, 2.);
    const Path_energy_level level =
        minimize_energy(Sphere(), options, std::vector<double>(39, 1.), path);
    EXPECT_LT(level.last_energy, level.first_energy);
    EXPECT_LT(level.number_of_iterations, 50u);
    for(const Projection& projection : path)
      EXPECT_NEAR(projection.point[2], 0., 1e-4); // above the square root of the tolerance, 1e-11
  }
}

TEST(path_energy, never_increases)
{
  // The final energy must not increase with the maximum number of iterations.
  for(const Path_constraint constraint : {Path_constraint::projected, Path_constraint::energy})
  {
    double previous_energy = infinity;
    for(std::size_t iterations = 0; iterations < 12; ++iterations)
    {
      Path_options options;
      options.constraint = constraint;
      options.max_iterations = iterations;
      std::vector<Projection> path = perturbed_great_circle(30, 2.5);
      const double energy =
          minimize_energy(Sphere(), options, std::vector<double>(29, 1.), path).last_energy;
      EXPECT_LE(energy, previous_energy);
      previous_energy = energy;
    }
  }
}

// The plane z = 0 with a narrow block of height 5 at y > 0.
struct Block : Path_surface
{
  Projection project(const Vec3& p, Index) const override
  {
    const bool is_high = std::abs(p[0] - 4.) < 0.05 && p[1] > 0.;
    return {{p[0], p[1], is_high ? 5. : 0.}, {0., 0., 1.}, {0., 0., 0.}, 0};
  }
};

TEST(path_energy, decreases_if_foot_points_jump)
{
  // The path zigzags. The node before the block jumps to its top after an arbitrarily small step.
  const Block surface;
  std::vector<Projection> path(41);
  for(std::size_t i = 0; i < path.size(); ++i)
    path[i] = surface.project({0.2 * double(i), i == 20 ? -1e-9 : i % 2 == 0 ? 0.2 : -0.2, 0.}, 0);
  const double initial_length = polyline_length(path), shortest_length = 8.;
  const Path_energy_level level =
      minimize_energy(surface, Path_options(), std::vector<double>(path.size() - 1, 1.), path);
  EXPECT_LT(level.last_energy, level.first_energy);
  EXPECT_LT(polyline_length(path) - shortest_length, 0.1 * (initial_length - shortest_length));
}

// The boundary of the quarter space x <= 0, z <= 0, with a sharp edge along the y-axis.
struct Right_angle : Path_surface
{
  Projection project(const Vec3& p, Index) const override
  {
    const Vec3 on_top = {std::min(p[0], 0.), p[1], 0.}, on_wall = {0., p[1], std::min(p[2], 0.)};
    return norm(p - on_top) < norm(p - on_wall)
               ? Projection{on_top, {0., 0., 1.}, {0., 0., 0.}, 0}
               : Projection{on_wall, {1., 0., 0.}, {0., 0., 0.}, 0};
  }
};

TEST(path_energy, segment_weight_pulls_segments_to_sharp_edges)
{
  // Figure 2 of the paper.
  const Right_angle surface;
  double max_depth[2];
  for(const int use_segment_weight : {0, 1})
  {
    std::vector<Projection> path(12);
    for(std::size_t i = 0; i < path.size(); ++i)
      path[i] = surface.project({double(i) - 5.5, 0.1 * double(i), 5.5 - double(i)}, 0);
    Path_options options;
    options.constraint = Path_constraint::energy;
    options.beta = 2. * use_segment_weight;
    minimize_energy(surface, options, std::vector<double>(11, 1.), path);
    max_depth[use_segment_weight] = 0.;
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const Vec3 midpoint = 0.5 * (path[i].point + path[i + 1].point);
      max_depth[use_segment_weight] = std::max(max_depth[use_segment_weight],
                                               norm(surface.project(midpoint, 0).point - midpoint));
    }
  }
  EXPECT_LT(max_depth[1], 0.8 * max_depth[0]);
}

TEST(path_energy, keeps_ratio_of_segment_lengths)
{
  std::vector<double> relative_length(20, 1.);
  relative_length[7] = relative_length[8] = 0.25;
  std::vector<Projection> path = perturbed_great_circle(21, 1.);
  minimize_energy(Sphere(), {}, relative_length, path);
  const auto length = [&](std::size_t i) { return norm(path[i + 1].point - path[i].point); };
  EXPECT_NEAR(length(7) / length(3), 0.25, 1e-3); // chords of arcs of 1/20 radian
  EXPECT_NEAR(length(8) / length(12), 0.25, 1e-3);
}

TEST(path_energy, shortens_paths_on_sphere)
{
  Sphere sphere;
  for(const double radius : {1., 1e-8, 1e8})
  {
    sphere.radius = radius;
    std::vector<Projection> chain = perturbed_great_circle(200, 2.5);
    for(Projection& projection : chain)
      projection.point = radius * projection.point;
    const Shortened_path path = shorten_path(sphere, {}, chain);
    EXPECT_EQ(path.number_of_control_points, 75u);
    EXPECT_GE(path.points.size(), 300u);
    EXPECT_NEAR(path.length, 2.5 * radius,
                1e-8 * radius); // error of fourth order in steps of 2.5 / 300
    EXPECT_LT(path.polyline_length, path.length);
    ASSERT_FALSE(path.levels.empty());
    for(const Path_energy_level& level : path.levels)
      EXPECT_LE(level.last_energy, level.first_energy);
  }
}

TEST(path_energy, shortens_paths_on_implicit_torus)
{
  // Polylines that oscillate around the inner equator and around a meridian.
  std::vector<Vec3> equator, meridian;
  for(int i = 0; i <= 60; ++i)
  {
    const double t = i / 60.;
    equator.push_back(on_torus(1.5 * t, pi + 0.4 * std::sin(pi * t)));
    meridian.push_back(on_torus(0.2 * std::sin(pi * t), 2.5 * t));
  }
  const Path_options options;
  // The inner equator is a shortest path locally. The tolerance is the error of fourth order in
  // the step, and that of the gradient's differences.
  EXPECT_NEAR(shorten_path(squared_distance_from_torus, options, equator).length, 1.5 * 0.6, 1e-5);
  EXPECT_NEAR(shorten_path(squared_distance_from_torus, options, meridian).length, 2.5 * 0.4, 1e-5);
}

TEST(path_energy, throws_on_invalid_polyline)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto constant = [](const Vec3&) { return 1.; };
  const auto not_a_number = [=](const Vec3&) { return nan; };
  EXPECT_THROW(shorten_path(constant, {}, std::vector<Vec3>{{0., 0., 0.}}), Invalid_argument_error);
  EXPECT_THROW(shorten_path(constant, {}, std::vector<Vec3>{{0., 0., 0.}, {nan, 0., 0.}}),
               Invalid_argument_error);
  EXPECT_THROW(shorten_path(not_a_number, {}, std::vector<Vec3>{{0., 0., 0.}, {1., 0., 0.}}),
               Invalid_argument_error);
}

} // namespace path_energy_test
