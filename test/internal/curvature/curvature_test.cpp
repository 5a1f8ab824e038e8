// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/curvature/curvature.h>

#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// By the points of a triangulation, in its unit.
std::vector<Curvature> curvatures_of(const Triangulation& shape, double radius = 0.,
                                     unsigned threads = 1)
{
  const Glued_surface surface(shape);
  const auto by_site = curvatures(surface.triangles(), radius / surface.scale(), threads);
  std::vector<Curvature> result(shape.points.size());
  for(Index i = 0; i < result.size(); ++i)
  {
    result[i] = by_site[surface.site(i)];
    result[i].least /= surface.scale();
    result[i].most /= surface.scale();
  }
  return result;
}

// z = f(x, y) over a square around the origin.
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

// A frame of two unit vectors that are perpendicular to each other and to the normal.
void expect_frame(const Curvature& curvature, const Point& normal, double tolerance)
{
  EXPECT_NEAR(norm(curvature.least_direction), 1., 1e-12);
  EXPECT_NEAR(norm(curvature.most_direction), 1., 1e-12);
  EXPECT_NEAR(dot(curvature.least_direction, curvature.most_direction), 0., 1e-12);
  EXPECT_NEAR(dot(curvature.least_direction, normal), 0., tolerance);
  EXPECT_NEAR(dot(curvature.most_direction, normal), 0., tolerance);
}

TEST(Curvature, of_a_sphere_is_that_of_its_radius_on_every_scale)
{
  for(const double radius : {1., 1e-6, 1e6})
  {
    Triangulation sphere = icosphere(4);
    for(Point& p : sphere.points)
      p = {radius * p[0], radius * p[1], radius * p[2]};
    const auto found = curvatures_of(sphere);
    for(Index i = 0; i < found.size(); ++i)
    {
      // Sides are 0.07 long, and balls of a radius of three have some forty edges.
      EXPECT_NEAR(radius * found[i].least, 1., 0.05);
      EXPECT_NEAR(radius * found[i].most, 1., 0.05);
      EXPECT_LE(found[i].least, found[i].most);
      const Point& p = sphere.points[i];
      expect_frame(found[i], {p[0] / radius, p[1] / radius, p[2] / radius}, 0.02);
    }
  }
}

TEST(Curvature, of_a_cylinder_is_around_its_axis)
{
  const double radius = 2.;
  const Triangulation pipe = cylinder(80, 40, radius, 6.);
  const auto found = curvatures_of(pipe, 0.6);
  for(Index i = 0; i < found.size(); ++i)
  {
    const Point& p = pipe.points[i];
    if(p[2] < 0.6 || p[2] > 5.4)
      continue;
    // Its edges bend by 2 pi / 80 each: a ball has eight of them beside each other, so that one more
    // or less is an eighth of them, at both ends in part.
    EXPECT_NEAR(found[i].most, 1. / radius, 0.1 / radius);
    EXPECT_NEAR(found[i].least, 0., 0.02 / radius);
    EXPECT_GT(std::abs(found[i].least_direction[2]), 0.999);
    EXPECT_LT(std::abs(found[i].most_direction[2]), 0.05);
  }
}

TEST(Curvature, of_a_torus_changes_its_sign)
{
  const double far = 1., near = 0.4;
  const Triangulation torus = grid(
      160, 80,
      [=](double u, double v)
      {
        const double a = 2. * pi * u, b = 2. * pi * v, r = far + near * std::cos(b);
        return Point{r * std::cos(a), r * std::sin(a), near * std::sin(b)};
      },
      0.);
  const auto found = curvatures_of(torus, 0.12);
  for(std::size_t j = 8; j <= 72; j += 4)
    for(std::size_t i = 10; i <= 150; i += 20)
    {
      const Curvature& here = found[i + 161 * j];
      const double a = 2. * pi * i / 160., b = 2. * pi * j / 80.;
      const double around = std::cos(b) / (far + near * std::cos(b)), across = 1. / near;
      // A ball of 0.12 averages over a third of a radian of b.
      EXPECT_NEAR(here.most, across, 0.05 * across);
      EXPECT_NEAR(here.least, around, 0.05 * across);
      const Point axis = {-std::sin(a), std::cos(a), 0.};
      EXPECT_GT(std::abs(dot(here.least_direction, axis)), 0.99);
    }
}

TEST(Curvature, of_a_saddle_is_up_one_way_and_down_the_other)
{
  // Turned by 0.3, on a triangulation without any order.
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Triangulation saddle = graph(60, 1.,
                                     [=](double x, double y)
                                     {
                                       const double u = c * x + s * y, v = c * y - s * x;
                                       return 0.5 * (u * u - v * v);
                                     });
  const Curvature middle = curvatures_of(saddle, 0.25)[30 + 61 * 30];
  // Normals point up, from where a valley is not convex.  A ball of 0.25 has curvatures down to
  // (1 + 0.25^2)^-1.5 of those in its middle.
  EXPECT_NEAR(middle.least, -1., 0.1);
  EXPECT_NEAR(middle.most, 1., 0.1);
  EXPECT_GT(std::abs(dot(middle.least_direction, Point{c, s, 0.})), 0.99);
  EXPECT_GT(std::abs(dot(middle.most_direction, Point{-s, c, 0.})), 0.99);
}

TEST(Curvature, of_a_plane_is_zero_up_to_its_border)
{
  for(const Curvature& here : curvatures_of(square(12, 0.24)))
  {
    EXPECT_NEAR(here.least, 0., 1e-12); // rounding
    EXPECT_NEAR(here.most, 0., 1e-12);
  }
}

TEST(Curvature, is_a_number_everywhere)
{
  Triangulation needles = square(8, 0.24);
  for(Point& p : needles.points)
    p = {p[0], 1e-9 * p[1], p[0] * p[0]};
  Triangulation flat = square(8);
  for(Point& p : flat.points)
    p[1] = 0.;
  Triangulation alone = tetrahedron();
  alone.points.push_back({5., 5., 5.});
  for(const Triangulation& shape : {needles, flat, alone, one_triangle(), apart(alone, square(2))})
    for(const Curvature& here : curvatures_of(shape))
    {
      EXPECT_TRUE(std::isfinite(here.least) && std::isfinite(here.most));
      for(int k = 0; k < 3; ++k)
        EXPECT_TRUE(std::isfinite(here.least_direction[k]) &&
                    std::isfinite(here.most_direction[k]));
    }
  const Curvature isolated = curvatures_of(alone).back();
  EXPECT_EQ(isolated.least, 0.);
  EXPECT_EQ(isolated.most, 0.);
}

TEST(Curvature, is_the_same_from_any_number_of_threads)
{
  const Triangulation shape = shaken(icosphere(3), 0.02);
  const auto one = curvatures_of(shape), three = curvatures_of(shape, 0., 3);
  for(Index i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i].least, three[i].least);
    EXPECT_EQ(one[i].most, three[i].most);
    EXPECT_EQ(one[i].most_direction, three[i].most_direction);
  }
}

} // namespace
