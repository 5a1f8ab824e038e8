// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature/curvature.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

namespace curvature_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of unit vectors and of planes.
constexpr double round_off = 1e-12;

// Returns the curvatures by the vertices of a triangulation, in its unit.
std::vector<Curvature> curvatures_of(const Triangulation& shape, double radius = 0.,
                                     unsigned number_of_threads = 1)
{
  const Array_surface surface(shape);
  const auto by_vertex =
      curvatures(surface.triangles(), radius / surface.scale(), number_of_threads);
  std::vector<Curvature> result(shape.points.size());
  for(Index i = 0; i < result.size(); ++i)
  {
    result[i] = by_vertex[surface.vertex(i)];
    result[i].min_curvature /= surface.scale();
    result[i].max_curvature /= surface.scale();
  }
  return result;
}

// Returns the graph z = f(x, y) over a square centered at the origin.
Triangulation graph(std::size_t n, double size, const std::function<double(double, double)>& f,
                    double jitter = 0.24)
{
  return grid(
      n, n,
      [=](double u, double v)
      {
        const double x = size * (2. * u - 1.), y = size * (2. * v - 1.);
        return Point{x, y, f(x, y)};
      },
      jitter);
}

// Checks that the directions are unit vectors perpendicular to each other and to the normal.
// tolerance  the angle between the estimated normal and the given one
void expect_frame(const Curvature& curvature, const Point& normal, double tolerance)
{
  EXPECT_NEAR(norm(curvature.min_direction), 1., round_off);
  EXPECT_NEAR(norm(curvature.max_direction), 1., round_off);
  EXPECT_NEAR(dot(curvature.min_direction, curvature.max_direction), 0., round_off);
  EXPECT_NEAR(dot(curvature.min_direction, normal), 0., tolerance);
  EXPECT_NEAR(dot(curvature.max_direction, normal), 0., tolerance);
}

TEST(Curvature, sphere_curvature_is_inverse_radius)
{
  for(const double radius : {1., 1e-6, 1e6})
  {
    Triangulation sphere = icosphere(4);
    for(Point& p : sphere.points)
      p = {radius * p[0], radius * p[1], radius * p[2]};
    const auto found = curvatures_of(sphere);
    for(Index i = 0; i < found.size(); ++i)
    {
      // Edges are 0.07 long; a ball with a radius of three edges contains about 40 edges.
      EXPECT_NEAR(radius * found[i].min_curvature, 1., 0.05);
      EXPECT_NEAR(radius * found[i].max_curvature, 1., 0.05);
      EXPECT_LE(found[i].min_curvature, found[i].max_curvature);
      const Point& p = sphere.points[i];
      // The measured angles between the normals are up to 0.004.
      expect_frame(found[i], {p[0] / radius, p[1] / radius, p[2] / radius}, 0.01);
    }
  }
}

TEST(Curvature, cylinder_has_one_non_zero_curvature)
{
  const double radius = 2.;
  const Triangulation pipe = cylinder(80, 40, radius, 6.);
  const auto found = curvatures_of(pipe, 0.6);
  for(Index i = 0; i < found.size(); ++i)
  {
    const Point& p = pipe.points[i];
    if(p[2] < 0.6 || p[2] > 5.4)
      continue;
    // The dihedral angle of each edge is 2 pi / 80. A ball covers eight parallel edges: one more
    // or less changes the curvature by an eighth.
    EXPECT_NEAR(found[i].max_curvature, 1. / radius, 0.1 / radius);
    EXPECT_NEAR(found[i].min_curvature, 0., 0.02 / radius);
    // The mesh is symmetric about the plane of each vertex and the axis.
    EXPECT_GT(std::abs(found[i].min_direction[2]), 1. - round_off);
    EXPECT_LT(std::abs(found[i].max_direction[2]), round_off);
  }
}

