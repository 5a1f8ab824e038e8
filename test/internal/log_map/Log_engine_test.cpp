// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Log_engine.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace Log_engine_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The largest error of the tangent vectors in a plane, where they are differences of points.
double largest_error(const Log_kind& kind, const Log_map_options& options = {})
{
  const Array_surface surface(square(10, 0.2));
  const Tangent_plane plane(surface.t(), surface.at(60));
  Log_engine engine(kind, surface.triangles());
  double result = 0.;
  std::size_t number_of_vertices = 0;
  engine.run(plane, options,
             [&](Index vertex, const Vec2& vector)
             {
               const Vec3 p = surface.t().point[vertex] - plane.point();
               const Vec2 expected = {dot(p, plane.x()), dot(p, plane.y())};
               result = std::max(result, norm(vector - expected));
               ++number_of_vertices;
             });
  EXPECT_EQ(number_of_vertices, surface.size());
  return result * surface.scale();
}

TEST(Log_engine, is_exact_in_the_plane)
{
  // Exact distances and angles, or sums of steps in one plane, up to round-off errors.
  const double round_off = 1e-12;
  EXPECT_LT(largest_error({Log_method::exact}), round_off);
  EXPECT_LT(largest_error({Log_method::gradient, Distance_method::exact}), round_off);
  EXPECT_LT(largest_error({Log_method::gradient, Distance_method::euclidean_front}), round_off);
  EXPECT_LT(largest_error({Log_method::discrete_exponential}), round_off);
}

TEST(Log_engine, options_are_exact_in_the_plane)
{
  // Refinement keeps exact distances exact, and smoothing reproduces linear functions.
  const double round_off = 1e-12;
  for(const std::size_t steps : {0, 10})
    for(const std::size_t refinements : {0, 1, 3})
    {
      Log_map_options options;
      options.number_of_smoothing_steps = steps;
      options.number_of_base_refinements = refinements;
      EXPECT_LT(largest_error({Log_method::gradient, Distance_method::exact}, options), round_off);
      EXPECT_LT(largest_error({Log_method::gradient, Distance_method::euclidean_front}, options),
                round_off);
    }
}

TEST(Log_engine, checks_options)
{
  const Array_surface surface(square(3));
  Log_map_options smoothing, refinement, many_steps, many_levels;
  smoothing.number_of_smoothing_steps = 1;
  refinement.number_of_base_refinements = 1;
  many_steps.number_of_smoothing_steps = 1001;
  many_levels.number_of_base_refinements = 9;
  const Log_engine gradient({Log_method::gradient}, surface.triangles());
  EXPECT_NO_THROW(gradient.check(smoothing));
  EXPECT_NO_THROW(gradient.check(refinement));
  EXPECT_THROW(gradient.check(many_steps), Invalid_argument_error);
  EXPECT_THROW(gradient.check(many_levels), Invalid_argument_error);
  for(const Log_method method : {Log_method::exact, Log_method::discrete_exponential})
  {
    const Log_engine engine({method}, surface.triangles());
    EXPECT_NO_THROW(engine.check({}));
    EXPECT_THROW(engine.check(smoothing), Unsupported_surface_error);
    EXPECT_THROW(engine.check(refinement), Unsupported_surface_error);
  }
}

TEST(Log_engine, respects_maximum_distance)
{
  const Array_surface surface(square(10));
  const Tangent_plane plane(surface.t(), surface.at(60));
  for(const Log_method method :
      {Log_method::gradient, Log_method::exact, Log_method::discrete_exponential})
  {
    Log_map_options options;
    options.maximum_distance = 0.25 / surface.scale();
    std::size_t number_of_vertices = 0;
    Log_engine({method}, surface.triangles())
        .run(plane, options,
             [&](Index, const Vec2& vector)
             {
               EXPECT_LT(norm(vector), 1.5 * options.maximum_distance);
               ++number_of_vertices;
             });
    EXPECT_GT(number_of_vertices, 1u);
    EXPECT_LT(number_of_vertices, surface.size());
  }
}

} // namespace Log_engine_test
