// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/relaxation.h"

#include "sampling/centroids.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace relaxation_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

struct Relaxed
{
  std::vector<Surface_location> samples;
  std::vector<Point> points;
};

Relaxed relaxed(const Array_surface& surface, std::vector<Surface_location> samples, int steps,
                std::vector<bool> is_fixed = {},
                std::shared_ptr<const std::vector<double>> slowness = nullptr)
{
  is_fixed.resize(samples.size());
  Front front(surface.triangles(), Front_kind::euclidean);
  std::vector<Front_source> sources;
  for(const Surface_location& sample : samples)
    sources.push_back({{sample}, 0., 0});
  Front_limits limits;
  limits.slowness = slowness;
  front.run(sources, limits);
  std::vector<Index> labels;
  for(Index vertex = 0; vertex < surface.size(); ++vertex)
    labels.push_back(front.source(vertex));
  Relaxation relaxation(surface.triangles(), slowness, samples, labels, is_fixed);
  for(int step = 0; step < steps; ++step)
    relaxation.step(step + 1 == steps);
  Relaxed result{relaxation.samples(), {}};
  for(const Surface_location& sample : result.samples)
    result.points.push_back(coordinates(surface.t(), sample));
  return result;
}

TEST(Relaxation, converges_on_square_and_strip)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Triangulation plane = scaled(square(20, 0.2), scale);
    const Array_surface surface(plane);
    const Relaxed one = relaxed(surface, {surface.at(0)}, 1);
    // Round-off errors of coordinates.
    EXPECT_LT(distance(one.points[0], {scale / 2., scale / 2., 0.}), 1e-13 * scale);

    // On a strip of aspect ratio four, the limits are the centers of four squares.
    for(Point& p : plane.points)
      p[1] /= 4.;
    const Array_surface strip(plane);
    // A step multiplies errors by at most 0.84 = sqrt(momentum), so that 60 steps reduce them to
    // 1e-4.
    const double error = 1e-4 * scale;
    const Relaxed four = relaxed(
        strip, {strip.at(10 * 21), strip.at(10 * 21 + 3), strip.at(10 * 21 + 10), strip.at(440)},
        60);
    for(int i = 0; i < 4; ++i)
      EXPECT_LT(distance(four.points[i], {(0.125 + 0.25 * i) * scale, 0.125 * scale, 0.}), error);
  }
}

TEST(Relaxation, converges_to_cell_centroids)
{
  const Array_surface surface(jittered(icosphere(4), 0.02));
  std::vector<Surface_location> samples = farthest_points(surface.triangles(), 40);
  const Relaxed found = relaxed(surface, samples, 100);
  // The cells computed by one front from all samples.
  Front front(surface.triangles(), Front_kind::euclidean);
  std::vector<Front_source> sources;
  for(const Surface_location& sample : found.samples)
    sources.push_back({{sample}, 0., 0});
  front.run(sources);
  std::vector<Index> labels;
  double largest = 0.;
  for(Index vertex = 0; vertex < surface.size(); ++vertex)
  {
    labels.push_back(front.source(vertex));
    largest = std::max(largest, front.distance(vertex) * surface.scale());
  }
  const std::vector<Surface_location> centers =
      centroids(surface.t(), triangle_masses(surface.t()), labels, found.samples);
  // Vertices that change their cell keep moving samples by a fraction of an edge, which has length
  // 0.07.
  for(std::size_t i = 0; i < centers.size(); ++i)
    EXPECT_LT(distance(coordinates(surface.t(), centers[i]), found.points[i]), 0.01);
  // The vertices of forty equal hexagons on a sphere are at distance 0.35 from their centers.
  EXPECT_LT(largest, 0.42);
}

TEST(Relaxation, keeps_fixed_samples)
{
  const Array_surface surface(square(10, 0.2));
  const std::vector<Surface_location> samples = {surface.at(0), surface.at(55), surface.at(120)};
  const Relaxed found = relaxed(surface, samples, 5, {true, false, true});
  EXPECT_EQ(found.points[0], surface.point(0));
  EXPECT_EQ(found.points[2], surface.point(120));
  EXPECT_NE(found.points[1], surface.point(55));
}

TEST(Relaxation, avoids_obstacles)
{
  const Array_surface surface(square(20, 0.2));
  // An obstacle that spans three quarters of the height.
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
  {
    const Point p = coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}});
    if(p[0] > 0.4 && p[0] < 0.6 && p[1] < 0.75)
      slowness[f] = infinity;
  }
  const Relaxed found = relaxed(surface, {surface.at(0), surface.at(20), surface.at(430)}, 20, {},
                                std::make_shared<const std::vector<double>>(slowness));
  for(std::size_t i = 0; i < 3; ++i)
  {
    for(const double x : found.points[i])
      EXPECT_TRUE(std::isfinite(x));
    const std::vector<Index> incident = triangles_at(surface.t(), found.samples[i]);
    EXPECT_TRUE(std::any_of(incident.begin(), incident.end(),
                            [&](Index f) { return slowness[f] < infinity; }));
  }
}

TEST(Relaxation, accepts_samples_with_empty_cells)
{
  Triangulation shape = square(4);
  shape.points.push_back({3., 0., 0.});
  const Array_surface surface(shape);
  const Relaxed found = relaxed(surface, {surface.at(25), surface.at(0), surface.at(0)}, 4);
  EXPECT_EQ(found.points[0], shape.points[25]);
  EXPECT_TRUE(std::isfinite(found.points[1][0]));
}

} // namespace relaxation_test
