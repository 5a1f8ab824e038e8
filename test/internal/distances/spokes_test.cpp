// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/spokes.h>

#include <CGAL/Geodesic_processing/internal/core/planar.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

TEST(Spokes, are_the_sides_around_a_site_and_the_triangles_between_them)
{
  // A pinched site, borders, and a closed surface.
  const Triangulation bow = {
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}}, {0, 1, 2, 0, 3, 4}};
  for(const Triangulation& triangulation : {bow, square(5), icosphere(2)})
  {
    const Glued_surface surface(triangulation);
    const Glued_triangles& t = *surface.triangles();
    const Spokes s = spokes(t, true);
    for(Index site = 0; site < t.number_of_sites(); ++site)
    {
      // The triangles of the star, in its order.
      Index i = t.first[site];
      for(Index j = s.first[site].spoke; j < s.first[site + 1].spoke; ++j)
      {
        if(!(s.spokes[j].flags & Spokes::Spoke::has_triangle))
          continue;
        ASSERT_LT(i, t.first[site + 1]);
        const Index corner = t.star[i++];
        EXPECT_EQ(s.spokes[j].end, t.corner[next_side(corner)]);
        EXPECT_EQ(s.spokes[j + 1].end, t.corner[previous_side(corner)]);
        EXPECT_EQ(s.spokes[j].length, t.length[corner]);
        EXPECT_EQ(s.spokes[j + 1].length, t.length[previous_side(corner)]);
        EXPECT_EQ(s.spokes[j].opening, corner_angle(t, corner));
        EXPECT_EQ(place_of(t, s, site, corner).spoke, j);
        EXPECT_EQ(place_of(t, s, site, corner).star, i - 1);
      }
      EXPECT_EQ(i, t.first[site + 1]);
      if(i == t.first[site])
        continue;
      EXPECT_FALSE(s.spokes[s.first[site + 1].spoke - 1].flags & Spokes::Spoke::has_triangle);
    }
  }
}

TEST(Spokes, split_obtuse_corners_of_the_plane_into_acute_ones)
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
  const Spokes s = spokes(t, true);
  const auto at = [&](Index site) { return surface.point(surface.point_of_site(site)); };
  // Each split is seen from both ends of the bases of its two halves.
  std::vector<int> views(t.corner.size(), 0);
  for(Index site = 0; site < t.number_of_sites(); ++site)
    for(Index i = s.first[site].split; i < s.first[site + 1].split; ++i)
    {
      const Spokes::Split& split = s.splits[i];
      ++views[split.corner];
      EXPECT_LT(corner_angle(t, split.corner)[0], 0.);
      EXPECT_EQ(split.target, t.corner[split.corner]);
      const Index behind = split.neighbour == site ? split.along : site;
      const Point x = at(t.corner[split.corner]), w = at(behind);
      EXPECT_TRUE(split.neighbour == t.corner[next_side(split.corner)] ||
                  split.neighbour == t.corner[previous_side(split.corner)]);
      EXPECT_TRUE(split.neighbour == site || split.neighbour == split.along);
      // A few unfoldings, each with a few roundings.
      EXPECT_NEAR(surface.scale() * split.base, distance(at(site), at(split.along)), 1e-12);
      const Planar to_along = split.apex - Planar{split.base, 0.};
      EXPECT_NEAR(surface.scale() * norm(split.apex), distance(at(site), x), 1e-12);
      EXPECT_NEAR(surface.scale() * norm(to_along), distance(at(split.along), x), 1e-12);
      const Point a = at(split.neighbour);
      EXPECT_GT(dot(Point{a[0] - x[0], a[1] - x[1], 0.}, Point{w[0] - x[0], w[1] - x[1], 0.}), 0.);
    }
  std::size_t split_corners = 0;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    const bool is_split = views[corner] != 0;
    EXPECT_TRUE(views[corner] == 0 || views[corner] == 4);
    split_corners += is_split;
    // Behind the border there is nothing.  Farther inside than 20 thin triangles there is.
    const Point p = at(t.corner[corner]);
    const bool is_inner = p[0] > 0.2 && p[0] < 0.8 && p[1] > 0.12 && p[1] < 0.18;
    EXPECT_TRUE(is_split || !is_inner || corner_angle(t, corner)[0] >= 0.);
  }
  EXPECT_GT(split_corners, 100u);
  // What is split is reached through its halves only.
  for(Index site = 0; site < t.number_of_sites(); ++site)
  {
    Index i = t.first[site];
    for(Index j = s.first[site].spoke; j < s.first[site + 1].spoke; ++j)
      if(const Index flags = s.spokes[j].flags; flags & Spokes::Spoke::has_triangle)
      {
        const Index corner = t.star[i++];
        EXPECT_EQ((flags & Spokes::Spoke::is_split) != 0, views[next_side(corner)] != 0);
        EXPECT_EQ((flags & Spokes::Spoke::next_is_split) != 0, views[previous_side(corner)] != 0);
      }
  }
}

