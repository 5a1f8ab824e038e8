// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature/speeds.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>

namespace speeds_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;
using Function = std::function<double(const Point&)>;

// Returns the relative gradient norms of functions of position, by the vertices of a triangulation.
std::vector<double> gradients_of(const Triangulation& shape, const std::vector<Function>& functions)
{
  const Array_surface surface(shape);
  std::vector<std::vector<double>> channels(functions.size(), std::vector<double>(surface.size()));
  for(std::size_t c = 0; c < functions.size(); ++c)
    for(Index i = 0; i < surface.size(); ++i)
      channels[c][surface.vertex(i)] = functions[c](surface.point(i));
  const auto found = relative_gradient_norms(surface.t(), channels);
  std::vector<double> result;
  for(Index i = 0; i < surface.size(); ++i)
    result.push_back(found[surface.vertex(i)]);
  return result;
}

double x_of(const Point& p) { return p[0]; }
double y_of(const Point& p) { return p[1]; }
double z_of(const Point& p) { return p[2]; }

TEST(Speeds, total_curvature_is_scale_invariant)
{
  EXPECT_NEAR(sphere_total_curvature, 4. * std::sqrt(pi), 1e-15); // round-off error
  for(const double radius : {1., 1e-6, 1e6})
  {
    Triangulation sphere = icosphere(4);
    for(Point& p : sphere.points)
      p = radius * p;
    const Array_surface surface(sphere);
    // 2 / r times the square root of 4 pi r^2; the tolerance is that of the curvature test.
    for(const double curvature : total_curvatures(surface.triangles(), 0., 1))
      EXPECT_NEAR(curvature, sphere_total_curvature, 0.05 * sphere_total_curvature);
  }
}

TEST(Speeds, total_curvature_of_a_cylinder_matches_formula)
{
  const Triangulation pipe = cylinder(80, 40, 2., 6.);
  const Array_surface surface(pipe);
  const auto found = total_curvatures(surface.triangles(), 0.6 / surface.scale(), 2);
  const double expected = std::sqrt(2. * pi * 2. * 6.) / 2.;
  for(Index i = 0; i < surface.size(); ++i)
    if(surface.point(i)[2] > 0.6 && surface.point(i)[2] < 5.4)
    {
      // A ball covers about eight parallel edges and averages over them. Measured: 0.2 %.
      EXPECT_NEAR(found[surface.vertex(i)], expected, 0.02 * expected);
    }
}

TEST(Speeds, plane_has_no_curvature_and_linear_functions_constant_gradient)
{
  const Triangulation plane = square(12, 0.24);
  for(const double curvature : total_curvatures(Array_surface(plane).triangles(), 0., 1))
    EXPECT_NEAR(curvature, 0., 1e-11); // round-off error; edges of length 1/12
  const std::vector<std::vector<Function>> images = {
      {x_of}, {x_of, y_of}, {[](const Point& p) { return 1e308 * (p[1] - 0.5 * p[0] - 0.25); }}};
  for(const auto& functions : images)
    for(const double gradient : gradients_of(plane, functions))
      EXPECT_NEAR(gradient, 1., 1e-12); // round-off error; edges of length 1/12
}

TEST(Speeds, gradients_differ_across_a_crease)
{
  // The gradient changes at x = 1/2; no triangle crosses this line.
  const Triangulation plane = grid(
      12, 12,
      [](double u, double v) {
        return Point{u, v, 0.};
      },
      0.);
  const Function bent = [](const Point& p) { return p[0] + 2. * std::max(0., p[0] - 0.5); };
  const Function flat = [](const Point& p) { return std::max(0., p[0] - 0.5); };
  const auto three = gradients_of(plane, {bent}), root = gradients_of(plane, {x_of, flat});
  for(std::size_t i = 0; i < plane.points.size(); ++i)
  {
    const double x = plane.points[i][0];
    if(std::abs(x - 0.5) < 1e-9)
      continue;
    EXPECT_NEAR(three[i], x < 0.5 ? 1. / 3. : 1., 1e-12); // round-off error
    EXPECT_NEAR(root[i], x < 0.5 ? std::sqrt(0.5) : 1., 1e-12);
  }
}

TEST(Speeds, height_gradient_on_a_sphere_is_the_sine)
{
  const Triangulation sphere = icosphere(4);
  const auto found = gradients_of(sphere, {z_of});
  const auto surfels = build_surfel_arrays(sphere.points, sphere.points);
  std::vector<double> heights;
  for(const Index surfel : surfels.caller_vertex)
    heights.push_back(sphere.points[surfel][2]);
  const auto on_cloud = relative_gradient_norms(surfels.arrays, {heights});
  for(std::size_t i = 0; i < sphere.points.size(); ++i)
  {
    const double sine = std::sqrt(1. - sphere.points[i][2] * sphere.points[i][2]);
    // At a pole the sine is 0; the mean over triangles of width 0.08 is half of that width.
    EXPECT_NEAR(found[i], sine, 0.05);
    EXPECT_NEAR(on_cloud[surfels.internal_vertex[i]], sine, 0.05);
  }
}

TEST(Speeds, are_finite_on_degenerate_meshes)
{
  Triangulation shape = disjoint_union(square(3), grid(4, 4,
                                                       [](double u, double) {
                                                         return Point{u, u, 0.};
                                                       }));
  shape = disjoint_union(shape, grid(8, 8,
                                     [](double u, double v) {
                                       return Point{u, 1e-150 * v, 1e-160 * u * v};
                                     }));
  shape.points.push_back({9., 9., 9.});
  const Array_surface surface(shape);
  for(const double curvature : total_curvatures(surface.triangles(), 0., 1))
    EXPECT_TRUE(curvature >= 0. && curvature < 1e7);
  for(const double scale : {0., 1e-300, 1., 1e308})
    for(const double gradient : gradients_of(
            shape, {[=](const Point& p) { return scale * std::sin(3. * p[0] + 5. * p[1]); }}))
    {
      EXPECT_TRUE(gradient >= 0. && gradient <= 1.);
      if(scale == 0.)
      {
        EXPECT_EQ(gradient, 0.);
      }
    }
  EXPECT_EQ(total_curvatures(Array_surface(Triangulation()).triangles(), 0., 1).size(), 0u);
  EXPECT_THROW(relative_gradient_norms(Array_surface(square(1)).t(), {{0., 1., infinity, 0.}}),
               Invalid_argument_error);
  EXPECT_THROW(relative_gradient_norms(Array_surface(square(1)).t(),
                                       {{0., 1., 0., std::numeric_limits<double>::quiet_NaN()}}),
               Invalid_argument_error);
}

} // namespace speeds_test
