// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/parameterization/atlas.h>
#include <CGAL/Geodesic_processing/tags.h>

#include "Glued_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::Euclidean_front;
using CGAL::Geodesic_processing::Invalid_argument_error;

Atlas atlas_of(const Glued_surface& glued, const Atlas_options& options)
{
  return make_atlas(glued.triangles(), Engine<Euclidean_front>(glued.triangles()), nullptr,
                    options);
}

Atlas_options options_for(std::size_t number, std::size_t texels = 256)
{
  Atlas_options options;
  options.tessellation.number = number;
  options.tessellation.most_steps = 5;
  options.texels = texels;
  return options;
}

// Triangles of the atlas that meet though they share no vertex of a chart, by CGAL's exact predicate.
std::size_t number_of_meetings(const Glued_triangles& t, const Atlas& atlas)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto triangle = [&](Index f)
  {
    const Planar* const p = &atlas.coordinates[3 * std::size_t(f)];
    return Kernel::Triangle_2({p[0][0], p[0][1]}, {p[1][0], p[1][1]}, {p[2][0], p[2][1]});
  };
  std::size_t result = 0;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    for(Index g = 0; g < f; ++g)
    {
      bool is_next = false;
      for(Index i = 3 * f; i < 3 * f + 3; ++i)
        for(Index j = 3 * g; j < 3 * g + 3; ++j)
          is_next = is_next || (atlas.chart[f] == atlas.chart[g] && t.corner[i] == t.corner[j]);
      result += !is_next && Kernel().do_intersect_2_object()(triangle(f), triangle(g));
    }
  return result;
}

void expect_atlas(const Triangulation& surface, std::size_t number, std::size_t least_charts,
                  std::size_t most_charts)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Glued_surface glued(scaled(surface, scale));
    const Glued_triangles& t = glued.t();
    const Atlas atlas = atlas_of(glued, options_for(number));
    ASSERT_TRUE(atlas.is_complete);
    EXPECT_EQ(atlas.number_of_flips, 0u);
    EXPECT_EQ(atlas.number_of_overlaps, 0u);
    EXPECT_EQ(number_of_meetings(t, atlas), 0u);
    EXPECT_GE(atlas.number_of_charts, least_charts);
    EXPECT_LE(atlas.number_of_charts, most_charts);
    EXPECT_EQ(std::set<Index>(atlas.chart.begin(), atlas.chart.end()).size(),
              atlas.number_of_charts);
    double area = 0.;
    for(std::size_t c = 0; c < atlas.coordinates.size(); c += 3)
      area += cross(atlas.coordinates[c + 1] - atlas.coordinates[c],
                    atlas.coordinates[c + 2] - atlas.coordinates[c]) /
              2.;
    EXPECT_NEAR(area, atlas.coverage, 1e-12);
    for(const Planar& p : atlas.coordinates)
      for(const double x : p)
      {
        EXPECT_GT(x, 0.);
        EXPECT_LT(x, 1.);
      }
    // Neighbours in a chart share the places of their corners.
    for(Index side = 0; side < t.twin.size(); ++side)
    {
      const Index twin = t.twin[side];
      if(twin != none && atlas.chart[twin / 3] == atlas.chart[side / 3])
      {
        EXPECT_EQ(atlas.coordinates[side], atlas.coordinates[next_side(twin)]);
      }
    }
  }
}

TEST(atlas, surfaces_of_any_topology)
{
  expect_atlas(icosphere(2), 6, 6, 8);
  expect_atlas(torus(16, 10), 4, 4, 16);
  expect_atlas(double_ring(4), 6, 6, 24);
  expect_atlas(annulus(24, 4, 1., 2.), 1, 2, 4);
  expect_atlas(square(10, 0.2), 3, 3, 4);
}

TEST(atlas, one_triangle_and_needles)
{
  expect_atlas(one_triangle(), 1, 1, 1);
  expect_atlas(tetrahedron(), 4, 2, 4);
  // Each triangle of a strip without area.
  expect_atlas(grid(8, 2, [](double s, double) -> Point { return {s, 0., 0.}; }), 1, 1, 64);
}

TEST(atlas, components_without_a_centre_have_charts_too)
{
  Triangulation surface = icosphere(1);
  for(int i = 1; i < 4; ++i)
  {
    Triangulation other = icosphere(1);
    for(Point& p : other.points)
      p[0] += 3. * i;
    surface = apart(surface, other);
  }
  expect_atlas(surface, 2, 6, 16);
}

TEST(atlas, threads_change_nothing)
{
  const Glued_surface glued(shaken(icosphere(3), 0.05));
  Atlas_options options = options_for(10);
  const Atlas one = atlas_of(glued, options);
  options.tessellation.threads = 3;
  const Atlas three = atlas_of(glued, options);
  EXPECT_EQ(one.coordinates, three.coordinates);
  EXPECT_EQ(one.chart, three.chart);
}

TEST(atlas, no_room_and_cancelled)
{
  const Glued_surface glued(icosphere(2));
  EXPECT_THROW(atlas_of(glued, options_for(100, 16)), Invalid_argument_error);
  for(int calls = 0; calls < 4; ++calls)
  {
    Atlas_options options = options_for(10);
    int left = calls;
    options.tessellation.callback = [&](double) { return left-- > 0; };
    const Atlas atlas = atlas_of(glued, options);
    EXPECT_FALSE(atlas.is_complete);
    EXPECT_TRUE(atlas.coordinates.empty());
  }
}

} // namespace
