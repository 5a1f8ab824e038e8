// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/Log_engine.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace Log_engine_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The largest error of the tangent vectors in a plane, where they are differences of points.
double largest_error(const Log_kind& kind)
{
  const Array_surface surface(square(10, 0.2));
  const Tangent_plane plane(surface.t(), surface.at(60));
  Log_engine engine(kind, surface.triangles());
  double result = 0.;
  std::size_t number_of_vertices = 0;
  engine.run(plane, {},
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
