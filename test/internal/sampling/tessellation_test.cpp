// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/tessellation.h>

#include "mesh/patches.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Triangles = std::shared_ptr<const Glued_triangles>;
using Slowness = std::shared_ptr<const std::vector<double>>;

Tessellation cells(const Triangles& triangles, std::size_t number,
                   Tessellation_options options = {}, const Slowness& slowness = nullptr,
                   Front_kind kind = Front_kind::euclidean)
{
  options.number = number;
  return tessellate(triangles, Front(triangles, kind), slowness, options);
}

// As near to the end as steps get.
Tessellation_options until_the_end()
{
  Tessellation_options options;
  options.most_steps = 300;
  options.least_gain = 0.;
  return options;
}

void expect_falling(const std::vector<double>& energies)
{
  ASSERT_GT(energies.size(), 1u);
  EXPECT_LT(energies.back(), energies.front());
  for(std::size_t i = 1; i < energies.size(); ++i)
    EXPECT_LE(energies[i], energies[i - 1]) << i;
}

TEST(Tessellation, puts_one_centre_in_the_middle_and_four_in_a_row)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Triangulation plane = scaled(square(20, 0.2), scale);
    const Glued_surface surface(plane);
    const Tessellation one = cells(surface.triangles(), 1, until_the_end());
    ASSERT_EQ(one.centers.size(), 1u);
    // Sites weigh as much as the triangles around them: their mean is that of the triangles to the square of
    // a side, and a centre stays when it would go less than a thousandth of the radius.
    EXPECT_LT(distance(coordinates(surface.t(), one.centers[0]), {scale / 2., scale / 2., 0.}),
              4e-3 * scale);
    // The integral of x^2 + y^2 over the square around the origin, 1 / 6; the trapezoidal rule adds a sixth of
    // the square of a side for each axis.
    EXPECT_NEAR(one.energies.back() * std::pow(surface.scale(), 4), std::pow(scale, 4) / 6.,
                0.01 * std::pow(scale, 4) / 6.);
    expect_falling(one.energies);

    for(Point& p : plane.points)
      p[1] /= 4.;
    const Glued_surface strip(plane);
    const Tessellation four = cells(strip.triangles(), 4, until_the_end());
    std::vector<double> along;
    for(const Location& center : four.centers)
    {
      const Point p = coordinates(strip.t(), center);
      along.push_back(p[0] / scale);
      EXPECT_NEAR(p[1], 0.125 * scale, 4e-3 * scale);
    }
    // Cells end between columns of sites, which are 0.05 apart.
    std::sort(along.begin(), along.end());
    for(std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(along[i], 0.125 + 0.25 * double(i), 0.03);
  }
}

TEST(Tessellation, ends_at_the_mean_of_the_logarithms)
{
  const Glued_surface surface(shaken(icosphere(4), 0.01));
  const Glued_triangles& t = surface.t();
  const Tessellation found = cells(surface.triangles(), 12, until_the_end());
  expect_falling(found.energies);
  // By great circles, from the middles of triangles, each with its area.
  std::vector<Spatial> sum(12, Spatial{0., 0., 0.});
  std::vector<double> area(12, 0.), radius(12, 0.);
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index cell = found.labels[f];
    ASSERT_LT(cell, 12u);
    const Spatial c = unit(point_at(t, found.centers[cell]));
    std::array<Spatial, 3> p;
    for(int k = 0; k < 3; ++k)
      p[k] = point_at(t, {none, t.corner[3 * f + Index(k)], {}});
    const double here = norm(cross(p[1] - p[0], p[2] - p[0])) / 2.;
    const Spatial x = unit(p[0] + p[1] + p[2]);
    const double angle = std::acos(dot(c, x));
    sum[cell] = sum[cell] + here * angle * unit(x - dot(c, x) * c);
    area[cell] += here;
    radius[cell] = std::max(radius[cell], angle);
  }
  // Cells are divided along sides of 0.07, an eighth of their radius, and a site of a border weighs for its
  // own alone: what that moves the mean by falls with the number of the sites of a border, thirty.
  for(std::size_t i = 0; i < 12; ++i)
    EXPECT_LT(norm((1. / area[i]) * sum[i]), 0.03 * radius[i]) << i;
}

TEST(Tessellation, never_raises_the_energy)
{
  const Glued_surface surface(shaken(torus(40, 20), 0.02));
  const std::size_t n = surface.t().number_of_triangles();
  auto slowness = std::make_shared<std::vector<double>>();
  for(std::size_t f = 0; f < n; ++f)
    slowness->push_back(f % 7 == 0 ? infinity : f < n / 2 ? 1. : 3.);
  for(const Front_kind kind : {Front_kind::arcs, Front_kind::planar, Front_kind::euclidean})
    for(const Slowness& slow : {Slowness(), Slowness(slowness)})
      for(const std::size_t number : {3, 9, 50}) // two lie opposite from the start
      {
        SCOPED_TRACE(std::to_string(int(kind)) + " " + std::to_string(number) +
                     (slow ? " slow" : ""));
        const Tessellation found = cells(surface.triangles(), number, until_the_end(), slow, kind);
        EXPECT_EQ(found.centers.size(), number);
        expect_falling(found.energies);
      }
}

