// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace sampling_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Kind = Front_kind;
using Slowness = std::shared_ptr<const std::vector<double>>;
constexpr Kind all_kinds[] = {Kind::dijkstra, Kind::planar, Kind::euclidean};

// Round-off errors of sums of a few hundred lengths.
constexpr double round_off_tolerance = 1e-12;

Sampling sampling(const std::shared_ptr<const Surface_arrays>& triangles,
                  Kind kind = Kind::euclidean,
                  Sample_location sample_location = Sample_location::triangle,
                  const Slowness& slowness = nullptr)
{
  return Sampling(triangles, Front(triangles, kind), sample_location, slowness);
}

// Adds farthest samples, and returns the covering radius after each of them.
std::vector<double> add_samples(Sampling& samples, std::size_t number, unsigned seed = 0)
{
  std::vector<double> radii;
  Sampling_options options;
  options.number_of_samples = number;
  options.seed = seed;
  EXPECT_TRUE(
      sample_farthest_points(samples, options, [&](double radius) { radii.push_back(radius); }));
  return radii;
}

Point point_of(const Surface_arrays& t, const Surface_location& sample)
{
  return scaled_coordinates(t, sample);
}

// Returns the minimum over the samples of the distance that a separate front from each computes.
std::vector<double> separate_distances(const std::shared_ptr<const Surface_arrays>& triangles,
                                       Kind kind, const Sampling& samples)
{
  Front front(triangles, kind);
  std::vector<double> result(triangles->number_of_vertices(), infinity);
  for(const Surface_location& sample : samples.samples())
  {
    front.run({{{sample}, 0., 0}});
    for(const Index vertex : front.reached())
      result[vertex] = std::min(result[vertex], front.distance(vertex));
  }
  return result;
}

void expect_consistent(const Sampling& samples, const std::vector<double>& radii)
{
  for(std::size_t i = 1; i < radii.size(); ++i)
    EXPECT_LE(radii[i], radii[i - 1]);
  double largest = 0.;
  for(const Index vertex : samples.sampled_vertices())
  {
    largest = std::max(largest, samples.distances()[vertex]);
    EXPECT_EQ(samples.labels()[vertex] == none, samples.distances()[vertex] == infinity);
    if(samples.labels()[vertex] != none)
    {
      EXPECT_LT(samples.labels()[vertex], samples.samples().size());
    }
  }
  ASSERT_FALSE(radii.empty());
  EXPECT_EQ(radii.back(), largest);
}

TEST(Sampling, starts_at_square_corners_then_center)
{
  for(const unsigned seed : {0u, 1u, 2u, 3u})
    for(const Kind kind : {Kind::planar, Kind::euclidean})
    {
      const Triangulation plane = square(20, 0.2, 3);
      const Array_surface surface(plane);
      Sampling samples = sampling(surface.triangles(), kind);
      add_samples(samples, 5, seed);
      std::set<Index> corners;
      for(std::size_t i = 0; i < 4; ++i)
        corners.insert(samples.samples()[i].vertex);
      EXPECT_EQ(corners, (std::set<Index>{surface.vertex(0), surface.vertex(20),
                                          surface.vertex(420), surface.vertex(440)}));
      // The sample is in a triangle at the center or at one of its corners, within two edges of
      // length 1/20. The planar front has an error of at most half an edge here.
      const Point center =
          0.5 * (surface.t().point[surface.vertex(0)] + surface.t().point[surface.vertex(440)]);
      EXPECT_LT(surface.scale() * distance(point_of(surface.t(), samples.samples()[4]), center),
                0.1);
    }
}

TEST(Sampling, second_sample_on_sphere_is_antipodal)
{
  const Array_surface surface(icosphere(4));
  for(const unsigned seed : {0u, 1u, 2u})
  {
    Sampling samples = sampling(surface.triangles());
    add_samples(samples, 2, seed);
    const Point p = surface.scale() * point_of(surface.t(), samples.samples()[0]);
    const Point q = surface.scale() * point_of(surface.t(), samples.samples()[1]);
    // The maximum edge length of this icosphere is 0.0812.
    EXPECT_LT(distance(p, -1. * q), 0.0812);
  }
}

// Returns the Euclidean distance from each point to the closest sample.
std::vector<double> euclidean_distances(const Array_surface& surface, const Sampling& samples)
{
  std::vector<double> result(surface.size(), infinity);
  for(const Surface_location& sample : samples.samples())
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
      result[vertex] = std::min(result[vertex],
                                distance(point_of(surface.t(), sample), surface.t().point[vertex]));
  return result;
}

