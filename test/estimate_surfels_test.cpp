// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/estimate_surfels.h>

#include <CGAL/Point_set_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace estimate_surfels_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;

Point_set sphere_points()
{
  Point_set points;
  for(const auto& [point, normal] : sphere_surfels(3))
    points.insert(point);
  return points;
}

TEST(estimate_surfels, estimates_sphere_normals_and_radii)
{
  Point_set points = sphere_points();
  EXPECT_EQ(GP::estimate_surfels(points), 0u);
  ASSERT_TRUE(points.has_normal_map());
  const auto [radius, is_new] = points.add_property_map<double>("radius");
  ASSERT_FALSE(is_new);
  double sign = 0.;
  for(const auto& index : points)
  {
    const double cosine = points.normal(index) * (points.point(index) - CGAL::ORIGIN);
    // A quadratic jet fit through points at a spacing of 0.1.
    EXPECT_GT(std::abs(cosine), std::cos(0.01));
    if(sign == 0.)
      sign = cosine;
    EXPECT_GT(cosine * sign, 0.);
    // For 642 points, the eighth neighbor is between one and two edge lengths away.
    EXPECT_GT(radius[index], 0.13 / std::sqrt(2.));
    EXPECT_LT(radius[index], 0.33 / std::sqrt(2.));
  }
}

TEST(estimate_surfels, removes_outliers)
{
  Point_set points = sphere_points();
  std::set<Point_set::Index> far;
  for(int i = 0; i < 6; ++i)
    far.insert(*points.insert({3. + i, 2. * i, 1.}));
  const std::size_t before = points.size();
  // 0.92 % of 648 points are 5.96 points.
  EXPECT_EQ(GP::estimate_surfels(points,
                                 GP::parameters::outlier_percentage(0.92).number_of_neighbors(12u)),
            6u);
  EXPECT_EQ(points.size(), before - 6);
  for(const auto& index : points)
    EXPECT_EQ(far.count(index), 0u);
}

TEST(estimate_surfels, writes_property_maps_of_range)
{
  Surfels surfels = flat_surfels(500);
  const Surfels given = surfels;
  for(auto& [point, normal] : surfels)
    normal = Kernel::Vector_3(0., 0., 0.);
  EXPECT_EQ(
      GP::estimate_surfels(
          surfels, GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map())),
      0u);
  for(std::size_t i = 0; i < surfels.size(); ++i)
  {
    EXPECT_EQ(surfels[i].first, given[i].first);
    EXPECT_NEAR(std::abs(surfels[i].second.z()), 1., 1e-12); // a plane is fitted exactly by a jet
  }
}

TEST(estimate_surfels, throws_on_invalid_input)
{
  Point_set few;
  few.insert({0., 0., 0.});
  EXPECT_THROW(GP::estimate_surfels(few), GP::Unsupported_surface_error);
  Point_set points = sphere_points();
  EXPECT_THROW(GP::estimate_surfels(points, GP::parameters::number_of_neighbors(3u)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::estimate_surfels(points, GP::parameters::outlier_percentage(-1.)),
               GP::Invalid_argument_error);
  points.insert({std::numeric_limits<double>::infinity(), 0., 0.});
  EXPECT_THROW(GP::estimate_surfels(points), GP::Invalid_argument_error);
  EXPECT_FALSE(points.has_normal_map());
  EXPECT_FALSE(points.has_property_map<double>("radius"));
}

} // namespace estimate_surfels_test
