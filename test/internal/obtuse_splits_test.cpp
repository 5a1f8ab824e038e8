// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/obtuse_splits.h>

#include <CGAL/Geodesic_processing/internal/planar.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Obtuse_splits, split_obtuse_corners_of_the_plane_into_acute_ones)
{
  // In the plane what is unfolded lies where it is.
  const Triangulation plane = grid(
      20, 20,
      [](double u, double v) {
        return Point{u, 0.3 * v, 0.};
      },
      0.24);
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  const Obtuse_splits splits = obtuse_splits(t);
  std::size_t split_corners = 0, inner_obtuse = 0, inner_missed = 0;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    const bool is_obtuse = corner_angle(t, corner)[0] < 0.;
    const Index index = splits.split_of_corner[corner];
    if(index == none)
    {
      // Behind the border there is nothing.  Farther inside than 20 thin triangles there is.
      const Point& p = surface.point(surface.point_of_site(t.corner[corner]));
      const bool is_inner = p[0] > 0.2 && p[0] < 0.8 && p[1] > 0.12 && p[1] < 0.18;
      inner_obtuse += is_obtuse && is_inner;
      inner_missed += is_obtuse && is_inner;
      continue;
    }
    ++split_corners;
    EXPECT_TRUE(is_obtuse);
    const Obtuse_splits::Split& split = splits.splits[index];
    EXPECT_EQ(split.corner, corner);
    const Point x = surface.point(surface.point_of_site(t.corner[corner])),
                a = surface.point(surface.point_of_site(t.corner[next_side(corner)])),
                b = surface.point(surface.point_of_site(t.corner[previous_side(corner)])),
                w = surface.point(surface.point_of_site(split.site));
    // A few unfoldings, each with a few roundings.
    EXPECT_NEAR(surface.scale() * split.length, distance(x, w), 1e-12);
    EXPECT_NEAR(surface.scale() * split.base[0], distance(a, w), 1e-12);
    EXPECT_NEAR(surface.scale() * split.base[1], distance(b, w), 1e-12);
    const auto from_x = [&](const Point& p) { return Point{p[0] - x[0], p[1] - x[1], 0.}; };
    EXPECT_GT(dot(from_x(a), from_x(w)), 0.);
    EXPECT_GT(dot(from_x(b), from_x(w)), 0.);
  }
  EXPECT_GT(split_corners, 100u);
  EXPECT_EQ(inner_missed, 0u) << "of " << inner_obtuse;
}

TEST(Obtuse_splits, are_found_from_the_site_behind)
{
  const Glued_surface surface(shaken(icosphere(3), 0.06));
  const Glued_triangles& t = *surface.triangles();
  const Obtuse_splits splits = obtuse_splits(t);
  EXPECT_GT(splits.splits.size(), 0u);
  EXPECT_EQ(splits.behind.size(), splits.splits.size());
  for(Index site = 0; site < t.number_of_sites(); ++site)
    for(Index i = splits.first[site]; i < splits.first[site + 1]; ++i)
      EXPECT_EQ(splits.splits[splits.behind[i]].site, site);
}

TEST(Obtuse_splits, are_none_where_no_corner_is_obtuse_or_nothing_lies_behind)
{
  EXPECT_TRUE(obtuse_splits(*Glued_surface(icosphere(2)).triangles()).splits.empty());
  EXPECT_TRUE(obtuse_splits(*Glued_surface(square(20)).triangles()).splits.empty()); // right angles
  const Triangulation obtuse = {{{0., 0., 0.}, {4., 0., 0.}, {2., 0.5, 0.}}, {0, 1, 2}};
  EXPECT_TRUE(obtuse_splits(*Glued_surface(obtuse).triangles()).splits.empty());
}

} // namespace
