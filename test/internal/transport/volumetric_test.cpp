// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace volumetric_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Vec3 random_point(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

// Returns two parallel rooms that are connected at one end: cubes in the shape of a U.
Triangulation u_shaped_room()
{
  return blocks(3, 2, 8, [](int x, int, int z) { return x != 1 || z == 0; });
}

TEST(volumetric, one_to_many_bounds_contain_single_distances)
{
  for(const Triangulation& shape : {icosphere(2), u_shaped_room()})
  {
    const Array_surface surface(shape);
    const Volumetric_distances distances(surface.triangles(), 1);
    std::mt19937 random(1);
    const Vec3 from = {0.5, 0.4, 0.3};
    std::vector<Vec3> to = {from};
    for(int i = 0; i < 20; ++i)
      for(int j = 0; j < 20; ++j)
        to.push_back({0.2 * i - 1., 0.45, 0.2 * j - 1.});
    for(Index i = 0; i < 10; ++i)
      to.push_back(surface.point(i));
    Volumetric_options options;
    const std::vector<Volumetric_bounds> found = distances.one_to_many(from, to, options);
    ASSERT_EQ(found.size(), to.size());
    EXPECT_EQ(found[0].upper, 0.);
    Transport_options tight_options;
    tight_options.tolerance = 1e-4;
    std::size_t solved = 0;
    for(std::size_t i = 0; i < to.size(); ++i)
    {
      // The requested gap.
      EXPECT_LE(found[i].upper - found[i].lower, options.tolerance * found[i].upper);
      EXPECT_GE(found[i].lower, norm(to[i] - from));
      solved += found[i].is_solved;
      if(i % 10 > 0)
        continue;
      const Transport_result single = distances.cost(from, to[i], tight_options);
      EXPECT_LE(found[i].lower, single.upper * (1. + 1e-12)); // round-off errors
      EXPECT_GE(found[i].upper, single.lower * (1. - 1e-12)); // round-off error
    }
    EXPECT_LT(solved, to.size() / 2);
  }
}

TEST(volumetric, one_to_many_is_independent_of_threads)
{
  const Array_surface surface(u_shaped_room());
  const Volumetric_distances distances(surface.triangles(), 1);
  std::mt19937 random(2);
  std::vector<Vec3> to;
  for(int i = 0; i < 100; ++i)
    to.push_back(random_point(random, 4.));
  Volumetric_options options;
  const auto single = distances.one_to_many({0.5, 0.5, 6.}, to, options);
  options.number_of_threads = 3;
  const auto parallel = distances.one_to_many({0.5, 0.5, 6.}, to, options);
  for(std::size_t i = 0; i < to.size(); ++i)
  {
    EXPECT_EQ(single[i].lower, parallel[i].lower);
    EXPECT_EQ(single[i].upper, parallel[i].upper);
    EXPECT_EQ(single[i].number_of_iterations, parallel[i].number_of_iterations);
  }
}

TEST(volumetric, one_to_many_handles_empty_equal_and_cancelled)
{
  const Array_surface surface(u_shaped_room());
  const Volumetric_distances distances(surface.triangles(), 0);
  const Vec3 from = {0.5, 0.5, 6.}, other = {2.5, 0.5, 6.};
  Volumetric_options options;
  EXPECT_TRUE(distances.one_to_many(from, {}, options).empty());
  const auto equal = distances.one_to_many(from, std::vector<Vec3>(20, other), options);
  for(const Volumetric_bounds& bounds : equal)
    // The gap of each of them.
    EXPECT_NEAR(bounds.upper, equal[0].upper, options.tolerance * equal[0].upper);
  EXPECT_EQ(std::count_if(equal.begin(), equal.end(),
                          [](const Volumetric_bounds& bounds) { return bounds.is_solved; }),
            1);
  double last = -1.;
  options.callback = [&](double done)
  {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.5;
  };
  EXPECT_TRUE(distances.one_to_many(from, std::vector<Vec3>(20, other), options).empty());
  EXPECT_GE(last, 0.5);
  options.callback = nullptr;
  options.tolerance = 0.;
  EXPECT_THROW(distances.one_to_many(from, {other}, options), Invalid_argument_error);
}

