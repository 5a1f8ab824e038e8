// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_energy.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::internal::operator-;

// The sphere of a radius around the origin.
struct Sphere : Path_surface
{
  double radius = 1.;

  Foot foot(const Spatial& p, Index) const override
  {
    return {radius * unit(p), unit(p), {0., 0., 0.}, 0};
  }
};

// The torus of radii 1 and 0.4 around the z-axis.
double squared_distance_from_torus(const Spatial& p)
{
  const double ring = std::hypot(p[0], p[1]) - 1., d = std::hypot(ring, p[2]) - 0.4;
  return d * d;
}

Spatial on_torus(double u, double v)
{
  const double r = 1. + 0.4 * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)};
}

// A path that strays around a great circle.
std::vector<Foot> wiggly(std::size_t nodes, double angle)
{
  std::vector<Foot> path(nodes);
  for(std::size_t i = 0; i < nodes; ++i)
  {
    const double a = angle * double(i) / double(nodes - 1),
                 z = 0.2 * std::sin(7. * a) * std::sin(pi * double(i) / double(nodes - 1));
    path[i].point = unit({std::cos(a), std::sin(a), z});
    path[i].normal = path[i].point;
    path[i].site = 0;
  }
  return path;
}

struct Evaluated
{
  std::vector<Spatial> points;
  std::vector<Foot> feet, middles;
  Path_energy energy;
};

Evaluated evaluated(const Path_options& options, const std::vector<double>& share,
                    const std::vector<Spatial>& points)
{
  Evaluated result{
      points, std::vector<Foot>(points.size()), std::vector<Foot>(points.size() - 1), {}};
  evaluate(Sphere(), options, share, 0.3, result.points, result.feet, result.middles,
           result.energy);
  return result;
}

TEST(path_energy, has_the_gradient_of_its_value)
{
  Path_options options;
  options.hold = Path_hold::energy;
  options.alpha = 1.3;
  options.beta = 2.1;
  std::vector<Spatial> points;
  for(const Foot& foot : wiggly(7, 2.))
    points.push_back(1.05 * foot.point);
  const std::vector<double> share = {1., 1., 0.5, 0.5, 1., 2.};
  const Path_energy energy = evaluated(options, share, points).energy;
  constexpr double step = 1e-5;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(int k = 0; k < 3; ++k)
    {
      std::vector<Spatial> ahead = points, behind = points;
      ahead[i][k] += step;
      behind[i][k] -= step;
      const double slope = (evaluated(options, share, ahead).energy.value -
                            evaluated(options, share, behind).energy.value) /
                           (2. * step);
      const bool is_end = i == 0 || i + 1 == points.size();
      // Differences of second order in the step, and rounding over it.
      EXPECT_NEAR(energy.gradient[i][k], is_end ? 0. : slope, 1e-8);
    }
}

TEST(path_energy, is_the_sum_of_the_paper)
{
  Path_options options;
  options.hold = Path_hold::energy;
  options.alpha = 3.;
  options.beta = 5.;
  // One segment of length 2 through the unit sphere's centre, and a node at a distance of 1.
  const Evaluated one = evaluated(options, {1., 1.}, {{1., 0., 0.}, {2., 0., 0.}, {2., 0., 4.}});
  const double far = std::sqrt(4. + 4.) - 1.,
               expected = 1. + 16. + 3. * 1. + 5. * 0.3 * 0.3 * (0.5 * 0.5 / 1. + far * far / 16.);
  EXPECT_NEAR(one.energy.value, expected, 1e-13); // rounding of numbers near 20
}

TEST(path_energy, falls_to_a_great_circle)
{
  for(const Path_hold hold : {Path_hold::projected, Path_hold::energy})
  {
    Path_options options;
    options.hold = hold;
    std::vector<Foot> path = wiggly(40, 2.);
    const Path_energy_level level = minimize(Sphere(), options, std::vector<double>(39, 1.), path);
    EXPECT_LT(level.last_energy, level.first_energy);
    EXPECT_LT(level.number_of_iterations, 50u);
    for(const Foot& foot : path)
      EXPECT_NEAR(foot.point[2], 0., 1e-4); // the energy is flat to 1e-11: its root, and some
  }
}

TEST(path_energy, never_rises)
{
  // After any number of iterations it is no higher than after one less.
  for(const Path_hold hold : {Path_hold::projected, Path_hold::energy})
  {
    double before = infinity;
    for(std::size_t iterations = 0; iterations < 12; ++iterations)
    {
      Path_options options;
      options.hold = hold;
      options.iterations = iterations;
      std::vector<Foot> path = wiggly(30, 2.5);
      const double energy =
          minimize(Sphere(), options, std::vector<double>(29, 1.), path).last_energy;
      EXPECT_LE(energy, before);
      before = energy;
    }
  }
}

// The plane z = 0 but for a high block behind y = 0.
struct Block : Path_surface
{
  Foot foot(const Spatial& p, Index) const override
  {
    const bool is_high = std::abs(p[0] - 4.) < 0.05 && p[1] > 0.;
    return {{p[0], p[1], is_high ? 5. : 0.}, {0., 0., 1.}, {0., 0., 0.}, 0};
  }
};

TEST(path_energy, goes_down_although_feet_jump)
{
  // To and fro; the node before the block would climb it with the smallest step of all.
  const Block surface;
  std::vector<Foot> path(41);
  for(std::size_t i = 0; i < path.size(); ++i)
    path[i] = surface.foot({0.2 * double(i), i == 20 ? -1e-9 : i % 2 == 0 ? 0.2 : -0.2, 0.}, 0);
  const double before = polyline_length(path), straight = 8.;
  const Path_energy_level level =
      minimize(surface, Path_options(), std::vector<double>(path.size() - 1, 1.), path);
  EXPECT_LT(level.last_energy, level.first_energy);
  EXPECT_LT(polyline_length(path) - straight, 0.1 * (before - straight));
}

