// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace repeated_queries {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

template <typename Engine>
void expect_independent_queries(const Array_surface& surface, Engine engine)
{
  const Engine prepared = engine;
  for(const Index source : {0u, 77u, 0u, 161u, 77u})
  {
    Engine fresh = prepared;
    fresh.run({surface.source(source)});
    engine.run({surface.source(source)});
    EXPECT_EQ(surface.distances(engine), surface.distances(fresh));
    // Heat is accurate in the mean over its sources. Here, there is one source.
    EXPECT_NEAR(engine.distance(surface.vertex(source)), 0., round_off_tolerance);
    for(Index i = 0; i < surface.size(); ++i)
    {
      EXPECT_LT(engine.distance(surface.vertex(i)), internal::infinity);
      EXPECT_EQ(engine.distance(surface.vertex(i)) > 0., i != source);
    }
  }
}

TEST(Repeated_queries, distances_are_independent_of_previous_queries)
{
  const Array_surface surface(icosphere(2));
  for(const Method method : fronts)
    expect_independent_queries(surface, internal::Front(surface.triangles(), kind_of(method)));
  expect_independent_queries(surface, internal::Heat_solver(surface.triangles()));
}

TEST(Repeated_queries, paths_are_independent_of_previous_queries)
{
  const Array_surface surface(icosphere(2));
  const Surface_arrays& t = *surface.triangles();
  internal::Path_finder finder(surface.triangles());
  for(const auto& [from, to] : {std::pair<Index, Index>(0, 77), {77, 0}, {5, 5}, {0, 77}, {161, 3}})
  {
    internal::Path_finder fresh(surface.triangles());
    const auto geodesic = finder(surface.at(from), surface.at(to)),
               expected = fresh(surface.at(from), surface.at(to));
    ASSERT_EQ(geodesic.size(), expected.size());
    for(std::size_t i = 0; i < geodesic.size(); ++i)
      EXPECT_TRUE(internal::is_same_point(t, internal::canonical(t, geodesic[i]),
                                          internal::canonical(t, expected[i])));
  }
}

// Checks that all corners of a regular solid have the same sorted distances, possibly at other
// vertices.
// tolerance  the differences that the triangulation or a solver causes
void expect_symmetry(const Triangulation& shape, Index number_of_corners, double tolerance)
{
  const Array_surface surface(shape);
  for(const Method method : all_methods)
  {
    std::vector<double> first;
    for(Index corner = 0; corner < number_of_corners; ++corner)
    {
      auto d = distances(surface, method, {surface.source(corner)});
      for(const double value : d)
        EXPECT_TRUE(value >= 0. && value < internal::infinity) << method;
      std::sort(d.begin(), d.end());
      if(first.empty())
        first = d;
      EXPECT_LT(largest_error(d, [&](Index i) { return first[i]; }), tolerance) << method;
    }
  }
}

TEST(Repeated_queries, distances_are_symmetric_on_tetrahedron)
{
  expect_symmetry(tetrahedron(), 4, 1e-9); // round-off error of a solve
}

TEST(Repeated_queries, distances_are_symmetric_on_icosahedron)
{
  expect_symmetry(icosphere(0), 12, 1e-9);
}

TEST(Repeated_queries, distances_are_symmetric_on_icosphere)
{
  // Round-off errors decide which of two equally short paths arrives first, and thus the front's
  // direction. After many such meetings, the error is a tenth of the edge length 0.14.
  expect_symmetry(icosphere(3), 12, 0.014);
}

TEST(Repeated_queries, distances_from_corners_are_exact_on_grid)
{
  const Index n = 10;
  const Triangulation plane = square(n);
  const Array_surface surface(plane);
  for(const Index source : {0u, n, n * (n + 1), (n + 1) * (n + 1) - 1, (n + 1) * n / 2 + n / 2})
    EXPECT_LT(largest_error(distances(surface, Method::euclidean_front, {surface.source(source)}),
                            [&](Index i)
                            { return distance(plane.points[i], plane.points[source]); }),
              front_tolerance);
}

} // namespace repeated_queries