TEST(volumetric, throws_on_several_components)
{
  Triangulation second_tetrahedron = tetrahedron();
  for(Point& p : second_tetrahedron.points)
    p[0] += 5.;
  const Array_surface surface(disjoint_union(tetrahedron(), second_tetrahedron));
  EXPECT_THROW(Volumetric_distances(surface.triangles(), 0), Unsupported_surface_error);
}

TEST(volumetric, checks_barycentric_coordinates)
{
  Triangulation shape = icosphere(0);
  shape.points.push_back({5., 5., 5.}); // isolated
  const Array_surface surface(shape);
  const Surface_arrays& t = surface.t();
  const Index isolated = surface.vertex(Index(shape.points.size() - 1));
  const Vector valid = Volumetric_distances(surface.triangles(), 0).coordinates({0.1, 0.2, -0.3});
  const Vec3 point = {0.1, 0.2, -0.3};
  // Weights are divided by their sum.
  const Vector scaled_weights = checked_coordinates(t, point, (1. + 1e-8) * valid);
  EXPECT_NEAR(scaled_weights.sum(), 1., 1e-15);
  EXPECT_LT((scaled_weights - valid).lpNorm<Eigen::Infinity>(), 1e-14); // round-off errors
  const auto expect_rejected = [&](const Vec3& p, const Vector& weights)
  { EXPECT_THROW(checked_coordinates(t, p, weights), Invalid_argument_error); };
  expect_rejected(point, 1.01 * valid);
  expect_rejected(point, Vector::Zero(valid.size()));
  expect_rejected({0.1, 0.2, -0.2}, valid);
  expect_rejected(point, valid.head(3));
  for(const double bad : {std::nan(""), infinity})
  {
    Vector weights = valid;
    weights[surface.vertex(0)] = bad;
    expect_rejected(point, weights);
  }
  Vector at_isolated = valid;
  at_isolated[isolated] = 1e-3;
  expect_rejected(point, at_isolated);
  // At a vertex. Two pairs of opposite vertices have the same mean, so that other weights reproduce
  // it as well.
  const Vec3 vertex = surface.point(0);
  const Vector unit = Vector::Unit(valid.size(), surface.vertex(0));
  EXPECT_EQ(checked_coordinates(t, vertex, unit), unit);
  Vector other = unit;
  double weight = 0.1;
  for(Index i = 1; i < 12; ++i)
    for(Index j = 1; j < i; ++j)
      if(norm(surface.point(i) + surface.point(j)) < 1e-15 && std::abs(weight) == 0.1)
      {
        other[surface.vertex(i)] = other[surface.vertex(j)] = weight;
        weight = weight > 0. ? -0.1 : 0.;
      }
  ASSERT_NEAR(other.sum(), 1., 1e-15);
  ASSERT_NEAR(other.lpNorm<1>(), 1.4, 1e-15);
  expect_rejected(vertex, other);
}

TEST(volumetric, coordinate_function_replaces_mean_value_coordinates)
{
  const Array_surface surface(icosphere(2));
  const Volumetric_distances expected(surface.triangles(), 0);
  std::size_t calls = 0;
  const Volumetric_distances found(surface.triangles(), 0,
                                   [&](const Vec3& point)
                                   {
                                     ++calls;
                                     return expected.coordinates(point);
                                   });
  const Vec3 p = {0.1, 0.2, -0.3}, q = {0.5, -0.2, 0.1};
  const Transport_result a = expected.cost(p, q, {}), b = found.cost(p, q, {});
  EXPECT_EQ(calls, 2u);
  EXPECT_NEAR(a.lower, b.lower, 1e-12); // the sum of the weights is one up to round-off errors
  EXPECT_NEAR(a.upper, b.upper, 1e-12);
  const auto to = std::vector<Vec3>{q, {0.3, 0.3, 0.3}, {-0.2, 0.6, 0.1}};
  Volumetric_options options;
  options.number_of_threads = 2;
  const auto many = found.one_to_many(p, to, options);
  for(std::size_t i = 0; i < to.size(); ++i)
    EXPECT_NEAR(many[i].upper, expected.one_to_many(p, to, {})[i].upper, 1e-9);
  EXPECT_NEAR(found.euclidean_bound(p, q, found.coordinates(q) - found.coordinates(p)), norm(q - p),
              1e-12);
  EXPECT_THROW(found.coordinates({infinity, 0., 0.}), Invalid_argument_error);
}

} // namespace volumetric_test
