// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Glued_surface.h"
#include "topology.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

double area(const Glued_triangles& t)
{
  double result = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    result += 0.5 * twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
  return t.scale * t.scale * result;
}

std::vector<bool> random_sides(const Glued_triangles& t, std::mt19937& random, unsigned one_of)
{
  std::vector<bool> result(t.corner.size(), false);
  for(Index side = 0; side < result.size(); ++side)
    if(random() % one_of == 0)
    {
      result[side] = true;
      if(t.twin[side] != none)
        result[t.twin[side]] = true;
    }
  return result;
}

void expect_same_surface(const Refinement& refinement)
{
  const Glued_triangles &fine = *refinement.triangles, &coarse = *refinement.coarse;
  EXPECT_EQ(topology(fine.corner), topology(coarse.corner));
  // Of sums of a thousand terms.
  EXPECT_NEAR(area(fine), area(coarse), 1e-12 * area(coarse));
  for(Index side = 0; side < fine.corner.size(); ++side)
  {
    const Index twin = fine.twin[side];
    if(twin == none)
      continue;
    EXPECT_EQ(fine.twin[twin], side);
    EXPECT_EQ(fine.corner[side], fine.corner[next_side(twin)]);
    EXPECT_EQ(fine.length[side], fine.length[twin]);
  }
}

TEST(Refinement, of_nothing_is_the_surface)
{
  const Glued_surface surface(icosphere(2));
  const Refinement same = refinement(surface.triangles());
  EXPECT_EQ(same.triangles, surface.triangles());
  const Location place = surface.in(3, {0.2, 0.3, 0.5});
  EXPECT_EQ(to_coarse(same, place).barycentric, place.barycentric);
  EXPECT_EQ(to_fine(same, {place})[0].triangle, place.triangle);
}

TEST(Refinement, keeps_the_surface)
{
  std::mt19937 random(1);
  for(const Triangulation& triangulation :
      {icosphere(1), square(6, 0.2), cylinder(7, 4, 1., 2.), torus(7, 5), one_triangle()})
    for(const unsigned one_of : {1u, 2u, 5u})
      for(const double scale : {1e-6, 1., 1e6})
      {
        const Glued_surface surface(scaled(triangulation, scale));
        Refinement fine = refinement(surface.triangles());
        for(int i = 0; i < 3; ++i)
        {
          fine = halved(fine, random_sides(*fine.triangles, random, one_of));
          expect_same_surface(fine);
        }
        for(int i = 0; i < 50; ++i)
        {
          const Location place = random_location(*fine.triangles, random);
          const Location there = to_coarse(fine, place);
          const Point p = coordinates(*fine.triangles, place);
          // A few roundings of numbers up to the scale.
          EXPECT_LT(distance(p, coordinates(surface.t(), there)), 1e-14 * scale);
          EXPECT_LT(distance(p, coordinates(*fine.triangles, to_fine(fine, {there})[0])),
                    1e-13 * scale);
        }
        // Sites of the surface are sites still, to the last bit.
        for(Index i = 0; i < surface.size(); ++i)
        {
          const Location there = to_fine(fine, {surface.at(i)})[0];
          const Index site = site_of(*fine.triangles, there);
          ASSERT_NE(site, none);
          EXPECT_EQ(site_of(surface.t(), to_coarse(fine, {none, site, {}})), surface.site(i));
        }
      }
}

TEST(Refinement, halves_what_it_is_told)
{
  const Glued_surface surface(one_triangle());
  const Refinement whole = refinement(surface.triangles());
  for(Index mask = 0; mask < 8; ++mask)
  {
    const std::vector<bool> sides = {bool(mask & 1), bool(mask & 2), bool(mask & 4)};
    const std::size_t number = sides[0] + sides[1] + sides[2];
    const Refinement fine = halved(whole, sides);
    EXPECT_EQ(fine.triangles->number_of_triangles(), 1 + number);
    EXPECT_EQ(fine.triangles->number_of_sites(), 3 + number);
    expect_same_surface(fine);
    const std::vector<Index> coarse = coarse_sides(fine);
    for(Index side = 0; side < 3; ++side)
      EXPECT_EQ(std::count(coarse.begin(), coarse.end(), side), sides[side] ? 2 : 1);
  }
}

TEST(Refinement, takes_pinched_sites_apart)
{
  // Two tetrahedra with a common corner.
  Triangulation pinched = tetrahedron();
  for(const Point& p : {Point{3., 1., 1.}, Point{3., 3., 1.}, Point{3., 1., 3.}})
    pinched.points.push_back(p);
  pinched.corners.insert(pinched.corners.end(), {0, 4, 5, 0, 5, 6, 0, 6, 4, 4, 6, 5});
  const Glued_surface surface(pinched);
  EXPECT_FALSE(topology(surface.t().corner).is_simple);
  const Refinement apart = refinement(surface.triangles());
  EXPECT_EQ(apart.triangles->number_of_sites(), 8u);
  EXPECT_EQ(topology(apart.triangles->corner), (Topology{true, {{2, 0}, {2, 0}}}));
  EXPECT_EQ(site_of(surface.t(), to_coarse(apart, to_fine(apart, {surface.at(0)})[0])),
            surface.site(0));
}

} // namespace
