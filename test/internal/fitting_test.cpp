// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/fitting.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Two triangles over the unit square, whose corners are the cells 0 to 3, and the cell of each site:
// the nearest corner.
struct Over_square
{
  Glued_surface fine;
  Coarse_mesh coarse;
  std::vector<Index> labels;

  explicit Over_square(const Triangulation& surface) : fine(surface)
  {
    const Glued_triangles& t = fine.t();
    const auto scaled = [&](const Point& p) { return (1. / t.scale) * (p - t.origin); };
    coarse.points = {scaled({0., 0., 0.}), scaled({1., 0., 0.}), scaled({0., 1., 0.}),
                     scaled({1., 1., 0.})};
    coarse.triangles = {{0, 1, 3}, {0, 3, 2}};
    for(Index site = 0; site < t.number_of_sites(); ++site)
    {
      const Point p = t.origin + t.scale * t.point[site];
      labels.push_back((p[0] > 0.5 ? 1 : 0) + (p[1] > 0.5 ? 2 : 0));
    }
  }
};

TEST(Fitting, leaves_what_is_on_the_surface)
{
  Over_square over(square(10));
  const std::vector<Spatial> before = over.coarse.points;
  // Roundings of numbers below two.
  EXPECT_TRUE(far_sites(over.fine.t(), over.labels, over.coarse, 1e-14).empty());
  fit(over.fine.t(), over.labels, std::vector<bool>(4, false), over.coarse);
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_LT(norm(over.coarse.points[i] - before[i]), 1e-14);
}

TEST(Fitting, moves_points_to_a_surface_above_them)
{
  Triangulation high = square(10);
  for(Point& p : high.points)
    p[2] = 0.1;
  Over_square over(high);
  const double scale = over.fine.scale();
  // One for each cell, as all are as far.
  EXPECT_EQ(far_sites(over.fine.t(), over.labels, over.coarse, 0.09 / scale).size(), 4u);
  EXPECT_TRUE(far_sites(over.fine.t(), over.labels, over.coarse, 0.11 / scale).empty());
  Over_square held = over;
  fit(over.fine.t(), over.labels, std::vector<bool>(4, false), over.coarse);
  fit(held.fine.t(), held.labels, {true, false, false, false}, held.coarse);
  const Spatial first = held.coarse.points[0];
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scale * (over.coarse.points[i][2] - first[2]), 0.1, 1e-14); // rounding
  for(std::size_t i = 1; i < 4; ++i)
    EXPECT_GT(scale * (held.coarse.points[i][2] - first[2]), 0.1); // for what is held

  Over_square near(high);
  fit(near.fine.t(), near.labels, std::vector<bool>(4, false), near.coarse, 0.04 / scale);
  for(std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(scale * (near.coarse.points[i][2] - first[2]), 0.04, 1e-14); // rounding
}

TEST(Fitting, finds_the_farthest_site_of_a_cell)
{
  // A bump at one vertex.
  Triangulation bump = square(10);
  bump.points[3 * 11 + 8][2] = 0.3;
  bump.points[3 * 11 + 7][2] = 0.2;
  Over_square over(bump);
  const double scale = over.fine.scale();
  EXPECT_EQ(far_sites(over.fine.t(), over.labels, over.coarse, 0.1 / scale),
            std::vector<Index>{over.fine.site(3 * 11 + 8)});
  over.labels[over.fine.site(3 * 11 + 8)] = none;
  EXPECT_EQ(far_sites(over.fine.t(), over.labels, over.coarse, 0.1 / scale),
            std::vector<Index>{over.fine.site(3 * 11 + 7)});
}

} // namespace