TEST(Curvature, torus_matches_formula)
{
  const double major_radius = 1., minor_radius = 0.4;
  const Triangulation torus = grid(
      160, 80,
      [=](double u, double v)
      {
        const double a = 2. * pi * u, b = 2. * pi * v,
                     r = major_radius + minor_radius * std::cos(b);
        return Point{r * std::cos(a), r * std::sin(a), minor_radius * std::sin(b)};
      },
      0.);
  const auto found = curvatures_of(torus, 0.12);
  for(std::size_t j = 8; j <= 72; j += 4)
    for(std::size_t i = 10; i <= 150; i += 20)
    {
      const Curvature& curvature = found[i + 161 * j];
      const double a = 2. * pi * i / 160., b = 2. * pi * j / 80.;
      const double around = std::cos(b) / (major_radius + minor_radius * std::cos(b)),
                   across = 1. / minor_radius;
      // A ball of radius 0.12 averages over a third of a radian of b.
      EXPECT_NEAR(curvature.max_curvature, across, 0.05 * across);
      EXPECT_NEAR(curvature.min_curvature, around, 0.05 * across);
      const Point axis = {-std::sin(a), std::cos(a), 0.};
      // Within 2.6 degrees; measured are 0.4.
      EXPECT_GT(std::abs(dot(curvature.min_direction, axis)), 0.999);
    }
}

TEST(Curvature, saddle_has_curvatures_of_opposite_sign)
{
  // Rotated by 0.3 radians, on an irregular triangulation.
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Triangulation saddle = graph(60, 1.,
                                     [=](double x, double y)
                                     {
                                       const double u = c * x + s * y, v = c * y - s * x;
                                       return 0.5 * (u * u - v * v);
                                     });
  const Curvature middle = curvatures_of(saddle, 0.25)[30 + 61 * 30];
  // Normals point upwards: the curvature of a valley is negative. In a ball of radius 0.25 the
  // curvature decreases to (1 + 0.25^2)^-1.5 of that in the center.
  EXPECT_NEAR(middle.min_curvature, -1., 0.1);
  EXPECT_NEAR(middle.max_curvature, 1., 0.1);
  // Within 2.6 degrees; measured are 0.3.
  EXPECT_GT(std::abs(dot(middle.min_direction, Point{c, s, 0.})), 0.999);
  EXPECT_GT(std::abs(dot(middle.max_direction, Point{-s, c, 0.})), 0.999);
}

TEST(Curvature, plane_has_zero_curvature)
{
  for(const Curvature& curvature : curvatures_of(square(12, 0.24)))
  {
    EXPECT_NEAR(curvature.min_curvature, 0., round_off);
    EXPECT_NEAR(curvature.max_curvature, 0., round_off);
  }
}

TEST(Curvature, is_finite_on_degenerate_meshes)
{
  Triangulation needles = square(8, 0.24);
  for(Point& p : needles.points)
    p = {p[0], 1e-9 * p[1], p[0] * p[0]};
  Triangulation flat = square(8);
  for(Point& p : flat.points)
    p[1] = 0.;
  Triangulation with_isolated_vertex = tetrahedron();
  with_isolated_vertex.points.push_back({5., 5., 5.});
  for(const Triangulation& shape : {needles, flat, with_isolated_vertex, one_triangle(),
                                    disjoint_union(with_isolated_vertex, square(2))})
    for(const Curvature& curvature : curvatures_of(shape))
    {
      EXPECT_TRUE(std::isfinite(curvature.min_curvature) && std::isfinite(curvature.max_curvature));
      for(int k = 0; k < 3; ++k)
        EXPECT_TRUE(std::isfinite(curvature.min_direction[k]) &&
                    std::isfinite(curvature.max_direction[k]));
    }
  const Curvature isolated = curvatures_of(with_isolated_vertex).back();
  EXPECT_EQ(isolated.min_curvature, 0.);
  EXPECT_EQ(isolated.max_curvature, 0.);
}

TEST(Curvature, does_not_depend_on_number_of_threads)
{
  const Triangulation shape = jittered(icosphere(3), 0.02);
  const auto one = curvatures_of(shape), three = curvatures_of(shape, 0., 3);
  for(Index i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i].min_curvature, three[i].min_curvature);
    EXPECT_EQ(one[i].max_curvature, three[i].max_curvature);
    EXPECT_EQ(one[i].max_direction, three[i].max_direction);
  }
}

} // namespace curvature_test
