// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/decal.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace decal_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The identity map of the unit square, relative to its center. Only vertices up to a distance from
// the center are reached.
struct Flat_map
{
  std::vector<Index> reached;
  std::vector<Vec2> coordinates;

  explicit Flat_map(const Surface_arrays& t, double distance = infinity)
  {
    for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    {
      const Vec2 position = {t.point[vertex][0] + (t.origin[0] - 0.5) / t.scale,
                             t.point[vertex][1] + (t.origin[1] - 0.5) / t.scale};
      const bool is_inside = norm(position) <= distance;
      const double outside = std::numeric_limits<double>::quiet_NaN();
      coordinates.push_back(is_inside ? position : Vec2{outside, outside});
      if(is_inside)
        reached.push_back(vertex);
    }
  }
};

TEST(decal, finds_triangles_of_intersected_cells)
{
  // A grid of 10 x 10 cells with two triangles each. The rectangle [0.31, 0.69] x [0.45, 0.55]
  // intersects columns 3 to 6 and rows 4 to 5.
  const Array_surface surface(square(10));
  const Flat_map map(surface.t());
  const Vec2 half_size = {0.19 / surface.scale(), 0.05 / surface.scale()};
  const Decal_triangles found =
      find_decal_triangles(surface.t(), map.reached, map.coordinates, half_size);
  EXPECT_EQ(found.longest_edge, 0.);
  std::set<Index> inside;
  for(const auto& image : found.covered)
    inside.insert(image.triangle);
  EXPECT_EQ(inside.size(), found.covered.size());
  std::size_t cells = 0;
  for(Index f = 0; f < surface.t().number_of_triangles(); ++f)
  {
    Vec2 low = {infinity, infinity};
    for(Index k = 0; k < 3; ++k)
      for(int c = 0; c < 2; ++c)
        low[c] =
            std::min(low[c], map.coordinates[surface.t().corner[3 * f + k]][c] * surface.scale());
    const double column = std::round(10. * low[0]) + 5., row = std::round(10. * low[1]) + 5.;
    const bool is_in_cell = column >= 3. && column <= 6. && row >= 4. && row <= 5.;
    cells += is_in_cell;
    // If the rectangle intersects only a corner of a cell, one of its triangles may not be covered.
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

TEST(decal, excludes_triangles_touched_at_boundary)
{
  const Array_surface surface(square(4)); // coordinates are multiples of 1/4, which are exact
  const Flat_map map(surface.t());
  const Vec2 half_size = {0.25 / surface.scale(), 0.25 / surface.scale()};
  EXPECT_EQ(
      find_decal_triangles(surface.t(), map.reached, map.coordinates, half_size).covered.size(),
      8u);
}

TEST(decal, reports_longest_edge_of_incomplete_triangles)
{
  const Array_surface surface(square(10, 0.2));
  const double half_size = 0.2 / surface.scale();
  const Decal_triangles all =
      find_decal_triangles(surface.t(), Flat_map(surface.t()).reached,
                           Flat_map(surface.t()).coordinates, {half_size, half_size});
  // Only vertices up to the distance of the rectangle's corners are reached.
  const Flat_map small_map(surface.t(), half_size * std::sqrt(2.));
  const Decal_triangles partial = find_decal_triangles(
      surface.t(), small_map.reached, small_map.coordinates, {half_size, half_size});
  EXPECT_GT(partial.longest_edge, 0.);
  EXPECT_LT(partial.covered.size(), all.covered.size());
  // With the distance increased by the reported length, all triangles are complete.
  const Flat_map large_map(surface.t(), half_size * std::sqrt(2.) + partial.longest_edge);
  const Decal_triangles found = find_decal_triangles(surface.t(), large_map.reached,
                                                     large_map.coordinates, {half_size, half_size});
  EXPECT_EQ(found.longest_edge, 0.);
  EXPECT_EQ(found.covered.size(), all.covered.size());
}

TEST(decal, completes_cut_triangles)
{
  const Array_surface surface(square(10, 0.2));
  Flat_map map(surface.t());
  const Flat_map original = map;
  const Vec2 half_size = {1. / surface.scale(), 1. / surface.scale()};
  const Index moved = surface.vertex(60);
  map.coordinates[moved] = 0.9 * half_size; // as across a cut locus
  const auto found = find_decal_triangles(surface.t(), map.reached, map.coordinates, half_size);
  EXPECT_EQ(found.covered.size(), surface.t().number_of_triangles());
  for(const auto& [triangle, corners] : found.covered)
    for(Index k = 0; k < 3; ++k)
    {
      const Vec2& position = original.coordinates[surface.t().corner[3 * triangle + k]];
      EXPECT_LT(norm(corners[k] - position), 1e-13); // round-off errors
    }
  // Triangles whose edges are all cut are omitted.
  for(const Index neighbor : {Index(61), Index(71), Index(70)})
    map.coordinates[surface.vertex(neighbor)] = (double(neighbor) - 65.) * half_size;
  EXPECT_LT(
      find_decal_triangles(surface.t(), map.reached, map.coordinates, half_size).covered.size(),
      found.covered.size());
}

TEST(decal, longest_edge_is_local)
{
  const Array_surface surface(square(10));
  const double edge_length = 0.1 / surface.scale();
  EXPECT_NEAR(longest_edge_at(surface.t(), {none, surface.vertex(60), {}}),
              std::sqrt(2.) * edge_length,
              1e-15); // round-off errors
  EXPECT_NEAR(longest_edge_at(surface.t(), {0, none, {0.2, 0.3, 0.5}}), std::sqrt(2.) * edge_length,
              1e-15);
}

TEST(decal, blending_is_associative)
{
  const Rgba red = {1., 0., 0., 1.}, green = {0., 1., 0., 0.5}, clear = {0.3, 0.2, 0.1, 0.};
  EXPECT_EQ(blend_over(red, green), red);
  EXPECT_EQ(blend_over(green, red), (Rgba{0.5, 0.5, 0., 1.}));
  EXPECT_EQ(blend_over(clear, red), red);
  EXPECT_EQ(blend_over(green, clear), green);
  EXPECT_EQ(blend_over(clear, clear)[3], 0.);
  // The result does not depend on the order in which three colors are composed.
  const Rgba glass = {0.2, 0.4, 0.8, 0.25};
  const Rgba first = blend_over(blend_over(glass, green), red),
             last = blend_over(glass, blend_over(green, red));
  for(int c = 0; c < 4; ++c)
    EXPECT_NEAR(first[c], last[c], 1e-15); // round-off errors
}

TEST(decal, each_texel_belongs_to_at_most_one_triangle)
{
  for(const std::size_t segments : {1u, 2u, 7u})
    for(const std::size_t number : {1u, 2u, 9u})
    {
      const Texture_cells cells(number, segments);
      std::vector<int> use_count(cells.width() * cells.height(), 0);
      for(std::size_t f = 0; f < number; ++f)
        cells.for_each_texel(
            f,
            [&](std::size_t texel, const std::array<double, 3>& barycentric)
            {
              ++use_count.at(texel);
              // Two additions.
              EXPECT_NEAR(barycentric[0] + barycentric[1] + barycentric[2], 1., 1e-14);
              // The barycentric coordinates determine the center of the texel, up to round-off
              // errors.
              const auto corners = cells.corners(f);
              const Vec2 position = barycentric[0] * corners[0] + barycentric[1] * corners[1] +
                                    barycentric[2] * corners[2];
              const double error = 1e-12; // of texel coordinates below 100
              const double w = double(cells.width()), h = double(cells.height());
              EXPECT_NEAR(position[0] * w - 0.5, double(texel % cells.width()), error);
              EXPECT_NEAR(position[1] * h - 0.5, double(texel / cells.width()), error);
            });
      EXPECT_LE(*std::max_element(use_count.begin(), use_count.end()), 1);
    }
}

TEST(decal, interpolation_uses_only_own_texels)
{
  const std::size_t number = 5, segments = 3;
  const Texture_cells cells(number, segments);
  std::vector<std::size_t> triangle_of_texel(cells.width() * cells.height(), number);
  for(std::size_t f = 0; f < number; ++f)
    cells.for_each_texel(f, [&](std::size_t texel, const auto&) { triangle_of_texel[texel] = f; });
  const int steps = 40;
  for(std::size_t f = 0; f < number; ++f)
    for(int i = 0; i <= steps; ++i)
      for(int j = 0; i + j <= steps; ++j)
      {
        const auto corners = cells.corners(f);
        const Vec2 position = (double(i) / steps) * corners[0] + (double(j) / steps) * corners[1] +
                              (double(steps - i - j) / steps) * corners[2];
        const double x = position[0] * double(cells.width()) - 0.5,
                     y = position[1] * double(cells.height()) - 0.5;
        // The four texels of bilinear interpolation, up to round-off errors of the position.
        for(const double right : {1e-9, 1. - 1e-9})
          for(const double up : {1e-9, 1. - 1e-9})
            EXPECT_EQ(
                triangle_of_texel[std::size_t(y + up) * cells.width() + std::size_t(x + right)], f);
      }
}

TEST(decal, throws_on_invalid_texture_size)
{
  EXPECT_THROW(Texture_cells(1, 0), Invalid_argument_error);
  EXPECT_THROW(Texture_cells(std::size_t(1) << 40, 4), Invalid_argument_error);
  EXPECT_THROW(Texture_cells(2, std::size_t(1) << 60), Invalid_argument_error);
}

} // namespace decal_test
