// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Three and more sources, some of them neighbours, one of them twice.
const std::vector<std::vector<Index>> choices = {
    {0, 1, 2}, {70, 71, 84, 85}, {70, 70, 71}, {0, 12, 168, 156, 84}, {3, 4, 5, 6, 7, 8}};

TEST(Adjacent_sources, are_each_the_source_of_its_own_cell)
{
  const Triangulation plane = square(12, 0.24, 5);
  const Glued_surface surface(plane);
  for(const auto& choice : choices)
  {
    std::vector<internal::Source> sources;
    for(const Index source : choice)
      sources.push_back(surface.source(source, 0., Index(sources.size())));
    internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
    front.run(sources);
    const auto d = surface.distances(front);
    for(Index i = 0; i < surface.size(); ++i)
    {
      double truth = internal::infinity;
      for(const Index source : choice)
        truth = std::min(truth, distance(plane.points[i], plane.points[source]));
      // Along the borders of cells a part of a side is lost.
      EXPECT_NEAR(d[i], truth, 0.25 / 12.);
      const Index nearest = front.source(surface.site(i));
      ASSERT_LT(nearest, choice.size());
      EXPECT_NEAR(distance(plane.points[i], plane.points[choice[nearest]]), d[i], 0.25 / 12.);
    }
  }
}

TEST(Adjacent_sources, are_as_near_as_the_nearest_alone)
{
  const Triangulation sphere = shaken(icosphere(2), 0.02);
  const Glued_surface surface(sphere);
  for(const auto& choice : choices)
    for(const Method method : fronts)
    {
      std::vector<internal::Source> sources;
      std::vector<double> alone(surface.size(), internal::infinity);
      for(Index source : choice)
      {
        source = source % surface.size();
        sources.push_back(surface.source(source, 0., Index(sources.size())));
        const auto d = distances(surface, method, {surface.source(source)});
        for(Index i = 0; i < surface.size(); ++i)
          alone[i] = std::min(alone[i], d[i]);
      }
      // Where two fronts meet, a triangle is passed by neither: the loss is a part of a side (0.3)
      // for planar fronts, and less for Euclidean ones, which know where they come from.
      const double error = method == Method::dijkstra        ? rounding
                           : method == Method::fast_marching ? 0.1
                                                             : 0.05;
      const auto together = distances(surface, method, sources);
      EXPECT_LT(largest_error(together, [&](Index i) { return alone[i]; }), error) << method;
      for(const Index source : choice)
        EXPECT_EQ(together[source % surface.size()], 0.);
    }
}

TEST(Adjacent_sources, are_all_at_zero_for_heat)
{
  // A site and its ring.
  const Triangulation sphere = icosphere(3);
  const Glued_surface surface(sphere);
  std::vector<internal::Source> sources;
  for(Index i = 0; i < surface.size(); ++i)
    if(distance(sphere.points[i], sphere.points[300]) < 0.2)
      sources.push_back(surface.source(i, 0., Index(sources.size())));
  ASSERT_EQ(sources.size(), 7u);
  const auto heat = distances(surface, Method::heat, sources);
  const auto front = distances(surface, Method::euclidean_front, sources);
  // The mean over the sources is right, each one and what is far away by less than a side (0.14).
  for(Index i = 0; i < surface.size(); ++i)
    EXPECT_NEAR(heat[i], front[i], 0.1);
}

} // namespace
