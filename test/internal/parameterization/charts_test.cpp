// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/charts.h>
#include <CGAL/Geodesic_processing/internal/numerics/singular_values.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace charts_test {

using namespace CGAL::Geodesic_processing::test;
using namespace CGAL::Geodesic_processing::internal;

// A spiral staircase around an axis: flattened, it overlaps itself.
Triangulation spiral_stairs(double turns, double height)
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
  const Array_surface arrays(surface);
  return injective_charts(arrays.t(), std::vector<Index>(arrays.t().number_of_triangles(), 0), 1,
                          options);
}

// Expects that each triangle is in exactly one chart.
void expect_partition(const std::vector<Chart>& charts, std::size_t triangles)
{
  std::set<Index> seen;
  std::size_t number = 0;
  for(const Chart& chart : charts)
  {
    seen.insert(chart.triangles.begin(), chart.triangles.end());
    number += chart.triangles.size();
    EXPECT_EQ(chart.triangles.size(), chart.surface.number_of_triangles());
    EXPECT_EQ(chart.image.size(), chart.surface.number_of_vertices());
  }
  EXPECT_EQ(number, triangles);
  EXPECT_EQ(seen.size(), triangles);
}

TEST(charts, extracted_charts_keep_lengths_and_twins)
{
  const Array_surface arrays(square(8, 0.2));
  const Surface_arrays& t = arrays.t();
  std::vector<Index> patch(t.number_of_triangles());
  for(Index f = 0; f < patch.size(); ++f)
    patch[f] = f % 5 == 0 ? 2 : 0;
  const std::vector<Chart> charts = extract_charts(t, patch, 3);
  ASSERT_EQ(charts.size(), 2u);
  std::size_t inner = 0, inner_before = 0;
  for(const Chart& chart : charts)
    for(Index h = 0; h < chart.surface.corner.size(); ++h)
    {
      const Index before = 3 * chart.triangles[h / 3] + h % 3, twin = chart.surface.twin[h];
      EXPECT_EQ(chart.surface.length[h], t.length[before]);
      if(twin == none)
        continue;
      ++inner;
      EXPECT_EQ(t.twin[before], 3 * chart.triangles[twin / 3] + twin % 3);
      EXPECT_EQ(chart.surface.corner[h], chart.surface.corner[next_halfedge(twin)]);
    }
  for(Index h = 0; h < t.twin.size(); ++h)
    inner_before += t.twin[h] != none && patch[t.twin[h] / 3] == patch[h / 3];
  EXPECT_EQ(inner, inner_before);
}

TEST(charts, planar_patch_is_isometric)
{
  for(const double scale : {1e-6, 1., 1e6})
    for(const std::size_t n : {1u, 4u, 15u}) // single triangles, Tutte's map, embedding
    {
      const Triangulation surface = scaled(square(n, 0.2), scale);
      const std::vector<Chart> charts = charts_of(surface);
      ASSERT_EQ(charts.size(), 1u);
      EXPECT_TRUE(is_injective(charts[0]));
      const Surface_arrays& t = charts[0].surface;
      for(Index h = 0; h < t.corner.size(); ++h)
        // The last Newton step decreased the energy by less than 1e-3: the relative error of
        // lengths is about the square root of the remaining energy.
        EXPECT_NEAR(
            norm(charts[0].image[t.corner[h]] - charts[0].image[t.corner[next_halfedge(h)]]),
            t.length[h], 0.05 * t.length[h]);
    }
}

TEST(charts, single_triangle_is_a_chart)
{
  const std::vector<Chart> charts = charts_of(one_triangle());
  ASSERT_EQ(charts.size(), 1u);
  EXPECT_TRUE(is_injective(charts[0]));
  // Also needles without area.
  const std::vector<Chart> needle = charts_of({{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, {0, 1, 2}});
  ASSERT_EQ(needle.size(), 1u);
  EXPECT_TRUE(is_injective(needle[0]));
}

TEST(charts, overlapping_spiral_is_cut)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation surface = scaled(spiral_stairs(1.6, 1.), scale);
    Chart_options options;
    options.max_steps = 200; // until convergence; Tutte's map is far from the optimum
    options.energy_tolerance = 1e-6;
    const std::vector<Chart> charts = charts_of(surface, options);
    expect_partition(charts, surface.corners.size() / 3);
    EXPECT_GE(charts.size(), 2u);
    EXPECT_LE(charts.size(), 6u);
    for(const Chart& chart : charts)
      EXPECT_TRUE(is_injective(chart));
  }
  EXPECT_EQ(charts_of(spiral_stairs(0.8, 1.)).size(), 1u);
}

