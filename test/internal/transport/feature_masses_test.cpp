// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/feature_masses.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace feature_masses_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of sums of some hundred numbers of order one.
constexpr double round_off = 1e-12;

// Returns the masses at the vertices of a triangulation, in its order.
std::vector<double> at_points(const Array_surface& surface,
                              const std::vector<Metric_tensor>& metric,
                              const Mass_distribution& masses)
{
  const Vector found =
      masses_at_vertices(surface.t(), metric_operators(surface.t(), metric).area, masses);
  std::vector<double> result;
  for(Index i = 0; i < surface.size(); ++i)
    result.push_back(found[surface.vertex(i)]);
  return result;
}

double sum(const std::vector<double>& values)
{
  double result = 0.;
  for(const double value : values)
    result += value;
  return result;
}

TEST(Feature_masses, are_proportional_to_length)
{
  for(const double scale : {1., 1e-6, 1e6})
  {
    // The bottom row of the square, whose edges have the lengths 0.1 and 0.2.
    Triangulation plane = square(6);
    for(Point& p : plane.points)
      p[0] = scale * (p[0] < 0.5 ? 0.6 * p[0] : 0.3 + 1.2 * (p[0] - 0.5)), p[1] *= scale;
    const Array_surface surface(plane);
    const Feature_masses found = uniform_feature_masses(
        surface.t(), {}, {surface.along({0, 1, 2, 3, 4, 5, 6}), surface.along({10})});
    const std::vector<double> mass = at_points(surface, {}, found.feature);
    const double area = 0.9 * scale * scale;
    EXPECT_NEAR(sum(mass), area, round_off * area);
    EXPECT_NEAR(sum(at_points(surface, {}, found.surface)), area, round_off * area);
    for(Index i = 0; i <= 6; ++i)
    {
      const double length = 0.5 * ((i > 0 ? plane.points[i][0] - plane.points[i - 1][0] : 0.) +
                                   (i < 6 ? plane.points[i + 1][0] - plane.points[i][0] : 0.));
      EXPECT_NEAR(mass[i], area * length / (0.9 * scale), round_off * area);
    }
    EXPECT_EQ(mass[10], 0.); // a point has no length
  }
}

TEST(Feature_masses, are_equal_at_points)
{
  const Array_surface surface(square(4, 0.2));
  const Feature_masses found = uniform_feature_masses(
      surface.t(), {}, {surface.along({3}), surface.along({20}), {surface.in(7, {0.2, 0.3, 0.5})}});
  const std::vector<double> mass = at_points(surface, {}, found.feature);
  EXPECT_NEAR(sum(mass), 1., round_off);
  ASSERT_EQ(found.feature.at_locations.size(), 3u);
  for(const auto& [location, value] : found.feature.at_locations)
    EXPECT_NEAR(value, 1. / 3., round_off);
}

TEST(Feature_masses, equal_the_area_of_each_component)
{
  Triangulation small = square(4, 0.2);
  for(Point& p : small.points)
    p = {0.5 * p[0], 0.5 * p[1], 1.};
  const Triangulation shape = disjoint_union(disjoint_union(square(4), small), icosphere(0));
  const Array_surface surface(shape);
  const Feature_masses found =
      uniform_feature_masses(surface.t(), {}, {surface.along({0, 1}), surface.along({30})});
  EXPECT_EQ(std::count(found.has_feature.begin(), found.has_feature.end(), true), 2);
  const std::vector<double> mass = at_points(surface, {}, found.feature),
                            area = at_points(surface, {}, found.surface);
  EXPECT_NEAR(mass[0] + mass[1], 1., round_off);
  EXPECT_NEAR(mass[30], 0.25, round_off);
  EXPECT_NEAR(sum(mass), 1.25, round_off);
  for(Index i = 50; i < surface.size(); ++i) // the sphere has no feature
    EXPECT_EQ(area[i], 0.);
}

// Blocked triangles separate the left from the right part. A location in a blocked triangle belongs
// to its corners.
TEST(Feature_masses, respect_obstacles)
{
  const Triangulation plane = square(4);
  const Array_surface surface(plane);
  std::vector<Metric_tensor> metric(surface.t().number_of_triangles(), {1., 0., 1.});
  Index blocked_face = none;
  for(Index f = 0; f < 32; ++f)
  {
    double x = 0.;
    for(std::size_t k = 0; k < 3; ++k)
      x += plane.points[plane.corners[3 * f + k]][0] / 3.;
    if(x > 0.5 && x < 0.75)
    {
      metric[surface.triangle(f)] = {infinity, 0., infinity};
      blocked_face = f;
    }
  }
  const Feature_masses left = uniform_feature_masses(surface.t(), metric, {surface.along({0})});
  EXPECT_NEAR(sum(at_points(surface, metric, left.feature)), 0.5, round_off);
  EXPECT_FALSE(left.has_feature[left.component[surface.vertex(4)]]);
  const Feature_masses both =
      uniform_feature_masses(surface.t(), metric, {{surface.in(blocked_face, {0.25, 0.25, 0.5})}});
  const std::vector<double> mass = at_points(surface, metric, both.feature);
  EXPECT_NEAR(sum(mass), 0.75, round_off);
  double right = 0.;
  for(Index i = 0; i < surface.size(); ++i)
    right += plane.points[i][0] > 0.7 ? mass[i] : 0.;
  EXPECT_NEAR(right, 0.25, round_off);
}

} // namespace feature_masses_test
