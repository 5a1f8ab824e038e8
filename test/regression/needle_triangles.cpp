// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"
#include "path_checks.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <gtest/gtest.h>

namespace needle_triangles {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Returns a square. Every other column is `width` times as wide as the remaining columns.
Triangulation square_with_needles(double width)
{
  const Index n = 16;
  return grid(n, n,
              [=](double u, double v)
              {
                const Index column = Index(std::lround(u * n));
                const double x = column / 2 * (1. + width) + column % 2;
                return Point{x / (n / 2 * (1. + width)), v, 0.};
              });
}

TEST(Needle_triangles, distances_are_finite)
{
  for(const double width : {1e-3, 1e-7, 1e-12, 1e-16, 0.})
  {
    const Triangulation shape = square_with_needles(width);
    const Array_surface surface(shape);
    for(const Method method : all_methods)
      for(const Index source : {0u, 8u, 140u, 288u})
      {
        const auto d = distances(surface, method, {surface.source(source)});
        for(Index i = 0; i < surface.size(); ++i)
        {
          ASSERT_TRUE(d[i] >= 0. && d[i] < internal::infinity) << method << ' ' << width;
          // Distances are at least Euclidean. Exceptions are the smoothing of heat and errors due
          // to angles close to 180 degrees.
          const double euclidean = distance(shape.points[i], shape.points[source]);
          const double min_ratio = method == Method::heat ? 0.5 : 0.99;
          EXPECT_GE(d[i], min_ratio * euclidean - front_tolerance) << method << ' ' << width;
        }
      }
  }
}

TEST(Needle_triangles, keep_euclidean_front_exact)
{
  for(const double width : {1e-3, 1e-7, 1e-12, 1e-16, 0.})
  {
    const Triangulation shape = square_with_needles(width);
    const Array_surface surface(shape);
    for(const Index source : {0u, 8u, 140u, 288u})
    {
      const auto d = distances(surface, Method::euclidean_front, {surface.source(source)});
      // Needles of zero width are treated as 1.5e-11 wide. Eight of them lie in a row.
      EXPECT_LT(largest_error(d, [&](Index i)
                              { return distance(shape.points[i], shape.points[source]); }),
                1e-9)
          << width;
    }
  }
}

TEST(Needle_triangles, paths_are_straight)
{
  for(const double width : {1e-3, 1e-7, 1e-12, 1e-16, 0.})
  {
    const Triangulation shape = square_with_needles(width);
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    const std::vector<internal::Front_source> sources = {surface.source(0)};
    internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
    front.run(sources);
    for(Index from = 1; from < surface.size(); from += 5)
    {
      const auto geodesic = path(t, front, sources, surface.at(from));
      ASSERT_FALSE(geodesic.empty());
      const double length = surface.scale() * internal::path_length(t, geodesic);
      // In the plane, a locally shortest path is straight. Corners remain if straightening gains
      // less than round-off errors.
      EXPECT_NEAR(length, distance(shape.points[from], shape.points[0]), 1e-6) << width;
    }
  }
}

TEST(Needle_triangles, are_accepted_without_other_triangles)
{
  // All points lie on a line, or coincide.
  for(const double length : {1., 0.})
  {
    Triangulation shape = square(4);
    for(Point& p : shape.points)
      p = {length * (p[0] + p[1]), 0., 0.};
    const Array_surface surface(shape);
    for(const Method method : all_methods)
    {
      std::vector<double> d;
      ASSERT_NO_THROW(d = distances(surface, method, {surface.source(7)})) << method;
      for(const double value : d)
        EXPECT_TRUE(value >= 0. && value < internal::infinity) << method << ' ' << length;
    }
  }
}

} // namespace needle_triangles
