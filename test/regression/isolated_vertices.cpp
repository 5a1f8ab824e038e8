// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <gtest/gtest.h>

namespace isolated_vertices {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Returns two components and three isolated vertices: with the first index, between the
// components, and with the last index.
Triangulation mesh_with_isolated_vertices(Index& first, Index& middle, Index& last)
{
  Triangulation result;
  result.points.push_back({5., 5., 5.});
  result = disjoint_union(result, tetrahedron());
  first = 0;
  middle = Index(result.points.size());
  result.points.push_back({6., 5., 5.});
  result = disjoint_union(result, square(4, 0.2));
  last = Index(result.points.size());
  result.points.push_back({6., 5., 5.}); // a duplicate of the second isolated vertex
  return result;
}

TEST(Isolated_vertices, are_infinitely_far)
{
  Index first, middle, last;
  const Array_surface surface(mesh_with_isolated_vertices(first, middle, last));
  for(const Method method : all_methods)
  {
    const auto d = distances(surface, method, {surface.source(1)});
    for(Index i = 0; i < surface.size(); ++i)
      EXPECT_EQ(d[i] >= 0. && d[i] < internal::infinity, i >= 1 && i < middle) << method;
  }
}

TEST(Isolated_vertices, are_reached_from_themselves_only)
{
  Index first, middle, last;
  const Array_surface surface(mesh_with_isolated_vertices(first, middle, last));
  for(const Method method : all_methods)
    for(const Index source : {first, middle, last})
    {
      const auto d = distances(surface, method, {surface.source(source, 0.5)});
      for(Index i = 0; i < surface.size(); ++i)
        EXPECT_EQ(d[i], i == source ? 0.5 : internal::infinity) << method;
    }
}

TEST(Isolated_vertices, do_not_affect_other_sources)
{
  Index first, middle, last;
  const Array_surface surface(mesh_with_isolated_vertices(first, middle, last));
  for(const Method method : all_methods)
  {
    const auto all = distances(
        surface, method,
        {surface.source(first), surface.source(1, 0., 1), surface.source(middle + 3, 0., 2)});
    const auto one = distances(surface, method, {surface.source(1)}),
               other = distances(surface, method, {surface.source(middle + 3)});
    for(Index i = 0; i < surface.size(); ++i)
    {
      const double expected = i == first ? 0. : std::min(one[i], other[i]);
      // Infinity must match exactly. A linear solve has round-off errors that depend on its whole
      // right-hand side.
      EXPECT_TRUE(all[i] == expected || std::abs(all[i] - expected) < 1e-9) << method;
    }
    EXPECT_EQ(all[middle], internal::infinity);
    EXPECT_EQ(all[last], internal::infinity);
  }
}

TEST(Isolated_vertices, are_accepted_without_faces)
{
  const Array_surface surface({{{0., 0., 0.}, {1., 0., 0.}, {1., 0., 0.}}, {}});
  for(const Method method : all_methods)
    EXPECT_EQ(distances(surface, method, {surface.source(1)}),
              (std::vector<double>{internal::infinity, 0., internal::infinity}))
        << method;
}

TEST(Isolated_vertices, have_no_path)
{
  Index first, middle, last;
  const Array_surface surface(mesh_with_isolated_vertices(first, middle, last));
  const std::vector<internal::Front_source> sources = {surface.source(1)};
  internal::Front front(surface.triangles(), internal::Front_kind::euclidean);
  front.run(sources);
  for(const Index from : {first, middle, last, middle + 1})
    EXPECT_TRUE(path(*surface.triangles(), front, sources, surface.at(from)).empty());
  EXPECT_FALSE(path(*surface.triangles(), front, sources, surface.at(2)).empty());
}

} // namespace isolated_vertices
