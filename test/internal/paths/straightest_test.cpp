// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/straightest.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "core/unfold.h"

#include "path_checks.h"

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Some hundred crossings of triangles of size 1, each with a few roundings.
constexpr double rounding = 1e-12;

struct Surface
{
  Glued_mesh mesh;

  explicit Surface(const Triangulation& triangulation) : mesh(glued(triangulation)) {}
  const Glued_triangles& t() const { return mesh.triangles; }
  Location at(Index point) const { return at_site(t(), mesh.site_of_vertex[point]); }
  double scale() const { return t().scale; }

  // The angle from side 0 of a location's triangle to a direction in space, all in one plane z = 0.
  double angle_of(const Location& location, const Point& direction) const
  {
    const auto& a = t().point[t().corner[3 * location.triangle]];
    const auto& b = t().point[t().corner[3 * location.triangle + 1]];
    return std::atan2(direction[1], direction[0]) - std::atan2(b[1] - a[1], b[0] - a[0]);
  }
};

Straightest_path checked(const Surface& surface, const Location& from, double angle, double length)
{
  const Straightest_path path = straightest(surface.t(), from, angle, length);
  expect_path_on_surface(surface.t(), path.locations, from, path.locations.back());
  EXPECT_NEAR(path_length(surface.t(), path.locations), path.length, rounding * (1. + path.length));
  if(path.end == Straightest_end::length)
  {
    EXPECT_NEAR(path.length, length, rounding * (1. + length));
  }
  return path;
}

TEST(Straightest, is_a_straight_line_in_the_plane)
{
  const Surface surface(square(20, 0.25));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 300; ++i)
  {
    const Location from =
        i % 3 == 0 ? surface.at(Index(random() % 441)) : random_location(surface.t(), random);
    const Point p = point_at(surface.t(), from);
    const double a = angle(random), length = 0.6;
    const Point q = {p[0] + length * std::cos(a), p[1] + length * std::sin(a), 0.};
    const auto path = checked(surface, from, surface.angle_of(from, {std::cos(a), std::sin(a), 0.}),
                              length / surface.scale());
    if(std::min({q[0], q[1], 1. - q[0], 1. - q[1]}) > 1e-9)
    {
      ASSERT_EQ(path.end, Straightest_end::length);
      EXPECT_NEAR(distance(point_at(surface.t(), path.locations.back()), q), 0., rounding);
      // The direction at the end is the one at the begin.
      EXPECT_NEAR(std::remainder(path.angle - surface.angle_of(path.locations.back(),
                                                               {std::cos(a), std::sin(a), 0.}),
                                 2. * pi),
                  0., rounding);
    }
    else
    {
      // It ends on the border, where the line leaves the square.
      ASSERT_EQ(path.end, Straightest_end::border);
      const Point r = point_at(surface.t(), path.locations.back());
      EXPECT_NEAR(std::min({r[0], r[1], 1. - r[0], 1. - r[1]}), 0., rounding);
      EXPECT_NEAR((r[0] - p[0]) * std::sin(a) - (r[1] - p[1]) * std::cos(a), 0., rounding);
    }
  }
}

TEST(Straightest, passes_the_sites_of_a_lattice)
{
  const Surface surface(square(16));
  for(const Point& way : {Point{1., 0., 0.}, Point{0., 1., 0.}, Point{1., 1., 0.},
                          Point{2., 1., 0.}, Point{1., 2., 0.}})
  {
    // Also along the border, which goes straight on at each of its sites.
    const Location from = surface.at(0);
    const double length = std::hypot(way[0], way[1]) / std::max(way[0], way[1]);
    const auto path = checked(surface, from, surface.angle_of(from, way), length / surface.scale());
    EXPECT_EQ(path.end, Straightest_end::length);
    EXPECT_NEAR(point_at(surface.t(), path.locations.back())[0], way[0] / std::max(way[0], way[1]),
                rounding);
    EXPECT_NEAR(point_at(surface.t(), path.locations.back())[1], way[1] / std::max(way[0], way[1]),
                rounding);
  }
}

