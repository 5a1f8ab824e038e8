// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/straighten.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include "core/unfold.h"

#include "Glued_surface.h"
#include "path_checks.h"

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Lengths are sums of at most a few thousand roundings.
constexpr double rounding = 1e-12;

// Corners of the path are cut when they gain more than rounding, so angles are right to the square
// root of rounding at worst.
constexpr double angle_rounding = 1e-6;

Straight_path checked(const Glued_surface& surface, const std::vector<Location>& path,
                      double tolerance = angle_rounding)
{
  const Glued_triangles& t = surface.t();
  const Straight_path result = straighten(t, path);
  expect_path_on_surface(t, result.locations, path.front(), path.back());
  expect_locally_shortest(result, tolerance);
  const double before = path_length(t, path);
  EXPECT_LE(result.length, before * (1. + rounding));
  EXPECT_NEAR(result.length, path_length(t, result.locations), rounding * before);
  EXPECT_NEAR(straighten(t, result.locations).length, result.length, rounding * before);
  return result;
}

TEST(Straighten, is_exact_on_an_irregular_flat_square)
{
  const Glued_surface surface(square(25, 0.25));
  Path_finder find(surface.triangles());
  std::mt19937 random(1);
  for(int i = 0; i < 200; ++i)
  {
    const Location p = random_location(surface.t(), random);
    const Location q =
        i % 2 == 0 ? random_location(surface.t(), random) : surface.at(Index(random() % (26 * 26)));
    const auto path = checked(surface, find(p, q));
    const double straight = distance(point_at(surface.t(), p), point_at(surface.t(), q));
    EXPECT_NEAR(path.length * surface.t().scale, straight, rounding);
  }
}

TEST(Straighten, is_exact_through_the_sites_of_a_lattice)
{
  const Glued_surface surface(square(16));
  // Along the border, then up the other border: the diagonal of the square.
  std::vector<Index> corner;
  for(Index i = 0; i <= 16; ++i)
    corner.push_back(i);
  for(Index j = 1; j <= 16; ++j)
    corner.push_back(16 + 17 * j);
  const auto path = checked(surface, surface.along(corner));
  EXPECT_NEAR(path.length * surface.t().scale, std::sqrt(2.), rounding);
}

TEST(Straighten, takes_the_side_of_a_cone_that_it_starts_on)
{
  const std::size_t n = 12;
  const double total = 1.5 * pi, step = total / n;
  const Glued_surface surface(cone(n, 5, total));
  // From ring 4 in direction 0 to ring 3 in direction k, along ring 4 counterclockwise.
  for(Index k = 1; k < n; ++k)
  {
    std::vector<Index> way;
    for(Index i = 0; i <= k; ++i)
      way.push_back(Index(1 + n * 4 + i));
    way.push_back(Index(1 + n * 3 + k));
    const auto path = checked(surface, surface.along(way));
    // Around the tip when less than a half turn lies on this side, else over to the other.
    const double angle = k * step < pi ? k * step : total - k * step;
    EXPECT_NEAR(path.length * surface.t().scale, std::sqrt(25. + 16. - 2. * 20. * std::cos(angle)),
                10. * rounding)
        << k;
  }
}

TEST(Straighten, goes_through_a_saddle)
{
  const std::size_t n = 12;
  const Glued_surface surface(cone(n, 5, 3. * pi));
  std::vector<Index> way;
  for(Index i = 0; i <= 6; ++i)
    way.push_back(Index(1 + n * 4 + i));
  const auto path = checked(surface, surface.along(way));
  EXPECT_NEAR(path.length * surface.t().scale, 10., 10. * rounding);
  double least = 0.;
  for(const Touched_site& touched : path.touched)
    if(site_of(surface.t(), path.locations[touched.place]) == surface.site(0))
      least = std::min(touched.left, touched.right);
  EXPECT_NEAR(least, 1.5 * pi, rounding);
}

TEST(Straighten, keeps_the_turns_around_a_cylinder)
{
  const std::size_t n = 10, number_of_rings = 8;
  const double side = 2. * std::sin(pi / n), perimeter = n * side;
  const Glued_surface surface(cylinder(n, number_of_rings, 1., 3.));
  for(Index turns = 1; turns < 4; ++turns)
  {
    // Around ring 2 several times, then up two rings: one step to the side (half a step a ring).
    std::vector<Index> way;
    for(Index i = 0; i <= turns * n; ++i)
      way.push_back(Index(2 * n + i % n));
    way.push_back(Index(3 * n));
    way.push_back(Index(4 * n));
    // Neighbouring rings are turned by half a step: a zigzag of chords, flat when unrolled only in
    // the limit.  So the certificate here is that of a local geodesic that still winds.
    const auto path = checked(surface, surface.along(way));
    EXPECT_GT(path.length * surface.t().scale, 0.95 * turns * perimeter);
  }
  // A closed path around, from a site to itself.
  std::vector<Index> loop;
  for(Index i = 0; i <= n; ++i)
    loop.push_back(Index(4 * n + i % n));
  const auto path = straighten(surface.t(), surface.along(loop));
  EXPECT_GT(path.length * surface.t().scale, 0.9 * perimeter);
  EXPECT_LE(path.length * surface.t().scale, perimeter * (1. + rounding));
}

