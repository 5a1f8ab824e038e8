// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

TEST(Source_on_the_border, is_exact_on_a_flat_square)
{
  const Index n = 12;
  const Triangulation plane = square(n, 0.24, 4);
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  std::vector<Location> sources;
  for(Index i = 0; i <= n; i += 4)
    for(const Index p : {i, i * (n + 1), n * (n + 1) + i})
      sources.push_back(surface.at(p));
  for(Index side = 0; side < plane.corners.size(); ++side)
    if(t.twin[3 * surface.triangle(side / 3) + side % 3] == none)
      sources.push_back(surface.on(side / 3, int(side % 3), 0.3));
  EXPECT_EQ(sources.size(), 12u + 4u * n);
  for(const Location& source : sources)
  {
    const Point p = point_at(t, source);
    EXPECT_LT(largest_error(distances(surface, Method::euclidean_front, {surface.source(source)}),
                            [&](Index i) { return distance(plane.points[i], p); }),
              rounding_of_fronts);
  }
}

TEST(Source_on_the_border, sees_as_far_as_it_is_seen)
{
  // Around the hole of a ring, where many pairs do not see each other.
  const Triangulation ring = annulus(36, 8, 1., 2.);
  const Glued_surface surface(ring);
  const double side = 2. * pi * 2. / 36.;
  for(const Method method : fronts)
  {
    std::vector<std::vector<double>> d;
    for(Index source = 0; source < surface.size(); source += 11)
      d.push_back(distances(surface, method, {surface.source(source)}));
    for(std::size_t a = 0; a < d.size(); ++a)
      for(std::size_t b = 0; b < a; ++b)
      {
        // Each of the two may err: planar fronts by first order in the side, Euclidean ones by a part of
        // a side behind the hole.
        const double error = method == Method::dijkstra        ? rounding
                             : method == Method::fast_marching ? 0.5 * side
                                                               : 0.2 * side;
        EXPECT_NEAR(d[a][11 * b], d[b][11 * a], error) << method;
      }
  }
}

TEST(Source_on_the_border, is_met_by_paths_along_it)
{
  const Index n = 8;
  const Triangulation plane = square(n, 0.24, 4);
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  const std::vector<internal::Source> sources = {surface.source(0)};
  internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
  front.run(sources);
  const Location end = surface.at(n); // the other end of the side
  const auto along = path(t, front, sources, end);
  expect_path_on_surface(t, along, end, surface.at(0));
  EXPECT_NEAR(surface.scale() * internal::path_length(t, along), 1., rounding);
}

} // namespace
