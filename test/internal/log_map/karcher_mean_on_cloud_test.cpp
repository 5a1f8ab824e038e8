// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/log_map/karcher_mean_on_cloud.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "clouds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace karcher_mean_on_cloud_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Cloud_path_finder finder_of(const Cloud& cloud)
{
  return Cloud_path_finder(std::make_shared<const Fitted_cloud>(
      cloud.points, cloud.normals, std::vector<double>(), Cloud_path_options()));
}

// Returns the mean of points of the unit sphere: a zero of the sum of their logarithms.
Vec3 spherical_mean(const std::vector<Vec3>& points, const std::vector<double>& weights)
{
  double total = 0.;
  for(const double weight : weights)
    total += weight;
  Vec3 mean = points[0];
  for(int i = 0; i < 1000; ++i)
  {
    Vec3 step = {0., 0., 0.};
    for(std::size_t k = 0; k < points.size(); ++k)
    {
      const Vec3 across = points[k] - dot(points[k], mean) * mean;
      if(const double sine = norm(across); sine > 0.)
        step = step + weights[k] / total * std::atan2(sine, dot(points[k], mean)) / sine * across;
    }
    const double length = norm(step);
    if(length < 1e-15)
      break;
    mean = unit(std::cos(length) * mean + std::sin(length) / length * step);
  }
  return mean;
}

// The fitted surface is the sphere up to round-off errors, so the error is that of the tolerance.
TEST(karcher_mean_on_cloud, matches_sphere)
{
  const Cloud cloud = octahedron_sphere(5);
  const Cloud_path_finder finder = finder_of(cloud);
  std::mt19937 random(1);
  std::vector<Tangent_location> locations;
  std::vector<Vec3> points;
  std::vector<double> weights;
  while(points.size() < 12)
  {
    const Index i = Index(random() % cloud.size());
    if(norm(cloud.points[i] - cloud.points[50]) > 0.9)
      continue;
    locations.push_back({i, {0., 0.}});
    points.push_back(cloud.points[i]);
    weights.push_back(double(1 + points.size() % 3));
  }
  const Vec3 expected = spherical_mean(points, weights);
  for(const double tolerance : {1e-4, 1e-10})
  {
    Cloud_mean_options options;
    options.tolerance = tolerance;
    const Cloud_mean mean =
        karcher_mean_on_cloud(finder, locations, weights, locations[0], options);
    EXPECT_TRUE(mean.is_converged);
    EXPECT_LE(mean.gradient_norm, 2. * tolerance); // distances are at most 2
    // The smallest eigenvalue of the Hessian is at least cos 0.9, about 0.6.
    EXPECT_LT(norm(mean.point - expected), 4. * tolerance + 1e-8); // and steps of 1e-9
    double value = 0.;
    for(std::size_t k = 0; k < points.size(); ++k)
    {
      const double distance = std::acos(dot(points[k], expected));
      value += weights[k] * distance * distance;
    }
    EXPECT_NEAR(mean.value, value, 24. * 4. * tolerance * tolerance + 1e-7);
  }
}

// At the boundary, the mean of points of one side is there.
TEST(karcher_mean_on_cloud, stays_on_the_surface)
{
  const Cloud cloud = square_cloud(21);
  const Cloud_path_finder finder = finder_of(cloud);
  const std::vector<Tangent_location> locations = {{0, {0., 0.}}, {20, {0., 0.}}}; // on one side
  const Cloud_mean mean = karcher_mean_on_cloud(finder, locations, {1., 1.}, {210, {0., 0.}}, {});
  EXPECT_TRUE(mean.is_converged);
  EXPECT_LT(norm(mean.point - 0.5 * (cloud.points[0] + cloud.points[20])), 5e-5); // tolerance 1e-5
  EXPECT_NEAR(mean.value, 0.5, 1e-6);
}

TEST(karcher_mean_on_cloud, stops_and_cancels)
{
  const Cloud cloud = octahedron_sphere(3);
  const Cloud_path_finder finder = finder_of(cloud);
  const std::vector<Tangent_location> locations = {{0, {0., 0.}}, {70, {0., 0.}}, {80, {0., 0.}}};
  const std::vector<double> weights = {1., 1., 1.};
  Cloud_mean_options options;
  options.maximum_number_of_iterations = 0;
  const Cloud_mean start =
      karcher_mean_on_cloud(finder, locations, weights, {0, {0., 0.}}, options);
  EXPECT_EQ(start.number_of_iterations, 0u);
  EXPECT_FALSE(start.is_converged);
  EXPECT_LT(norm(start.point - cloud.points[0]), 1e-9);
  options.maximum_number_of_iterations = 3;
  EXPECT_LT(karcher_mean_on_cloud(finder, locations, weights, {0, {0., 0.}}, options).value,
            start.value);
  options.callback = [](double) { return false; };
  EXPECT_THROW(karcher_mean_on_cloud(finder, locations, weights, {0, {0., 0.}}, options),
               Cancelled);
}

} // namespace karcher_mean_on_cloud_test
