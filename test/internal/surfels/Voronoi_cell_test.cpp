// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/Voronoi_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace Voronoi_cell_test {

using namespace CGAL::Geodesic_processing::internal;

// Round-off errors of distances near 1.
constexpr double round_off = 1e-14;

double area(const Voronoi_cell& cell)
{
  const auto& c = cell.corners();
  double sum = 0.;
  for(std::size_t i = 0; i < c.size(); ++i)
  {
    const auto& next = c[(i + 1) % c.size()];
    sum += 0.5 * (c[i].x * next.y - c[i].y * next.x);
  }
  return sum;
}

TEST(Voronoi_cell, clipping_removes_half_plane)
{
  Voronoi_cell cell;
  cell.reset(1.);
  EXPECT_EQ(cell.squared_radius(), 2.);
  cell.clip(2., 0., 1., 7); // x <= 1/2
  EXPECT_EQ(area(cell), 3.);
  EXPECT_EQ(cell.squared_radius(), 2.);
  cell.clip(-4., 0., 1., 8); // x >= -1/4
  EXPECT_EQ(area(cell), 1.5);
  EXPECT_EQ(cell.squared_radius(), 1.25);
  for(std::size_t i = 0; i < 4; ++i)
  {
    const auto &a = cell.corners()[i], &b = cell.corners()[(i + 1) % 4];
    EXPECT_EQ(a.edge, a.x == b.x ? (a.x > 0. ? 7u : 8u) : none);
  }
}

TEST(Voronoi_cell, half_plane_without_corners_or_with_all_changes_nothing)
{
  Voronoi_cell cell;
  cell.reset(1.);
  cell.clip(1., 0., 3., 7);
  cell.clip(1., 0., -3., 7);
  EXPECT_EQ(area(cell), 4.);
  for(const auto& corner : cell.corners())
    EXPECT_EQ(corner.edge, none);
}

TEST(Voronoi_cell, corners_are_equidistant_from_origin_and_both_labels)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1., 1.);
  std::vector<std::array<double, 2>> points;
  Voronoi_cell cell;
  cell.reset(10.);
  for(Index i = 0; i < 40; ++i)
  {
    const double x = coordinate(random), y = coordinate(random);
    points.push_back({x, y});
    cell.clip(x, y, (x * x + y * y) / 2., i);
  }
  const auto& corners = cell.corners();
  ASSERT_GE(corners.size(), 3u);
  for(std::size_t k = 0; k < corners.size(); ++k)
  {
    const double distance = std::hypot(corners[k].x, corners[k].y);
    const Index before = corners[(k + corners.size() - 1) % corners.size()].edge;
    for(Index i = 0; i < points.size(); ++i)
    {
      const double other = std::hypot(corners[k].x - points[i][0], corners[k].y - points[i][1]);
      EXPECT_GT(other, distance - round_off);
      if(i == corners[k].edge || i == before)
      {
        EXPECT_NEAR(other, distance, round_off);
      }
    }
  }
}

} // namespace Voronoi_cell_test
