// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/coarse_mean.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coarse_mean_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The distances of the front are exact in the plane, so the nearest vertex is the best.
TEST(Coarse_mean, is_the_best_vertex_in_the_plane)
{
  const Array_surface surface(square(12));
  const std::vector<Surface_location> corners = {surface.at(0), surface.at(12), surface.at(156),
                                                 surface.at(168)};
  const Surface_location center = coarse_mean(surface.triangles(), corners, {1., 1., 1., 1.});
  EXPECT_LT(distance(point_at(surface.t(), center), surface.point(84)), 1e-12); // round-off
  const Surface_location pulled = coarse_mean(surface.triangles(), corners, {3., 1., 1., 1.});
  EXPECT_LT(distance(point_at(surface.t(), pulled), surface.point(4 + 13 * 4)), 1e-12);
}

// A location is replaced by one that is closer than the distances between eight ones.
TEST(Coarse_mean, approximates_the_mean_of_many_locations)
{
  const Array_surface surface(icosphere(4));
  std::mt19937 random(1);
  std::vector<Surface_location> locations;
  Point sum = {0., 0., 0.};
  while(locations.size() < 200)
  {
    const Surface_location location = random_location(surface.t(), random);
    const Point p = point_at(surface.t(), location);
    if(p[2] < 0.8)
      continue;
    locations.push_back(location);
    for(int k = 0; k < 3; ++k)
      sum[k] += p[k];
  }
  const std::vector<double> weights(locations.size(), 1.);
  const Point found = point_at(surface.t(), coarse_mean(surface.triangles(), locations, weights));
  // The cap has a radius of 0.64; eight balls of half of this radius cover it.
  EXPECT_LT(distance(unit(found), unit(sum)), 0.32);
}

TEST(Coarse_mean, returns_a_location_if_there_is_no_better_vertex)
{
  const Array_surface surface(one_triangle());
  const Surface_location inside = surface.in(0, {0.4, 0.3, 0.3});
  EXPECT_EQ(coarse_mean(surface.triangles(), {inside}, {1.}).barycentric, inside.barycentric);
}

TEST(Coarse_mean, throws)
{
  const Array_surface surface(disjoint_union(icosphere(1), scaled(icosphere(1), 3.)));
  EXPECT_THROW(coarse_mean(surface.triangles(), {surface.at(0), surface.at(42)}, {1., 1.}),
               Invalid_argument_error);
  EXPECT_THROW(coarse_mean(surface.triangles(), {surface.at(0), surface.at(1)}, {1., 1.},
                           [](double) { return false; }),
               Cancelled);
}

} // namespace coarse_mean_test