TEST(Straighten, is_exact_on_a_prism)
{
  // Rings without twist: the strips between them unroll to a flat band.
  const std::size_t n = 10;
  const double perimeter = n * 2. * std::sin(pi / n);
  const Glued_surface surface(rings(
      n, 8, [](double) { return 1.; }, [](double s) { return 3. * s; }, 0.));
  for(Index turns = 0; turns < 4; ++turns)
    for(Index extra = 0; extra < n; ++extra)
    {
      std::vector<Index> way;
      for(Index i = 0; i <= turns * n + extra; ++i)
        way.push_back(Index(i % n));
      for(Index j = 1; j <= 8; ++j)
        way.push_back(Index(j * n + extra));
      const auto path = checked(surface, surface.along(way));
      EXPECT_NEAR(path.length * surface.t().scale,
                  std::hypot((turns + extra / double(n)) * perimeter, 3.), 100. * rounding);
    }
}

TEST(Straighten, hugs_a_hole)
{
  const std::size_t n = 24;
  const Glued_surface surface(annulus(n, 4, 1., 3.));
  // Half around, on the outer ring.
  std::vector<Index> way;
  for(Index i = 0; i <= n / 2; ++i)
    way.push_back(i);
  const auto path = checked(surface, surface.along(way));
  // Between the taut string around the hole's inscribed and around its circumscribed circle.
  const auto string = [](double r)
  { return 2. * std::sqrt(9. - r * r) + 2. * r * (pi / 2. - std::acos(r / 3.)); };
  EXPECT_GT(path.length * surface.t().scale, string(std::cos(pi / n)) - rounding);
  EXPECT_LT(path.length * surface.t().scale, string(1.) + rounding);
}

TEST(Straighten, contracts_a_loop)
{
  const Glued_surface surface(square(8, 0.25));
  const auto path = straighten(surface.t(), surface.along({20, 21, 22, 31, 40, 39, 38, 29, 20}));
  ASSERT_EQ(path.locations.size(), 1u);
  EXPECT_EQ(path.length, 0.);
}

TEST(Straighten, leaves_single_locations_and_parts_of_one_triangle_alone)
{
  const Glued_surface surface(square(4, 0.2));
  const Glued_triangles& t = surface.t();
  std::mt19937 random(3);
  for(int i = 0; i < 20; ++i)
  {
    const Location p = random_location(t, random);
    Location q = random_location(t, random);
    q.triangle = p.triangle;
    EXPECT_EQ(straighten(t, {p}).locations.size(), 1u);
    EXPECT_EQ(straighten(t, {p, p}).locations.size(), 1u);
    const auto path = checked(surface, {p, q});
    EXPECT_EQ(path.locations.size(), 2u);
    EXPECT_NEAR(path.length * t.scale, distance(point_at(t, p), point_at(t, q)), rounding);
  }
  EXPECT_EQ(straighten(t, {surface.at(7)}).length, 0.);
}

TEST(Straighten, ends_on_sides)
{
  const Glued_surface surface(square(12, 0.25));
  const Glued_triangles& t = surface.t();
  Path_finder find(surface.triangles());
  std::mt19937 random(4);
  for(int i = 0; i < 100; ++i)
  {
    Location p = random_location(t, random), q = random_location(t, random);
    p.barycentric = on_side(Index(random() % 3), 0.3);
    q.barycentric = i % 3 == 0 ? std::array<double, 3>{0.5, 1e-15, 0.5 - 1e-15}
                               : on_side(Index(random() % 3), 0.999);
    const auto path = checked(surface, find(p, q));
    EXPECT_NEAR(path.length * t.scale, distance(point_at(t, p), point_at(t, q)), rounding);
  }
}

TEST(Straighten, passes_a_pinched_site_straight_through)
{
  //  0---1      4
  //   \ / \    / \       two fans meet at 2 alone
  //    5---2--+   |
  //        |   \ /
  const Glued_surface surface(
      Triangulation{{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}},
                    {0, 1, 2, 0, 3, 4}});
  const auto path = checked(surface, surface.along({1, 0, 3}));
  EXPECT_NEAR(path.length * surface.t().scale, 2., rounding);
  ASSERT_EQ(path.touched.size(), 1u);
  EXPECT_EQ(path.touched[0].left, infinity);
  EXPECT_EQ(path.touched[0].right, infinity);
}

