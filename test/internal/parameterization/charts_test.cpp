// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

// Stairs around an axis: flat they would go around it, and over themselves.
Triangulation stairs(double turns, double height)
{
  return grid(std::size_t(40 * turns), 4,
              [=](double s, double t) -> Point
              {
                const double angle = 2. * pi * turns * s, radius = 2. - t;
                return {radius * std::cos(angle), radius * std::sin(angle), height * turns * s};
              });
}

std::vector<Chart> charts_of(const Triangulation& surface, const Chart_options& options = {})
{
  const Glued_surface glued(surface);
  return injective_charts(glued.t(), std::vector<Index>(glued.t().number_of_triangles(), 0), 1,
                          options);
}

// Each triangle is in one chart.
void expect_all_once(const std::vector<Chart>& charts, std::size_t triangles)
{
  std::set<Index> seen;
  std::size_t number = 0;
  for(const Chart& chart : charts)
  {
    seen.insert(chart.triangles.begin(), chart.triangles.end());
    number += chart.triangles.size();
    EXPECT_EQ(chart.triangles.size(), chart.shape.number_of_triangles());
    EXPECT_EQ(chart.image.size(), chart.shape.number_of_sites());
  }
  EXPECT_EQ(number, triangles);
  EXPECT_EQ(seen.size(), triangles);
}

TEST(charts, cut_out_patches_keep_their_lengths_and_gluing)
{
  const Glued_surface glued(square(8, 0.2));
  const Glued_triangles& t = glued.t();
  std::vector<Index> patch(t.number_of_triangles());
  for(Index f = 0; f < patch.size(); ++f)
    patch[f] = f % 5 == 0 ? 2 : 0;
  const std::vector<Chart> charts = cut_out(t, patch, 3);
  ASSERT_EQ(charts.size(), 2u);
  std::size_t inner = 0, inner_before = 0;
  for(const Chart& chart : charts)
    for(Index side = 0; side < chart.shape.corner.size(); ++side)
    {
      const Index before = 3 * chart.triangles[side / 3] + side % 3, twin = chart.shape.twin[side];
      EXPECT_EQ(chart.shape.length[side], t.length[before]);
      if(twin == none)
        continue;
      ++inner;
      EXPECT_EQ(t.twin[before], 3 * chart.triangles[twin / 3] + twin % 3);
      EXPECT_EQ(chart.shape.corner[side], chart.shape.corner[next_side(twin)]);
    }
  for(Index side = 0; side < t.twin.size(); ++side)
    inner_before += t.twin[side] != none && patch[t.twin[side] / 3] == patch[side / 3];
  EXPECT_EQ(inner, inner_before);
}

TEST(charts, a_flat_patch_keeps_its_lengths)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const std::size_t n : {1u, 4u, 15u}) // triangles, Tutte's start, the embedding's
    {
      const Triangulation surface = scaled(square(n, 0.2), scale);
      const std::vector<Chart> charts = charts_of(surface);
      ASSERT_EQ(charts.size(), 1u);
      EXPECT_TRUE(is_injective(charts[0]));
      const Glued_triangles& t = charts[0].shape;
      for(Index side = 0; side < t.corner.size(); ++side)
        // The last step of Newton's method gained less than a thousandth: lengths are as far off as the
        // root of the energy that is left.
        EXPECT_NEAR(
            norm(charts[0].image[t.corner[side]] - charts[0].image[t.corner[next_side(side)]]),
            t.length[side], 0.05 * t.length[side]);
    }
}

TEST(charts, one_triangle_is_a_chart)
{
  const std::vector<Chart> charts = charts_of(one_triangle());
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_TRUE(is_injective(charts[0]));
  // Needles without area as well.
  const std::vector<Chart> needle = charts_of({{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, {0, 1, 2}});
  ASSERT_EQ(needle.size(), 1u);
  EXPECT_TRUE(is_injective(needle[0]));
}

TEST(charts, stairs_that_would_cover_themselves_are_cut)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation surface = scaled(stairs(1.6, 1.), scale);
    Chart_options options;
    options.most_steps = 200; // to the end, where lengths are kept: from Tutte's map it is far
    options.least_progress = 1e-6;
    const std::vector<Chart> charts = charts_of(surface, options);
    expect_all_once(charts, surface.corners.size() / 3);
    EXPECT_GE(charts.size(), 2u);
    EXPECT_LE(charts.size(), 6u);
    for(const Chart& chart : charts)
      EXPECT_TRUE(is_injective(chart));
  }
  EXPECT_EQ(charts_of(stairs(0.8, 1.)).size(), 1u);
}

TEST(charts, an_image_that_covers_itself_is_not_injective)
{
  // Rolled out by hand: no flip, but the border meets itself.
  const Triangulation surface = stairs(1.6, 0.);
  const Glued_surface glued(surface);
  Chart chart = cut_out(glued.t(), std::vector<Index>(glued.t().number_of_triangles(), 0), 1)[0];
  chart.image.clear();
  for(const Point& p : glued.t().point)
    chart.image.push_back({p[0], p[1]});
  EXPECT_EQ(number_of_flips(chart) % chart.triangles.size(), 0u); // all or none, by the way up
  if(number_of_flips(chart) > 0)
    for(Planar& p : chart.image)
      p[1] = -p[1];
  EXPECT_EQ(number_of_flips(chart), 0u);
  EXPECT_FALSE(is_injective(chart));
}

TEST(charts, threads_change_nothing)
{
  std::vector<std::vector<Planar>> images[2];
  for(const unsigned threads : {1u, 3u})
  {
    Chart_options options;
    options.threads = threads;
    for(const Chart& chart : charts_of(stairs(2.3, 1.), options))
      images[threads / 3].push_back(chart.image);
  }
  EXPECT_EQ(images[0], images[1]);
}

TEST(charts, can_be_cancelled)
{
  Chart_options options;
  options.callback = [](double) { return false; };
  EXPECT_TRUE(charts_of(square(4), options).empty());
}

TEST(charts, of_a_surface_that_is_one_point)
{
  Triangulation mesh = square(12);
  for(Point& p : mesh.points)
    p = {1., 2., 3.};
  const auto charts = charts_of(mesh);
  expect_all_once(charts, mesh.corners.size() / 3);
}

} // namespace