TEST(Spokes, know_where_a_surface_does_not_unfold)
{
  const auto number_of_curved = [](const Triangulation& triangulation)
  {
    const Glued_surface surface(triangulation);
    const Glued_triangles& t = *surface.triangles();
    const Spokes s = spokes(t, false);
    std::size_t result = 0;
    for(Index site = 0; site < t.number_of_sites(); ++site)
      result += (s.spokes[s.first[site].spoke].flags & Spokes::Spoke::is_curved) != 0;
    return result;
  };
  EXPECT_EQ(number_of_curved(square(10, 0.25)), 0u);
  // Creases and borders unfold, tips and saddles do not.
  const auto fold = [](double u, double v) { return Point{u, v, std::abs(u - 0.5)}; };
  EXPECT_EQ(number_of_curved(grid(10, 10, fold)), 0u);
  EXPECT_EQ(number_of_curved(cone(8, 3, 5.)), 1u);
  EXPECT_EQ(number_of_curved(cone(8, 3, 7.)), 1u);
  const Triangulation sphere = icosphere(2);
  EXPECT_EQ(number_of_curved(sphere), sphere.points.size());
}

TEST(Spokes, are_not_split_where_no_corner_is_obtuse_or_nothing_lies_behind)
{
  EXPECT_TRUE(spokes(*Glued_surface(icosphere(2)).triangles(), true).splits.empty());
  EXPECT_TRUE(spokes(*Glued_surface(square(20)).triangles(), true).splits.empty()); // right angles
  const Triangulation obtuse = {{{0., 0., 0.}, {4., 0., 0.}, {2., 0.5, 0.}}, {0, 1, 2}};
  EXPECT_TRUE(spokes(*Glued_surface(obtuse).triangles(), true).splits.empty());
}

TEST(Spokes, are_shared_as_long_as_somebody_has_them)
{
  const Glued_surface surface(square(4, 0.2));
  const auto plain = shared_spokes(surface.t(), false), split = shared_spokes(surface.t(), true);
  EXPECT_EQ(shared_spokes(surface.t(), false), plain);
  EXPECT_EQ(shared_spokes(surface.t(), true), split);
  EXPECT_NE(plain, split);
  // Lengths of copies may be changed.
  Glued_triangles copy = surface.t();
  for(double& length : copy.length)
    length *= 2.;
  EXPECT_EQ(shared_spokes(copy, false)->spokes[0].length, 2. * plain->spokes[0].length);
  Glued_triangles assigned = *Glued_surface(square(2)).triangles();
  const auto before = shared_spokes(assigned, false);
  assigned = copy;
  EXPECT_NE(before->spokes.size(), plain->spokes.size());
  EXPECT_EQ(shared_spokes(assigned, false)->spokes.size(), plain->spokes.size());
  std::weak_ptr<const Spokes> left = shared_spokes(copy, false);
  EXPECT_TRUE(left.expired());
}

} // namespace
