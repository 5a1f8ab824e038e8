// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/volumetric.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

Spatial random_point(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

// Two long rooms side by side, joined at one end: a U of cubes.
Triangulation bent_hall()
{
  return blocks(3, 2, 8, [](int x, int, int z) { return x != 1 || z == 0; });
}

TEST(volumetric, bounds_of_many_hold_what_one_by_one_are)
{
  for(const Triangulation& shape : {icosphere(2), bent_hall()})
  {
    const Glued_surface surface(shape);
    const Volumetric_distances distances(surface.triangles(), 1);
    std::mt19937 random(1);
    const Spatial from = {0.5, 0.4, 0.3};
    std::vector<Spatial> to = {from};
    for(int i = 0; i < 20; ++i)
      for(int j = 0; j < 20; ++j)
        to.push_back({0.2 * i - 1., 0.45, 0.2 * j - 1.});
    for(Index i = 0; i < 10; ++i)
      to.push_back(surface.point(i));
    Volumetric_options options;
    const std::vector<Volumetric_bounds> found = distances.one_to_many(from, to, options);
    ASSERT_EQ(found.size(), to.size());
    EXPECT_EQ(found[0].upper, 0.);
    Earth_movers_options precise;
    precise.transport.tolerance = 1e-4;
    std::size_t solved = 0;
    for(std::size_t i = 0; i < to.size(); ++i)
    {
      EXPECT_LE(found[i].upper - found[i].lower, options.tolerance * found[i].upper);
      EXPECT_GE(found[i].lower, norm(to[i] - from));
      solved += found[i].is_solved;
      if(i % 10 > 0)
        continue;
      const Earth_movers_result one = distances.cost(from, to[i], precise);
      EXPECT_LE(found[i].lower, one.upper * (1. + 1e-12)); // roundings
      EXPECT_GE(found[i].upper, one.lower * (1. - 1e-12));
    }
    EXPECT_LT(solved, to.size() / 2);
  }
}

TEST(volumetric, many_do_not_depend_on_threads)
{
  const Glued_surface surface(bent_hall());
  const Volumetric_distances distances(surface.triangles(), 1);
  std::mt19937 random(2);
  std::vector<Spatial> to;
  for(int i = 0; i < 100; ++i)
    to.push_back(random_point(random, 4.));
  Volumetric_options options;
  const auto one = distances.one_to_many({0.5, 0.5, 6.}, to, options);
  options.threads = 3;
  const auto three = distances.one_to_many({0.5, 0.5, 6.}, to, options);
  for(std::size_t i = 0; i < to.size(); ++i)
  {
    EXPECT_EQ(one[i].lower, three[i].lower);
    EXPECT_EQ(one[i].upper, three[i].upper);
    EXPECT_EQ(one[i].iterations, three[i].iterations);
  }
}

TEST(volumetric, many_may_be_none_equal_or_cancelled)
{
  const Glued_surface surface(bent_hall());
  const Volumetric_distances distances(surface.triangles(), 0);
  const Spatial from = {0.5, 0.5, 6.}, other = {2.5, 0.5, 6.};
  Volumetric_options options;
  EXPECT_TRUE(distances.one_to_many(from, {}, options).empty());
  const auto equal = distances.one_to_many(from, std::vector<Spatial>(20, other), options);
  for(const Volumetric_bounds& bounds : equal)
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
  EXPECT_TRUE(distances.one_to_many(from, std::vector<Spatial>(20, other), options).empty());
  EXPECT_GE(last, 0.5);
  options.callback = nullptr;
  options.tolerance = 0.;
  EXPECT_THROW(distances.one_to_many(from, {other}, options), Invalid_argument_error);
}

TEST(volumetric, refuses_pieces)
{
  Triangulation far = tetrahedron();
  for(Point& p : far.points)
    p[0] += 5.;
  const Glued_surface surface(apart(tetrahedron(), far));
  EXPECT_THROW(Volumetric_distances(surface.triangles(), 0), Unsupported_surface_error);
}

} // namespace
