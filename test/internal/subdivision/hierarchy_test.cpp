// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/hierarchy.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace hierarchy_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns the triangles as a set, independent of their order and of their first corners.
std::set<Triangle> as_set(const std::vector<Triangle>& triangles)
{
  std::set<Triangle> result;
  for(Triangle t : triangles)
  {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    result.insert(t);
  }
  return result;
}

TEST(Hierarchy, recovers_subdivision_with_same_indices)
{
  for(const Triangulation& surface :
      {icosphere(0), square(3), annulus(5, 2, 1., 2.), tetrahedron()})
  {
    const Subdivision s = subdivided(surface, 3);
    const Hierarchy h = recover_hierarchy(s.finest().triangles, s.number_of_vertices(), 3);
    ASSERT_EQ(h.subdivision->levels.size(), 4u);
    for(std::size_t j = 0; j < 4; ++j)
      EXPECT_EQ(h.subdivision->levels[j].triangles, s.levels[j].triangles);
    for(Index v = 0; v < s.number_of_vertices(); ++v)
      EXPECT_EQ(h.input_vertex[v], v);
  }
}

TEST(Hierarchy, does_not_depend_on_order)
{
  std::mt19937 random(1);
  for(const Triangulation& surface : {icosphere(0), square(3), annulus(5, 2, 1., 2.)})
  {
    const Subdivision s = subdivided(surface, 2);
    std::vector<Index> permutation(s.number_of_vertices());
    std::iota(permutation.begin(), permutation.end(), 0u);
    std::shuffle(permutation.begin(), permutation.end(), random);
    std::vector<Triangle> triangles = s.finest().triangles;
    std::shuffle(triangles.begin(), triangles.end(), random);
    for(Triangle& t : triangles)
    {
      for(Index& v : t)
        v = permutation[v];
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    const Hierarchy h = recover_hierarchy(triangles, s.number_of_vertices(), 2);
    ASSERT_EQ(h.subdivision->levels.size(), 3u);
    std::vector<Triangle> found = h.subdivision->finest().triangles;
    for(Triangle& t : found)
      for(Index& v : t)
        v = h.input_vertex[v];
    EXPECT_EQ(as_set(found), as_set(triangles));
    std::vector<Index> sorted = h.input_vertex;
    std::sort(sorted.begin(), sorted.end());
    for(Index v = 0; v < sorted.size(); ++v)
      EXPECT_EQ(sorted[v], v);
  }
}

TEST(Hierarchy, respects_max_number_of_levels)
{
  const Subdivision s = subdivided(icosphere(0), 3);
  for(const unsigned max_levels : {0u, 1u, 2u, 3u, 9u})
    EXPECT_EQ(recover_hierarchy(s.finest().triangles, s.number_of_vertices(), max_levels)
                  .subdivision->levels.size(),
              1u + std::min(max_levels, 3u));
  // The octahedron is not a subdivision, although its faces can be partitioned into groups of four:
  // one vertex would be both a corner and a midpoint.
  const std::vector<Triangle> octahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                            {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
  EXPECT_EQ(recover_hierarchy(octahedron, 6, 9).subdivision->levels.size(), 1u);
  EXPECT_EQ(recover_hierarchy({}, 6, 9).input_vertex.size(), 6u);
}

TEST(Hierarchy, is_limited_by_component_with_fewest_levels)
{
  // Two components with two levels and one level, and an isolated vertex.
  const Subdivision a = subdivided(icosphere(0), 2), b = subdivided(icosphere(0), 1);
  std::vector<Triangle> triangles = a.finest().triangles;
  for(Triangle t : b.finest().triangles)
  {
    for(Index& v : t)
      v += a.number_of_vertices();
    triangles.push_back(t);
  }
  const Index n = a.number_of_vertices() + b.number_of_vertices() + 1;
  const Hierarchy h = recover_hierarchy(triangles, n, 9);
  EXPECT_EQ(h.subdivision->levels.size(), 2u);
  EXPECT_EQ(h.input_vertex.size(), n);
}

TEST(Hierarchy, edge_flip_destroys_hierarchy)
{
  // Flip one edge.
  const Subdivision s = subdivided(icosphere(0), 2);
  std::vector<Triangle> triangles = s.finest().triangles;
  const Index h = 3 * 17, twin = s.finest().twin[h];
  const auto [a, b] = edge_vertices(s.finest(), h);
  const Index c = opposite_vertex(s.finest(), h), d = opposite_vertex(s.finest(), twin);
  triangles[h / 3] = {c, a, d};
  triangles[twin / 3] = {d, b, c};
  EXPECT_EQ(recover_hierarchy(triangles, s.number_of_vertices(), 9).subdivision->levels.size(), 1u);
}

} // namespace hierarchy_test
