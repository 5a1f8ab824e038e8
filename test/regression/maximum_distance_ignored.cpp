// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

namespace maximum_distance_ignored {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// The maximum distance bounds the visited vertices, not only the written ones.
TEST(Maximum_distance, bounds_reached_vertices)
{
  const Index n = 100;
  const Triangulation plane = square(n, 0.2, 7);
  const Array_surface surface(plane);
  const Index center = 50 * (n + 1) + 50;
  for(const Method method : fronts)
  {
    internal::Front front(surface.triangles(), kind_of(method));
    front.run({surface.source(center)});
    const auto all = surface.distances(front);
    for(const double maximum : {0., 0.03, 0.1, 0.3})
    {
      internal::Front_limits limits;
      limits.maximum_distance = maximum / surface.scale();
      front.run({surface.source(center)}, limits);
      std::size_t number_inside = 0;
      for(const double d : all)
        number_inside += d <= maximum;
      // The full front may correct a distance by round-off errors that the bounded front leaves.
      EXPECT_NEAR(double(front.reached().size()), double(number_inside), 1.)
          << method << ' ' << maximum;
      for(const Index vertex : front.reached())
        EXPECT_LE(surface.scale() * front.distance(vertex), maximum * (1. + round_off_tolerance));
    }
  }
}

TEST(Maximum_distance, bounds_number_of_callbacks)
{
  // The callback is called once per some thousand vertices. A front that ignored the limit would
  // call it much more often.
  const Array_surface surface(square(300));
  internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
  const auto calls = [&](double maximum)
  {
    int result = 0;
    internal::Front_limits limits;
    limits.maximum_distance = maximum / surface.scale();
    limits.callback = [&](double)
    {
      ++result;
      return true;
    };
    front.run({surface.source(150 * 301 + 150)}, limits);
    return result;
  };
  // A disk of radius 0.05 covers 0.8 % of the square.
  EXPECT_LT(10 * calls(0.05), calls(2.));
}

TEST(Maximum_distance, includes_offset_of_source)
{
  const Triangulation plane = square(20);
  const Array_surface surface(plane);
  for(const Method method : fronts)
  {
    internal::Front front(surface.triangles(), kind_of(method));
    internal::Front_limits limits;
    limits.maximum_distance = 0.5 / surface.scale();
    front.run({surface.source(0, 0.2), surface.source(440, 0.6, 1)}, limits);
    EXPECT_EQ(front.distance(surface.vertex(440)), internal::infinity) << method;
    EXPECT_LE(surface.scale() * front.distance(surface.vertex(5)), 0.5) << method;
    EXPECT_EQ(front.distance(surface.vertex(7)), internal::infinity) << method; // 0.35 + 0.2
  }
}

} // namespace maximum_distance_ignored
