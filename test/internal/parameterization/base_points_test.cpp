// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

Base_points spread(const Glued_surface& surface, std::size_t number, std::size_t nearest)
{
  const Front front(surface.triangles(), Front_kind::euclidean);
  Sampling sampling(surface.triangles(), front, Sample_place::site);
  Sampling_goal goal;
  goal.number = number;
  sample_farthest(sampling, goal, [](double) {});
  return nearest_base_points(surface.t(), sampling, front, nearest);
}

double straight(const Glued_surface& surface, Index a, Index b)
{
  return distance(surface.point(surface.point_of_site(a)), surface.point(surface.point_of_site(b)));
}

TEST(base_points, are_nearer_to_each_other_than_a_surface_is_wide)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const auto strip = [&](std::size_t length)
    {
      const auto place = [&](double u, double v) { return Point{double(length) * u, v, 0.}; };
      return Glued_surface(scaled(grid(length, 1, place), scale));
    };
    EXPECT_EQ(base_points_across(Glued_surface(scaled(square(10), scale)).t()), 200u);
    EXPECT_EQ(base_points_across(strip(100).t()), 200u);
    // Its width in the mean is 800 / 802, and a hexagon with 0.85 of that between its sides has an area
    // of 0.6226.
    EXPECT_EQ(base_points_across(strip(400).t()), 642u);
    EXPECT_EQ(base_points_across(strip(2000).t()), 1000u);
    EXPECT_EQ(base_points_across(Glued_surface(scaled(tetrahedron(), scale)).t()), 200u);
  }
}

TEST(base_points, are_those_nearest_to_each_site)
{
  const Glued_surface surface(square(40, 0.25));
  const Base_points base = spread(surface, 60, 12);
  ASSERT_EQ(base.size(), 60u);
  ASSERT_EQ(base.nearest, 12u);
  for(Index site = 0; site < surface.size(); ++site)
  {
    std::vector<double> truth;
    for(const Index point : base.sites)
      truth.push_back(straight(surface, site, point));
    std::sort(truth.begin(), truth.end());
    for(std::size_t k = 0; k < 12; ++k)
    {
      // Where a front ends it may be too long by some thousandths of a side; not so far inside.
      const double error = k < 8 ? 1e-6 : 0.01 / 40.;
      EXPECT_NEAR(surface.scale() * base.distance[12 * site + k], truth[k], error);
      EXPECT_NEAR(straight(surface, site, base.sites[base.point[12 * site + k]]), truth[k], error);
    }
  }
}

TEST(base_points, are_at_their_distance_from_neighbours_that_have_a_neighbour_in_common)
{
  const Glued_surface surface(square(40, 0.25));
  const Base_points base = spread(surface, 60, 16);
  for(Index site = 0; site < surface.size(); ++site)
    for(std::size_t a = 0; a < 8; ++a)
      for(std::size_t b = 0; b < 8; ++b)
      {
        const Index i = base.point[16 * site + a], j = base.point[16 * site + b];
        EXPECT_NEAR(surface.scale() * base.distance_between(i, j),
                    straight(surface, base.sites[i], base.sites[j]), 1e-6);
        EXPECT_EQ(base.distance_between(i, j), base.distance_between(j, i));
      }
}

TEST(base_points, are_all_there_where_they_are_few)
{
  const Glued_surface surface(square(10, 0.25));
  const Base_points base = spread(surface, 5, 16);
  EXPECT_EQ(base.nearest, 5u);
  EXPECT_TRUE(std::none_of(base.distance.begin(), base.distance.end(),
                           [](double d) { return d == infinity; }));
  for(Index i = 0; i < 5; ++i)
    for(Index j = 0; j < 5; ++j)
      EXPECT_NEAR(surface.scale() * base.distance_between(i, j),
                  straight(surface, base.sites[i], base.sites[j]), 1e-9);
}

TEST(base_points, of_two_pieces_do_not_meet)
{
  const Triangulation piece = square(6, 0.2);
  Triangulation other = piece;
  for(Point& p : other.points)
    p[2] += 3.;
  const Glued_surface surface(apart(piece, other));
  const Base_points base = spread(surface, 10, 8);
  std::size_t apart = 0;
  for(Index i = 0; i < 10; ++i)
    for(Index j = 0; j < 10; ++j)
      apart += base.distance_between(i, j) == infinity;
  EXPECT_EQ(apart, 50u); // five samples each
  EXPECT_GT(std::count(base.point.begin(), base.point.end(), none), 0);
}

TEST(base_points, are_none_when_cancelled)
{
  const Glued_surface surface(square(6, 0.2));
  const Front front(surface.triangles(), Front_kind::euclidean);
  Sampling sampling(surface.triangles(), front, Sample_place::site);
  sampling.add(surface.at(0));
  EXPECT_EQ(
      nearest_base_points(surface.t(), sampling, front, 3, [](double) { return false; }).size(),
      0u);
}

} // namespace
