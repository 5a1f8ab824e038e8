// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_on_cloud.h"

#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "triangulations.h"

#include <gtest/gtest.h>

#include <memory>

namespace shorten_on_cloud_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

struct Cloud
{
  Surfel_arrays surfels;
  std::shared_ptr<const Surface_arrays> triangles;

  Cloud(const std::vector<Point>& points, const std::vector<Point>& normals)
      : surfels(build_surfel_arrays(points, normals)),
        triangles(std::make_shared<const Surface_arrays>(surfels.arrays))
  {}
  const Surface_arrays& t() const { return *triangles; }
  Surface_location at(Index point) const
  {
    return vertex_location(t(), surfels.internal_vertex[point]);
  }
};

Cloud plane_cloud(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0., 1.);
  std::vector<Point> points(n);
  for(Point& p : points)
    p = {unit(random), unit(random), 0.};
  return Cloud(points, std::vector<Point>(n, {0., 0., 1.}));
}

// Points of the unit sphere along a spiral, evenly spaced.
Cloud sphere_cloud(std::size_t n)
{
  std::vector<Point> points(n);
  for(std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * i + 1.) / n, a = i * pi * (3. - std::sqrt(5.));
    const double r = std::sqrt(1. - z * z);
    points[i] = {r * std::cos(a), r * std::sin(a), z};
  }
  return Cloud(points, points);
}

TEST(Shorten_on_cloud, is_straight_on_plane)
{
  const Cloud cloud = plane_cloud(2000, 1);
  Path_finder find(cloud.triangles);
  std::mt19937 random(2);
  double sum_of_errors = 0., sum_of_initial_errors = 0.;
  const int number_of_pairs = 50;
  for(int i = 0; i < number_of_pairs; ++i)
  {
    const Surface_location p = cloud.at(Index(random() % 2000)),
                           q = cloud.at(Index(random() % 2000));
    const auto chain = find(p, q);
    const auto path = shorten_on_cloud(cloud.t(), chain);
    const double length = polyline_length(cloud.t(), path) * cloud.t().scale;
    const double euclidean = distance(point_at(cloud.t(), p), point_at(cloud.t(), q));
    EXPECT_GE(length, euclidean * (1. - 1e-12)); // round-off errors
    // Relative round-off error of a sum.
    EXPECT_LE(length, polyline_length(cloud.t(), chain) * cloud.t().scale * (1. + 1e-12));
    sum_of_errors += length / euclidean - 1.;
    sum_of_initial_errors += polyline_length(cloud.t(), chain) * cloud.t().scale / euclidean - 1.;
  }
  // Paths are straight except at gaps between triangles and at the boundary of the samples.
  EXPECT_LE(sum_of_errors, 0.02 * sum_of_initial_errors);
}

TEST(Shorten_on_cloud, follows_great_circles_on_sphere)
{
  for(const std::size_t n : {1000, 4000})
  {
    const Cloud cloud = sphere_cloud(n);
    Path_finder find(cloud.triangles);
    std::mt19937 random(3);
    for(int i = 0; i < 50; ++i)
    {
      const Surface_location p = cloud.at(Index(random() % n)), q = cloud.at(Index(random() % n));
      const auto path = shorten_on_cloud(cloud.t(), find(p, q));
      const double length = polyline_length(cloud.t(), path) * cloud.t().scale;
      const double chord = distance(point_at(cloud.t(), p), point_at(cloud.t(), q));
      const double expected = 2. * std::asin(std::min(1., chord / 2.));
      // Edges of length h have h^2 of about 12.6 / n. An inscribed polyline with steps of 2 h is
      // shorter by h^2 / 6, and by half of this again because the triangles are inside the sphere.
      EXPECT_NEAR(length, expected, expected * 12.6 / double(n)) << n;
      // Each location lies on a triangle near the sphere.
      for(const Surface_location& location : path)
      {
        const Point x = point_at(cloud.t(), location);
        EXPECT_NEAR(std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), 1., 12.6 / double(n));
      }
    }
  }
}

TEST(Shorten_on_cloud, keeps_end_points)
{
  const Cloud cloud = plane_cloud(500, 4);
  Path_finder find(cloud.triangles);
  std::mt19937 random(5);
  for(int i = 0; i < 50; ++i)
  {
    const Surface_location p = random_location(cloud.t(), random),
                           q = random_location(cloud.t(), random);
    const auto chain = find(p, q);
    ASSERT_FALSE(chain.empty());
    const auto path = shorten_on_cloud(cloud.t(), chain);
    ASSERT_FALSE(path.empty());
    // Round-off errors of coordinates near 1.
    EXPECT_NEAR(distance(point_at(cloud.t(), path.front()), point_at(cloud.t(), p)), 0., 1e-12);
    EXPECT_NEAR(distance(point_at(cloud.t(), path.back()), point_at(cloud.t(), q)), 0., 1e-12);
    EXPECT_LE(polyline_length(cloud.t(), path),
              polyline_length(cloud.t(), chain) * (1. + 1e-12)); // round-off errors
  }
}

TEST(Shorten_on_cloud, keeps_path_on_cloud_without_triangles)
{
  Surface_arrays cloud;
  cloud.ring_begin.assign(4, 0);
  cloud.point = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}};
  cloud.normal.assign(3, {0., 0., 1.});
  cloud.graph.begin = {0, 1, 3, 4};
  cloud.graph.target = {1, 0, 2, 1};
  const std::vector<Surface_location> chain = {vertex_location(cloud, 0), vertex_location(cloud, 1),
                                               vertex_location(cloud, 2)};
  EXPECT_EQ(shorten_on_cloud(cloud, chain).size(), 3u);
  EXPECT_EQ(shorten_on_cloud(cloud, {chain[0]}).size(), 1u);
  EXPECT_TRUE(shorten_on_cloud(cloud, {}).empty());
}

} // namespace shorten_on_cloud_test
