// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/cloud_path.h"

#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "triangulations.h"

#include <gtest/gtest.h>

#include <memory>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

struct Cloud
{
  Glued_surfels surfels;
  std::shared_ptr<const Glued_triangles> triangles;

  Cloud(const std::vector<Point>& points, const std::vector<Point>& normals)
      : surfels(glue_surfels(points, normals)),
        triangles(std::make_shared<const Glued_triangles>(surfels.triangles))
  {}
  const Glued_triangles& t() const { return *triangles; }
  Location at(Index point) const { return at_site(t(), surfels.site_of_surfel[point]); }
};

Cloud plane(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0., 1.);
  std::vector<Point> points(n);
  for(Point& p : points)
    p = {unit(random), unit(random), 0.};
  return Cloud(points, std::vector<Point>(n, {0., 0., 1.}));
}

// Points of the unit sphere along a spiral, evenly spaced.
Cloud sphere(std::size_t n)
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

TEST(Cloud_path, is_straight_on_a_plane)
{
  const Cloud cloud = plane(2000, 1);
  Path_finder find(cloud.triangles);
  std::mt19937 random(2);
  double sum = 0., sum_before = 0.;
  const int count = 50;
  for(int i = 0; i < count; ++i)
  {
    const Location p = cloud.at(Index(random() % 2000)), q = cloud.at(Index(random() % 2000));
    const auto chain = find(p, q);
    const auto path = smoothed_on_cloud(cloud.t(), chain);
    const double length = polyline_length(cloud.t(), path) * cloud.t().scale;
    const double straight = distance(point_at(cloud.t(), p), point_at(cloud.t(), q));
    EXPECT_GE(length, straight * (1. - 1e-12)); // rounding
    EXPECT_LE(length, polyline_length(cloud.t(), chain) * cloud.t().scale * (1. + 1e-12));
    sum += length / straight - 1.;
    sum_before += polyline_length(cloud.t(), chain) * cloud.t().scale / straight - 1.;
  }
  // Straight but for gaps in the cover and the border of the samples.
  EXPECT_LE(sum, 0.02 * sum_before);
}

TEST(Cloud_path, follows_great_circles_on_a_sphere)
{
  for(const std::size_t n : {1000, 4000})
  {
    const Cloud cloud = sphere(n);
    Path_finder find(cloud.triangles);
    std::mt19937 random(3);
    for(int i = 0; i < 50; ++i)
    {
      const Location p = cloud.at(Index(random() % n)), q = cloud.at(Index(random() % n));
      const auto path = smoothed_on_cloud(cloud.t(), find(p, q));
      const double length = polyline_length(cloud.t(), path) * cloud.t().scale;
      const double chord = distance(point_at(cloud.t(), p), point_at(cloud.t(), q));
      const double arc = 2. * std::asin(std::min(1., chord / 2.));
      // Sides h have h^2 about 12.6 / n; a polyline inscribed with steps 2 h is shorter by h^2 / 6,
      // and half of it again for the triangles' depth below the sphere.
      EXPECT_NEAR(length, arc, arc * 12.6 / double(n)) << n;
      // Each location lies on a triangle near the sphere.
      for(const Location& location : path)
      {
        const Point x = point_at(cloud.t(), location);
        EXPECT_NEAR(std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), 1., 12.6 / double(n));
      }
    }
  }
}

TEST(Cloud_path, starts_and_ends_where_it_did)
{
  const Cloud cloud = plane(500, 4);
  Path_finder find(cloud.triangles);
  std::mt19937 random(5);
  for(int i = 0; i < 50; ++i)
  {
    const Location p = random_location(cloud.t(), random), q = random_location(cloud.t(), random);
    const auto chain = find(p, q);
    ASSERT_FALSE(chain.empty());
    const auto path = smoothed_on_cloud(cloud.t(), chain);
    ASSERT_FALSE(path.empty());
    EXPECT_NEAR(distance(point_at(cloud.t(), path.front()), point_at(cloud.t(), p)), 0., 1e-12);
    EXPECT_NEAR(distance(point_at(cloud.t(), path.back()), point_at(cloud.t(), q)), 0., 1e-12);
    EXPECT_LE(polyline_length(cloud.t(), path),
              polyline_length(cloud.t(), chain) * (1. + 1e-12)); // rounding
  }
}

TEST(Cloud_path, stays_on_clouds_that_have_no_triangles)
{
  Glued_triangles cloud;
  cloud.first.assign(4, 0);
  cloud.point = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}};
  cloud.normal.assign(3, {0., 0., 1.});
  cloud.graph.first = {0, 1, 3, 4};
  cloud.graph.target = {1, 0, 2, 1};
  cloud.graph.length = {1., 1., 1., 1.};
  const std::vector<Location> chain = {at_site(cloud, 0), at_site(cloud, 1), at_site(cloud, 2)};
  EXPECT_EQ(smoothed_on_cloud(cloud, chain).size(), 3u);
  EXPECT_EQ(smoothed_on_cloud(cloud, {chain[0]}).size(), 1u);
  EXPECT_TRUE(smoothed_on_cloud(cloud, {}).empty());
}

} // namespace