TEST(Straighten, pulls_any_chain_taut_on_rough_surfaces)
{
  for(unsigned seed = 1; seed <= 6; ++seed)
  {
    // Edges are about 0.15 long: from smooth to crumpled.
    const Glued_surface surface(shaken(icosphere(3), 0.02 * seed, seed));
    const Glued_triangles& t = surface.t();
    std::mt19937 random(seed);
    for(int i = 0; i < 60; ++i)
    {
      // A random walk along arcs: many loops and reversals.
      Index site = Index(random() % t.number_of_sites());
      std::vector<Location> path = {at_site(t, site)};
      for(int k = 0; k < 40; ++k)
      {
        const Index degree = t.first[site + 1] - t.first[site];
        site = t.corner[next_side(t.star[t.first[site] + random() % degree])];
        path.push_back(at_site(t, site));
      }
      const Straight_path result = straighten(t, path);
      expect_path_on_surface(t, result.locations, path.front(), path.back());
      expect_locally_shortest(result, angle_rounding);
      EXPECT_LE(result.length, path_length(t, path) * (1. + rounding));
      EXPECT_NEAR(result.length, path_length(t, result.locations), 10. * rounding);
    }
  }
}

TEST(Straighten, does_not_depend_on_the_unit)
{
  Triangulation surface = shaken(icosphere(3), 0.03);
  const Glued_surface reference(surface);
  for(const double unit : {1e-8, 1e8, 1e-150, 1e150})
  {
    Triangulation scaled = surface;
    for(Point& p : scaled.points)
      for(double& x : p)
        x *= unit;
    const Glued_surface other(scaled);
    Path_finder find(reference.triangles()), find_other(other.triangles());
    for(Index k = 1; k < 600; k += 50)
    {
      const auto a = straighten(reference.t(), find(reference.at(0), reference.at(k)));
      const auto b = straighten(other.t(), find_other(other.at(0), other.at(k)));
      EXPECT_NEAR(b.length * (other.t().scale / unit), a.length * reference.t().scale, rounding);
    }
  }
}

TEST(Straighten, survives_slivers_and_sides_of_length_zero)
{
  Triangulation flat = square(10);
  // Rows of points fall together, others nearly so.
  for(std::size_t i = 0; i < flat.points.size(); ++i)
  {
    const std::size_t column = i % 11, row = i / 11;
    if(column == 4)
      flat.points[i][0] = 0.3;
    if(row == 5)
      flat.points[i][1] = 0.6 - 1e-9;
  }
  const Glued_surface surface(flat);
  const Glued_triangles& t = surface.t();
  Path_finder find(surface.triangles());
  std::mt19937 random(5);
  for(int i = 0; i < 200; ++i)
  {
    const Index p = Index(random() % 121), q = Index(random() % 121);
    const auto chain = find(surface.at(p), surface.at(q));
    const auto path = straighten(t, chain);
    expect_path_on_surface(t, path.locations, surface.at(p), surface.at(q));
    EXPECT_LE(path.length, path_length(t, chain) * (1. + rounding) + rounding);
    // Where nothing but a fold of no width lies between, the straight line is found; the sliver's
    // width is all that may be lost.
    EXPECT_NEAR(path.length * t.scale, distance(flat.points[p], flat.points[q]), 2e-9);
    expect_locally_shortest(path, angle_rounding);
  }
}

TEST(Straighten, is_locally_shortest_around_sites_at_one_point)
{
  Triangulation sphere = icosphere(2);
  // Both ends of a side, and all corners of a triangle elsewhere.
  sphere.points[sphere.corners[0]] = sphere.points[sphere.corners[1]];
  for(std::size_t k = 1; k < 3; ++k)
    sphere.points[sphere.corners[600 + k]] = sphere.points[sphere.corners[600]];
  const Glued_surface surface(sphere);
  Path_finder find(surface.triangles());
  for(Index from = 0; from < surface.size(); from += 3)
    for(Index to = 0; to < surface.size(); ++to)
    {
      const auto path = straighten(surface.t(), find(surface.at(from), surface.at(to)));
      expect_locally_shortest(path, angle_rounding);
    }
}

TEST(Straighten, refuses_what_is_no_path)
{
  const Glued_surface surface(square(4));
  EXPECT_THROW(straighten(surface.t(), {}), Invalid_argument_error);
  EXPECT_THROW(straighten(surface.t(), surface.along({0, 24})), Invalid_argument_error);
}

} // namespace