TEST(Sampling, distances_in_plane_are_euclidean)
{
  for(const unsigned seed : {5u, 6u, 7u})
  {
    const Triangulation plane = square(40, 0.24, seed);
    const Array_surface surface(plane);
    const double edge_length = 1. / 40. / surface.scale();
    Sampling samples = sampling(surface.triangles());
    expect_consistent(samples, add_samples(samples, 60));
    const auto expected = euclidean_distances(surface, samples);
    std::size_t wrong = 0;
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      const double error = samples.distances()[vertex] - expected[vertex];
      EXPECT_GE(error, -round_off_tolerance * edge_length);
      // At the boundary of a cell, the front may have to pass a triangle with a vertex outside of
      // the adjacent ring. It passes along an edge instead, which is longer by a few percent of the
      // edge.
      EXPECT_LT(error, 0.05 * edge_length);
      wrong += error > round_off_tolerance * edge_length;
    }
    EXPECT_LE(wrong, 3u);

    // This is the only error: fronts that extend one edge farther are exact.
    Front front(surface.triangles(), Kind::euclidean);
    std::vector<double> distances(surface.size(), infinity), known = distances;
    Front_limits limits;
    limits.known_distance = &known;
    for(const Surface_location& sample : samples.samples())
    {
      for(Index vertex = 0; vertex < surface.size(); ++vertex)
        known[vertex] = distances[vertex] + edge_length;
      front.run({{{sample}, 0., 0}}, limits);
      for(const Index vertex : front.reached())
        distances[vertex] = std::min(distances[vertex], front.distance(vertex));
    }
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
      EXPECT_NEAR(distances[vertex], expected[vertex], round_off_tolerance * edge_length);
  }
}

TEST(Sampling, distances_match_separate_fronts)
{
  for(const unsigned seed : {2u, 3u, 4u, 5u})
    for(const Kind kind : all_kinds)
    {
      const Array_surface surface(jittered(icosphere(4), 0.01, seed));
      Sampling samples = sampling(surface.triangles(), kind);
      const auto radii = add_samples(samples, 50, 4);
      expect_consistent(samples, radii);
      const auto expected = separate_distances(surface.triangles(), kind, samples);
      std::size_t wrong = 0;
      for(Index vertex = 0; vertex < surface.size(); ++vertex)
      {
        // The errors are those of the plane, and ties between an edge and a triangle.
        EXPECT_NEAR(samples.distances()[vertex], expected[vertex], 1e-4 * radii.back());
        wrong += samples.distances()[vertex] != expected[vertex];
      }
      // Shortest paths along edges do not depend on the extent of the front.
      EXPECT_LE(wrong, kind == Kind::dijkstra ? 0u : 2u);
    }
}

TEST(Sampling, samples_are_covering_radius_apart)
{
  for(const Sample_location sample_location : {Sample_location::vertex, Sample_location::triangle})
  {
    const Triangulation plane = square(30, 0.2, 7);
    const Array_surface surface(plane);
    Sampling samples = sampling(surface.triangles(), Kind::euclidean, sample_location);
    const auto radii = add_samples(samples, 100);
    expect_consistent(samples, radii);
    // Each sample was as far from the earlier ones as any vertex. Distances of vertices are too
    // large by a few thousandths of an edge, see above. At a point inside a triangle, the distance
    // is an estimate from the corners, with an error of up to 10 % and a tenth of an edge.
    const double ratio = sample_location == Sample_location::vertex ? 1. : 0.9;
    const double error =
        (sample_location == Sample_location::vertex ? 0.01 : 0.1) / 30. / surface.scale();
    for(std::size_t i = 2; i < samples.samples().size(); ++i)
      for(std::size_t j = 0; j < i; ++j)
        EXPECT_GE(distance(point_of(surface.t(), samples.samples()[i]),
                           point_of(surface.t(), samples.samples()[j])),
                  ratio * radii[i - 1] - error);
  }
}

