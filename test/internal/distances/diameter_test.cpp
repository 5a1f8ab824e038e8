// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/diameter.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include "Array_surface.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace diameter_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Relative errors of exact distances are 2e-12.
constexpr double round_off = 1e-11;

// Returns the eccentricity of each vertex, in the indices and the unit of the arrays.
std::vector<double> eccentricities(const Array_surface& surface)
{
  Window_propagation windows(surface.triangles());
  std::vector<double> result;
  for(Index v = 0; v < surface.size(); ++v)
  {
    windows.run({{{{none, v, {}}}, 0., 0}});
    double eccentricity = 0.;
    for(const Index reached : windows.reached())
      eccentricity = std::max(eccentricity, windows.distance(reached));
    result.push_back(eccentricity);
  }
  return result;
}

Diameter_options with_tolerance(double tolerance)
{
  Diameter_options result;
  result.relative_tolerance = tolerance;
  return result;
}

std::vector<std::pair<std::string, Triangulation>> small_surfaces()
{
  return {{"square", square(7, 0.2)},
          {"sphere", icosphere(2)},
          {"torus", torus(16, 10)},
          {"cylinder", cylinder(10, 9, 1., 3.)},
          {"annulus", annulus(16, 3, 1., 2.)},
          {"cone", cone(9, 5, 4.)},
          {"saddle", cone(10, 5, 8.)},
          {"blocks", blocks(3, 2, 2, [](int, int, int) { return true; })},
          {"double torus", double_torus(2)},
          {"knot", knot(40, 5)},
          {"tetrahedron", tetrahedron()},
          {"triangle", one_triangle()}};
}

TEST(diameter, bounds_contain_the_largest_and_the_smallest_eccentricity)
{
  for(const auto& [name, triangulation] : small_surfaces())
  {
    SCOPED_TRACE(name);
    const Array_surface surface(triangulation);
    if(surface.size() > 500)
      continue;
    const std::vector<double> exact = eccentricities(surface);
    const auto [radius, diameter] = std::minmax_element(exact.begin(), exact.end());
    for(const double tolerance : {0., 0.01, 0.2})
    {
      const Diameter_bounds bounds = bound_diameter(surface.triangles(), with_tolerance(tolerance));
      EXPECT_TRUE(bounds.is_converged);
      EXPECT_LE(bounds.lower, *diameter * (1. + round_off));
      EXPECT_GE(bounds.upper, *diameter * (1. - round_off));
      EXPECT_LE(bounds.upper, bounds.lower * (1. + tolerance + round_off));
      Window_propagation windows(surface.triangles());
      windows.run({{{{none, bounds.from, {}}}, 0., 0}});
      EXPECT_NEAR(windows.distance(bounds.to), bounds.lower, round_off * bounds.lower);

      const Radius_bounds center = bound_radius(surface.triangles(), with_tolerance(tolerance));
      EXPECT_TRUE(center.is_converged);
      EXPECT_LE(center.lower, *radius * (1. + round_off));
      EXPECT_GE(center.upper, *radius * (1. - round_off));
      EXPECT_LE(center.upper, center.lower * (1. + tolerance + round_off));
      EXPECT_NEAR(exact[center.center], center.upper, round_off * center.upper);
      windows.run({{{{none, center.center, {}}}, 0., 0}});
      EXPECT_NEAR(windows.distance(center.farthest), center.upper, round_off * center.upper);
    }
  }
}

TEST(diameter, bounds_hold_after_few_queries)
{
  const Array_surface surface(icosphere(2));
  const std::vector<double> exact = eccentricities(surface);
  const auto [radius, diameter] = std::minmax_element(exact.begin(), exact.end());
  for(const std::size_t number : {1, 2, 3, 10})
  {
    Diameter_options options = with_tolerance(0.);
    options.max_number_of_queries = number;
    const Diameter_bounds bounds = bound_diameter(surface.triangles(), options);
    EXPECT_LE(bounds.number_of_queries, number);
    EXPECT_LE(bounds.lower, *diameter * (1. + round_off));
    EXPECT_GE(bounds.upper, *diameter * (1. - round_off));
    EXPECT_LT(bounds.upper, infinity);
    const Radius_bounds center = bound_radius(surface.triangles(), options);
    EXPECT_LE(center.number_of_queries, number);
    EXPECT_FALSE(center.is_converged);
    EXPECT_LE(center.lower, *radius * (1. + round_off));
    EXPECT_GE(center.upper, *radius * (1. - round_off));
  }
}

TEST(diameter, is_the_largest_one_of_the_components)
{
  const Triangulation large = scaled(square(5), 2.);
  Triangulation both = disjoint_union(square(3), large);
  both.points.push_back({50., 50., 50.}); // a vertex without triangles
  const Array_surface surface(both);
  const Diameter_bounds bounds = bound_diameter(surface.triangles(), with_tolerance(0.));
  EXPECT_NEAR(surface.scale() * bounds.lower, 2. * std::sqrt(2.), round_off);
  EXPECT_NEAR(surface.scale() * bounds.upper, 2. * std::sqrt(2.), round_off);
  // With one query in each component, the bounds are finite.
  Diameter_options one_query;
  one_query.max_number_of_queries = 1;
  const Diameter_bounds coarse = bound_diameter(surface.triangles(), one_query);
  EXPECT_EQ(coarse.number_of_queries, 2u);
  EXPECT_GE(coarse.upper, bounds.upper);
  EXPECT_LE(coarse.upper, 2. * bounds.upper * (1. + round_off));
  EXPECT_LT(bound_radius(surface.triangles(), one_query).upper, infinity);
  const Array_surface alone(large);
  EXPECT_NEAR(surface.scale() * bound_radius(surface.triangles(), with_tolerance(0.)).upper,
              alone.scale() * bound_radius(alone.triangles(), with_tolerance(0.)).upper, round_off);
}

TEST(diameter, needs_a_triangle)
{
  const Array_surface surface({{{0., 0., 0.}}, {}});
  EXPECT_THROW(bound_diameter(surface.triangles()), Unsupported_surface_error);
  EXPECT_THROW(bound_radius(surface.triangles()), Unsupported_surface_error);
}

TEST(diameter, reports_fractions)
{
  const Array_surface surface(square(7));
  std::vector<double> fractions;
  Diameter_options options;
  options.callback = [&](double fraction)
  {
    fractions.push_back(fraction);
    return true;
  };
  bound_diameter(surface.triangles(), options);
  bound_radius(surface.triangles(), options);
  ASSERT_GE(fractions.size(), 2u);
  EXPECT_EQ(fractions.back(), 1.);
  for(const double fraction : fractions)
  {
    EXPECT_GE(fraction, 0.);
    EXPECT_LE(fraction, 1.);
  }
}

} // namespace diameter_test
