// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace heat_with_all_boundary_vertices {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// All boundary vertices of a flat mesh are sources. A heat method that mishandles many sources
// returns about half of the distance in the first rings.
class Heat_with_all_boundary_vertices : public testing::Test
{
protected:
  static constexpr Index n = 40;
  const Triangulation plane = square(n, 0.24, 3);
  const Array_surface surface{plane};

  std::vector<Index> boundary_vertices() const
  {
    std::vector<Index> result;
    for(Index i = 0; i < surface.size(); ++i)
      if(i % (n + 1) == 0 || i % (n + 1) == n || i <= n || i >= n * (n + 1))
        result.push_back(i);
    return result;
  }
  std::vector<double> euclidean_distances() const
  {
    std::vector<double> result(surface.size(), internal::infinity);
    for(const Index v : boundary_vertices())
      for(Index i = 0; i < surface.size(); ++i)
        result[i] = std::min(result[i], distance(plane.points[i], plane.points[v]));
    return result;
  }
  std::vector<internal::Front_source> sources() const
  {
    std::vector<internal::Front_source> result;
    for(const Index v : boundary_vertices())
      result.push_back(surface.source(v, 0., Index(result.size())));
    return result;
  }
};

TEST_F(Heat_with_all_boundary_vertices, euclidean_front_is_accurate)
{
  const auto d = distances(surface, Method::euclidean_front, sources());
  const auto expected = euclidean_distances();
  // A front propagates only through vertices of its own cell. At cell boundaries, the error is a
  // fraction of an edge length. The mean error is nearly zero.
  EXPECT_LT(largest_error(d, [&](Index i) { return expected[i]; }), 0.5 / n);
  EXPECT_LT(mean_relative_error(d, 1. / n, [&](Index i) { return expected[i]; }), 3e-3);
}

TEST_F(Heat_with_all_boundary_vertices, distance_is_at_least_euclidean)
{
  // The front of a single source interpolates a convex function, so distances are never too short.
  // A Euclidean front also fits a circle to two distances. At cell boundaries, one of them may be
  // too long by a fraction of an edge length.
  const auto expected = euclidean_distances();
  for(const Method method : fronts)
  {
    const auto d = distances(surface, method, sources());
    for(Index i = 0; i < surface.size(); ++i)
      EXPECT_GE(d[i],
                expected[i] - (method == Method::euclidean_front ? 0.02 / n : front_tolerance))
          << method;
  }
}

TEST_F(Heat_with_all_boundary_vertices, mean_is_accurate_near_boundary)
{
  const auto expected = euclidean_distances();
  for(const Method method : all_methods)
  {
    const auto d = distances(surface, method, sources());
    double sum = 0.;
    std::size_t number_of_vertices = 0;
    for(Index i = 0; i < surface.size(); ++i)
      if(expected[i] >= 2. / n && expected[i] <= 6. / n)
      {
        sum += d[i] / expected[i];
        ++number_of_vertices;
      }
    ASSERT_GT(number_of_vertices, 100u);
    // On such a mesh, edge chains are 10 % too long. Planar fronts of point sources and heat err
    // by a few percent in the first rings. Euclidean fronts lose a little at cell boundaries.
    const double error = method == Method::euclidean_front ? 1e-3
                         : method == Method::dijkstra      ? 0.12
                                                           : 0.06;
    EXPECT_NEAR(sum / double(number_of_vertices), 1., error) << method;
  }
}

TEST_F(Heat_with_all_boundary_vertices, polyline_source_gives_straight_fronts)
{
  std::vector<Index> boundary_loop;
  for(Index i = 0; i < n; ++i)
    boundary_loop.push_back(i);
  for(Index j = 0; j < n; ++j)
    boundary_loop.push_back(j * (n + 1) + n);
  for(Index i = n; i > 0; --i)
    boundary_loop.push_back(n * (n + 1) + i);
  for(Index j = n; j > 0; --j)
    boundary_loop.push_back(j * (n + 1));
  boundary_loop.push_back(0);
  const auto distance_to_square_boundary = [&](Index i)
  {
    const auto& p = plane.points[i];
    return std::min({p[0], p[1], 1. - p[0], 1. - p[1]});
  };
  const std::vector<internal::Front_source> line = {surface.line(boundary_loop)};
  // Exact except along the bisectors of the corners. There, the edges around a vertex propagate
  // two waves as one, which costs a fraction of an edge length.
  EXPECT_LT(
      largest_error(distances(surface, Method::euclidean_front, line), distance_to_square_boundary),
      0.25 / n);
  // A planar front from a straight line is exact. Close to the bisectors of two sides of the
  // square, it errs by a fraction of an edge length.
  EXPECT_LT(
      largest_error(distances(surface, Method::fast_marching, line), distance_to_square_boundary),
      0.5 / n);
}

} // namespace heat_with_all_boundary_vertices
