// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <limits>

namespace surfel_neighbors_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Square roots of sums of three squares, in different order.
constexpr double round_off = 1e-15;

TEST(surfel_neighbors, are_the_nearest_compatible_surfels)
{
  // Two sheets with opposite normals: only surfels of the same sheet are compatible.
  Cloud sheets = square_cloud(12);
  for(std::size_t i = 0; i < 144; ++i)
    sheets.add(sheets.points[i] + Vec3{0.01, 0.02, 0.05}, {0., 0., -1.});
  std::vector<Index> order;
  Sorted_surfels surfels;
  surfels.point = sheets.points;
  surfels.tree = Kd_tree(surfels.point, order);
  for(const Index i : order)
    surfels.normal.push_back(sheets.normals[i]);
  const std::vector<Vec3>&point = surfels.point, &normal = surfels.normal;
  Neighbor_distances distances;
  const Compatibility_test compatibility_test = {0.5};
  const Ragged_rows neighbors = find_neighbors(surfels, &compatibility_test, 20, 1, distances),
                    all = find_neighbors(surfels, nullptr, 20, 1, distances);
  for(Index i = 0; i < point.size(); ++i)
  {
    EXPECT_EQ(all.end(i) - all.begin(i), 20);
    std::vector<Index> expected;
    double last = 0.;
    for(const Index* j = all.begin(i); j != all.end(i); ++j)
    {
      const double distance = norm(point[*j] - point[i]);
      EXPECT_LE(last, distance * (1. + round_off));
      last = distance;
      if(normal[i] == normal[*j])
        expected.push_back(*j);
    }
    EXPECT_NEAR(distances.search_radius[i], last, round_off);
    EXPECT_NEAR(distances.spacing[i], norm(point[all.begin(i)[5]] - point[i]), round_off);
    EXPECT_EQ(std::vector<Index>(neighbors.begin(i), neighbors.end(i)), expected);
  }
}

TEST(surfel_neighbors, are_compatible_on_arcs_but_not_through_sheets)
{
  const Compatibility_test compatibility_test = {0.5};
  const Vec3 up = {0., 0., 1.}, tilted = unit({0.3, 0., 1.});
  EXPECT_EQ(compatibility_test({0., 0., 0.}, up, {1., 0., 0.}, up), Compatibility::gentle);
  EXPECT_EQ(compatibility_test({0., 0., 0.}, up, {0., 0., 1.}, up), Compatibility::incompatible);
  EXPECT_EQ(compatibility_test({0., 0., 0.}, up, {1., 0., 0.}, {0., 0., -1.}),
            Compatibility::incompatible);
  EXPECT_EQ(compatibility_test({0., 0., 0.}, up, {1., 0., -0.15}, tilted), Compatibility::gentle);
}

TEST(surfel_neighbors, normalizes_normals)
{
  std::vector<Vec3> normals = {{0., 3., 4.}, {1e-200, 0., 0.}, {0., -1e200, 0.}};
  normalize(normals);
  EXPECT_EQ(normals, (std::vector<Vec3>{{0., 0.6, 0.8}, {1., 0., 0.}, {0., -1., 0.}}));
  normals = {{0., 0., 0.}};
  EXPECT_THROW(normalize(normals), Invalid_argument_error);
  normals = {{std::numeric_limits<double>::infinity(), 0., 0.}};
  EXPECT_THROW(normalize(normals), Invalid_argument_error);
}

TEST(surfel_neighbors, throws_on_different_sizes)
{
  EXPECT_NO_THROW(check_sizes(3, 3, 0));
  EXPECT_NO_THROW(check_sizes(3, 3, 3));
  EXPECT_THROW(check_sizes(3, 2, 0), Invalid_argument_error);
  EXPECT_THROW(check_sizes(3, 3, 2), Invalid_argument_error);
  EXPECT_THROW(check_sizes(std::size_t(1) << 26, std::size_t(1) << 26, 0),
               Unsupported_surface_error);
}

