// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/mean_value.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace mean_value_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Sums of up to some hundred angles, of which many cancel; measured are 3e-14.
constexpr double round_off = 1e-12;

Triangulation perturbed_sphere() { return jittered(icosphere(2), 0.1); }
Triangulation l_shaped_blocks() // cubes in the shape of an L: not convex, with coplanar faces
{
  return blocks(3, 1, 3, [](int x, int, int z) { return x == 0 || z == 0; });
}

Vec3 random_point(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

// Returns the distance of the point from the sum of coordinates times vertices.
double linear_error(const Array_surface& surface, const Vector& coordinates, const Vec3& point)
{
  Vec3 sum = {0., 0., 0.};
  for(Index i = 0; i < surface.size(); ++i)
    sum = sum + coordinates[surface.vertex(i)] * surface.point(i);
  return norm(sum - point);
}

// Computes mean value coordinates from their definition. The integral over all directions is
// transformed to the triangles. Each is divided into subdivisions^2 triangles, to which the
// midpoint rule is applied.
Vector by_quadrature(const Array_surface& surface, const Triangulation& shape, const Vec3& point,
                     int subdivisions)
{
  Vector result = Vector::Zero(Eigen::Index(surface.size()));
  for(std::size_t f = 0; f < shape.corners.size(); f += 3)
  {
    const Vec3 a = shape.points[shape.corners[f]], b = shape.points[shape.corners[f + 1]],
               c = shape.points[shape.corners[f + 2]];
    const Vec3 area_vector = 0.5 / (subdivisions * subdivisions) * cross(b - a, c - a);
    const auto add = [&](double v, double w)
    {
      const std::array<double, 3> barycentric = {1. - v - w, v, w};
      const Vec3 offset = barycentric[0] * a + barycentric[1] * b + barycentric[2] * c - point;
      for(std::size_t k = 0; k < 3; ++k)
        result[surface.vertex(shape.corners[f + k])] +=
            barycentric[k] * dot(area_vector, offset) / std::pow(dot(offset, offset), 2);
    };
    for(int i = 0; i < subdivisions; ++i)
      for(int j = 0; i + j < subdivisions; ++j)
      {
        add((i + 1. / 3.) / subdivisions, (j + 1. / 3.) / subdivisions);
        if(i + j + 1 < subdivisions)
          add((i + 2. / 3.) / subdivisions, (j + 2. / 3.) / subdivisions);
      }
  }
  return result / result.sum();
}

TEST(mean_value, matches_quadrature)
{
  for(const Triangulation& shape : {perturbed_sphere(), l_shaped_blocks()})
  {
    const Array_surface surface(shape);
    const Mean_value_coordinates coordinates(surface.triangles());
    for(const Vec3& point : {Vec3{0.4, 0.3, 0.35}, Vec3{-1.2, 0.4, 0.5}, Vec3{1.5, 1.4, 1.6}})
    {
      const int subdivisions = 24;
      const Vector coarse = by_quadrature(surface, shape, point, subdivisions);
      const Vector fine = by_quadrature(surface, shape, point, 2 * subdivisions);
      const Vector estimate = (4. * fine - coarse) / 3.; // extrapolation of a rule of order two
      // The error after extrapolation is far below the difference of both approximations.
      const double error = 0.02 * (fine - coarse).lpNorm<Eigen::Infinity>() + 1e-9;
      EXPECT_LT(error, 1e-4);
      EXPECT_LT((coordinates(point) - estimate).lpNorm<Eigen::Infinity>(), error);
    }
  }
}

// On a tetrahedron, barycentric coordinates are unique, inside and outside.
TEST(mean_value, is_barycentric_on_a_tetrahedron)
{
  const Array_surface surface(tetrahedron());
  const Mean_value_coordinates coordinates(surface.triangles());
  std::mt19937 random(1);
  for(int i = 0; i < 200; ++i)
  {
    const Vec3 point = random_point(random, 4.);
    const Vector found = coordinates(point);
    for(Index k = 0; k < 4; ++k)
    {
      // The corners have coordinates of 1 and -1, and their sum is zero.
      const double expected = 0.25 + 0.25 * dot(point, surface.point(k));
      EXPECT_NEAR(found[surface.vertex(k)], expected, round_off);
    }
  }
}

TEST(mean_value, is_uniform_at_center)
{
  const Array_surface surface(icosphere(0));
  const Vector found = Mean_value_coordinates(surface.triangles())({0., 0., 0.});
  for(const double coordinate : found)
    EXPECT_NEAR(coordinate, 1. / 12., 1e-15); // equal terms; measured are 1e-17
}

// The points include those in planes of faces, on lines of edges, and very close to the surface.
TEST(mean_value, reproduces_linear_functions)
{
  for(const Triangulation& unit : {perturbed_sphere(), l_shaped_blocks()})
    for(const double scale : {1e-6, 1., 1e6})
    {
      const Array_surface surface(scaled(unit, scale));
      const Mean_value_coordinates coordinates(surface.triangles());
      std::mt19937 random(2);
      const auto check = [&](const Vec3& point)
      {
        const Vector found = coordinates(point);
        EXPECT_NEAR(found.sum(), 1., round_off);
        // Vertices and points have coordinates of a few units.
        EXPECT_LT(linear_error(surface, found, point), 10. * round_off * scale);
      };
      for(int i = 0; i < 50; ++i)
      {
        check(scale * random_point(random, 4.));
        Vec3 point_in_plane = scale * random_point(random, 4.);
        point_in_plane[i % 3] = scale * (i % 2);
        check(point_in_plane);
        Vec3 point_on_line = point_in_plane;
        point_on_line[(i + 1) % 3] = scale;
        check(point_on_line);
        const Surface_location location = random_location(surface.t(), random);
        const Vec3 offset = random_point(random, 1.);
        for(double step = 1.; step > 1e-16; step *= 0.1)
          check(point_at(surface.t(), location) + step * scale * offset);
      }
    }
}

TEST(mean_value, is_barycentric_on_the_surface)
{
  for(const Triangulation& shape : {perturbed_sphere(), l_shaped_blocks()})
  {
    const Array_surface surface(shape);
    const Mean_value_coordinates coordinates(surface.triangles());
    for(Index i = 0; i < surface.size(); ++i)
    {
      const Vector found = coordinates(surface.point(i));
      EXPECT_EQ(found[surface.vertex(i)], 1.);
      EXPECT_EQ(found.cwiseAbs().sum(), 1.);
    }
    std::mt19937 random(3);
    for(int i = 0; i < 100; ++i)
    {
      Surface_location location = random_location(surface.t(), random);
      if(i % 2 == 0) // on an edge
      {
        location.barycentric[2] = 0.;
        location.barycentric[0] = 1. - location.barycentric[1];
      }
      Vector found = coordinates(point_at(surface.t(), location));
      for(std::size_t k = 0; k < 3; ++k)
        found[surface.t().corner[3 * location.triangle + k]] -= location.barycentric[k];
      // The coordinates are near 1, and the minimum edge length is a tenth.
      EXPECT_LT(found.lpNorm<Eigen::Infinity>(), 1e-14);
    }
  }
}

// The coordinates must be continuous across a face, an edge and a vertex. The minimum edge length
// is a tenth, so that derivatives are at most some tens.
TEST(mean_value, is_continuous)
{
  for(const Triangulation& shape : {perturbed_sphere(), l_shaped_blocks()})
  {
    const Array_surface surface(shape);
    const Mean_value_coordinates coordinates(surface.triangles());
    std::mt19937 random(4);
    for(int i = 0; i < 60; ++i)
    {
      Surface_location location = random_location(surface.t(), random);
      if(i % 3 > 0)
        location.barycentric = {0.6, 0.4, 0.};
      if(i % 3 > 1)
        location.barycentric = {1., 0., 0.};
      const Vec3 surface_point = point_at(surface.t(), location), offset = random_point(random, 1.);
      const Vector found = coordinates(surface_point);
      for(const double step : {1e-3, 1e-5, 1e-7, 1e-9, 10. * round_off, round_off, 1e-13})
        for(const double side : {-step, step})
          // The derivatives, and round-off errors, which nearby faces amplify.
          EXPECT_LT((coordinates(surface_point + side * offset) - found).lpNorm<Eigen::Infinity>(),
                    200. * step + 1e-9);
    }
  }
}

TEST(mean_value, is_positive_inside_convex_meshes)
{
  const Array_surface surface(icosphere(2));
  const Mean_value_coordinates coordinates(surface.triangles());
  std::mt19937 random(5);
  for(int i = 0; i < 50; ++i)
    EXPECT_GT(coordinates(random_point(random, 0.5)).minCoeff(), 0.);
  EXPECT_LT(coordinates({2., 0., 0.}).minCoeff(), 0.);
}

// If all faces are inverted, the coordinates must not change.
TEST(mean_value, is_independent_of_orientation)
{
  const Triangulation shape = perturbed_sphere();
  Triangulation inverted = shape;
  for(std::size_t f = 0; f < inverted.corners.size(); f += 3)
    std::swap(inverted.corners[f], inverted.corners[f + 1]);
  const Array_surface surface(shape), inverted_surface(inverted);
  const Mean_value_coordinates coordinates(surface.triangles()),
      inverted_coordinates(inverted_surface.triangles());
  std::mt19937 random(6);
  for(int i = 0; i < 20; ++i)
  {
    const Vec3 point = random_point(random, 2.);
    const Vector a = coordinates(point), b = inverted_coordinates(point);
    for(Index k = 0; k < surface.size(); ++k)
      EXPECT_NEAR(a[surface.vertex(k)], b[inverted_surface.vertex(k)], round_off);
  }
}

TEST(mean_value, handles_degenerate_triangles)
{
  Triangulation shape = l_shaped_blocks();
  shape.points[1] = shape.points[0]; // an edge of length zero
  const Array_surface surface(shape);
  const Mean_value_coordinates coordinates(surface.triangles());
  std::mt19937 random(7);
  for(int i = 0; i < 50; ++i)
  {
    const Vec3 point = random_point(random, 3.);
    const Vector found = coordinates(point);
    EXPECT_TRUE(found.allFinite());
    EXPECT_LT(linear_error(surface, found, point), 10. * round_off);
  }
  EXPECT_LT(linear_error(surface, coordinates(shape.points[0]), shape.points[0]),
            1e-15); // one coordinate is 1
}

TEST(mean_value, throws_on_open_or_flat_meshes)
{
  EXPECT_THROW(Mean_value_coordinates(Array_surface(square(3)).triangles()),
               Unsupported_surface_error);
  EXPECT_THROW(Mean_value_coordinates(Array_surface({{{0., 0., 0.}}, {}}).triangles()),
               Unsupported_surface_error);
  const Array_surface surface(perturbed_sphere());
  const Mean_value_coordinates coordinates(surface.triangles());
  EXPECT_THROW(coordinates({0., infinity, 0.}), Invalid_argument_error);
  EXPECT_THROW(coordinates({std::numeric_limits<double>::quiet_NaN(), 0., 0.}),
               Invalid_argument_error);
  EXPECT_THROW(coordinates({1e12, 0., 0.}), Unsupported_surface_error);
  EXPECT_THROW(coordinates({1e300, 1e300, 0.}), Unsupported_surface_error);
  // Two triangles with opposite orientation enclose no volume.
  const Array_surface flat({{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 1, 2, 0, 2, 1}});
  EXPECT_THROW(Mean_value_coordinates(flat.triangles())({0.3, 0.3, 1.}), Unsupported_surface_error);
}

} // namespace mean_value_test
