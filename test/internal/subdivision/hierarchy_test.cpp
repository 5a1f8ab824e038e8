// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/hierarchy.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "subdivided.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Triangles by their vertices, whatever their order.
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

TEST(Hierarchy, of_a_subdivision_is_the_same_numbers)
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
      EXPECT_EQ(h.vertex[v], v);
  }
}

TEST(Hierarchy, is_found_in_any_order)
{
  std::mt19937 random(1);
  for(const Triangulation& surface : {icosphere(0), square(3), annulus(5, 2, 1., 2.)})
  {
    const Subdivision s = subdivided(surface, 2);
    std::vector<Index> number(s.number_of_vertices());
    std::iota(number.begin(), number.end(), 0u);
    std::shuffle(number.begin(), number.end(), random);
    std::vector<Triangle> triangles = s.finest().triangles;
    std::shuffle(triangles.begin(), triangles.end(), random);
    for(Triangle& t : triangles)
    {
      for(Index& v : t)
        v = number[v];
      std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    }
    const Hierarchy h = recover_hierarchy(triangles, s.number_of_vertices(), 2);
    ASSERT_EQ(h.subdivision->levels.size(), 3u);
    std::vector<Triangle> found = h.subdivision->finest().triangles;
    for(Triangle& t : found)
      for(Index& v : t)
        v = h.vertex[v];
    EXPECT_EQ(as_set(found), as_set(triangles));
    std::vector<Index> each = h.vertex;
    std::sort(each.begin(), each.end());
    for(Index v = 0; v < each.size(); ++v)
      EXPECT_EQ(each[v], v);
  }
}

TEST(Hierarchy, goes_as_far_as_asked_and_as_there_is)
{
  const Subdivision s = subdivided(icosphere(0), 3);
  for(const unsigned most : {0u, 1u, 2u, 3u, 9u})
    EXPECT_EQ(recover_hierarchy(s.finest().triangles, s.number_of_vertices(), most)
                  .subdivision->levels.size(),
              1u + std::min(most, 3u));
  // The octahedron is no subdivision, though its faces can be taken in fours: a corner would be a midpoint.
  const std::vector<Triangle> octahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1},
                                            {5, 2, 1}, {5, 3, 2}, {5, 4, 3}, {5, 1, 4}};
  EXPECT_EQ(recover_hierarchy(octahedron, 6, 9).subdivision->levels.size(), 1u);
  EXPECT_EQ(recover_hierarchy({}, 6, 9).vertex.size(), 6u);
}

TEST(Hierarchy, of_several_pieces_ends_with_the_first_of_them)
{
  // An icosphere of two levels beside one of one level, and a vertex alone.
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
  EXPECT_EQ(h.vertex.size(), n);
}

TEST(Hierarchy, is_lost_by_one_flip)
{
  // The two triangles at one edge, joined the other way.
  const Subdivision s = subdivided(icosphere(0), 2);
  std::vector<Triangle> triangles = s.finest().triangles;
  const Index side = 3 * 17, twin = s.finest().twin[side];
  const auto [a, b] = ends(s.finest(), side);
  const Index c = opposite(s.finest(), side), d = opposite(s.finest(), twin);
  triangles[side / 3] = {c, a, d};
  triangles[twin / 3] = {d, b, c};
  EXPECT_EQ(recover_hierarchy(triangles, s.number_of_vertices(), 9).subdivision->levels.size(), 1u);
}

} // namespace
