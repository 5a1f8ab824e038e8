// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(surfel_neighbors, are_the_nearest_that_agree)
{
  // Two sheets, of which each surfel sees its own.
  Cloud sheets = square_cloud(12);
  for(std::size_t i = 0; i < 144; ++i)
    sheets.add(sheets.points[i] + Spatial{0.01, 0.02, 0.05}, {0., 0., -1.});
  std::vector<Index> order;
  std::vector<Spatial> point = sheets.points, normal;
  const Kd_tree tree(point, order);
  for(const Index i : order)
    normal.push_back(sheets.normals[i]);
  Surroundings around;
  const Agree agree = {0.5};
  const Rows near = find_neighbors(point, normal, tree, &agree, 20, 1, around),
             all = find_neighbors(point, normal, tree, nullptr, 20, 1, around);
  for(Index i = 0; i < point.size(); ++i)
  {
    EXPECT_EQ(all.end(i) - all.begin(i), 20);
    std::vector<Index> expected;
    double last = 0.;
    for(const Index* j = all.begin(i); j != all.end(i); ++j)
    {
      const double distance = norm(point[*j] - point[i]);
      EXPECT_LE(last, distance * (1. + 1e-15));
      last = distance;
      if(normal[i] == normal[*j])
        expected.push_back(*j);
    }
    EXPECT_NEAR(around.seen[i], last, 1e-15);
    EXPECT_NEAR(around.spacing[i], norm(point[all.begin(i)[5]] - point[i]), 1e-15);
    EXPECT_EQ(std::vector<Index>(near.begin(i), near.end(i)), expected);
  }
}

TEST(surfel_neighbors, agree_on_arcs_and_not_through_sheets)
{
  const Agree agree = {0.5};
  const Spatial up = {0., 0., 1.}, tilted = unit({0.3, 0., 1.});
  EXPECT_EQ(agree({0., 0., 0.}, up, {1., 0., 0.}, up), Agreement::gentle);
  EXPECT_EQ(agree({0., 0., 0.}, up, {0., 0., 1.}, up), Agreement::no);
  EXPECT_EQ(agree({0., 0., 0.}, up, {1., 0., 0.}, {0., 0., -1.}), Agreement::no);
  EXPECT_EQ(agree({0., 0., 0.}, up, {1., 0., -0.15}, tilted), Agreement::gentle);
}

TEST(surfel_neighbors, makes_normals_unit_vectors)
{
  std::vector<Spatial> normals = {{0., 3., 4.}, {1e-200, 0., 0.}, {0., -1e200, 0.}};
  normalize(normals);
  EXPECT_EQ(normals, (std::vector<Spatial>{{0., 0.6, 0.8}, {1., 0., 0.}, {0., -1., 0.}}));
  normals = {{0., 0., 0.}};
  EXPECT_THROW(normalize(normals), Invalid_argument_error);
  normals = {{std::numeric_limits<double>::infinity(), 0., 0.}};
  EXPECT_THROW(normalize(normals), Invalid_argument_error);
}

TEST(surfel_neighbors, count_alike)
{
  EXPECT_NO_THROW(check_sizes(3, 3, 0));
  EXPECT_NO_THROW(check_sizes(3, 3, 3));
  EXPECT_THROW(check_sizes(3, 2, 0), Invalid_argument_error);
  EXPECT_THROW(check_sizes(3, 3, 2), Invalid_argument_error);
  EXPECT_THROW(check_sizes(std::size_t(1) << 26, std::size_t(1) << 26, 0),
               Unsupported_surface_error);
}

TEST(surfel_neighbors, sorts_surfels_without_copies)
{
  const std::vector<Spatial> points = {{0., 0., 0.}, {1., 0., 0.}, {0., 0., 0.}, {0., 0., 0.}};
  const std::vector<Spatial> normals = {{0., 0., 1.}, {0., 0., 1.}, {0., 0., 1.}, {0., 0., -1.}};
  const Sorted_surfels sorted = sort_surfels(points, normals, 0.5, 1);
  ASSERT_EQ(sorted.point.size(), 3u);
  EXPECT_EQ(sorted.tree.size(), 3u);
  for(Index i = 0; i < 4; ++i)
  {
    const Index site = sorted.site_of_surfel[i];
    EXPECT_EQ(sorted.surfel_of_site[site], i == 2 ? 0 : i); // the third is the first one's copy
    EXPECT_EQ(sorted.frame.origin + sorted.frame.scale * sorted.point[site], points[i]);
    EXPECT_EQ(sorted.normal[site], normals[i]);
  }
  // In another frame.
  const Frame frame = {{4., 0., 0.}, 8.};
  EXPECT_EQ(sort_surfels(points, normals, 0.5, 1, &frame).point[sorted.site_of_surfel[1]],
            (Spatial{-0.375, 0., 0.}));
}

TEST(surfel_neighbors, give_radii_where_there_are_none)
{
  const Cloud square = square_cloud(9);
  const Sorted_surfels sorted = sort_surfels(square.points, square.normals, 0.5, 1);
  Surroundings around;
  const Rows near =
      find_neighbors(sorted.point, sorted.normal, sorted.tree, nullptr, 20, 1, around);
  std::vector<double> given(81);
  for(std::size_t i = 0; i < 81; ++i)
    given[i] = double(i);
  const std::vector<double> found = site_radii(sorted, {}, near, 8, 1),
                            read = site_radii(sorted, given, near, 8, 1);
  const Index middle = sorted.site_of_surfel[40];
  // Eight are no farther than a diagonal of the lattice.
  EXPECT_NEAR(sorted.frame.scale * found[middle], 1. / 8., 1e-15);
  EXPECT_EQ(sorted.frame.scale * read[sorted.site_of_surfel[1]], 1.);
  EXPECT_EQ(read[middle], 8.); // larger than the cloud
  given[7] = -1.;
  EXPECT_THROW(site_radii(sorted, given, near, 8, 1), Invalid_argument_error);
  given[7] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(site_radii(sorted, given, near, 8, 1), Invalid_argument_error);
}

} // namespace