// A sphere with random spikes, without one triangle. A map of the whole surface is too distorted.
Triangulation spiky_sphere(unsigned seed)
{
  Triangulation result = icosphere(1);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-2., 2.);
  for(Point& p : result.points)
  {
    const double radius = std::pow(10., exponent(random));
    for(double& x : p)
      x *= radius;
  }
  result.corners.resize(result.corners.size() - 3);
  return result;
}

// The image of a piece of a chart that is too distorted is not used for the piece.
TEST(charts, charts_are_not_too_distorted)
{
  for(unsigned seed = 0; seed < 40; ++seed)
    for(Chart& chart : charts_of(spiky_sphere(seed)))
      // The limit of the implementation for charts of few vertices
      EXPECT_LE(minimize_symmetric_dirichlet(chart.surface, chart.image, 0).energy, 100.) << seed;
}

// The unrolled stairs: without inverted triangles, but the boundary intersects itself.
Chart overlapping_chart()
{
  const Array_surface arrays(spiral_stairs(1.6, 0.));
  Chart chart =
      extract_charts(arrays.t(), std::vector<Index>(arrays.t().number_of_triangles(), 0), 1)[0];
  for(const Point& p : arrays.t().point)
    chart.image.push_back({p[0], p[1]});
  if(number_of_flips(chart) > 0)
    for(Vec2& p : chart.image)
      p[1] = -p[1];
  return chart;
}

TEST(charts, overlapping_image_is_not_injective)
{
  const Chart chart = overlapping_chart();
  EXPECT_EQ(number_of_flips(chart), 0u);
  EXPECT_FALSE(is_injective(chart));
}

TEST(charts, splits_make_the_image_injective)
{
  const Chart chart = overlapping_chart();
  std::vector<Chart> injective, queue = {chart};
  while(!queue.empty())
  {
    const Chart one = std::move(queue.back());
    queue.pop_back();
    if(is_injective(one))
    {
      injective.push_back(one);
      continue;
    }
    const auto [first, second] = triangles_to_separate(one);
    for(const Chart& piece : split_chart(one, first, second))
    {
      EXPECT_LT(piece.triangles.size(), one.triangles.size());
      queue.push_back(piece);
    }
  }
  expect_partition(injective, chart.triangles.size());
  EXPECT_LE(injective.size(), 4u); // two splits suffice for 1.6 turns
  for(const Chart& piece : injective)
    for(Index f = 0; f < piece.triangles.size(); ++f)
      for(Index k = 0; k < 3; ++k)
        EXPECT_EQ(piece.image[piece.surface.corner[3 * f + k]],
                  chart.image[chart.surface.corner[3 * piece.triangles[f] + k]]);
}

TEST(charts, is_independent_of_threads)
{
  std::vector<std::vector<Vec2>> images[2];
  for(const unsigned number_of_threads : {1u, 3u})
  {
    Chart_options options;
    options.number_of_threads = number_of_threads;
    for(const Chart& chart : charts_of(spiral_stairs(2.3, 1.), options))
      images[number_of_threads / 3].push_back(chart.image);
  }
  EXPECT_EQ(images[0], images[1]);
}

TEST(charts, can_be_cancelled)
{
  Chart_options options;
  options.callback = [](double) { return false; };
  EXPECT_TRUE(charts_of(square(4), options).empty());
}

TEST(charts, handles_collapsed_surface)
{
  Triangulation mesh = square(12);
  for(Point& p : mesh.points)
    p = {1., 2., 3.};
  const auto charts = charts_of(mesh);
  expect_partition(charts, mesh.corners.size() / 3);
}

} // namespace charts_test