TEST(Sampling, samples_each_component_first)
{
  Triangulation surface_points =
      disjoint_union(icosphere(2), disjoint_union(square(5), tetrahedron()));
  const std::size_t isolated = surface_points.points.size();
  surface_points.points.push_back({9., 9., 9.});
  const Array_surface surface(surface_points);
  for(const unsigned seed : {0u, 1u, 2u, 3u})
  {
    Sampling samples = sampling(surface.triangles());
    const auto radii = add_samples(samples, 8, seed);
    EXPECT_EQ(radii[0], infinity);
    EXPECT_EQ(radii[1], infinity);
    EXPECT_LT(radii[2], infinity);
    expect_consistent(samples, radii);
    EXPECT_EQ(samples.labels()[surface.vertex(Index(isolated))], none);
    // The first sample of a component is an extremal vertex; in the square, a corner.
    std::size_t corners = 0;
    for(std::size_t i = 0; i < 3; ++i)
      for(const Index corner : {0u, 5u, 30u, 35u})
        corners += samples.samples()[i].vertex == surface.vertex(Index(162 + corner));
    EXPECT_EQ(corners, 1u);
  }
}

TEST(Sampling, stops_when_every_vertex_is_sampled)
{
  const std::vector<Triangulation> surfaces = {one_triangle(), tetrahedron(), square(3),
                                               square(3, 0.2)};
  for(const Triangulation& triangulation : surfaces)
    for(const Kind kind : all_kinds)
      for(const Sample_location sample_location :
          {Sample_location::vertex, Sample_location::triangle})
      {
        const Array_surface surface(triangulation);
        Sampling samples = sampling(surface.triangles(), kind, sample_location);
        const auto radii = add_samples(samples, 10000);
        EXPECT_EQ(radii.back(), 0.);
        expect_consistent(samples, radii);
        // Each vertex is a sample once, and each triangle contains at most one sample.
        std::set<std::pair<Index, Index>> seen;
        for(const Surface_location& sample : samples.samples())
          EXPECT_TRUE(
              seen.insert({sample.triangle, sample.triangle == none ? sample.vertex : 0}).second);
        if(sample_location == Sample_location::vertex)
        {
          EXPECT_EQ(samples.samples().size(), surface.size());
        }
      }
}

TEST(Sampling, is_empty_without_triangles)
{
  Triangulation points;
  points.points = {{0., 0., 0.}, {1., 0., 0.}};
  for(const Triangulation& triangulation : {Triangulation(), points})
  {
    const Array_surface surface(triangulation);
    Sampling samples = sampling(surface.triangles());
    EXPECT_TRUE(add_samples(samples, 5).empty());
    EXPECT_EQ(samples.covering_radius(), 0.);
  }
}

TEST(Sampling, adds_single_locations)
{
  const Array_surface surface(square(10));
  Sampling samples = sampling(surface.triangles());
  EXPECT_EQ(samples.covering_radius(), infinity);
  EXPECT_TRUE(samples.add(surface.in(77, {0.2, 0.3, 0.5})));
  const double radius = samples.covering_radius();
  EXPECT_LT(radius, infinity);
  // Adding the same location again changes distances by round-off errors only.
  const std::vector<double> before = samples.distances();
  EXPECT_TRUE(samples.add(surface.in(77, {0.2, 0.3, 0.5})));
  for(const Index vertex : samples.sampled_vertices())
    EXPECT_NEAR(samples.distances()[vertex], before[vertex], round_off_tolerance * before[vertex]);
  EXPECT_EQ(samples.samples().size(), 2u);
  EXPECT_TRUE(samples.add(surface.at(0)));
  EXPECT_LE(samples.covering_radius(), radius);
  EXPECT_EQ(samples.labels()[surface.vertex(0)], 2u);
  EXPECT_EQ(samples.distances()[surface.vertex(0)], 0.);
}

TEST(Sampling, density_follows_slowness)
{
  const Triangulation plane = square(40, 0.2);
  const Array_surface surface(plane);
  const std::size_t m = surface.t().number_of_triangles();
  const auto count_left = [&](const Sampling& samples)
  {
    std::size_t left = 0;
    for(const Surface_location& sample : samples.samples())
      left += point_of(surface.t(), sample)[0] < 0.;
    return left;
  };
  std::vector<double> fourfold(m, 1.);
  for(Index f = 0; f < m; ++f)
    if(point_of(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] < 0.)
      fourfold[f] = 4.;
  Sampling weighted = sampling(surface.triangles(), Kind::euclidean, Sample_location::triangle,
                               std::make_shared<const std::vector<double>>(fourfold));
  expect_consistent(weighted, add_samples(weighted, 170));
  // The slow half has slowness four, and 16/17 of the area in the metric of travel times. Samples
  // on the boundary change this by less than 10 %.
  EXPECT_NEAR(double(count_left(weighted)), 160., 16.);

  // A constant slowness changes the unit only.
  Sampling plain = sampling(surface.triangles(), Kind::planar),
           twice = sampling(surface.triangles(), Kind::planar, Sample_location::triangle,
                            std::make_shared<const std::vector<double>>(m, 2.));
  const auto radii = add_samples(plain, 40), doubled = add_samples(twice, 40);
  for(std::size_t i = 0; i < radii.size(); ++i)
    EXPECT_EQ(doubled[i], 2. * radii[i]);
}

