// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace source_on_boundary {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

TEST(Source_on_boundary, distance_is_exact_on_flat_square)
{
  const Index n = 12;
  const Triangulation plane = square(n, 0.24, 4);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  std::vector<Surface_location> sources;
  for(Index i = 0; i <= n; i += 4)
    for(const Index p : {i, i * (n + 1), n * (n + 1) + i})
      sources.push_back(surface.at(p));
  for(Index h = 0; h < plane.corners.size(); ++h)
    if(t.twin[3 * surface.triangle(h / 3) + h % 3] == none)
      sources.push_back(surface.on(h / 3, int(h % 3), 0.3));
  EXPECT_EQ(sources.size(), 12u + 4u * n);
  for(const Surface_location& source : sources)
  {
    const Point p = point_at(t, source);
    EXPECT_LT(largest_error(distances(surface, Method::euclidean_front, {surface.source(source)}),
                            [&](Index i) { return distance(plane.points[i], p); }),
              front_tolerance);
  }
}

TEST(Source_on_boundary, distance_is_symmetric)
{
  // Around the hole of an annulus, where many pairs are not connected by a straight line.
  const Triangulation annulus_mesh = annulus(36, 8, 1., 2.);
  const Array_surface surface(annulus_mesh);
  const double edge_length = 2. * pi * 2. / 36.;
  for(const Method method : fronts)
  {
    std::vector<std::vector<double>> d;
    for(Index source = 0; source < surface.size(); source += 11)
      d.push_back(distances(surface, method, {surface.source(source)}));
    for(std::size_t a = 0; a < d.size(); ++a)
      for(std::size_t b = 0; b < a; ++b)
      {
        // Both distances may err. Planar fronts have first-order errors in the edge length. Behind
        // the hole, Euclidean fronts err by a fraction of it.
        const double error = method == Method::dijkstra        ? round_off_tolerance
                             : method == Method::fast_marching ? 0.5 * edge_length
                                                               : 0.2 * edge_length;
        EXPECT_NEAR(d[a][11 * b], d[b][11 * a], error) << method;
      }
  }
}

TEST(Source_on_boundary, paths_follow_boundary)
{
  const Index n = 8;
  const Triangulation plane = square(n, 0.24, 4);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  const std::vector<internal::Front_source> sources = {surface.source(0)};
  internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
  front.run(sources);
  const Surface_location end = surface.at(n); // the other end of this side of the square
  const auto path_along_boundary = path(t, front, sources, end);
  expect_path_on_surface(t, path_along_boundary, end, surface.at(0));
  EXPECT_NEAR(surface.scale() * internal::path_length(t, path_along_boundary), 1.,
              round_off_tolerance);
}

} // namespace source_on_boundary