// The quarter of space below z = 0 and before x = 0.
struct Right_angle : Path_surface
{
  Foot foot(const Spatial& p, Index) const override
  {
    const Spatial on_top = {std::min(p[0], 0.), p[1], 0.}, on_side = {0., p[1], std::min(p[2], 0.)};
    return norm(p - on_top) < norm(p - on_side) ? Foot{on_top, {0., 0., 1.}, {0., 0., 0.}, 0}
                                                : Foot{on_side, {1., 0., 0.}, {0., 0., 0.}, 0};
  }
};

TEST(path_energy, holds_segments_on_sharp_edges_by_their_weight)
{
  // Figure 2 of the paper.
  const Right_angle surface;
  double deepest[2];
  for(const int with : {0, 1})
  {
    std::vector<Foot> path(12);
    for(std::size_t i = 0; i < path.size(); ++i)
      path[i] = surface.foot({double(i) - 5.5, 0.1 * double(i), 5.5 - double(i)}, 0);
    Path_options options;
    options.hold = Path_hold::energy;
    options.beta = 2. * with;
    minimize(surface, options, std::vector<double>(11, 1.), path);
    deepest[with] = 0.;
    for(std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      const Spatial middle = 0.5 * (path[i].point + path[i + 1].point);
      deepest[with] = std::max(deepest[with], norm(surface.foot(middle, 0).point - middle));
    }
  }
  EXPECT_LT(deepest[1], 0.8 * deepest[0]);
}

TEST(path_energy, keeps_segments_in_the_ratio_of_their_shares)
{
  std::vector<double> share(20, 1.);
  share[7] = share[8] = 0.25;
  std::vector<Foot> path = wiggly(21, 1.);
  minimize(Sphere(), {}, share, path);
  const auto length = [&](std::size_t i) { return norm(path[i + 1].point - path[i].point); };
  EXPECT_NEAR(length(7) / length(3), 0.25, 1e-3); // chords of arcs of a twentieth
  EXPECT_NEAR(length(8) / length(12), 0.25, 1e-3);
}

TEST(path_energy, shortens_chains_on_a_sphere)
{
  Sphere sphere;
  for(const double radius : {1., 1e-8, 1e8})
  {
    sphere.radius = radius;
    std::vector<Foot> chain = wiggly(200, 2.5);
    for(Foot& foot : chain)
      foot.point = radius * foot.point;
    const Shortened_path path = shortened(sphere, {}, chain);
    EXPECT_EQ(path.control_points, 75u);
    EXPECT_GE(path.points.size(), 300u);
    EXPECT_NEAR(path.length, 2.5 * radius, 1e-8 * radius); // fourth order in steps of 2.5 / 300
    EXPECT_LT(path.polyline_length, path.length);
    ASSERT_FALSE(path.levels.empty());
    for(const Path_energy_level& level : path.levels)
      EXPECT_LE(level.last_energy, level.first_energy);
  }
}

TEST(path_energy, shortens_chains_on_an_implicit_torus)
{
  // The inner equator, from a chain that strays, and a meridian.
  std::vector<Spatial> equator, meridian;
  for(int i = 0; i <= 60; ++i)
  {
    const double t = i / 60.;
    equator.push_back(on_torus(1.5 * t, pi + 0.4 * std::sin(pi * t)));
    meridian.push_back(on_torus(0.2 * std::sin(pi * t), 2.5 * t));
  }
  const Path_options options;
  // The inner equator is the shortest between places nearby; step^4, and the gradient's differences.
  EXPECT_NEAR(shortened(squared_distance_from_torus, options, equator).length, 1.5 * 0.6, 1e-5);
  EXPECT_NEAR(shortened(squared_distance_from_torus, options, meridian).length, 2.5 * 0.4, 1e-5);
}

TEST(path_energy, measures_arcs)
{
  std::vector<Foot> arc(11);
  for(std::size_t i = 0; i < arc.size(); ++i)
  {
    arc[i].point = {std::cos(0.1 * double(i)), std::sin(0.1 * double(i)), 0.};
    arc[i].normal = arc[i].point;
  }
  EXPECT_NEAR(length_along_arcs(arc), 1., 1e-14); // a circle is exact
  EXPECT_NEAR(polyline_length(arc), 20. * std::sin(0.05), 1e-14);
  EXPECT_NEAR(length_of_arc(arc[0], arc[3]), 0.3, 1e-14);
}

TEST(path_energy, measures_around_edges)
{
  // From one side of a right angle to the other, also along the edge.
  const Foot from = {{-1., 0., 0.}, {0., 0., 1.}, {0., 0., 0.}, 0},
             to = {{0., 2., -3.}, {1., 0., 0.}, {0., 0., 0.}, 0};
  EXPECT_NEAR(length_of_arc(from, to), std::hypot(4., 2.), 1e-14);
}

TEST(path_energy, refuses_what_is_no_chain)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto one = [](const Spatial&) { return 1.; };
  const auto none_at_all = [=](const Spatial&) { return nan; };
  EXPECT_THROW(shortened(one, {}, std::vector<Spatial>{{0., 0., 0.}}), Invalid_argument_error);
  EXPECT_THROW(shortened(one, {}, std::vector<Spatial>{{0., 0., 0.}, {nan, 0., 0.}}),
               Invalid_argument_error);
  EXPECT_THROW(shortened(none_at_all, {}, std::vector<Spatial>{{0., 0., 0.}, {1., 0., 0.}}),
               Invalid_argument_error);
}

} // namespace