TEST(Straightest, goes_straight_on_past_sites_that_it_nearly_hits)
{
  const std::size_t n = 16;
  const Surface surface(square(n));
  std::mt19937 random(1);
  for(int i = 0; i < 2000; ++i)
  {
    const Location from = random_location(surface.t(), random);
    const Location at =
        surface.at(Index((n + 1) * (1 + random() % (n - 1)) + 1 + random() % (n - 1)));
    const Point p = point_at(surface.t(), from), q = point_at(surface.t(), at);
    // Around the distance at which a site counts as hit: one of the sides there may tell that it is
    // hit, and the other one that it is not.
    const double aside = (i % 41 - 20) * 1e-13 / n;
    const Point way = {q[0] - p[0] - aside * (q[1] - p[1]), q[1] - p[1] + aside * (q[0] - p[0]),
                       0.};
    const Point end = {p[0] + 1.8 * way[0], p[1] + 1.8 * way[1], 0.};
    if(std::min({end[0], end[1], 1. - end[0], 1. - end[1]}) < 1e-9)
      continue;
    const auto path = checked(surface, from, surface.angle_of(from, way),
                              1.8 * std::hypot(way[0], way[1]) / surface.scale());
    ASSERT_EQ(path.end, Straightest_end::length);
    EXPECT_NEAR(distance(point_at(surface.t(), path.locations.back()), end), 0., rounding);
  }
}

TEST(Straightest, winds_around_a_prism_as_when_unrolled)
{
  const std::size_t n = 9;
  const Surface surface(rings(
      n, 6, [](double) { return 1.; }, [](double s) { return 4. * s; }, 0.));
  // From a point of the lowest ring, along the side to the next one and up.
  for(const double slope : {0.1, 0.5, 1.2})
  {
    const Location from = surface.at(0);
    Index corner = none; // of the triangle with the side from point 0 to point 1
    for(Index c = 0; c < surface.t().corner.size(); ++c)
      if(surface.t().corner[c] == surface.mesh.site_of_vertex[0] &&
         surface.t().corner[next_side(c)] == surface.mesh.site_of_vertex[1])
        corner = c;
    ASSERT_NE(corner, none);
    Location start = from;
    start.triangle = corner / 3;
    start.barycentric = at_corner(corner);
    const auto corners = unfolded(surface.t(), start.triangle);
    const Planar side = corners[next_side(corner) % 3] - corners[corner % 3];
    const double length = 3. / std::sin(slope);
    const auto path =
        checked(surface, start, std::atan2(side[1], side[0]) + slope, length / surface.scale());
    EXPECT_EQ(path.end, Straightest_end::length);
    EXPECT_NEAR(point_at(surface.t(), path.locations.back())[2], 3., 10. * rounding);
  }
}

TEST(Straightest, leaves_a_site_with_equal_angles)
{
  const std::size_t n = 12;
  for(const double total : {0.9 * pi, 1.7 * pi, 2. * pi, 2.6 * pi, 3. * pi})
  {
    const Surface surface(cone(n, 4, total));
    // From ring 3 in direction 2 to the tip and as far beyond: half of the angle is half of n.
    const Location from = surface.at(1 + 3 * n + 2), tip = surface.at(0);
    const auto first = straighten(surface.t(), {from, surface.at(1 + 2 * n + 2),
                                                surface.at(1 + n + 2), surface.at(1 + 2), tip});
    ASSERT_NEAR(first.length * surface.scale(), 4., rounding);
    const Location start = first.locations.front();
    // Along the arc to the next ring inwards.
    const Location next = first.locations[1];
    const Index triangle = common_triangle(surface.t(), start, next);
    const auto corners = unfolded(surface.t(), triangle);
    const Planar way = unfolded_point(corners, *seen_from(surface.t(), triangle, next)) -
                       unfolded_point(corners, *seen_from(surface.t(), triangle, start));
    Location begin = start;
    begin.triangle = triangle;
    begin.barycentric = *seen_from(surface.t(), triangle, start);
    const auto path = checked(surface, begin, std::atan2(way[1], way[0]), 7. / surface.scale());
    EXPECT_EQ(path.end, Straightest_end::length);
    EXPECT_NEAR(distance(point_at(surface.t(), path.locations.back()),
                         point_at(surface.t(), surface.at(Index(1 + 2 * n + 8)))),
                0., 1e-10) // the tip is hit to 1e-12 of a side only
        << total;
  }
}

