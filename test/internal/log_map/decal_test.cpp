// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/decal.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The points of a square around its middle, as a map of itself; in reach of a distance.
struct Flat_map
{
  std::vector<Index> reached;
  std::vector<Planar> coordinates;

  explicit Flat_map(const Glued_triangles& t, double distance = infinity)
  {
    for(Index site = 0; site < t.number_of_sites(); ++site)
    {
      const Planar place = {t.point[site][0] + (t.origin[0] - 0.5) / t.scale,
                            t.point[site][1] + (t.origin[1] - 0.5) / t.scale};
      const bool is_inside = norm(place) <= distance;
      const double outside = std::numeric_limits<double>::quiet_NaN();
      coordinates.push_back(is_inside ? place : Planar{outside, outside});
      if(is_inside)
        reached.push_back(site);
    }
  }
};

TEST(decal, triangles_are_those_of_the_cells_that_a_rectangle_meets)
{
  // Ten cells a side, of two triangles each.  From 0.31 to 0.69 and from 0.45 to 0.55: cells 3 to 6 and
  // 4 to 5.
  const Glued_surface surface(square(10));
  const Flat_map map(surface.t());
  const Planar half = {0.19 / surface.scale(), 0.05 / surface.scale()};
  const Decal_triangles found = triangles_of_decal(surface.t(), map.reached, map.coordinates, half);
  EXPECT_EQ(found.longest_side, 0.);
  std::set<Index> inside;
  for(const auto& image : found.inside)
    inside.insert(image.triangle);
  EXPECT_EQ(inside.size(), found.inside.size());
  std::size_t cells = 0;
  for(Index f = 0; f < surface.t().number_of_triangles(); ++f)
  {
    Planar low = {infinity, infinity};
    for(Index k = 0; k < 3; ++k)
      for(int c = 0; c < 2; ++c)
        low[c] =
            std::min(low[c], map.coordinates[surface.t().corner[3 * f + k]][c] * surface.scale());
    const double column = std::round(10. * low[0]) + 5., row = std::round(10. * low[1]) + 5.;
    const bool is_in_cell = column >= 3. && column <= 6. && row >= 4. && row <= 5.;
    cells += is_in_cell;
    // A cell that is met in a corner only may have a triangle that is not.
    if(!is_in_cell)
    {
      EXPECT_EQ(inside.count(f), 0u);
    }
    else if(column >= 4. && column <= 5.)
    {
      EXPECT_EQ(inside.count(f), 1u);
    }
  }
  EXPECT_EQ(cells, 16u);
}

TEST(decal, a_border_that_is_only_touched_does_not_count)
{
  const Glued_surface surface(square(4)); // its lines are multiples of 1/4: exact
  const Flat_map map(surface.t());
  const Planar half = {0.25 / surface.scale(), 0.25 / surface.scale()};
  EXPECT_EQ(triangles_of_decal(surface.t(), map.reached, map.coordinates, half).inside.size(), 8u);
}

TEST(decal, says_how_long_sides_are_where_it_has_not_all_corners)
{
  const Glued_surface surface(square(10, 0.2));
  const double half = 0.2 / surface.scale();
  const Decal_triangles all = triangles_of_decal(surface.t(), Flat_map(surface.t()).reached,
                                                 Flat_map(surface.t()).coordinates, {half, half});
  // As far as the rectangle's corners: sides beyond it are missing.
  const Flat_map near(surface.t(), half * std::sqrt(2.));
  const Decal_triangles some =
      triangles_of_decal(surface.t(), near.reached, near.coordinates, {half, half});
  EXPECT_GT(some.longest_side, 0.);
  EXPECT_LT(some.inside.size(), all.inside.size());
  // Farther by as much as it says, everything is there.
  const Flat_map far(surface.t(), half * std::sqrt(2.) + some.longest_side);
  const Decal_triangles found =
      triangles_of_decal(surface.t(), far.reached, far.coordinates, {half, half});
  EXPECT_EQ(found.longest_side, 0.);
  EXPECT_EQ(found.inside.size(), all.inside.size());
}

TEST(decal, cut_triangles_are_made_whole)
{
  const Glued_surface surface(square(10, 0.2));
  Flat_map map(surface.t());
  const Flat_map truth = map;
  const Planar half = {1. / surface.scale(), 1. / surface.scale()};
  const Index moved = surface.site(60);
  map.coordinates[moved] = 0.9 * half; // as if behind a cut locus
  const auto found = triangles_of_decal(surface.t(), map.reached, map.coordinates, half);
  EXPECT_EQ(found.inside.size(), surface.t().number_of_triangles());
  for(const auto& [triangle, corners] : found.inside)
    for(Index k = 0; k < 3; ++k)
    {
      const Planar& place = truth.coordinates[surface.t().corner[3 * triangle + k]];
      EXPECT_LT(norm(corners[k] - place), 1e-13); // rounding
    }
  // Those without a whole side stay out.
  for(const Index near : {Index(61), Index(71), Index(70)})
    map.coordinates[surface.site(near)] = (double(near) - 65.) * half;
  EXPECT_LT(triangles_of_decal(surface.t(), map.reached, map.coordinates, half).inside.size(),
            found.inside.size());
}

