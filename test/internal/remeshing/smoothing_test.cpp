// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/smoothing.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "polygons.h"
#include "subdivided_surfaces.h"

#include <gtest/gtest.h>

#include <random>

namespace smoothing_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Triangles = std::vector<std::array<Index, 3>>;

struct Input
{
  std::vector<Surface_location> samples;
  Triangles triangles;
  std::vector<bool> is_fixed;
};

// Returns the points of a mesh as samples of a square mesh of n x n quads in the same plane.
Input on_square(const Array_surface& surface, std::size_t n, const Triangulation& points,
                double scale)
{
  Input result = {{}, triangles_of(points), {}};
  for(const Point& p : points.points)
  {
    const double x = p[0] / scale * double(n), y = p[1] / scale * double(n);
    const std::size_t i = std::min(std::size_t(x), n - 1), j = std::min(std::size_t(y), n - 1);
    // The quad has two triangles; the sample lies in one of them.
    for(Index face = Index(2 * (j * n + i)); face < 2 * (j * n + i) + 2; ++face)
    {
      const Index f = surface.triangle(face);
      const Point a = coordinates(surface.t(), {f, none, {1., 0., 0.}}),
                  b = coordinates(surface.t(), {f, none, {0., 1., 0.}}),
                  c = coordinates(surface.t(), {f, none, {0., 0., 1.}});
      const double area = cross(b - a, c - a)[2];
      const std::array<double, 3> barycentric = {cross(b - p, c - p)[2] / area,
                                                 cross(c - p, a - p)[2] / area,
                                                 cross(a - p, b - p)[2] / area};
      if(*std::min_element(barycentric.begin(), barycentric.end()) < -1e-12)
        continue;
      result.samples.push_back(canonical(surface.t(), {f, none, barycentric}));
      break;
    }
    const auto is_on_boundary = [&](double z) { return z == 0. || z == scale; };
    result.is_fixed.push_back(is_on_boundary(p[0]) || is_on_boundary(p[1]));
  }
  EXPECT_EQ(result.samples.size(), points.points.size());
  return result;
}

std::vector<Point> smoothed(const Array_surface& surface, const Input& input, int steps,
                            const std::vector<double>* slowness = nullptr,
                            std::vector<bool> is_feature = {})
{
  is_feature.resize(surface.t().corner.size());
  Smoothing smoothing(surface.t(), slowness, input.samples, input.triangles, input.is_fixed,
                      is_feature);
  for(int step = 0; step < steps; ++step)
    smoothing.step();
  std::vector<Point> result;
  for(const Surface_location& sample : smoothing.samples())
    result.push_back(coordinates(surface.t(), sample));
  return result;
}

TEST(Smoothing, converges_to_voronoi_centroids)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Array_surface surface(scaled(square(20), scale));
    const Input input = on_square(surface, 20, scaled(square(6, 0.25, 5), scale), scale);
    const std::vector<Point> found = smoothed(surface, input, 1000);
    const std::vector<Point> all = {
        {0., 0., 0.}, {scale, 0., 0.}, {scale, scale, 0.}, {0., scale, 0.}};
    for(std::size_t i = 0; i < found.size(); ++i)
    {
      if(input.is_fixed[i])
      {
        EXPECT_EQ(found[i], coordinates(surface.t(), input.samples[i]));
        continue;
      }
      std::vector<Point> cell = all;
      for(std::size_t j = 0; j < found.size(); ++j)
        if(j != i)
          cell = clip_to_bisector(cell, found[i], found[j]);
      // Round-off errors of a mean of some points.
      EXPECT_LT(distance(centroid(cell), found[i]), 1e-12 * scale);
    }
  }
}

TEST(Smoothing, keeps_samples_without_closed_ring)
{
  const Array_surface surface(square(20));
  Input input = on_square(surface, 20, square(4, 0.3), 1.);
  const auto points = [&](const Input& in) { return smoothed(surface, in, 0); };
  Input apart = input;
  apart.triangles.clear();
  EXPECT_EQ(smoothed(surface, apart, 3), points(apart));
  // A third triangle at one edge: the ends of the edge must not move. Its corners coincide with
  // those of the first triangle.
  Input non_manifold = input;
  non_manifold.triangles.push_back(non_manifold.triangles[14]);
  const std::vector<Point> before = points(non_manifold),
                           after = smoothed(surface, non_manifold, 1);
  std::size_t moved = 0;
  for(std::size_t i = 0; i < before.size(); ++i)
    moved += before[i] != after[i];
  for(const Index i : non_manifold.triangles[14])
    EXPECT_EQ(before[i], after[i]);
  EXPECT_GT(moved, 3u);
}

