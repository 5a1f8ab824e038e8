// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

namespace heat_far_field_underflow {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Heat decreases by a factor of e per edge. It underflows about 700 edges away from its source.
TEST(Heat_far_field, is_accurate_at_2000_edge_lengths)
{
  const Index columns = 2000, rows = 4;
  const Triangulation strip = grid(
      columns, rows,
      [=](double u, double v) {
        return Point{columns * u, rows * v, 0.};
      },
      0.2);
  const Array_surface surface(strip);
  const Index source = 2 * (columns + 1);
  const auto expected = [&](Index i) { return distance(strip.points[i], strip.points[source]); };
  for(const Method method : all_methods)
  {
    const auto d = distances(surface, method, {surface.source(source)});
    for(Index i = 0; i < surface.size(); ++i)
    {
      ASSERT_TRUE(d[i] >= 0. && d[i] < internal::infinity) << method;
      if(expected(i) < 300.)
        continue;
      // Far away, the front is a straight wave along the strip. Heat loses the first few edges,
      // first-order fronts err by 1 % on flat meshes, and edge chains zigzag. Beyond 250 edges, a
      // Euclidean front hardly distinguishes its circle from a line, which costs a tenth of an
      // edge.
      const double error = method == Method::euclidean_front ? 3e-4
                           : method == Method::dijkstra      ? 0.05
                                                             : 0.01;
      EXPECT_NEAR(d[i] / expected(i), 1., error) << method << " at " << expected(i);
    }
  }
}

TEST(Heat_far_field, increases_along_strip)
{
  const Index columns = 1000, rows = 2;
  const Triangulation strip = grid(columns, rows,
                                   [=](double u, double v) {
                                     return Point{columns * u, rows * v, 0.};
                                   });
  const Array_surface surface(strip);
  for(const Method method : all_methods)
  {
    const auto d = distances(surface, method, {surface.source(0)});
    for(Index i = 1; i <= columns; ++i)
      EXPECT_GT(d[i], d[i - 1]) << method << " at " << i;
  }
}

} // namespace heat_far_field_underflow