TEST(surfel_neighbors, merges_coincident_surfels)
{
  const std::vector<Vec3> points = {{0., 0., 0.}, {1., 0., 0.}, {0., 0., 0.}, {0., 0., 0.}};
  const std::vector<Vec3> normals = {{0., 0., 1.}, {0., 0., 1.}, {0., 0., 1.}, {0., 0., -1.}};
  const Sorted_surfels sorted = sort_surfels(points, normals, 0.5, 1);
  ASSERT_EQ(sorted.point.size(), 3u);
  EXPECT_EQ(sorted.tree.size(), 3u);
  for(Index i = 0; i < 4; ++i)
  {
    const Index v = sorted.internal_vertex[i];
    EXPECT_EQ(sorted.caller_vertex[v], i == 2 ? 0 : i); // the third surfel is a copy of the first
    EXPECT_EQ(sorted.frame.origin + sorted.frame.scale * sorted.point[v], points[i]);
    EXPECT_EQ(sorted.normal[v], normals[i]);
  }
  // A given frame determines the coordinates.
  const Frame frame = {{4., 0., 0.}, 8.};
  EXPECT_EQ(sort_surfels(points, normals, 0.5, 1, &frame).point[sorted.internal_vertex[1]],
            (Vec3{-0.375, 0., 0.}));
}

TEST(Ragged_rows, rows_can_be_replaced_and_joined)
{
  // Row i has i % 5 entries in the first and i % 7 in the second version.
  const std::size_t size = 2 * surfel_block_size + 10;
  const auto entry = [](std::size_t row, std::size_t k) { return Index(100 * row + k); };
  Ragged_rows rows(size);
  for(std::size_t row = 0; row < size; ++row)
  {
    for(std::size_t k = 0; k < row % 5; ++k)
      rows.buffer(row / surfel_block_size).push_back(entry(row, k));
    rows.end_row(row / surfel_block_size, row);
  }
  for(std::size_t block = 0; block < 3; ++block)
    rows.replace_rows(
        block,
        [&](std::size_t row, const Index* begin, const Index* end, std::vector<Index>& result)
        {
          ASSERT_EQ(std::size_t(end - begin), row % 5);
          for(std::size_t k = 0; k < row % 5; ++k)
            EXPECT_EQ(begin[k], entry(row, k));
          for(std::size_t k = 0; k < row % 7; ++k)
            result.push_back(entry(row, k));
        });
  const auto expect_new_rows = [&]
  {
    for(std::size_t row = 0; row < size; ++row)
    {
      ASSERT_EQ(std::size_t(rows.end(row) - rows.begin(row)), row % 7);
      for(std::size_t k = 0; k < row % 7; ++k)
        EXPECT_EQ(rows.begin(row)[k], entry(row, k));
    }
  };
  expect_new_rows();
  rows.join();
  expect_new_rows();
  EXPECT_EQ(rows.entries.size(), rows.row_begin.back());
  EXPECT_EQ(rows.entries.capacity(), rows.entries.size());
}

TEST(surfel_neighbors, estimates_missing_radii)
{
  const Cloud square = square_cloud(9);
  const Sorted_surfels sorted = sort_surfels(square.points, square.normals, 0.5, 1);
  Neighbor_distances distances;
  const Ragged_rows neighbors = find_neighbors(sorted, nullptr, 20, 1, distances);
  std::vector<double> given(81);
  for(std::size_t i = 0; i < 81; ++i)
    given[i] = double(i);
  const std::vector<double> estimated_radii = surfel_radii(sorted, {}, neighbors, 8, 1),
                            scaled_radii = surfel_radii(sorted, given, neighbors, 8, 1);
  const Index middle = sorted.internal_vertex[40];
  // The eight nearest surfels are within a diagonal of the lattice.
  EXPECT_NEAR(sorted.frame.scale * estimated_radii[middle], 1. / 8., round_off);
  EXPECT_EQ(sorted.frame.scale * scaled_radii[sorted.internal_vertex[1]], 1.);
  EXPECT_EQ(scaled_radii[middle], 8.); // larger than the cloud
  given[7] = -1.;
  EXPECT_THROW(surfel_radii(sorted, given, neighbors, 8, 1), Invalid_argument_error);
  given[7] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(surfel_radii(sorted, given, neighbors, 8, 1), Invalid_argument_error);
}

} // namespace surfel_neighbors_test
