// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/tessellation.h>

#include "mesh/patches.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace tessellation_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Triangles = std::shared_ptr<const Surface_arrays>;
using Slowness = std::shared_ptr<const std::vector<double>>;

Tessellation cells(const Triangles& triangles, std::size_t number,
                   Tessellation_options options = {}, const Slowness& slowness = nullptr,
                   Front_kind kind = Front_kind::euclidean)
{
  options.number_of_cells = number;
  return tessellate(triangles, Front(triangles, kind), slowness, options);
}

// Steps until convergence.
Tessellation_options options_until_convergence()
{
  Tessellation_options options;
  options.max_steps = 300;
  options.energy_tolerance = 0.;
  return options;
}

void expect_decreasing(const std::vector<double>& energies)
{
  ASSERT_GT(energies.size(), 1u);
  EXPECT_LT(energies.back(), energies.front());
  for(std::size_t i = 1; i < energies.size(); ++i)
    EXPECT_LE(energies[i], energies[i - 1]) << i;
}

TEST(Tessellation, converges_on_square_and_strip)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Triangulation plane = scaled(square(20, 0.2), scale);
    const Array_surface surface(plane);
    const Tessellation one = cells(surface.triangles(), 1, options_until_convergence());
    ASSERT_EQ(one.centers.size(), 1u);
    // Vertices are weighted by the incident area, so that their mean is the centroid up to the
    // square of the edge length. A center stays if it would move by less than a thousandth of the
    // radius.
    const double center_tolerance = 4e-3 * scale;
    EXPECT_LT(distance(coordinates(surface.t(), one.centers[0]), {scale / 2., scale / 2., 0.}),
              center_tolerance);
    // The integral of x^2 + y^2 over the unit square around the origin is 1/6. The trapezoidal rule
    // adds a sixth of the square of the edge length for each axis.
    EXPECT_NEAR(one.energies.back() * std::pow(surface.scale(), 4), std::pow(scale, 4) / 6.,
                0.01 * std::pow(scale, 4) / 6.);
    expect_decreasing(one.energies);

    for(Point& p : plane.points)
      p[1] /= 4.;
    const Array_surface strip(plane);
    const Tessellation four = cells(strip.triangles(), 4, options_until_convergence());
    std::vector<double> coordinates_along_strip;
    for(const Surface_location& center : four.centers)
    {
      const Point p = coordinates(strip.t(), center);
      coordinates_along_strip.push_back(p[0] / scale);
      EXPECT_NEAR(p[1], 0.125 * scale, center_tolerance);
    }
    std::sort(coordinates_along_strip.begin(), coordinates_along_strip.end());
    // The bisectors lie between columns of vertices at distance 0.05, up to half of it from the
    // limit.
    for(std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(coordinates_along_strip[i], 0.125 + 0.25 * double(i), 0.03);
  }
}

TEST(Tessellation, converges_to_intrinsic_mean)
{
  const Array_surface surface(jittered(icosphere(4), 0.01));
  const Surface_arrays& t = surface.t();
  const Tessellation found = cells(surface.triangles(), 12, options_until_convergence());
  expect_decreasing(found.energies);
  // The mean of logarithms along great circles, over the centroids of triangles weighted by area.
  std::vector<Vec3> sum(12, Vec3{0., 0., 0.});
  std::vector<double> area(12, 0.), radius(12, 0.);
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index cell = found.labels[f];
    ASSERT_LT(cell, 12u);
    const Vec3 c = unit(point_at(t, found.centers[cell]));
    std::array<Vec3, 3> p;
    for(int k = 0; k < 3; ++k)
      p[k] = point_at(t, {none, t.corner[3 * f + Index(k)], {}});
    const double triangle_area = norm(cross(p[1] - p[0], p[2] - p[0])) / 2.;
    const Vec3 x = unit(p[0] + p[1] + p[2]);
    const double angle = std::acos(dot(c, x));
    sum[cell] = sum[cell] + triangle_area * angle * unit(x - dot(c, x) * c);
    area[cell] += triangle_area;
    radius[cell] = std::max(radius[cell], angle);
  }
  // Cells are bounded by edges of length 0.07, an eighth of their radius, and a vertex at the
  // bisector counts for its own cell only. The resulting error of the mean decreases with the
  // number of vertices at the bisectors, which is 30.
  for(std::size_t i = 0; i < 12; ++i)
    EXPECT_LT(norm((1. / area[i]) * sum[i]), 0.03 * radius[i]) << i;
}

TEST(Tessellation, energy_never_increases)
{
  const Array_surface surface(jittered(torus(40, 20), 0.02));
  const std::size_t n = surface.t().number_of_triangles();
  auto slowness = std::make_shared<std::vector<double>>();
  for(std::size_t f = 0; f < n; ++f)
    slowness->push_back(f % 7 == 0 ? infinity : f < n / 2 ? 1. : 3.);
  for(const Front_kind kind : {Front_kind::dijkstra, Front_kind::planar, Front_kind::euclidean})
    for(const Slowness& slow : {Slowness(), Slowness(slowness)})
      for(const std::size_t number : {3, 9, 50}) // two centers would start at opposite points
      {
        SCOPED_TRACE(std::to_string(int(kind)) + " " + std::to_string(number) +
                     (slow ? " slow" : ""));
        const Tessellation found =
            cells(surface.triangles(), number, options_until_convergence(), slow, kind);
        EXPECT_EQ(found.centers.size(), number);
        expect_decreasing(found.energies);
      }
}

