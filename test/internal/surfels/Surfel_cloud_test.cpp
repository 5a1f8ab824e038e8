// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace Surfel_cloud_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::set<std::pair<Index, Index>> edges(const Surfel_cloud& cloud)
{
  std::set<std::pair<Index, Index>> result;
  for(Index i = 0; i < cloud.number_of_vertices(); ++i)
    for(Index e = cloud.graph.begin[i]; e < cloud.graph.begin[i + 1]; ++e)
      EXPECT_TRUE(result.emplace(i, cloud.graph.target[e]).second) << "duplicate edge";
  return result;
}

TEST(Surfel_cloud, graph_is_symmetric)
{
  const Cloud torus = torus_cloud(1000, 0.4);
  for(const Surfel_graph graph :
      {Surfel_graph::extended_spheres, Surfel_graph::spheres, Surfel_graph::nearest})
  {
    Surfel_cloud_options options;
    options.graph = graph;
    const Surfel_cloud cloud = make_cloud(torus.points, torus.normals, {}, options);
    const auto all = edges(cloud);
    for(const auto& [a, b] : all)
    {
      EXPECT_NE(a, b);
      EXPECT_TRUE(all.count({b, a}) > 0);
    }
  }
}

TEST(Surfel_cloud, connects_intersecting_spheres)
{
  // Compare with the definition for all pairs.
  const Cloud sphere = ellipsoid_cloud(300, {1., 0.9, 0.7});
  Surfel_cloud_options options;
  options.neighbors = 299;
  const Surfel_cloud cloud = make_cloud(sphere.points, sphere.normals, {}, options);
  const auto found = edges(cloud);
  for(Index i = 0; i < 300; ++i)
    for(Index j = 0; j < 300; ++j)
    {
      const double distance = norm(cloud.point[i] - cloud.point[j]);
      const double max_distance = options.influence_ratio * (cloud.radius[i] + cloud.radius[j]);
      // The normals of surfels with intersecting spheres are compatible here.
      if(i != j && std::abs(distance - max_distance) > 1e-9)
      {
        EXPECT_EQ(found.count({i, j}) > 0, distance < max_distance);
      }
    }
  options.graph = Surfel_graph::spheres;
  const Surfel_cloud canonical_cloud = make_cloud(sphere.points, sphere.normals, {}, options);
  std::vector<double> nearest(300, infinity);
  for(Index i = 0; i < 300; ++i)
    for(Index j = 0; j < 300; ++j)
      if(i != j)
        nearest[i] =
            std::min(nearest[i], norm(canonical_cloud.point[i] - canonical_cloud.point[j]));
  const auto intersecting = edges(canonical_cloud);
  for(Index i = 0; i < 300; ++i)
    for(Index j = 0; j < 300; ++j)
      if(const double distance = norm(canonical_cloud.point[i] - canonical_cloud.point[j]);
         i != j && std::abs(distance - nearest[i] - nearest[j]) > 1e-9)
      {
        EXPECT_EQ(intersecting.count({i, j}) > 0, distance < nearest[i] + nearest[j]);
      }
}

TEST(Surfel_cloud, separates_sheets_by_normals)
{
  // Two parallel sheets at a distance of half a spacing, with opposite normals.
  Cloud sheets = square_cloud(20);
  for(std::size_t i = 0; i < 400; ++i)
    sheets.add(sheets.points[i] - Vec3{0., 0., 0.5 / 19.}, {0., 0., -1.});
  EXPECT_EQ(make_cloud(sheets.points, sheets.normals).number_of_components, 2u);
  Surfel_cloud_options options;
  options.graph = Surfel_graph::nearest;
  const Surfel_cloud joined = make_cloud(sheets.points, sheets.normals, {}, options);
  EXPECT_EQ(joined.number_of_components, 1u); // without normals, the sheets are connected
}

TEST(Surfel_cloud, labels_components)
{
  Cloud two = square_cloud(6);
  for(std::size_t i = 0; i < 36; ++i)
    two.add(two.points[i] + Vec3{7., 0., 0.}, two.normals[i]);
  const Surfel_cloud cloud = make_cloud(two.points, two.normals);
  ASSERT_EQ(cloud.number_of_components, 2u);
  for(std::size_t i = 0; i < 72; ++i)
    EXPECT_EQ(cloud.component[cloud.internal_vertex[i]] ==
                  cloud.component[cloud.internal_vertex[0]],
              i < 36);
}

TEST(Surfel_cloud, merges_coincident_surfels)
{
  Cloud twice = square_cloud(5);
  for(std::size_t i = 0; i < 25; ++i)
    twice.add(twice.points[i], twice.normals[i]);
  const Surfel_cloud cloud = make_cloud(twice.points, twice.normals);
  EXPECT_EQ(cloud.number_of_vertices(), 25u);
  for(std::size_t i = 0; i < 25; ++i)
  {
    EXPECT_EQ(cloud.internal_vertex[i], cloud.internal_vertex[25 + i]);
    EXPECT_EQ(cloud.caller_vertex[cloud.internal_vertex[i]], i);
  }
}

TEST(Surfel_cloud, does_not_depend_on_number_of_threads)
{
  const Cloud torus = torus_cloud(9000, 0.4);
  Surfel_cloud_options options;
  const Surfel_cloud one = make_cloud(torus.points, torus.normals, {}, options);
  options.number_of_threads = 3;
  const Surfel_cloud three = make_cloud(torus.points, torus.normals, {}, options);
  EXPECT_EQ(one.graph.begin, three.graph.begin);
  EXPECT_EQ(one.graph.target, three.graph.target);
}

TEST(Surfel_cloud, handles_few_surfels)
{
  EXPECT_EQ(make_cloud({}, {}).number_of_components, 0u);
  const Surfel_cloud one = make_cloud({{1., 2., 3.}}, {{0., 0., 5.}});
  EXPECT_EQ(one.number_of_components, 1u);
  EXPECT_EQ(one.radius[0], 0.);
}

TEST(Surfel_cloud, throws_on_invalid_surfels)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(make_cloud({{0., 0., 0.}}, {}), Invalid_argument_error);
  EXPECT_THROW(make_cloud({{0., nan, 0.}}, {{0., 0., 1.}}), Invalid_argument_error);
  EXPECT_THROW(make_cloud({{0., 0., 0.}}, {{0., 0., 0.}}), Invalid_argument_error);
  EXPECT_THROW(make_cloud({{0., 0., 0.}}, {{0., 0., 1.}}, {-1.}), Invalid_argument_error);
  Surfel_cloud_options options;
  options.neighbors = 0;
  EXPECT_THROW(make_cloud({}, {}, {}, options), Invalid_argument_error);
}

} // namespace Surfel_cloud_test
