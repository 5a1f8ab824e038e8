// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include "core/unfold.h"

#include "path_checks.h"

namespace trace_straightest_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Some hundred crossings of triangles of size 1, each with a few round-off errors.
constexpr double round_off = 1e-12;

struct Surface
{
  Mesh_arrays mesh;

  explicit Surface(const Triangulation& triangulation) : mesh(arrays_of(triangulation)) {}
  const Surface_arrays& t() const { return mesh.arrays; }
  Surface_location at(Index point) const
  {
    return vertex_location(t(), mesh.internal_vertex[point]);
  }
  double scale() const { return t().scale; }

  // Returns the angle from halfedge 0 of a location's triangle to a direction in the plane z = 0.
  double angle_of(const Surface_location& location, const Point& direction) const
  {
    const auto& a = t().point[t().corner[3 * location.triangle]];
    const auto& b = t().point[t().corner[3 * location.triangle + 1]];
    return std::atan2(direction[1], direction[0]) - std::atan2(b[1] - a[1], b[0] - a[0]);
  }
};

Straightest_path checked_trace(const Surface& surface, const Surface_location& from, double angle,
                               double length)
{
  const Straightest_path path = trace_straightest(surface.t(), from, angle, length);
  expect_path_on_surface(surface.t(), path.locations, from, path.locations.back());
  EXPECT_NEAR(path_length(surface.t(), path.locations), path.length,
              round_off * (1. + path.length));
  if(path.end == Straightest_path_end::length)
  {
    EXPECT_NEAR(path.length, length, round_off * (1. + length));
  }
  return path;
}

TEST(Trace_straightest, is_straight_in_plane)
{
  const Surface surface(square(20, 0.25));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 300; ++i)
  {
    const Surface_location from =
        i % 3 == 0 ? surface.at(Index(random() % 441)) : random_location(surface.t(), random);
    const Point p = point_at(surface.t(), from);
    const double a = angle(random), length = 0.6;
    const Point q = {p[0] + length * std::cos(a), p[1] + length * std::sin(a), 0.};
    const auto path =
        checked_trace(surface, from, surface.angle_of(from, {std::cos(a), std::sin(a), 0.}),
                      length / surface.scale());
    if(std::min({q[0], q[1], 1. - q[0], 1. - q[1]}) > 1e-9)
    {
      ASSERT_EQ(path.end, Straightest_path_end::length);
      EXPECT_NEAR(distance(point_at(surface.t(), path.locations.back()), q), 0., round_off);
      // The direction at the end is the initial one.
      EXPECT_NEAR(std::remainder(path.angle - surface.angle_of(path.locations.back(),
                                                               {std::cos(a), std::sin(a), 0.}),
                                 2. * pi),
                  0., round_off);
    }
    else
    {
      // The path ends on the boundary, at the intersection with the line.
      ASSERT_EQ(path.end, Straightest_path_end::boundary);
      const Point r = point_at(surface.t(), path.locations.back());
      EXPECT_NEAR(std::min({r[0], r[1], 1. - r[0], 1. - r[1]}), 0., round_off);
      EXPECT_NEAR((r[0] - p[0]) * std::sin(a) - (r[1] - p[1]) * std::cos(a), 0., round_off);
    }
  }
}

TEST(Trace_straightest, passes_through_lattice_vertices)
{
  const Surface surface(square(16));
  for(const Point& direction : {Point{1., 0., 0.}, Point{0., 1., 0.}, Point{1., 1., 0.},
                                Point{2., 1., 0.}, Point{1., 2., 0.}})
  {
    // Some paths follow the boundary, which is straight at each of its vertices.
    const Surface_location from = surface.at(0);
    const double length =
        std::hypot(direction[0], direction[1]) / std::max(direction[0], direction[1]);
    const auto path =
        checked_trace(surface, from, surface.angle_of(from, direction), length / surface.scale());
    EXPECT_EQ(path.end, Straightest_path_end::length);
    EXPECT_NEAR(point_at(surface.t(), path.locations.back())[0],
                direction[0] / std::max(direction[0], direction[1]), round_off);
    EXPECT_NEAR(point_at(surface.t(), path.locations.back())[1],
                direction[1] / std::max(direction[0], direction[1]), round_off);
  }
}

