// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/centroids.h"

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include "Array_surface.h"
#include "polygons.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace centroids_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums over a few hundred triangles.
constexpr double round_off_tolerance = 1e-13;

std::vector<Index> labels_of(const Array_surface& surface,
                             const std::vector<Surface_location>& samples)
{
  Front front(surface.triangles(), Front_kind::euclidean);
  std::vector<Front_source> sources;
  for(const Surface_location& sample : samples)
    sources.push_back({{sample}, 0., 0});
  front.run(sources);
  std::vector<Index> result;
  for(Index vertex = 0; vertex < surface.size(); ++vertex)
    result.push_back(front.source(vertex));
  return result;
}

std::vector<Surface_location> centroids_of(const Array_surface& surface,
                                           const std::vector<Index>& labels,
                                           const std::vector<Surface_location>& samples,
                                           const std::vector<double>* slowness = nullptr,
                                           const Centroid_step& step = {})
{
  return centroids(surface.t(), triangle_masses(surface.t(), slowness), labels, samples, slowness,
                   step);
}

Point moved(const Array_surface& surface, const std::vector<Surface_location>& samples,
            std::size_t i)
{
  return coordinates(surface.t(), centroids_of(surface, labels_of(surface, samples), samples)[i]);
}

TEST(Centroids, are_exact_for_square_and_halves)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Triangulation plane = scaled(square(10, 0.2), scale);
    const Array_surface surface(plane);
    EXPECT_LT(distance(moved(surface, {surface.at(0)}, 0), {scale / 2., scale / 2., 0.}),
              round_off_tolerance * scale);
    // The bisector at the center of the square crosses triangles.
    const std::vector<Surface_location> two = {surface.at(5 * 11), surface.at(5 * 11 + 10)};
    EXPECT_LT(distance(moved(surface, two, 0), {scale / 4., scale / 2., 0.}),
              round_off_tolerance * scale);
    EXPECT_LT(distance(moved(surface, two, 1), {3. * scale / 4., scale / 2., 0.}),
              round_off_tolerance * scale);
  }
  // Both diagonals split the square into four cells that meet at a vertex. The centroid of a cell
  // is that of a triangle.
  const Array_surface regular(square(10));
  const std::vector<Surface_location> four = {regular.at(5), regular.at(5 * 11),
                                              regular.at(5 * 11 + 10), regular.at(115)};
  EXPECT_LT(distance(moved(regular, four, 0), {0.5, 1. / 6., 0.}), round_off_tolerance);
}

TEST(Centroids, split_triangle_among_three_cells)
{
  const Triangulation one{{{0., 0., 0.}, {1., 0.25, 0.}, {0.25, 0.75, 0.}}, {0, 1, 2}};
  const Array_surface surface(one);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.05, 1.);
  for(int i = 0; i < 300; ++i)
  {
    std::vector<Surface_location> samples;
    std::vector<Point> positions;
    std::vector<Index> labels(3);
    for(Index k = 0; k < 3; ++k)
    {
      // The first samples are near their corners, so that three regions meet inside the triangle.
      // The others are arbitrary.
      std::array<double, 3> b = {uniform(random), uniform(random), uniform(random)};
      b[k] += i < 150 ? 2. : 0.;
      const double sum = b[0] + b[1] + b[2];
      samples.push_back({0, none, {b[0] / sum, b[1] / sum, b[2] / sum}});
      positions.push_back(coordinates(surface.t(), samples.back()));
      labels[surface.t().corner[k]] = k;
    }
    const std::vector<Point> corners = {coordinates(surface.t(), {0, none, {1., 0., 0.}}),
                                        coordinates(surface.t(), {0, none, {0., 1., 0.}}),
                                        coordinates(surface.t(), {0, none, {0., 0., 1.}})};
    const std::vector<Surface_location> found = centroids_of(surface, labels, samples);
    for(int k = 0; k < 3; ++k)
    {
      const std::vector<Point> cell =
          clip_to_bisector(clip_to_bisector(corners, positions[k], positions[(k + 1) % 3]),
                           positions[k], positions[(k + 2) % 3]);
      // The last region is computed as a difference, so that small cells have larger round-off
      // errors.
      EXPECT_LT(distance(coordinates(surface.t(), found[k]), centroid(cell)), 1e-9);
    }
  }
}

TEST(Centroids, step_factor_and_momentum_overshoot)
{
  const Array_surface surface(square(10));
  const std::vector<Index> labels(surface.size(), 0);
  for(const double step_factor : {0., 0.5, 1.5})
    EXPECT_LT(distance(coordinates(surface.t(), centroids_of(surface, labels, {surface.at(0)},
                                                             nullptr, {step_factor})[0]),
                       {0.5 * step_factor, 0.5 * step_factor, 0.}),
              round_off_tolerance);
  const std::vector<Vec3> momentum = {{0.25, -0.125, 0.}};
  const Surface_location found =
      centroids_of(surface, labels, {surface.at(0)}, nullptr, {1., &momentum})[0];
  const double unit = surface.scale();
  EXPECT_LT(distance(coordinates(surface.t(), found), {0.5 + 0.25 * unit, 0.5 - 0.125 * unit, 0.}),
            round_off_tolerance);
}

TEST(Centroids, follow_density)
{
  const Array_surface surface(square(10));
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] < 0.5)
      slowness[f] = 2.;
  const std::vector<Index> labels(surface.size(), 0);
  const Point p =
      coordinates(surface.t(), centroids_of(surface, labels, {surface.at(0)}, &slowness)[0]);
  // The density is 16 times larger on the left.
  EXPECT_NEAR(p[0], (16. * 0.25 + 0.75) / 17., round_off_tolerance);
  EXPECT_NEAR(p[1], 0.5, round_off_tolerance);
}

TEST(Centroids, lie_on_the_surface)
{
  const Triangulation sphere = icosphere(3);
  const Array_surface surface(sphere);
  std::vector<Surface_location> samples;
  for(Index i = 0; i < 12; ++i)
    samples.push_back(surface.at(i));
  const std::vector<Surface_location> found =
      centroids_of(surface, labels_of(surface, samples), samples);
  ASSERT_EQ(found.size(), 12u);
  for(Index i = 0; i < 12; ++i)
  {
    EXPECT_NE(found[i].triangle, none);
    // By symmetry, the vertices of an icosahedron are the centroids of their cells. The center of
    // mass lies below the surface, and its closest point is within a tenth of an edge of the
    // vertex.
    EXPECT_LT(distance(coordinates(surface.t(), found[i]), sphere.points[i]), 0.016);
  }
}

TEST(Centroids, keep_samples_of_cells_without_area)
{
  // Two degenerate triangles adjacent to a regular one.
  Triangulation surface{{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0.5, 0., 0.}, {2., 0., 0.}},
                        {0, 1, 2, 1, 0, 3, 3, 4, 1}};
  const Array_surface arrays(surface);
  std::vector<Index> labels(5, 0);
  labels[arrays.vertex(4)] = 1;
  labels[arrays.vertex(3)] = 1;
  const std::vector<Surface_location> samples = {arrays.at(0), arrays.at(4)};
  const std::vector<Surface_location> found = centroids_of(arrays, labels, samples);
  for(const Surface_location& location : found)
    for(const double x : coordinates(arrays.t(), location))
      EXPECT_TRUE(std::isfinite(x));
  // A cell without vertices, and vertices without a cell.
  EXPECT_EQ(centroids_of(arrays, std::vector<Index>(5, none), samples)[1].barycentric,
            canonical(arrays.t(), samples[1]).barycentric);
}

} // namespace centroids_test