TEST(Straightest, comes_back_the_same_way)
{
  const Surface surface(shaken(icosphere(3), 0.02));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 100; ++i)
  {
    const Location from = random_location(surface.t(), random);
    const auto there = checked(surface, from, angle(random), 2. / surface.scale());
    const auto back = checked(surface, there.locations.back(), there.angle + pi, there.length);
    // Errors grow along the way where the surface is curved like a saddle.
    EXPECT_NEAR(distance(point_at(surface.t(), from), point_at(surface.t(), back.locations.back())),
                0., 1e-9);
  }
}

TEST(Straightest, is_locally_shortest_where_it_meets_no_site)
{
  const Surface surface(shaken(icosphere(3), 0.03));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 50; ++i)
  {
    const auto path =
        checked(surface, random_location(surface.t(), random), angle(random), 3. / surface.scale());
    const auto taut = straighten(surface.t(), path.locations);
    EXPECT_NEAR(taut.length, path.length, 10. * rounding);
    EXPECT_EQ(taut.locations.size(), path.locations.size());
  }
}

TEST(Straightest, ends_where_the_surface_does)
{
  const Surface surface(one_triangle());
  Location middle;
  middle.triangle = 0;
  middle.barycentric = {1. / 3., 1. / 3., 1. / 3.};
  for(int i = 0; i < 12; ++i)
  {
    const auto path = checked(surface, middle, i * pi / 6. + 0.1, 10.);
    EXPECT_EQ(path.end, Straightest_end::border);
    EXPECT_LT(path.length * surface.scale(), 1.);
  }
  // From a corner out of the triangle, and with no length.
  const auto out = checked(surface, surface.at(0), 0.75 * pi + 0.1 * pi, 1.);
  EXPECT_EQ(out.locations.size(), 1u);
  EXPECT_EQ(checked(surface, middle, 1., 0.).locations.size(), 1u);
}

TEST(Straightest, gets_on_through_slivers)
{
  Triangulation flat = square(10);
  for(std::size_t i = 0; i < flat.points.size(); ++i)
  {
    if(i % 11 == 4)
      flat.points[i][0] = 0.3;
    if(i / 11 == 5)
      flat.points[i][1] = 0.6 - 1e-9;
  }
  const Surface surface(flat);
  std::mt19937 random(4);
  for(int i = 0; i < 200; ++i)
  {
    const auto path = straightest(surface.t(), random_location(surface.t(), random), i, 1e3);
    EXPECT_EQ(path.end, Straightest_end::border);
    for(const Location& location : path.locations)
      for(const double b : location.barycentric)
        EXPECT_TRUE(b >= 0. && b <= 1.);
  }
}

TEST(Straightest, takes_directions_of_space)
{
  // The square in a tilted plane, so that directions have a part across it.
  const double c = std::cos(0.7), d = std::sin(0.7);
  Triangulation tilted = square(12, 0.25);
  for(Point& p : tilted.points)
    p = {p[0], c * p[1], d * p[1]};
  const Surface surface(tilted);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 100; ++i)
  {
    Location from = random_location(surface.t(), random);
    if(i % 2 == 0) // an inner point of the square
      from = surface.at(Index(14 + random() % 11 + 13 * (random() % 11)));
    const double a = angle(random), length = 0.02, across = i % 3 - 1.;
    const Point way = {std::cos(a), c * std::sin(a), d * std::sin(a)};
    const Point direction = {way[0], way[1] - across * d, way[2] + across * c};
    const auto path = straightest_in_space(surface.t(), from, direction, length / surface.scale());
    if(path.end == Straightest_end::border)
      continue;
    const Point p = point_at(surface.t(), from), q = point_at(surface.t(), path.locations.back());
    for(int k = 0; k < 3; ++k)
      EXPECT_NEAR(q[k], p[k] + length * way[k], rounding);
  }
  EXPECT_THROW(straightest_in_space(surface.t(), surface.at(20), {0., -d, c}, 1.),
               Invalid_argument_error);
}

TEST(Straightest, refuses_lengths_that_are_none)
{
  const Surface surface(tetrahedron());
  Location from;
  from.triangle = 0;
  EXPECT_THROW(straightest(surface.t(), from, 0., -1.), Invalid_argument_error);
  EXPECT_THROW(straightest(surface.t(), from, 0., infinity), Invalid_argument_error);
  EXPECT_THROW(straightest(surface.t(), from, infinity - infinity, 1.), Invalid_argument_error);
}

} // namespace