TEST(Tessellation, is_finer_where_fronts_are_slow)
{
  const Glued_surface surface(square(30, 0.2));
  const Glued_triangles& t = surface.t();
  auto slowness = std::make_shared<std::vector<double>>();
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    slowness->push_back(point_at(t, {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] < 0.5 ? 1. : 3.);
  const Tessellation found = cells(surface.triangles(), 60, {}, slowness);
  // Equal cells in the metric: nine on the right for one on the left, but for those in between.
  const auto right =
      std::count_if(found.centers.begin(), found.centers.end(),
                    [&](const Location& center) { return coordinates(t, center)[0] > 0.5; });
  EXPECT_GT(right, 48);
  EXPECT_LT(right, 58);
}

TEST(Tessellation, makes_discs)
{
  // A plate with twelve holes: of more handles than cells are asked for.
  const Triangulation sieve =
      blocks(18, 14, 2, [](int i, int j, int) { return i % 4 < 2 || j % 4 < 2; });
  for(const Triangulation& mesh : {icosphere(3), torus(24, 12), cylinder(16, 9, 1., 3.),
                                   apart(torus(12, 6), square(3)), double_ring(), sieve})
  {
    const Glued_surface surface(mesh);
    for(const std::size_t number : {1, 2, 7})
    {
      Tessellation_options options;
      options.makes_discs = true;
      const Tessellation found = cells(surface.triangles(), number, options);
      EXPECT_GE(found.centers.size(), number);
      expect_falling(found.energies);
      const std::vector<bool> is_disc =
          are_discs(surface.t(), found.labels, Index(found.centers.size()));
      EXPECT_EQ(std::count(is_disc.begin(), is_disc.end(), false), 0);
      // Each cell has a triangle.
      for(Index i = 0; i < found.centers.size(); ++i)
        EXPECT_NE(std::count(found.labels.begin(), found.labels.end(), i), 0);
    }
  }
}

TEST(Tessellation, makes_discs_of_farthest_points_without_steps)
{
  const Glued_surface surface(torus(24, 12));
  Tessellation_options options;
  options.makes_discs = true;
  options.most_steps = 0;
  const Tessellation found = cells(surface.triangles(), 1, options);
  // One for the start, and one after each round of cells that were added.
  EXPECT_LE(found.energies.size(), found.centers.size());
  const std::vector<bool> is_disc =
      are_discs(surface.t(), found.labels, Index(found.centers.size()));
  EXPECT_EQ(std::count(is_disc.begin(), is_disc.end(), false), 0);
}

TEST(Tessellation, tells_what_is_done_in_order)
{
  double told = 0.;
  Tessellation_options options;
  options.makes_discs = true;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, told);
    EXPECT_LE(done, 1.);
    told = done;
    return true;
  };
  cells(Glued_surface(torus(24, 12)).triangles(), 3, options);
  EXPECT_EQ(told, 1.);
}

TEST(Tessellation, leaves_out_what_has_no_centre)
{
  const Glued_surface surface(apart(square(6), tetrahedron()));
  const Tessellation one = cells(surface.triangles(), 1);
  const auto outside = std::count(one.labels.begin(), one.labels.end(), none);
  EXPECT_TRUE(outside == 4 || outside == 72) << outside;
  const Tessellation two = cells(surface.triangles(), 2);
  EXPECT_EQ(std::count(two.labels.begin(), two.labels.end(), none), 0);
}

TEST(Tessellation, of_surfels)
{
  const Cloud cloud = octahedron_sphere(4);
  const Glued_surfels surfels = glue_surfels(cloud.points, cloud.normals, {}, {});
  const auto triangles = std::make_shared<const Glued_triangles>(surfels.triangles);
  const Tessellation found = cells(triangles, 20, until_the_end());
  expect_falling(found.energies);
  ASSERT_EQ(found.labels.size(), cloud.size());
  std::vector<double> size(20, 0.);
  for(Index site = 0; site < found.labels.size(); ++site)
  {
    ASSERT_LT(found.labels[site], 20u);
    size[found.labels[site]] += 1. / double(cloud.size());
  }
  // Twenty cells of a sphere, at the start from a half of the mean to twice it.
  for(const double part : size)
  {
    EXPECT_GT(part, 0.6 / 20.);
    EXPECT_LT(part, 1.5 / 20.);
  }
}

TEST(Tessellation, is_the_same_for_any_number_of_threads_and_can_be_cancelled)
{
  const Glued_surface surface(shaken(icosphere(4), 0.02));
  Tessellation_options options;
  const Tessellation one = cells(surface.triangles(), 30, options);
  options.threads = 3;
  const Tessellation three = cells(surface.triangles(), 30, options);
  EXPECT_EQ(one.labels, three.labels);
  EXPECT_EQ(one.energies, three.energies);

  int calls = 0;
  double told = 0.;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, told);
    told = done;
    return ++calls < 40;
  };
  const Tessellation cancelled = cells(surface.triangles(), 30, options);
  EXPECT_FALSE(cancelled.is_finished);
  EXPECT_EQ(cancelled.labels.size(), one.labels.size());
}

} // namespace
