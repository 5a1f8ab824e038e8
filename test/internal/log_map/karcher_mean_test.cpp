// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/karcher_mean.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Departure_finder.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/log_map/Polar_frame.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace karcher_mean_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of distances across some tens of triangles.
constexpr double round_off = 1e-11;

// Returns the weighted sum of squared distances at a location, by the distances of the exact method
// from the other locations.
double sum_at(const Array_surface& surface, const std::vector<Surface_location>& locations,
              const std::vector<double>& weights, const Surface_location& at)
{
  Window_propagation windows(surface.triangles());
  windows.run({{{at}, 0., 0}});
  double result = 0.;
  for(std::size_t i = 0; i < locations.size(); ++i)
  {
    const double distance = windows.distance(canonical(surface.t(), locations[i]));
    result += weights[i] * distance * distance;
  }
  return result;
}

std::vector<Surface_location> random_locations(const Array_surface& surface, std::size_t number,
                                               std::mt19937& random)
{
  std::vector<Surface_location> result;
  while(result.size() < number)
    result.push_back(canonical(surface.t(), random_location(surface.t(), random)));
  return result;
}

// The rough surfaces have convex and saddle vertices with large curvature, so most means are in
// a triangle with several vertices nearby, or at a vertex.
TEST(karcher_mean_kernel, is_a_local_minimum)
{
  std::mt19937 random(1);
  const std::vector<std::pair<std::string, Triangulation>> surfaces = {
      {"rough sphere", jittered(icosphere(2), 0.1)},
      {"cube", blocks(2, 2, 2, [](int, int, int) { return true; })},
      {"double torus", double_torus(1)},
      {"tetrahedron", tetrahedron()},
      {"saddle", cone(12, 3, 9.)},
      {"annulus", annulus(16, 3, 1., 2.)}};
  for(const auto& [name, triangulation] : surfaces)
    for(int repetition = 0; repetition < 5; ++repetition)
    {
      SCOPED_TRACE(name + ", " + std::to_string(repetition));
      const Array_surface surface(triangulation);
      const auto locations = random_locations(surface, 3 + repetition, random);
      const std::vector<double> weights(locations.size(), 1. / double(locations.size()));
      const Mean_location mean = karcher_mean(surface.triangles(), locations, weights);
      EXPECT_TRUE(mean.is_converged);
      EXPECT_LE(mean.gradient_norm, 1e-8 * 10.); // the tolerance times a bound of the distances
      EXPECT_NEAR(mean.value, sum_at(surface, locations, weights, mean.location), round_off);
      // The sum increases in all directions: by the square of the step at smooth points.
      const Polar_frame frame(surface.t(), mean.location);
      const double step = 1e-5;
      for(const Direction_fan& fan : frame.fans())
        for(int i = 0; i < 16; ++i)
        {
          const Straightest_path path = frame.path(fan.begin + fan.angle * (i + 0.5) / 16., step);
          EXPECT_GT(sum_at(surface, locations, weights, path.locations.back()),
                    mean.value - 1e-13); // round-off; the increase at smooth points is 1e-10
        }
    }
}

// The derivative of the sum in a direction, by central differences.
TEST(karcher_mean_kernel, gradient_norm_matches_finite_differences)
{
  std::mt19937 random(2);
  const Array_surface surface(jittered(icosphere(2), 0.05));
  for(int repetition = 0; repetition < 10; ++repetition)
  {
    const auto locations = random_locations(surface, 4, random);
    const std::vector<double> weights = {1., 2., 3., 4.};
    Mean_options options;
    options.maximum_number_of_iterations = 0;
    options.initial_location = canonical(surface.t(), random_location(surface.t(), random));
    const Mean_location start = karcher_mean(surface.triangles(), locations, weights, options);
    EXPECT_FALSE(start.is_converged);
    EXPECT_EQ(start.number_of_iterations, 0u);
    const Polar_frame frame(surface.t(), *options.initial_location);
    const double step = 1e-5;
    const auto derivative = [&](double angle)
    {
      const auto sum = [&](double at)
      { return sum_at(surface, locations, weights, frame.path(at, step).locations.back()); };
      return (sum(angle) - sum(angle + pi)) / (2. * step) / 20.; // half the sum, sum of weights 10
    };
    // The differences of sums of order 10 have round-off errors of 1e-15 / step.
    EXPECT_NEAR(start.gradient_norm, std::hypot(derivative(0.), derivative(pi / 2.)), 1e-8);
  }
}

// In the plane, one step leads to the centroid.
TEST(karcher_mean_kernel, takes_one_step_in_the_plane)
{
  const Array_surface surface(square(10, 0.24));
  std::mt19937 random(3);
  const auto locations = random_locations(surface, 50, random);
  const std::vector<double> weights(50, 2.);
  Point centroid = {0., 0., 0.};
  for(const Surface_location& location : locations)
    for(int k = 0; k < 3; ++k)
      centroid[k] += point_at(surface.t(), location)[k] / 50.;
  const Mean_location mean = karcher_mean(surface.triangles(), locations, weights);
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LE(mean.number_of_iterations, 1u);
  EXPECT_LT(distance(point_at(surface.t(), mean.location), centroid), round_off);
}

// The fan of a saddle vertex: the minimum is exactly there, also if the weights differ a little.
TEST(karcher_mean_kernel, finds_minima_at_saddle_vertices)
{
  const Array_surface surface(cone(12, 3, 9.));
  const std::vector<Surface_location> locations = {surface.at(1 + 12), surface.at(1 + 12 + 4),
                                                   surface.at(1 + 12 + 8)};
  Mean_options options;
  options.initial_location = surface.in(3, {0.1, 0.2, 0.7});
  for(const std::vector<double>& weights :
      {std::vector<double>{1., 1., 1.}, std::vector<double>{1., 1.2, 0.9}})
  {
    const Mean_location mean = karcher_mean(surface.triangles(), locations, weights, options);
    EXPECT_TRUE(mean.is_converged);
    EXPECT_EQ(mean.gradient_norm, 0.);
    EXPECT_EQ(vertex_of(surface.t(), mean.location), surface.vertex(0));
  }
  // The derivative towards the first location is - 5 + 1 + 1, times its distance.
  const Mean_location moved = karcher_mean(surface.triangles(), locations, {5., 1., 1.}, options);
  EXPECT_TRUE(moved.is_converged);
  EXPECT_EQ(vertex_of(surface.t(), moved.location), none);
  // At the distance r from the center, on the line to the first location. The angles to the others
  // are 3, so the sum is 5 (2 - r)^2 + 2 (r^2 + 4 - 4 r cos 3).
  EXPECT_NEAR(norm(point_at(surface.t(), moved.location)), (10. + 4. * std::cos(3.)) / 7.,
              1e-7); // tolerance: 3e-8
}

TEST(karcher_mean_kernel, throws_and_cancels)
{
  const Array_surface surface(disjoint_union(icosphere(1), scaled(icosphere(1), 3.)));
  EXPECT_THROW(karcher_mean(surface.triangles(), {surface.at(0), surface.at(42)}, {1., 1.}),
               Invalid_argument_error);
  Mean_options options;
  options.initial_location = surface.at(42);
  EXPECT_THROW(karcher_mean(surface.triangles(), {surface.at(0)}, {1.}, options),
               Invalid_argument_error);
  options = {};
  options.callback = [](double) { return false; };
  EXPECT_THROW(karcher_mean(surface.triangles(), {surface.at(0), surface.at(1)}, {1., 1.}, options),
               Cancelled);
}

} // namespace karcher_mean_test
