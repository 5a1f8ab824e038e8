// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flips.h"

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include "topology.h"

#include <gtest/gtest.h>

namespace flips_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Triangles = std::vector<std::array<Index, 3>>;

Triangles triangles_of(const Triangulation& surface)
{
  Triangles result;
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
    result.push_back({surface.corners[c], surface.corners[c + 1], surface.corners[c + 2]});
  return result;
}

Topology topology_of(const Triangles& triangles)
{
  std::vector<Index> corners;
  for(const auto& f : triangles)
    corners.insert(corners.end(), f.begin(), f.end());
  return topology(corners);
}

double area(const std::vector<Point>& points, const Triangles& triangles)
{
  double result = 0.;
  for(const auto& f : triangles)
    result += 0.5 * norm(cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]]));
  return result;
}

double min_angle(const std::vector<Point>& points, const Triangles& triangles)
{
  double result = pi;
  for(const auto& f : triangles)
    for(int k = 0; k < 3; ++k)
    {
      const Point u = points[f[(k + 1) % 3]] - points[f[k]],
                  v = points[f[(k + 2) % 3]] - points[f[k]];
      result = std::min(result, std::atan2(norm(cross(u, v)), dot(u, v)));
    }
  return result;
}

// Returns whether a planar triangulation is Delaunay: no circumcircle contains another point.
bool is_delaunay(const std::vector<Point>& p, const Triangles& triangles)
{
  for(const auto& f : triangles)
    for(Index i = 0; i < p.size(); ++i)
    {
      std::array<double, 3> x, y, square;
      for(int k = 0; k < 3; ++k)
      {
        x[k] = p[f[k]][0] - p[i][0];
        y[k] = p[f[k]][1] - p[i][1];
        square[k] = x[k] * x[k] + y[k] * y[k];
      }
      const double determinant = square[0] * (x[1] * y[2] - x[2] * y[1]) +
                                 square[1] * (x[2] * y[0] - x[0] * y[2]) +
                                 square[2] * (x[0] * y[1] - x[1] * y[0]);
      if(determinant > 1e-7) // the smallest improvement for which edges are flipped
        return false;
    }
  return true;
}

TEST(Flips, planar_triangulation_becomes_delaunay)
{
  for(const unsigned seed : {1u, 2u, 3u})
  {
    const Triangulation plane = square(12, 0.25, seed);
    Triangles triangles = triangles_of(plane);
    EXPECT_FALSE(is_delaunay(plane.points, triangles));
    flip_to_larger_angles(plane.points, {}, triangles);
    EXPECT_TRUE(is_delaunay(plane.points, triangles));
    EXPECT_EQ(topology_of(triangles), topology(plane.corners));
    EXPECT_NEAR(area(plane.points, triangles), 1., 1e-13); // a sum of 300 terms
  }
}

TEST(Flips, constrained_edges_are_kept)
{
  const std::vector<Point> points = {{0., 0., 0.}, {4., 0., 0.}, {2., 1., 0.}, {2., -1., 0.}};
  const Triangles both = {{0, 1, 2}, {1, 0, 3}};
  Triangles triangles = both;
  flip_to_larger_angles(points, {{0, 1}}, triangles);
  EXPECT_EQ(triangles, both);
  flip_to_larger_angles(points, {{0, 2}, {0, 3}, {2, 3}}, triangles);
  EXPECT_EQ(topology_of(triangles), topology_of(both));
  for(const auto& f : triangles)
    EXPECT_EQ(std::count_if(f.begin(), f.end(), [](Index i) { return i >= 2; }), 2);
}

TEST(Flips, creases_are_kept)
{
  // The same triangles, bent by 60 degrees at the common edge.
  const double c = 0.5, s = std::sqrt(0.75);
  const std::vector<Point> points = {{0., 0., 0.}, {4., 0., 0.}, {2., 1., 0.}, {2., -c, -s}};
  const Triangles both = {{0, 1, 2}, {1, 0, 3}};
  Triangles triangles = both;
  flip_to_larger_angles(points, {}, triangles);
  EXPECT_EQ(triangles, both);
  // In a flat tetrahedron the flipped edge exists already.
  Triangulation flat = tetrahedron();
  for(Point& p : flat.points)
    p[2] *= 1e-3;
  triangles = triangles_of(flat);
  flip_to_larger_angles(flat.points, {}, triangles);
  EXPECT_EQ(topology_of(triangles), topology(flat.corners));
}

TEST(Flips, needles_at_creases_are_flipped)
{
  // A needle perpendicular to a horizontal triangle, with a height of 1/20 and 1/4 of the common
  // edge.
  const Triangles both = {{0, 1, 2}, {1, 0, 3}};
  for(const double height : {0.2, 1.})
  {
    const std::vector<Point> points = {{0., 0., 0.}, {4., 0., 0.}, {2., 0., height}, {2., -2., 0.}};
    Triangles triangles = both;
    flip_to_larger_angles(points, {}, triangles);
    EXPECT_EQ(topology_of(triangles), topology_of(both));
    EXPECT_EQ(triangles == both, height == 1.);
  }
}

TEST(Flips, min_angle_does_not_decrease)
{
  for(const Triangulation& surface : {jittered(icosphere(3), 0.03), jittered(torus(60, 24), 0.01),
                                      cylinder(24, 40, 1., 5.), double_torus(3)})
  {
    Triangles triangles = triangles_of(surface);
    const double before = min_angle(surface.points, triangles);
    flip_to_larger_angles(surface.points, {}, triangles);
    EXPECT_EQ(topology_of(triangles), topology(surface.corners));
    EXPECT_GE(min_angle(surface.points, triangles), before);
  }
}

TEST(Flips, coincident_points_are_handled)
{
  Triangulation plane = square(4);
  for(Point& p : plane.points)
    p[1] = 0.;
  Triangles triangles = triangles_of(plane);
  flip_to_larger_angles(plane.points, {}, triangles);
  EXPECT_EQ(topology_of(triangles), topology(plane.corners));
  triangles.clear();
  flip_to_larger_angles({}, {}, triangles);
  EXPECT_TRUE(triangles.empty());
}

} // namespace flips_test
