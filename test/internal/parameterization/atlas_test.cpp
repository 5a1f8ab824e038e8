// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/parameterization/atlas.h>

#include "Array_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace atlas_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;
using CGAL::Geodesic_processing::Invalid_argument_error;

Atlas atlas_of(const Array_surface& arrays, const Atlas_options& options)
{
  return make_atlas(arrays.triangles(), Front(arrays.triangles(), Front_kind::euclidean), nullptr,
                    options);
}

Atlas_options options_for(std::size_t number, std::size_t texels = 256)
{
  Atlas_options options;
  options.tessellation.number_of_cells = number;
  options.tessellation.max_steps = 5;
  options.texels = texels;
  return options;
}

// Counts pairs of triangles of the atlas that intersect, without those that share a vertex of a
// chart, by an exact predicate of CGAL.
std::size_t number_of_triangle_intersections(const Surface_arrays& t, const Atlas& atlas)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto triangle = [&](Index f)
  {
    const Vec2* const p = &atlas.coordinates[3 * std::size_t(f)];
    return Kernel::Triangle_2({p[0][0], p[0][1]}, {p[1][0], p[1][1]}, {p[2][0], p[2][1]});
  };
  std::size_t result = 0;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    for(Index g = 0; g < f; ++g)
    {
      bool is_adjacent = false;
      for(Index i = 3 * f; i < 3 * f + 3; ++i)
        for(Index j = 3 * g; j < 3 * g + 3; ++j)
          is_adjacent =
              is_adjacent || (atlas.chart[f] == atlas.chart[g] && t.corner[i] == t.corner[j]);
      result += !is_adjacent && Kernel().do_intersect_2_object()(triangle(f), triangle(g));
    }
  return result;
}

void expect_atlas(const Triangulation& surface, std::size_t number, std::size_t min_charts,
                  std::size_t max_charts)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Array_surface arrays(scaled(surface, scale));
    const Surface_arrays& t = arrays.t();
    const Atlas atlas = atlas_of(arrays, options_for(number));
    ASSERT_TRUE(atlas.is_complete);
    EXPECT_EQ(atlas.number_of_flips, 0u);
    EXPECT_EQ(atlas.number_of_overlaps, 0u);
    EXPECT_EQ(number_of_triangle_intersections(t, atlas), 0u);
    EXPECT_GE(atlas.number_of_charts, min_charts);
    EXPECT_LE(atlas.number_of_charts, max_charts);
    EXPECT_EQ(std::set<Index>(atlas.chart.begin(), atlas.chart.end()).size(),
              atlas.number_of_charts);
    double area = 0.;
    for(std::size_t c = 0; c < atlas.coordinates.size(); c += 3)
      area += cross(atlas.coordinates[c + 1] - atlas.coordinates[c],
                    atlas.coordinates[c + 2] - atlas.coordinates[c]) /
              2.;
    EXPECT_NEAR(area, atlas.coverage, 1e-12); // sums of some hundred areas
    for(const Vec2& p : atlas.coordinates)
      for(const double x : p)
      {
        EXPECT_GT(x, 0.);
        EXPECT_LT(x, 1.);
      }
    // Adjacent triangles of a chart have equal UV coordinates at their common corners.
    for(Index h = 0; h < t.twin.size(); ++h)
    {
      const Index twin = t.twin[h];
      if(twin != none && atlas.chart[twin / 3] == atlas.chart[h / 3])
      {
        EXPECT_EQ(atlas.coordinates[h], atlas.coordinates[next_halfedge(twin)]);
      }
    }
  }
}

TEST(atlas, handles_any_topology)
{
  expect_atlas(icosphere(2), 6, 6, 8);
  expect_atlas(torus(16, 10), 4, 4, 16);
  expect_atlas(double_torus(4), 6, 6, 24);
  expect_atlas(annulus(24, 4, 1., 2.), 1, 2, 4);
  expect_atlas(square(10, 0.2), 3, 3, 4);
}

TEST(atlas, handles_single_triangle_and_needles)
{
  expect_atlas(one_triangle(), 1, 1, 1);
  expect_atlas(tetrahedron(), 4, 2, 4);
  // A strip of triangles without area.
  expect_atlas(grid(8, 2, [](double s, double) -> Point { return {s, 0., 0.}; }), 1, 1, 64);
}

TEST(atlas, covers_components_without_center)
{
  Triangulation surface = icosphere(1);
  for(int i = 1; i < 4; ++i)
  {
    Triangulation other = icosphere(1);
    for(Point& p : other.points)
      p[0] += 3. * i;
    surface = disjoint_union(surface, other);
  }
  expect_atlas(surface, 2, 6, 16);
}

TEST(atlas, is_independent_of_threads)
{
  const Array_surface arrays(jittered(icosphere(3), 0.05));
  Atlas_options options = options_for(10);
  const Atlas one = atlas_of(arrays, options);
  options.tessellation.number_of_threads = 3;
  const Atlas three = atlas_of(arrays, options);
  EXPECT_EQ(one.coordinates, three.coordinates);
  EXPECT_EQ(one.chart, three.chart);
}

TEST(atlas, throws_if_texture_too_small_and_can_be_cancelled)
{
  const Array_surface arrays(icosphere(2));
  EXPECT_THROW(atlas_of(arrays, options_for(100, 16)), Invalid_argument_error);
  for(int calls = 0; calls < 4; ++calls)
  {
    Atlas_options options = options_for(10);
    int left = calls;
    options.tessellation.callback = [&](double) { return left-- > 0; };
    const Atlas atlas = atlas_of(arrays, options);
    EXPECT_FALSE(atlas.is_complete);
    EXPECT_TRUE(atlas.coordinates.empty());
  }
}

} // namespace atlas_test
