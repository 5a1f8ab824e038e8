// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace subdivision_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Surfaces without and with boundary, an annulus, and two components with an isolated vertex.
std::vector<Triangulation> surfaces()
{
  Triangulation two = tetrahedron();
  const Index n = Index(two.points.size());
  for(const Point& p : tetrahedron().points)
    two.points.push_back(p);
  for(const Index c : tetrahedron().corners)
    two.corners.push_back(n + c);
  two.points.push_back({9., 9., 9.});
  return {one_triangle(), tetrahedron(), icosphere(0), square(3), annulus(5, 2, 1., 2.), two};
}

std::vector<Index> corners_of(const std::vector<Triangle>& triangles)
{
  std::vector<Index> result;
  for(const Triangle& t : triangles)
    result.insert(result.end(), t.begin(), t.end());
  return result;
}

TEST(Subdivision, numbers_vertices_and_triangles_as_documented)
{
  // The midpoints of the edges 0, 1, 2 are the vertices 3, 4, 5.
  const Subdivision s = subdivided(one_triangle(), 1);
  ASSERT_EQ(s.levels.size(), 2u);
  EXPECT_EQ(s.levels[0].midpoint, (std::vector<Index>{3, 4, 5}));
  EXPECT_EQ(s.levels[1].triangles,
            (std::vector<Triangle>{{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {4, 5, 3}}));
  EXPECT_EQ(s.parents,
            (std::vector<std::array<Index, 2>>{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}));
}

TEST(Subdivision, counts_match_euler_characteristic)
{
  for(const Triangulation& surface : surfaces())
  {
    const Subdivision s = subdivided(surface, 3);
    for(std::size_t j = 0; j + 1 < s.levels.size(); ++j)
    {
      const Subdivision::Level &level = s.levels[j], &next = s.levels[j + 1];
      std::size_t edges = 0;
      for(Index h = 0; h < level.twin.size(); ++h)
        edges += is_edge_representative(level, h);
      EXPECT_EQ(next.triangles.size(), 4 * level.triangles.size());
      EXPECT_EQ(next.number_of_vertices, level.number_of_vertices + edges);
    }
    EXPECT_EQ(s.parents.size(), s.number_of_vertices());
  }
}

// The twins of a refined level equal those that are computed from its triangles.
TEST(Subdivision, twins_match_triangle_soup)
{
  for(const Triangulation& surface : surfaces())
  {
    const Subdivision s = subdivided(surface, 3);
    for(const Subdivision::Level& level : s.levels)
      EXPECT_EQ(level.twin, twins_of_soup(level.number_of_vertices, corners_of(level.triangles)));
  }
}

TEST(Subdivision, levels_are_prefixes_and_parents_are_edge_vertices)
{
  for(const Triangulation& surface : surfaces())
  {
    const Subdivision s = subdivided(surface, 3);
    for(std::size_t j = 0; j < s.levels.size(); ++j)
    {
      const Subdivision::Level& level = s.levels[j];
      for(const Index v : corners_of(level.triangles))
        EXPECT_LT(v, level.number_of_vertices);
      if(j + 1 == s.levels.size())
        break;
      for(Index h = 0; h < level.twin.size(); ++h)
      {
        const Index m = level.midpoint[h];
        EXPECT_GE(m, level.number_of_vertices);
        EXPECT_LT(m, s.levels[j + 1].number_of_vertices);
        auto parents = s.parents[m], expected_parents = edge_vertices(level, h);
        std::sort(parents.begin(), parents.end());
        std::sort(expected_parents.begin(), expected_parents.end());
        EXPECT_EQ(parents, expected_parents);
      }
      // Corner k of triangle f is corner k of triangle 4f+k; child 3 is the central one.
      for(Index f = 0; f < level.triangles.size(); ++f)
        for(Index k = 0; k < 3; ++k)
        {
          EXPECT_EQ(s.levels[j + 1].triangles[4 * f + k][k], level.triangles[f][k]);
          EXPECT_GE(s.levels[j + 1].triangles[4 * f + 3][k], level.number_of_vertices);
        }
    }
  }
}

// The position of a vertex from its parents equals that from its location in the base triangle.
TEST(Subdivision, coarse_locations_match_midpoints)
{
  for(const Triangulation& surface : surfaces())
  {
    const unsigned times = 4;
    const Subdivision s = subdivided(surface, times);
    std::vector<Point> points = surface.points;
    for(Index v = Index(points.size()); v < s.number_of_vertices(); ++v)
    {
      const Point &a = points[s.parents[v][0]], &b = points[s.parents[v][1]];
      points.push_back({(a[0] + b[0]) / 2., (a[1] + b[1]) / 2., (a[2] + b[2]) / 2.});
    }
    const std::vector<Coarse_location> locations = coarse_locations(s);
    std::vector<bool> is_used(s.number_of_vertices(), false);
    for(const Index v : corners_of(s.finest().triangles))
      is_used[v] = true;
    for(Index v = 0; v < s.number_of_vertices(); ++v)
    {
      ASSERT_EQ(locations[v].triangle != none, is_used[v]);
      if(!is_used[v])
        continue;
      const auto& c = locations[v].coordinates;
      EXPECT_EQ(c[0] + c[1] + c[2], Index(1) << times);
      for(int x = 0; x < 3; ++x)
      {
        double coordinate = 0.;
        for(int k = 0; k < 3; ++k)
          coordinate +=
              c[k] / 16. * surface.points[s.levels[0].triangles[locations[v].triangle][k]][x];
        // Round-off errors of sums of three coordinates up to 2.
        EXPECT_NEAR(coordinate, points[v][x], 1e-14);
      }
    }
  }
}

TEST(Subdivision, throws_on_invalid_surface)
{
  const auto expect_throws = [](const std::vector<Triangle>& triangles, Index n, unsigned times = 1)
  {
    EXPECT_THROW(subdivide(triangles, n, times), Invalid_argument_error);
    EXPECT_THROW(subdivide_into_quads(triangles, n, times + 1), Invalid_argument_error);
  };
  expect_throws({{0, 1, 1}}, 2);
  expect_throws({{0, 1, 3}}, 3);
  expect_throws({{0, 1, 2}, {0, 1, 3}}, 4);            // inconsistent orientation
  expect_throws({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5); // three triangles at an edge
  expect_throws({{0, 1, 2}}, 3, 15);
  expect_throws({}, 3, 40);
  EXPECT_THROW(subdivide_into_quads({{0, 1, 2}}, 3, 0), Invalid_argument_error);
  EXPECT_EQ(subdivide({}, 3, 2).number_of_vertices(), 3u);
  EXPECT_EQ(subdivide({{0, 1, 2}, {0, 2, 1}}, 3, 2).finest().triangles.size(), 32u); // a pillow
}

TEST(Subdivision, is_halfedge_mesh_unless_interior_vertex_is_pinched)
{
  for(const Triangulation& surface : surfaces())
    EXPECT_TRUE(is_halfedge_mesh(subdivided(surface, 1).finest()));
  EXPECT_TRUE(is_halfedge_mesh(subdivide({{0, 1, 2}, {0, 3, 4}}, 5, 0).finest())); // two fans at 0
  // Two tetrahedra, or a tetrahedron and a triangle, with the common vertex 0.
  const std::vector<Triangle> tetrahedron = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  std::vector<Triangle> two = tetrahedron;
  for(Triangle t : tetrahedron)
  {
    for(Index& v : t)
      v += v > 0 ? 3 : 0;
    two.push_back(t);
  }
  EXPECT_FALSE(is_halfedge_mesh(subdivide(two, 7, 0).finest()));
  std::vector<Triangle> kite = tetrahedron;
  kite.push_back({0, 4, 5});
  EXPECT_FALSE(is_halfedge_mesh(subdivide(kite, 6, 1).finest()));
}

TEST(Subdivision_into_quads, counts_match_euler_characteristic_and_halfedges_are_unique)
{
  for(const Triangulation& surface : surfaces())
  {
    const std::vector<Triangle> triangles = triangles_of(surface);
    const Subdivision s = subdivided(surface, 1);
    const Quad_subdivision q = subdivide_into_quads(triangles, Index(surface.points.size()), 3);
    ASSERT_EQ(q.levels.size(), 3u);
    ASSERT_EQ(q.number_of_vertices[0], s.number_of_vertices() + triangles.size());
    for(std::size_t j = 0; j < 3; ++j)
    {
      EXPECT_EQ(q.levels[j].size(), triangles.size() * 3 << (2 * j));
      std::map<std::array<Index, 2>, int> halfedges;
      for(const Quad& quad : q.levels[j])
        for(int k = 0; k < 4; ++k)
        {
          EXPECT_LT(quad[k], q.number_of_vertices[j]);
          EXPECT_EQ((++halfedges[{quad[k], quad[(k + 1) % 4]}]), 1); // consistent orientation
        }
      std::set<std::array<Index, 2>> edges;
      for(const auto& [h, number] : halfedges)
        edges.insert({std::min(h[0], h[1]), std::max(h[0], h[1])});
      if(j == 2)
        break;
      EXPECT_EQ(q.number_of_vertices[j + 1],
                q.number_of_vertices[j] + edges.size() + q.levels[j].size());
    }
    EXPECT_EQ(q.locations.size(), q.number_of_vertices.back());
    EXPECT_EQ(q.parents.size(), q.number_of_vertices.back());
  }
}

TEST(Subdivision_into_quads, coarse_locations_match_centroids)
{
  for(const Triangulation& surface : surfaces())
  {
    const std::vector<Triangle> triangles = triangles_of(surface);
    const Quad_subdivision q = subdivide_into_quads(triangles, Index(surface.points.size()), 4);
    const double denominator = 6. * 64.;
    std::vector<Point> points = surface.points;
    for(Index v = Index(points.size()); v < q.parents.size(); ++v)
    {
      Point p = {0., 0., 0.};
      for(const Index parent : q.parents[v])
        for(int x = 0; x < 3; ++x)
          p[x] += points[parent][x] / double(q.parents[v].size());
      points.push_back(p);
    }
    for(Index v = 0; v < q.parents.size(); ++v)
    {
      if(q.locations[v].triangle == none)
        continue;
      const auto& c = q.locations[v].coordinates;
      EXPECT_EQ(c[0] + c[1] + c[2], Index(denominator));
      for(int x = 0; x < 3; ++x)
      {
        double coordinate = 0.;
        for(int k = 0; k < 3; ++k)
          coordinate +=
              c[k] / denominator * surface.points[triangles[q.locations[v].triangle][k]][x];
        EXPECT_NEAR(coordinate, points[v][x], 1e-14); // round-off errors as above
      }
    }
  }
}

} // namespace subdivision_test