TEST(Tessellation, density_follows_slowness)
{
  const Array_surface surface(square(30, 0.2));
  const Surface_arrays& t = surface.t();
  auto slowness = std::make_shared<std::vector<double>>();
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    slowness->push_back(point_at(t, {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] < 0.5 ? 1. : 3.);
  const Tessellation found = cells(surface.triangles(), 60, {}, slowness);
  // Cells have equal size in the metric of travel times: nine on the right for one on the left,
  // except for the cells in between.
  const auto right = std::count_if(found.centers.begin(), found.centers.end(),
                                   [&](const Surface_location& center)
                                   { return coordinates(t, center)[0] > 0.5; });
  EXPECT_GT(right, 48);
  EXPECT_LT(right, 58);
}

TEST(Tessellation, patches_are_disks)
{
  // A plate with twelve holes has more handles than the requested number of cells.
  const Triangulation sieve =
      blocks(18, 14, 2, [](int i, int j, int) { return i % 4 < 2 || j % 4 < 2; });
  for(const Triangulation& mesh : {icosphere(3), torus(24, 12), cylinder(16, 9, 1., 3.),
                                   disjoint_union(torus(12, 6), square(3)), double_torus(), sieve})
  {
    const Array_surface surface(mesh);
    for(const std::size_t number : {1, 2, 7})
    {
      Tessellation_options options;
      options.does_make_disks = true;
      const Tessellation found = cells(surface.triangles(), number, options);
      EXPECT_GE(found.centers.size(), number);
      expect_decreasing(found.energies);
      const std::vector<bool> is_disk =
          are_disks(surface.t(), found.labels, Index(found.centers.size()));
      EXPECT_EQ(std::count(is_disk.begin(), is_disk.end(), false), 0);
      // Each cell contains a triangle.
      for(Index i = 0; i < found.centers.size(); ++i)
        EXPECT_NE(std::count(found.labels.begin(), found.labels.end(), i), 0);
    }
  }
}

TEST(Tessellation, patches_are_disks_without_relaxation)
{
  const Array_surface surface(torus(24, 12));
  Tessellation_options options;
  options.does_make_disks = true;
  options.max_steps = 0;
  const Tessellation found = cells(surface.triangles(), 1, options);
  // One energy for the initial centers, and one after each round in which cells were added.
  EXPECT_LE(found.energies.size(), found.centers.size());
  const std::vector<bool> is_disk =
      are_disks(surface.t(), found.labels, Index(found.centers.size()));
  EXPECT_EQ(std::count(is_disk.begin(), is_disk.end(), false), 0);
}

TEST(Tessellation, progress_is_monotone)
{
  double last_progress = 0.;
  Tessellation_options options;
  options.does_make_disks = true;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, last_progress);
    EXPECT_LE(done, 1.);
    last_progress = done;
    return true;
  };
  cells(Array_surface(torus(24, 12)).triangles(), 3, options);
  EXPECT_EQ(last_progress, 1.);
}

TEST(Tessellation, component_without_center_is_unlabeled)
{
  const Array_surface surface(disjoint_union(square(6), tetrahedron()));
  const Tessellation one = cells(surface.triangles(), 1);
  const auto number_unlabeled = std::count(one.labels.begin(), one.labels.end(), none);
  EXPECT_TRUE(number_unlabeled == 4 || number_unlabeled == 72) << number_unlabeled;
  const Tessellation two = cells(surface.triangles(), 2);
  EXPECT_EQ(std::count(two.labels.begin(), two.labels.end(), none), 0);
}

TEST(Tessellation, tessellates_surfels)
{
  const Cloud cloud = octahedron_sphere(4);
  const Surfel_arrays surfels = build_surfel_arrays(cloud.points, cloud.normals, {}, {});
  const auto triangles = std::make_shared<const Surface_arrays>(surfels.arrays);
  const Tessellation found = cells(triangles, 20, options_until_convergence());
  expect_decreasing(found.energies);
  ASSERT_EQ(found.labels.size(), cloud.size());
  std::vector<double> size(20, 0.);
  for(Index vertex = 0; vertex < found.labels.size(); ++vertex)
  {
    ASSERT_LT(found.labels[vertex], 20u);
    size[found.labels[vertex]] += 1. / double(cloud.size());
  }
  // Twenty cells of a sphere. The initial sizes range from half of the mean to twice the mean.
  for(const double fraction : size)
  {
    EXPECT_GT(fraction, 0.6 / 20.);
    EXPECT_LT(fraction, 1.5 / 20.);
  }
}

TEST(Tessellation, is_independent_of_threads_and_can_be_cancelled)
{
  const Array_surface surface(jittered(icosphere(4), 0.02));
  Tessellation_options options;
  const Tessellation one = cells(surface.triangles(), 30, options);
  options.number_of_threads = 3;
  const Tessellation three = cells(surface.triangles(), 30, options);
  EXPECT_EQ(one.labels, three.labels);
  EXPECT_EQ(one.energies, three.energies);

  int calls = 0;
  double last_progress = 0.;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, last_progress);
    last_progress = done;
    return ++calls < 40;
  };
  const Tessellation cancelled = cells(surface.triangles(), 30, options);
  EXPECT_FALSE(cancelled.is_finished);
  EXPECT_EQ(cancelled.labels.size(), one.labels.size());
}

} // namespace tessellation_test