TEST(decal, longest_sides_are_those_around)
{
  const Glued_surface surface(square(10));
  const double side = 0.1 / surface.scale();
  EXPECT_NEAR(longest_side_around(surface.t(), {none, surface.site(60), {}}), std::sqrt(2.) * side,
              1e-15); // rounding
  EXPECT_NEAR(longest_side_around(surface.t(), {0, none, {0.2, 0.3, 0.5}}), std::sqrt(2.) * side,
              1e-15);
}

TEST(decal, colours_are_seen_through_one_another)
{
  const Rgba red = {1., 0., 0., 1.}, green = {0., 1., 0., 0.5}, clear = {0.3, 0.2, 0.1, 0.};
  EXPECT_EQ(over(red, green), red);
  EXPECT_EQ(over(green, red), (Rgba{0.5, 0.5, 0., 1.}));
  EXPECT_EQ(over(clear, red), red);
  EXPECT_EQ(over(green, clear), green);
  EXPECT_EQ(over(clear, clear)[3], 0.);
  // In whatever order three are put together.
  const Rgba glass = {0.2, 0.4, 0.8, 0.25};
  const Rgba first = over(over(glass, green), red), last = over(glass, over(green, red));
  for(int c = 0; c < 4; ++c)
    EXPECT_NEAR(first[c], last[c], 1e-15); // rounding
}

TEST(decal, texels_belong_to_one_triangle)
{
  for(const std::size_t segments : {1u, 2u, 7u})
    for(const std::size_t number : {1u, 2u, 9u})
    {
      const Texture_cells cells(number, segments);
      std::vector<int> times(cells.width() * cells.height(), 0);
      for(std::size_t f = 0; f < number; ++f)
        cells.for_each_texel(
            f,
            [&](std::size_t texel, const std::array<double, 3>& shares)
            {
              ++times.at(texel);
              EXPECT_NEAR(shares[0] + shares[1] + shares[2], 1., 1e-14);
              // Where the texel is, seen from the corners.
              const auto corners = cells.corners(f);
              const Planar place =
                  shares[0] * corners[0] + shares[1] * corners[1] + shares[2] * corners[2];
              const double w = double(cells.width()), h = double(cells.height());
              EXPECT_NEAR(place[0] * w - 0.5, double(texel % cells.width()), 1e-10);
              EXPECT_NEAR(place[1] * h - 0.5, double(texel / cells.width()), 1e-10);
            });
      EXPECT_LE(*std::max_element(times.begin(), times.end()), 1);
    }
}

TEST(decal, interpolation_inside_of_a_triangle_sees_its_texels_alone)
{
  const std::size_t number = 5, segments = 3;
  const Texture_cells cells(number, segments);
  std::vector<std::size_t> owner(cells.width() * cells.height(), number);
  for(std::size_t f = 0; f < number; ++f)
    cells.for_each_texel(f, [&](std::size_t texel, const auto&) { owner[texel] = f; });
  const int steps = 40;
  for(std::size_t f = 0; f < number; ++f)
    for(int i = 0; i <= steps; ++i)
      for(int j = 0; i + j <= steps; ++j)
      {
        const auto corners = cells.corners(f);
        const Planar place = (double(i) / steps) * corners[0] + (double(j) / steps) * corners[1] +
                             (double(steps - i - j) / steps) * corners[2];
        const double x = place[0] * double(cells.width()) - 0.5,
                     y = place[1] * double(cells.height()) - 0.5;
        // Rounding is not seen.
        for(const double right : {1e-9, 1. - 1e-9})
          for(const double up : {1e-9, 1. - 1e-9})
            EXPECT_EQ(owner[std::size_t(y + up) * cells.width() + std::size_t(x + right)], f);
      }
}

TEST(decal, textures_have_a_largest_size)
{
  EXPECT_THROW(Texture_cells(1, 0), Invalid_argument_error);
  EXPECT_THROW(Texture_cells(std::size_t(1) << 40, 4), Invalid_argument_error);
  EXPECT_THROW(Texture_cells(2, std::size_t(1) << 60), Invalid_argument_error);
}

} // namespace
