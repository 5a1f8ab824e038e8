// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_in_strip.h"

#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <random>

namespace shorten_in_strip_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Returns the edges crossed by the strip with the fewest triangles between two vertices.
std::vector<Index> shortest_strip(const Split_mesh& mesh, Index from, Index to)
{
  const Surface_arrays& t = mesh.triangles();
  std::vector<Index> entry_halfedge(t.number_of_triangles(), none);
  std::vector<bool> is_seen(t.number_of_triangles(), false);
  std::queue<Index> queue;
  for(const Index corner : mesh.corners_around(from))
  {
    is_seen[corner / 3] = true;
    queue.push(corner / 3);
  }
  while(!queue.empty())
  {
    const Index f = queue.front();
    queue.pop();
    if(std::find(&t.corner[3 * f], &t.corner[3 * f] + 3, to) != &t.corner[3 * f] + 3)
    {
      std::vector<Index> result;
      for(Index current = f; entry_halfedge[current] != none; current = entry_halfedge[current] / 3)
        result.push_back(entry_halfedge[current]);
      std::reverse(result.begin(), result.end());
      return result;
    }
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(const Index twin = t.twin[h]; twin != none && !is_seen[twin / 3])
      {
        is_seen[twin / 3] = true;
        entry_halfedge[twin / 3] = h;
        queue.push(twin / 3);
      }
  }
  return {};
}

std::vector<Vec3> points_along(const Split_mesh& mesh, Index from, Index to,
                               const Strip_path& strip)
{
  const std::vector<Vec3>& point = mesh.triangles().point;
  std::vector<Vec3> result = {point[from]};
  for(std::size_t i = 0; i < strip.halfedges.size(); ++i)
    result.push_back((1. - strip.fractions[i]) * point[mesh.source(strip.halfedges[i])] +
                     strip.fractions[i] * point[mesh.target(strip.halfedges[i])]);
  result.push_back(point[to]);
  return result;
}

double length(const std::vector<Vec3>& path)
{
  double result = 0.;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    result += norm(path[i + 1] - path[i]);
  return result;
}

// The margins at vertices make a path longer by at most two margins per edge.
double length_tolerance(const Split_mesh& mesh, const Strip_path& strip)
{
  double result = 0.;
  for(const Index h : strip.halfedges)
    result += 2. * Split_mesh::min_split_fraction * mesh.length(h);
  return result;
}

void expect_is_strip(const Split_mesh& mesh, Index from, Index to, const Strip_path& strip)
{
  const Surface_arrays& t = mesh.triangles();
  ASSERT_EQ(strip.fractions.size(), strip.halfedges.size());
  ASSERT_FALSE(strip.halfedges.empty());
  EXPECT_EQ(mesh.apex(strip.halfedges.front()), from);
  EXPECT_EQ(mesh.apex(t.twin[strip.halfedges.back()]), to);
  for(std::size_t i = 0; i + 1 < strip.halfedges.size(); ++i)
  {
    EXPECT_EQ(t.twin[strip.halfedges[i]] / 3, strip.halfedges[i + 1] / 3);
    EXPECT_NE(t.twin[strip.halfedges[i]], strip.halfedges[i + 1]);
  }
  for(const double fraction : strip.fractions)
  {
    EXPECT_GE(fraction, Split_mesh::min_split_fraction);
    EXPECT_LE(fraction, 1. - Split_mesh::min_split_fraction);
  }
}

TEST(Shorten_in_strip, is_straight_in_plane_and_shortest_on_sphere)
{
  std::mt19937 random(1);
  for(const Triangulation& shape : {jittered(square(12), 0.02, 3), icosphere(2)})
  {
    const Array_surface surface(shape);
    const std::vector<bool> no_feature(surface.t().corner.size(), false);
    const Split_mesh mesh(surface.t(), no_feature);
    const Index n = surface.t().number_of_vertices();
    const std::vector<bool> is_barred(n, false);
    int number_of_paths = 0;
    for(int i = 0; i < 60; ++i)
    {
      const Index from = Index(random() % n), to = Index(random() % n);
      const std::vector<Index> initial_strip = shortest_strip(mesh, from, to);
      if(from == to || initial_strip.empty())
        continue;
      const Strip_path strip = shorten_in_strip(mesh, is_barred, from, to, initial_strip);
      if(strip.halfedges.empty())
        continue;
      expect_is_strip(mesh, from, to, strip);
      Window_propagation windows(surface.triangles());
      windows.run({surface.source(surface.caller_vertex(from))});
      const double exact = windows.distance(to),
                   length_in_strip = length(points_along(mesh, from, to, strip));
      EXPECT_GE(length_in_strip, exact * (1. - 1e-12)); // a sum of one term per edge
      // On the coarse sphere, it can be a longer geodesic that passes vertices on the other side.
      EXPECT_LE(length_in_strip, 1.02 * exact + length_tolerance(mesh, strip));
      ++number_of_paths;
    }
    EXPECT_GT(number_of_paths, 20);
  }
}

TEST(Shorten_in_strip, does_not_cross_barred_vertices)
{
  const Array_surface surface(grid(4, 4,
                                   [](double x, double y) {
                                     return Point{x, y + 0.2 * x * (1. - x), 0.};
                                   }));
  const Split_mesh mesh(surface.t(), std::vector<bool>(surface.t().corner.size(), false));
  const Index n = surface.t().number_of_vertices();
  for(Index a = 0; a < n; ++a)
    for(Index b = a + 1; b < n; ++b)
    {
      const std::vector<Index> initial_strip = shortest_strip(mesh, a, b);
      const Strip_path unconstrained =
                           shorten_in_strip(mesh, std::vector<bool>(n, false), a, b, initial_strip),
                       constrained =
                           shorten_in_strip(mesh, std::vector<bool>(n, true), a, b, initial_strip);
      if(unconstrained.halfedges.empty() || constrained.halfedges.empty())
        continue;
      expect_is_strip(mesh, a, b, constrained);
      EXPECT_LE(length(points_along(mesh, a, b, unconstrained)),
                length(points_along(mesh, a, b, constrained)) +
                    length_tolerance(mesh, unconstrained));
      // Without reroutings, it crosses only edges of the initial strip.
      for(const Index h : constrained.halfedges)
        EXPECT_NE(std::find(initial_strip.begin(), initial_strip.end(), h), initial_strip.end());
    }
}

} // namespace shorten_in_strip_test