TEST(Sampling, avoids_obstacles)
{
  const Triangulation plane = square(20);
  const Array_surface surface(plane);
  // A central obstacle, three edges wide, whose interior is unreachable.
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(std::abs(surface.scale() *
                point_of(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0]) < 1.5 / 20.)
      slowness[f] = infinity;
  Sampling samples = sampling(surface.triangles(), Kind::euclidean, Sample_location::triangle,
                              std::make_shared<const std::vector<double>>(slowness));
  const auto radii = add_samples(samples, 20);
  EXPECT_EQ(radii[0], infinity);
  EXPECT_LT(radii[1], infinity);
  expect_consistent(samples, radii);
  for(const Surface_location& sample : samples.samples())
    if(sample.triangle != none)
    {
      EXPECT_EQ(slowness[sample.triangle], 1.);
    }
}

TEST(Sampling, is_scale_invariant)
{
  std::vector<std::vector<double>> all;
  for(const double scale : {1., 0x1p-20, 0x1p20})
  {
    const Triangulation plane = scaled(square(20, 0.2), scale);
    const Array_surface surface(plane);
    Sampling samples = sampling(surface.triangles());
    all.push_back(add_samples(samples, 50));
  }
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
}

TEST(Sampling, is_deterministic_for_a_seed)
{
  const Array_surface surface(icosphere(3));
  std::vector<std::vector<double>> all;
  for(const unsigned seed : {5u, 5u, 6u})
  {
    Sampling samples = sampling(surface.triangles());
    all.push_back(add_samples(samples, 30, seed));
  }
  EXPECT_EQ(all[0], all[1]);
  EXPECT_NE(all[0], all[2]);
}

TEST(Sampling, stops_at_covering_radius_and_on_cancel)
{
  const Array_surface surface(square(20));
  Sampling samples = sampling(surface.triangles());
  Sampling_options options;
  options.number_of_samples = 10000;
  options.covering_radius = 0.2 / surface.scale();
  std::vector<double> radii;
  EXPECT_TRUE(
      sample_farthest_points(samples, options, [&](double radius) { radii.push_back(radius); }));
  EXPECT_LE(radii.back(), options.covering_radius);
  EXPECT_GT(radii[radii.size() - 2], options.covering_radius);

  Sampling cancelled = sampling(surface.triangles());
  options.covering_radius = 0.;
  double last = 0.;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.002;
  };
  EXPECT_FALSE(sample_farthest_points(cancelled, options, [](double) {}));
  EXPECT_EQ(cancelled.samples().size(), 20u);
}

TEST(Sampling, samples_surfels_of_a_cloud)
{
  const Triangulation sphere = icosphere(3);
  for(const Kind kind : all_kinds)
  {
    std::vector<Point> points = sphere.points, normals = sphere.points;
    // Duplicate surfels, and an isolated one.
    points.push_back(points[7]);
    normals.push_back(normals[7]);
    points.push_back({50., 0., 0.});
    normals.push_back({1., 0., 0.});
    const auto cloud_arrays = std::make_shared<const Surfel_arrays>(
        build_surfel_arrays(std::move(points), std::move(normals)));
    const std::shared_ptr<const Surface_arrays> triangles(cloud_arrays, &cloud_arrays->arrays);
    Sampling samples = sampling(triangles, kind);
    const auto radii = add_samples(samples, 40, 3);
    expect_consistent(samples, radii);
    const auto expected = separate_distances(triangles, kind, samples);
    double worst = 0.;
    for(Index vertex = 0; vertex < expected.size(); ++vertex)
      if(expected[vertex] < infinity)
        worst = std::max(worst, std::abs(expected[vertex] - samples.distances()[vertex]));
    EXPECT_LE(worst, kind == Kind::dijkstra ? round_off_tolerance : 0.05 * radii.back());
    for(const Surface_location& sample : samples.samples())
      EXPECT_EQ(sample.triangle, none);
  }
}

TEST(Sampling, handles_needles)
{
  const Array_surface surface(grid(
      30, 30,
      [](double u, double v) {
        return Point{u, 1e-3 * v, 0.};
      },
      0.24, 3));
  Sampling samples = sampling(surface.triangles());
  expect_consistent(samples, add_samples(samples, 200));
}

} // namespace sampling_test