TEST(Trace_straightest, is_straight_past_nearly_hit_vertices)
{
  const std::size_t n = 16;
  const Surface surface(square(n));
  std::mt19937 random(1);
  for(int i = 0; i < 2000; ++i)
  {
    const Surface_location from = random_location(surface.t(), random);
    const Surface_location at =
        surface.at(Index((n + 1) * (1 + random() % (n - 1)) + 1 + random() % (n - 1)));
    const Point p = point_at(surface.t(), from), q = point_at(surface.t(), at);
    // The distance to the vertex is close to the tolerance of a hit. One of the edges at the
    // vertex may be hit at its endpoint, and another one may not.
    const double offset = (i % 41 - 20) * 1e-13 / n;
    const Point direction = {q[0] - p[0] - offset * (q[1] - p[1]),
                             q[1] - p[1] + offset * (q[0] - p[0]), 0.};
    const Point end = {p[0] + 1.8 * direction[0], p[1] + 1.8 * direction[1], 0.};
    if(std::min({end[0], end[1], 1. - end[0], 1. - end[1]}) < 1e-9)
      continue;
    const auto path = checked_trace(surface, from, surface.angle_of(from, direction),
                                    1.8 * std::hypot(direction[0], direction[1]) / surface.scale());
    ASSERT_EQ(path.end, Straightest_path_end::length);
    EXPECT_NEAR(distance(point_at(surface.t(), path.locations.back()), end), 0., round_off);
  }
}

TEST(Trace_straightest, is_straight_on_unrolled_prism)
{
  const std::size_t n = 9;
  const Surface surface(rings(
      n, 6, [](double) { return 1.; }, [](double s) { return 4. * s; }, 0.));
  // The path starts at a vertex of the lowest ring, at an angle to the edge of the ring.
  for(const double slope : {0.1, 0.5, 1.2})
  {
    const Surface_location from = surface.at(0);
    Index corner = none; // whose halfedge runs from point 0 to point 1
    for(Index c = 0; c < surface.t().corner.size(); ++c)
      if(surface.t().corner[c] == surface.mesh.internal_vertex[0] &&
         surface.t().corner[next_halfedge(c)] == surface.mesh.internal_vertex[1])
        corner = c;
    ASSERT_NE(corner, none);
    Surface_location start = from;
    start.triangle = corner / 3;
    start.barycentric = barycentric_at_corner(corner);
    const auto corners = unfolded(surface.t(), start.triangle);
    const Vec2 edge = corners[next_halfedge(corner) % 3] - corners[corner % 3];
    const double length = 3. / std::sin(slope);
    const auto path = checked_trace(surface, start, std::atan2(edge[1], edge[0]) + slope,
                                    length / surface.scale());
    EXPECT_EQ(path.end, Straightest_path_end::length);
    EXPECT_NEAR(point_at(surface.t(), path.locations.back())[2], 3., 10. * round_off);
  }
}

TEST(Trace_straightest, bisects_total_angle_at_vertices)
{
  const std::size_t n = 12;
  for(const double total_angle : {0.9 * pi, 1.7 * pi, 2. * pi, 2.6 * pi, 3. * pi})
  {
    const Surface surface(cone(n, 4, total_angle));
    // From ring 3 in direction 2 to the apex, and on to ring 2: half of the total angle is n / 2
    // directions.
    const Surface_location from = surface.at(1 + 3 * n + 2), apex = surface.at(0);
    const auto path_to_apex =
        shorten_geodesic(surface.t(), {from, surface.at(1 + 2 * n + 2), surface.at(1 + n + 2),
                                       surface.at(1 + 2), apex});
    ASSERT_NEAR(path_to_apex.length * surface.scale(), 4., round_off);
    const Surface_location start = path_to_apex.locations.front();
    // The initial direction is that of the first segment.
    const Surface_location next = path_to_apex.locations[1];
    const Index triangle = common_triangle(surface.t(), start, next);
    const auto corners = unfolded(surface.t(), triangle);
    const Vec2 direction = unfolded_point(corners, *barycentric_in(surface.t(), triangle, next)) -
                           unfolded_point(corners, *barycentric_in(surface.t(), triangle, start));
    Surface_location begin = start;
    begin.triangle = triangle;
    begin.barycentric = *barycentric_in(surface.t(), triangle, start);
    const auto path =
        checked_trace(surface, begin, std::atan2(direction[1], direction[0]), 7. / surface.scale());
    EXPECT_EQ(path.end, Straightest_path_end::length);
    EXPECT_NEAR(distance(point_at(surface.t(), path.locations.back()),
                         point_at(surface.t(), surface.at(Index(1 + 2 * n + 8)))),
                0., 1e-10) // the apex is hit up to 1e-12 of an edge
        << total_angle;
  }
}

TEST(Trace_straightest, is_reversible)
{
  const Surface surface(jittered(icosphere(3), 0.02));
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 100; ++i)
  {
    const Surface_location from = random_location(surface.t(), random);
    const auto there = checked_trace(surface, from, angle(random), 2. / surface.scale());
    const auto back =
        checked_trace(surface, there.locations.back(), there.angle + pi, there.length);
    // Errors grow along the path in regions of negative curvature.
    EXPECT_NEAR(distance(point_at(surface.t(), from), point_at(surface.t(), back.locations.back())),
                0., 1e-9);
  }
}

