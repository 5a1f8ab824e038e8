// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

namespace adjacent_sources {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Sets of at least three sources. Some sources are adjacent, and one set contains a source twice.
const std::vector<std::vector<Index>> source_sets = {
    {0, 1, 2}, {70, 71, 84, 85}, {70, 70, 71}, {0, 12, 168, 156, 84}, {3, 4, 5, 6, 7, 8}};

TEST(Adjacent_sources, label_their_own_voronoi_cells)
{
  const Triangulation plane = square(12, 0.24, 5);
  const Array_surface surface(plane);
  for(const auto& source_set : source_sets)
  {
    std::vector<internal::Front_source> sources;
    for(const Index source : source_set)
      sources.push_back(surface.source(source, 0., Index(sources.size())));
    internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
    front.run(sources);
    const auto d = surface.distances(front);
    for(Index i = 0; i < surface.size(); ++i)
    {
      double expected = internal::infinity;
      for(const Index source : source_set)
        expected = std::min(expected, distance(plane.points[i], plane.points[source]));
      // At cell boundaries, the error is a fraction of an edge length.
      const double error = 0.25 / 12.;
      EXPECT_NEAR(d[i], expected, error);
      const Index nearest = front.source(surface.vertex(i));
      ASSERT_LT(nearest, source_set.size());
      EXPECT_NEAR(distance(plane.points[i], plane.points[source_set[nearest]]), d[i], error);
    }
  }
}

TEST(Adjacent_sources, distance_is_minimum_over_single_sources)
{
  const Triangulation sphere = jittered(icosphere(2), 0.02);
  const Array_surface surface(sphere);
  for(const auto& source_set : source_sets)
    for(const Method method : fronts)
    {
      std::vector<internal::Front_source> sources;
      std::vector<double> min_over_single_sources(surface.size(), internal::infinity);
      for(Index source : source_set)
      {
        source = source % surface.size();
        sources.push_back(surface.source(source, 0., Index(sources.size())));
        const auto d = distances(surface, method, {surface.source(source)});
        for(Index i = 0; i < surface.size(); ++i)
          min_over_single_sources[i] = std::min(min_over_single_sources[i], d[i]);
      }
      // Neither of two meeting fronts crosses the triangle between them. The error is a fraction
      // of the edge length 0.3 for planar fronts. It is smaller for Euclidean fronts, which know
      // their origin.
      const double error = method == Method::dijkstra        ? round_off_tolerance
                           : method == Method::fast_marching ? 0.1
                                                             : 0.05;
      const auto joint_distances = distances(surface, method, sources);
      EXPECT_LT(largest_error(joint_distances, [&](Index i) { return min_over_single_sources[i]; }),
                error)
          << method;
      for(const Index source : source_set)
        EXPECT_EQ(joint_distances[source % surface.size()], 0.);
    }
}

TEST(Adjacent_sources, have_small_distance_with_heat_method)
{
  // A vertex and its one-ring.
  const Triangulation sphere = icosphere(3);
  const Array_surface surface(sphere);
  std::vector<internal::Front_source> sources;
  for(Index i = 0; i < surface.size(); ++i)
    if(distance(sphere.points[i], sphere.points[300]) < 0.2)
      sources.push_back(surface.source(i, 0., Index(sources.size())));
  ASSERT_EQ(sources.size(), 7u);
  const auto heat = distances(surface, Method::heat, sources);
  const auto front = distances(surface, Method::euclidean_front, sources);
  // The mean over the sources is accurate. At single sources and far away, the error is less than
  // the edge length 0.14.
  for(Index i = 0; i < surface.size(); ++i)
    EXPECT_NEAR(heat[i], front[i], 0.1);
}

} // namespace adjacent_sources
