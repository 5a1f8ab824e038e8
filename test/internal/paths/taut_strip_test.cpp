// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/taut_strip.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The sides of a strip with the fewest triangles.
std::vector<Index> rough_strip(const Divided_mesh& mesh, Index from, Index to)
{
  const Glued_triangles& t = mesh.triangles();
  std::vector<Index> entry(t.number_of_triangles(), none);
  std::vector<bool> is_seen(t.number_of_triangles(), false);
  std::queue<Index> waiting;
  for(const Index corner : mesh.corners_around(from))
  {
    is_seen[corner / 3] = true;
    waiting.push(corner / 3);
  }
  while(!waiting.empty())
  {
    const Index f = waiting.front();
    waiting.pop();
    if(std::find(&t.corner[3 * f], &t.corner[3 * f] + 3, to) != &t.corner[3 * f] + 3)
    {
      std::vector<Index> result;
      for(Index at = f; entry[at] != none; at = entry[at] / 3)
        result.push_back(entry[at]);
      std::reverse(result.begin(), result.end());
      return result;
    }
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
      if(const Index twin = t.twin[side]; twin != none && !is_seen[twin / 3])
      {
        is_seen[twin / 3] = true;
        entry[twin / 3] = side;
        waiting.push(twin / 3);
      }
  }
  return {};
}

std::vector<Spatial> places(const Divided_mesh& mesh, Index from, Index to, const Taut_strip& strip)
{
  const std::vector<Spatial>& point = mesh.triangles().point;
  std::vector<Spatial> result = {point[from]};
  for(std::size_t i = 0; i < strip.sides.size(); ++i)
    result.push_back((1. - strip.shares[i]) * point[mesh.source(strip.sides[i])] +
                     strip.shares[i] * point[mesh.target(strip.sides[i])]);
  result.push_back(point[to]);
  return result;
}

double length(const std::vector<Spatial>& path)
{
  double result = 0.;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    result += norm(path[i + 1] - path[i]);
  return result;
}

// What keeping off sites can cost: at most two margins at each side.
double slack(const Divided_mesh& mesh, const Taut_strip& strip)
{
  double result = 0.;
  for(const Index side : strip.sides)
    result += 2. * Divided_mesh::margin * mesh.length(side);
  return result;
}

void expect_is_strip(const Divided_mesh& mesh, Index from, Index to, const Taut_strip& strip)
{
  const Glued_triangles& t = mesh.triangles();
  ASSERT_EQ(strip.shares.size(), strip.sides.size());
  ASSERT_FALSE(strip.sides.empty());
  EXPECT_EQ(mesh.apex(strip.sides.front()), from);
  EXPECT_EQ(mesh.apex(t.twin[strip.sides.back()]), to);
  for(std::size_t i = 0; i + 1 < strip.sides.size(); ++i)
  {
    EXPECT_EQ(t.twin[strip.sides[i]] / 3, strip.sides[i + 1] / 3);
    EXPECT_NE(t.twin[strip.sides[i]], strip.sides[i + 1]);
  }
  for(const double share : strip.shares)
  {
    EXPECT_GE(share, Divided_mesh::margin);
    EXPECT_LE(share, 1. - Divided_mesh::margin);
  }
}

TEST(Taut_strip, is_straight_in_the_plane_and_shortest_on_a_sphere)
{
  std::mt19937 random(1);
  for(const Triangulation& points : {shaken(square(12), 0.02, 3), icosphere(2)})
  {
    const Glued_surface surface(points);
    const std::vector<bool> none_of(surface.t().corner.size(), false);
    const Divided_mesh mesh(surface.t(), none_of);
    const Index n = surface.t().number_of_sites();
    const std::vector<bool> is_barred(n, false);
    int found = 0;
    for(int i = 0; i < 60; ++i)
    {
      const Index from = Index(random() % n), to = Index(random() % n);
      const std::vector<Index> rough = rough_strip(mesh, from, to);
      if(from == to || rough.empty())
        continue;
      const Taut_strip strip = taut_strip(mesh, is_barred, from, to, rough);
      if(strip.sides.empty())
        continue;
      expect_is_strip(mesh, from, to, strip);
      Window_propagation windows(surface.triangles());
      windows.run({surface.source(surface.point_of_site(from))});
      const double exact = windows.distance(to), own = length(places(mesh, from, to, strip));
      EXPECT_GE(own, exact * (1. - 1e-12)); // a sum of as many roundings as sides
      // On a sphere it can be a longer geodesic, around another side of its few creases.
      EXPECT_LE(own, 1.02 * exact + slack(mesh, strip));
      ++found;
    }
    EXPECT_GT(found, 20);
  }
}

TEST(Taut_strip, stays_on_its_side_of_what_is_barred)
{
  const Glued_surface surface(grid(4, 4,
                                   [](double x, double y) {
                                     return Point{x, y + 0.2 * x * (1. - x), 0.};
                                   }));
  const Divided_mesh mesh(surface.t(), std::vector<bool>(surface.t().corner.size(), false));
  const Index n = surface.t().number_of_sites();
  for(Index a = 0; a < n; ++a)
    for(Index b = a + 1; b < n; ++b)
    {
      const std::vector<Index> rough = rough_strip(mesh, a, b);
      const Taut_strip free = taut_strip(mesh, std::vector<bool>(n, false), a, b, rough),
                       held = taut_strip(mesh, std::vector<bool>(n, true), a, b, rough);
      if(free.sides.empty() || held.sides.empty())
        continue;
      expect_is_strip(mesh, a, b, held);
      EXPECT_LE(length(places(mesh, a, b, free)),
                length(places(mesh, a, b, held)) + slack(mesh, free));
      // Not led around any site, it has no side that the rough one has not.
      for(const Index side : held.sides)
        EXPECT_NE(std::find(rough.begin(), rough.end(), side), rough.end());
    }
}

} // namespace