TEST(Trace_straightest, is_locally_shortest_away_from_vertices)
{
  const Surface surface(jittered(icosphere(3), 0.03));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 50; ++i)
  {
    const auto path = checked_trace(surface, random_location(surface.t(), random), angle(random),
                                    3. / surface.scale());
    const auto geodesic = shorten_geodesic(surface.t(), path.locations);
    EXPECT_NEAR(geodesic.length, path.length, 10. * round_off);
    EXPECT_EQ(geodesic.locations.size(), path.locations.size());
  }
}

TEST(Trace_straightest, ends_at_boundary)
{
  const Surface surface(one_triangle());
  Surface_location barycenter;
  barycenter.triangle = 0;
  barycenter.barycentric = {1. / 3., 1. / 3., 1. / 3.};
  for(int i = 0; i < 12; ++i)
  {
    const auto path = checked_trace(surface, barycenter, i * pi / 6. + 0.1, 10.);
    EXPECT_EQ(path.end, Straightest_path_end::boundary);
    EXPECT_LT(path.length * surface.scale(), 1.);
  }
  // A direction that points out of the triangle at a corner, and a path of length zero.
  const auto out = checked_trace(surface, surface.at(0), 0.75 * pi + 0.1 * pi, 1.);
  EXPECT_EQ(out.locations.size(), 1u);
  EXPECT_EQ(checked_trace(surface, barycenter, 1., 0.).locations.size(), 1u);
}

TEST(Trace_straightest, passes_through_slivers)
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
    const auto path = trace_straightest(surface.t(), random_location(surface.t(), random), i, 1e3);
    EXPECT_EQ(path.end, Straightest_path_end::boundary);
    for(const Surface_location& location : path.locations)
      for(const double b : location.barycentric)
        EXPECT_TRUE(b >= 0. && b <= 1.);
  }
}

// Two triangles of the height 1e-7, back to back: a path around them crosses them ten million times
// per unit of length.
TEST(Trace_straightest, number_of_crossed_triangles_is_bounded)
{
  const Surface surface({{{0., 0., 0.}, {1., 0., 0.}, {0.5, 1e-7, 0.}}, {0, 1, 2, 0, 2, 1}});
  Surface_location from;
  from.triangle = 0;
  from.barycentric = {0.3, 0.3, 0.4};
  const double angle = surface.angle_of(from, {0., 1., 0.});
  EXPECT_EQ(trace_straightest(surface.t(), from, angle, 0.01).end, Straightest_path_end::length);
  const Straightest_path path = trace_straightest(surface.t(), from, angle, 1.);
  EXPECT_EQ(path.end, Straightest_path_end::degenerate);
  EXPECT_LT(path.locations.size(), 1100000u); // 10^6 + 10 #triangles, and the ends
}

TEST(Trace_straightest, accepts_directions_in_space)
{
  // The square is in a tilted plane, so that directions have a normal component.
  const double c = std::cos(0.7), d = std::sin(0.7);
  Triangulation tilted = square(12, 0.25);
  for(Point& p : tilted.points)
    p = {p[0], c * p[1], d * p[1]};
  const Surface surface(tilted);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for(int i = 0; i < 100; ++i)
  {
    Surface_location from = random_location(surface.t(), random);
    if(i % 2 == 0) // an interior vertex of the square
      from = surface.at(Index(14 + random() % 11 + 13 * (random() % 11)));
    const double a = angle(random), length = 0.02, normal_component = i % 3 - 1.;
    const Point tangent_direction = {std::cos(a), c * std::sin(a), d * std::sin(a)};
    const Point direction = {tangent_direction[0], tangent_direction[1] - normal_component * d,
                             tangent_direction[2] + normal_component * c};
    const auto path =
        trace_straightest_in_space(surface.t(), from, direction, length / surface.scale());
    if(path.end == Straightest_path_end::boundary)
      continue;
    const Point p = point_at(surface.t(), from), q = point_at(surface.t(), path.locations.back());
    for(int k = 0; k < 3; ++k)
      EXPECT_NEAR(q[k], p[k] + length * tangent_direction[k], round_off);
  }
  EXPECT_THROW(trace_straightest_in_space(surface.t(), surface.at(20), {0., -d, c}, 1.),
               Invalid_argument_error);
}

TEST(Trace_straightest, throws_on_invalid_length)
{
  const Surface surface(tetrahedron());
  Surface_location from;
  from.triangle = 0;
  EXPECT_THROW(trace_straightest(surface.t(), from, 0., -1.), Invalid_argument_error);
  EXPECT_THROW(trace_straightest(surface.t(), from, 0., infinity), Invalid_argument_error);
  EXPECT_THROW(trace_straightest(surface.t(), from, infinity - infinity, 1.),
               Invalid_argument_error);
}

} // namespace trace_straightest_test
