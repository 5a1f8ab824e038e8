// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Uniform samples of a part of the square from -1 to 1.
template <typename Inside>
std::vector<Point> samples(std::size_t number, unsigned seed, const Inside& inside)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<Point> result;
  while(result.size() < number)
  {
    const Point p = {coordinate(random), coordinate(random), 0.};
    if(inside(p))
      result.push_back(p);
  }
  return result;
}

// Every point of a path lies near a surfel: at borders and holes it does not cut across.  Triangles have
// circumradii of up to 2.5 radii, which is how far apart samples at random are in places.
template <typename Inside>
void expect_paths_in_disks(const Inside& inside)
{
  const auto points = samples(4000, 1, inside);
  const internal::Glued_surfels cloud =
      internal::glue_surfels(points, std::vector<Point>(points.size(), {0., 0., 1.}));
  const Glued_triangles& t = cloud.triangles;
  const auto shared = std::make_shared<const Glued_triangles>(t);
  internal::Front front(shared, internal::Front_kind::euclidean);
  std::mt19937 random(2);
  std::size_t found_paths = 0;
  for(int query = 0; query < 10; ++query)
  {
    const std::vector<internal::Source> sources = {
        {{{none, Index(random() % t.number_of_sites()), {}}}, 0., 0}};
    front.run(sources);
    for(int i = 0; i < 5; ++i)
    {
      const auto found = path(t, front, sources, {none, Index(random() % t.number_of_sites()), {}});
      found_paths += !found.empty();
      for(std::size_t k = 0; k + 1 < found.size(); ++k)
      {
        const Point a = internal::scaled_coordinates(t, found[k]),
                    b = internal::scaled_coordinates(t, found[k + 1]);
        for(int step = 0; step <= 10; ++step)
        {
          Point p;
          for(int axis = 0; axis < 3; ++axis)
            p[axis] = a[axis] + 0.1 * step * (b[axis] - a[axis]);
          bool is_covered = false;
          for(Index site = 0; site < t.number_of_sites() && !is_covered; ++site)
            is_covered = distance(p, t.point[site]) <= 2.5 * cloud.radius[site] * (1. + rounding);
          EXPECT_TRUE(is_covered) << "at " << t.scale * p[0] << ' ' << t.scale * p[1];
        }
      }
    }
  }
  EXPECT_GT(found_paths, 40u); // samples at random hang together but for a few
}

TEST(Path_on_a_cloud, stays_in_disks_around_a_hole)
{
  expect_paths_in_disks([](const Point& p) { return std::hypot(p[0], p[1]) > 0.5; });
}

TEST(Path_on_a_cloud, stays_in_disks_around_a_notch)
{
  expect_paths_in_disks([](const Point& p) { return p[1] < 0. || std::abs(p[0]) > 0.2; });
}

TEST(Path_on_a_cloud, stays_in_disks_around_a_thin_slit)
{
  // Its middle is just beyond 2.5 radii (0.09, and more along borders) of all surfels.
  expect_paths_in_disks([](const Point& p) { return p[1] < 0. || std::abs(p[0]) > 0.12; });
}

} // namespace