// Six fixed samples around a movable one at the center of a square of size 4.
Input hexagon(const Array_surface& surface, Point center)
{
  Triangulation points;
  points.points.push_back(center);
  for(Index k = 0; k < 6; ++k)
  {
    points.points.push_back({2. + std::cos(k * pi / 3.), 2. + std::sin(k * pi / 3.), 0.});
    points.corners.insert(points.corners.end(), {0, k + 1, (k + 1) % 6 + 1});
  }
  Input result = on_square(surface, 16, points, 4.);
  result.is_fixed = {false, true, true, true, true, true, true};
  return result;
}

TEST(Smoothing, moves_toward_slow_regions)
{
  const Array_surface surface(scaled(square(16), 4.));
  const Input input = hexagon(surface, {2.25, 2.125, 0.});
  // Each step halves the error; 50 steps reduce it to 1e-15.
  EXPECT_LT(distance(smoothed(surface, input, 50)[0], {2., 2., 0.}), 1e-12);
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] < 2.)
      slowness[f] = 1.5;
  const Point slow = smoothed(surface, input, 50, &slowness)[0];
  EXPECT_LT(slow[0], 1.95);
  // Samples on the line between the two speeds may take the density of either.
  EXPECT_NEAR(slow[1], 2., 1e-3);
}

TEST(Smoothing, does_not_cross_features)
{
  const Array_surface surface(scaled(square(16), 4.));
  const Input input = hexagon(surface, {2.45, 2., 0.});
  std::vector<bool> is_feature(surface.t().corner.size(), false);
  for(Index h = 0; h < is_feature.size(); ++h)
  {
    const Index x = surface.t().corner[h], y = surface.t().corner[next_halfedge(h)];
    is_feature[h] = surface.point(surface.caller_vertex(x))[0] == 2.25 &&
                    surface.point(surface.caller_vertex(y))[0] == 2.25;
  }
  EXPECT_GT(smoothed(surface, input, 20, nullptr, is_feature)[0][0], 2.25);
  EXPECT_LT(smoothed(surface, input, 20)[0][0], 2.01);
}

TEST(Smoothing, stays_on_surface_and_at_corners)
{
  const Triangulation sphere = icosphere(4), coarse = icosphere(2);
  const Array_surface surface(sphere);
  Input input = {{}, triangles_of(coarse), std::vector<bool>(coarse.points.size(), false)};
  // The first points of a finer icosphere are those of the coarse one. Some of them are displaced.
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for(Index i = 0; i < coarse.points.size(); ++i)
  {
    const Index corner = surface.t().ring[surface.t().ring_begin[surface.vertex(i)]];
    std::array<double, 3> b = {0., 0., 0.};
    b[corner % 3] = 1. - uniform(random);
    b[(corner + 1) % 3] = 1. - b[corner % 3];
    input.samples.push_back(canonical(surface.t(), {corner / 3, none, b}));
  }
  const auto min_edge_length = [&](const std::vector<Point>& points)
  {
    double result = infinity;
    for(const auto& f : input.triangles)
      for(int k = 0; k < 3; ++k)
        result = std::min(result, distance(points[f[k]], points[f[(k + 1) % 3]]));
    return result;
  };
  const std::vector<Point> before = smoothed(surface, input, 0),
                           after = smoothed(surface, input, 20);
  // Measured are 0.18 before and 0.27 after smoothing.
  EXPECT_GT(min_edge_length(after), min_edge_length(before) + 0.05);
  for(const Point& p : after)
  {
    EXPECT_LT(norm(p), 1. + 1e-14); // round-off error of a point on the unit circle
    EXPECT_GT(norm(p), 0.995); // the distance of the triangles of the finer sphere to the center
  }

  // At the corner of a cube the sum of three unit normals has length 0.58 times 3.
  const Triangulation block = blocks(1, 1, 1, [](int, int, int) { return true; });
  const Array_surface cube(block);
  Input corners = {{}, triangles_of(block), std::vector<bool>(8, false)};
  for(Index i = 0; i < 8; ++i)
    corners.samples.push_back(cube.at(i));
  EXPECT_EQ(smoothed(cube, corners, 5), smoothed(cube, corners, 0));
}

} // namespace smoothing_test
