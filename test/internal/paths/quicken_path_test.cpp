// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/quicken_path.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace quicken_path_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns the value of a function at the center of each triangle.
std::vector<double> slowness_of(const Array_surface& surface,
                                const std::function<double(const Point&)>& f)
{
  const Surface_arrays& t = surface.t();
  std::vector<double> result;
  for(Index triangle = 0; triangle < t.number_of_triangles(); ++triangle)
    result.push_back(f(point_at(t, {triangle, none, {1. / 3., 1. / 3., 1. / 3.}})));
  return result;
}

double block(const Point& p)
{
  return std::abs(p[0] - 0.5) < 0.2 && std::abs(p[1] - 0.5) < 0.4 ? 20. : 1.;
}

// A front from point 0 and the paths to it.
struct Paths
{
  Paths(const Array_surface& surface, const std::vector<double>& slowness)
      : surface(surface), slowness(slowness), front(surface.triangles(), Front_kind::euclidean)
  {
    Front_limits limits;
    limits.slowness = std::make_shared<const std::vector<double>>(slowness);
    front.run({surface.source(0)}, limits);
  }
  // Returns the fast path from a point.
  std::vector<Surface_location> from(Index i) const
  {
    const auto path = path_to_sources(
        surface.t(), surface.at(i), {surface.source(0)}, [&](Index v) { return front.distance(v); },
        [&](Index v) { return front.predecessor(v); }, [&](Index v) { return front.source(v); },
        &slowness);
    expect_path_on_surface(surface.t(), path, surface.at(i), surface.at(0));
    return path;
  }
  double time(const std::vector<Surface_location>& path) const
  {
    return surface.scale() * travel_time(surface.t(), slowness, path);
  }

  const Array_surface& surface;
  const std::vector<double>& slowness;
  Front front;
};

TEST(Quicken_path, refracts_as_snell_demands)
{
  const Array_surface surface(square(20)); // edges on the line x = 1/2
  const std::vector<double> slowness =
      slowness_of(surface, [](const Point& p) { return p[0] < 0.5 ? 1. : 3.; });
  const Paths paths(surface, slowness);
  const double time = paths.time(paths.from(440));
  // The time through (1/2, y) is convex in y: bisect its derivative.
  const auto sine = [](double y) { return y / std::hypot(0.5, y); };
  double low = 0., high = 1.;
  for(int i = 0; i < 60; ++i)
  {
    const double y = 0.5 * (low + high);
    (sine(y) < 3. * sine(1. - y) ? low : high) = y;
  }
  const double fastest = std::hypot(0.5, low) + 3. * std::hypot(0.5, 1. - low);
  EXPECT_GE(time, fastest * (1. - 1e-12)); // round-off errors of a sum of segments
  // The path is the fastest one in its strip of triangles. With three points per edge, the best
  // strip is found up to about this error.
  EXPECT_LE(time, fastest * (1. + 1e-3));
}

TEST(Quicken_path, goes_around_slow_block_and_obstacle)
{
  for(const double slow : {20., infinity})
    for(const double jitter : {0., 0.24})
    {
      const Array_surface surface(square(40, jitter));
      const std::vector<double> slowness =
          slowness_of(surface, [&](const Point& p) { return block(p) > 1. ? slow : 1.; });
      const Paths paths(surface, slowness);
      const double time = paths.time(paths.from(1680));
      // Around the corner (0.7, 0.1) or (0.3, 0.9). The triangles of the block, whose centers are
      // in it, reach beyond it or not by at most an edge.
      const double edge = 1. / 40., fastest = std::hypot(0.7, 0.1) + std::hypot(0.3, 0.9);
      EXPECT_GT(time, fastest - 2. * edge);
      EXPECT_LT(time, fastest + 2. * edge);
    }
}

TEST(Quicken_path, is_as_fast_as_front)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(0., 3.);
  const std::vector<std::function<double(const Point&)>> functions = {
      block, [](const Point& p) { return 1. + 0.9 * std::sin(9. * p[0]) * std::cos(7. * p[1]); },
      [&](const Point&) { return std::exp(exponent(random)); }};
  const Array_surface surface(square(20, 0.24));
  for(const auto& f : functions)
  {
    const std::vector<double> slowness = slowness_of(surface, f);
    const Paths paths(surface, slowness);
    // A front is too slow where it has to turn within a triangle, so that most paths are faster.
    // The largest excess that was measured is 0.2 %.
    for(Index i = 1; i < surface.size(); i += 11)
      EXPECT_LT(paths.time(paths.from(i)),
                1.01 * surface.scale() * paths.front.distance(surface.vertex(i)));
  }
}

TEST(Quicken_path, keeps_short_paths)
{
  const Array_surface surface(square(4));
  const std::vector<double> slowness(surface.t().number_of_triangles(), 2.);
  const Surface_location from = surface.in(3, {.2, .3, .5}), to = surface.in(3, {.5, .3, .2});
  EXPECT_TRUE(quicken_path(surface.t(), slowness, {}).empty());
  EXPECT_EQ(quicken_path(surface.t(), slowness, {from}).size(), 1u);
  const auto path = quicken_path(surface.t(), slowness, {from, to});
  EXPECT_EQ(path.size(), 2u);
  expect_path_on_surface(surface.t(), path, from, to);
}

} // namespace quicken_path_test
