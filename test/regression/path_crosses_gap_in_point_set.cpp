// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "methods.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace path_crosses_gap_in_point_set {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Returns uniform random samples of a subset of the square [-1, 1]^2.
template <typename IsInside>
std::vector<Point> random_samples(std::size_t number, unsigned seed, const IsInside& is_inside)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<Point> result;
  while(result.size() < number)
  {
    const Point p = {coordinate(random), coordinate(random), 0.};
    if(is_inside(p))
      result.push_back(p);
  }
  return result;
}

// Checks that every path point lies close to a surfel, so paths do not cross gaps at boundaries
// and holes. Triangles have circumradii of at most 2.5 surfel radii, which is the largest local
// spacing of random samples.
template <typename IsInside>
void expect_paths_inside_disks(const IsInside& is_inside)
{
  const auto points = random_samples(4000, 1, is_inside);
  const internal::Surfel_arrays cloud =
      internal::build_surfel_arrays(points, std::vector<Point>(points.size(), {0., 0., 1.}));
  const Surface_arrays& t = cloud.arrays;
  const auto shared_arrays = std::make_shared<const Surface_arrays>(t);
  internal::Front front(shared_arrays, internal::Front_kind::euclidean);
  std::mt19937 random(2);
  std::size_t number_of_paths = 0;
  for(int query = 0; query < 10; ++query)
  {
    const std::vector<internal::Front_source> sources = {
        {{{none, Index(random() % t.number_of_vertices()), {}}}, 0., 0}};
    front.run(sources);
    for(int i = 0; i < 5; ++i)
    {
      const auto geodesic =
          path(t, front, sources, {none, Index(random() % t.number_of_vertices()), {}});
      number_of_paths += !geodesic.empty();
      for(std::size_t k = 0; k + 1 < geodesic.size(); ++k)
      {
        const Point a = internal::scaled_coordinates(t, geodesic[k]),
                    b = internal::scaled_coordinates(t, geodesic[k + 1]);
        for(int step = 0; step <= 10; ++step)
        {
          Point p;
          for(int axis = 0; axis < 3; ++axis)
            p[axis] = a[axis] + 0.1 * step * (b[axis] - a[axis]);
          bool is_covered = false;
          for(Index vertex = 0; vertex < t.number_of_vertices() && !is_covered; ++vertex)
            is_covered = distance(p, t.point[vertex]) <=
                         2.5 * cloud.radius[vertex] * (1. + round_off_tolerance);
          EXPECT_TRUE(is_covered) << "at " << t.scale * p[0] << ' ' << t.scale * p[1];
        }
      }
    }
  }
  EXPECT_GT(number_of_paths, 40u); // random samples are connected except for a few
}

TEST(Path_on_point_set, does_not_cross_hole)
{
  expect_paths_inside_disks([](const Point& p) { return std::hypot(p[0], p[1]) > 0.5; });
}

TEST(Path_on_point_set, does_not_cross_notch)
{
  expect_paths_inside_disks([](const Point& p) { return p[1] < 0. || std::abs(p[0]) > 0.2; });
}

TEST(Path_on_point_set, does_not_cross_thin_slit)
{
  // The center line of the slit is slightly farther than 2.5 radii from all surfels. A radius is
  // 0.09, and more along boundaries.
  expect_paths_inside_disks([](const Point& p) { return p[1] < 0. || std::abs(p[0]) > 0.12; });
}

} // namespace path_crosses_gap_in_point_set
