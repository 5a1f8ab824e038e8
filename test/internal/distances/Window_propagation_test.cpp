// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>
#include "core/unfold.h"

#include "mesh/Intrinsic_triangulation.h"

#include "mesh/degenerate_triangles.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <thread>

namespace Window_propagation_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off error of some hundred sums of lengths and changes of coordinates.
constexpr double round_off = 1e-12;

std::vector<double> run(const Array_surface& surface,
                        const std::vector<internal::Front_source>& sources,
                        const Front_limits& limits = {})
{
  Window_propagation windows(surface.triangles());
  EXPECT_TRUE(windows.run(sources, limits));
  return surface.distances(windows);
}

Triangulation scaled(Triangulation surface, double x, double y, double z)
{
  for(Point& p : surface.points)
    p = {x * p[0], y * p[1], z * p[2]};
  return surface;
}

// A height field with hills and saddles over the unit square.
Triangulation hilly_square(std::size_t n, double height, unsigned seed = 1)
{
  return grid(
      n, n,
      [=](double u, double v) {
        return Point{u, v, height * std::sin(7. * u) * std::cos(9. * v + u)};
      },
      0.24, seed);
}

// The unit square without its upper right quarter, whose vertices are isolated.
Triangulation l_shaped_room(std::size_t n, double jitter)
{
  Triangulation result = square(n, jitter);
  const auto is_kept = [&](std::size_t f)
  {
    double u = 0., v = 0.;
    for(int k = 0; k < 3; ++k)
    {
      const Index point = result.corners[3 * f + k];
      u += double(point % (n + 1)) / (3. * n);
      v += double(point / (n + 1)) / (3. * n);
    }
    return u < 0.5 || v < 0.5;
  };
  std::vector<Index> corners;
  for(std::size_t f = 0; 3 * f < result.corners.size(); ++f)
    if(is_kept(f))
      corners.insert(corners.end(), &result.corners[3 * f], &result.corners[3 * f] + 3);
  result.corners = corners;
  // The new boundary is straight.
  for(Index i = 0; i < result.points.size(); ++i)
  {
    const std::size_t column = i % (n + 1), row = i / (n + 1);
    if((2 * column == n && 2 * row >= n) || (2 * row == n && 2 * column >= n))
      result.points[i] = {double(column) / n, double(row) / n, 0.};
  }
  return result;
}

TEST(Window_propagation, is_exact_on_flat_convex_meshes)
{
  for(const double scale : {1., 1e-6, 1e6})
    for(const double height : {1., 0.05, 20.})
      for(const double jitter : {0., 0.24})
      {
        const Triangulation plane = scaled(square(30, jitter), scale, scale * height, scale);
        const Array_surface surface(plane);
        for(const Index source : {0, 15 * 31 + 15, 30, 7 * 31 + 22, 28 * 31 + 3})
        {
          const auto d = run(surface, {surface.source(source)});
          EXPECT_LT(largest_error(d, [&](Index i)
                                  { return distance(plane.points[i], plane.points[source]); }),
                    round_off * scale * std::max(1., height));
        }
      }
}

TEST(Window_propagation, accepts_sources_in_faces_and_on_edges)
{
  const Triangulation plane = square(20, 0.24);
  const Array_surface surface(plane);
  std::mt19937 random(1);
  for(int i = 0; i < 10; ++i)
  {
    Surface_location at = random_location(*surface.triangles(), random);
    if(i % 2 == 1) // on an edge
      at.barycentric = {at.barycentric[0], 1. - at.barycentric[0], 0.};
    const Point p = point_at(*surface.triangles(), at);
    const auto d = run(surface, {surface.source(at)});
    EXPECT_LT(largest_error(d, [&](Index j) { return distance(plane.points[j], p); }), round_off);
  }
}

TEST(Window_propagation, is_exact_on_cones_and_saddles)
{
  constexpr Index n = 12, rings = 9;
  for(const double total : {0.7, 2., 5., 2. * pi, 7., 9., 16.})
  {
    const Array_surface surface(cone(n, rings, total));
    const auto location = [&](Index i) -> std::pair<double, double> // radius, angle
    {
      return i == 0 ? std::pair(0., 0.)
                    : std::pair(double((i - 1) / n + 1), total * ((i - 1) % n) / n);
    };
    for(const Index source : {Index(0), Index(1), Index(1 + 4 * n + 5), Index(1 + 8 * n + 11)})
    {
      const auto [a, angle] = location(source);
      const auto d = run(surface, {surface.source(source)});
      const double error =
          largest_error(d,
                        [&, a = a, angle = angle](Index i)
                        {
                          const auto [b, other] = location(i);
                          return distance_on_cone(a, b, std::abs(angle - other), total);
                        });
      EXPECT_LT(error, round_off * rings) << total << " " << source;
    }
  }
}

TEST(Window_propagation, bends_around_boundary_corner)
{
  for(const double jitter : {0., 0.24})
  {
    const Triangulation l_shaped_mesh = l_shaped_room(24, jitter);
    const Array_surface surface(l_shaped_mesh);
    const Point corner = {0.5, 0.5, 0.};
    for(const Index source : {Index(24), Index(24 + 25 * 7), Index(5), Index(12 + 25 * 12)})
    {
      const Point& p = l_shaped_mesh.points[source];
      const auto d = run(surface, {surface.source(source)});
      const double error = largest_error(d,
                                         [&](Index i)
                                         {
                                           const Point& q = l_shaped_mesh.points[i];
                                           if(q[0] > 0.5 + 1e-9 && q[1] > 0.5 + 1e-9)
                                             return infinity;
                                           // The path bends at the corner if the corner is to the
                                           // left of the segment from a to b.
                                           const Point& a = p[0] - p[1] > q[0] - q[1] ? p : q;
                                           const Point& b = p[0] - p[1] > q[0] - q[1] ? q : p;
                                           const double turn = (b[0] - a[0]) * (corner[1] - a[1]) -
                                                               (b[1] - a[1]) * (corner[0] - a[0]);
                                           const bool is_around_corner = a[0] > 0.5 && b[1] > 0.5;
                                           return is_around_corner && turn > 0.
                                                      ? distance(a, corner) + distance(corner, b)
                                                      : distance(a, b);
                                         });
      EXPECT_LT(error, round_off);
    }
  }
}

TEST(Window_propagation, lies_between_bounds_on_sphere)
{
  for(const unsigned level : {0u, 1u, 2u, 4u})
  {
    const Triangulation sphere = icosphere(level);
    const Array_surface surface(sphere);
    double inner = 1.; // radius of the inscribed ball
    for(std::size_t f = 0; f < sphere.corners.size(); f += 3)
    {
      const Point &p = sphere.points[sphere.corners[f]], &q = sphere.points[sphere.corners[f + 1]],
                  &r = sphere.points[sphere.corners[f + 2]];
      const Point u = {q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                  v = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
      const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]};
      inner = std::min(inner, std::abs(test::dot(n, p)) / std::sqrt(test::dot(n, n)));
    }
    for(const Index source : {Index(0), Index(surface.size() - 1)})
    {
      const auto d = run(surface, {surface.source(source)});
      for(Index i = 0; i < surface.size(); ++i)
      {
        // The projection to a convex surface does not increase distances, and the central
        // projection from the inscribed ball to the sphere increases them by a factor of at most 1
        // / inner.
        const double edge = great_circle(sphere.points[i], sphere.points[source]);
        EXPECT_LE(d[i], edge * (1. + round_off));
        EXPECT_GE(d[i], inner * edge * (1. - round_off));
      }
    }
  }
}

TEST(Window_propagation, satisfies_metric_axioms)
{
  for(const Triangulation& shape :
      {jittered(icosphere(3), 0.05), hilly_square(24, 0.2),
       scaled(jittered(icosphere(2), 0.1), 1., 1., 20.), jittered(annulus(24, 6, 0.4, 1.), 0.03),
       tetrahedron(), one_triangle()})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    const Index sources[] = {0, surface.size() / 2, surface.size() - 1};
    std::vector<std::vector<double>> d;
    for(const Index source : sources)
      d.push_back(run(surface, {surface.source(source)}));
    for(int a = 0; a < 3; ++a)
      for(int b = 0; b < 3; ++b)
      {
        const double there = d[a][sources[b]], back = d[b][sources[a]];
        EXPECT_NEAR(there, back, round_off * (there + back));
        for(Index i = 0; i < surface.size(); ++i)
          EXPECT_LE(d[a][i], (there + d[b][i]) * (1. + round_off));
      }
    for(const auto& one : d)
      for(Index h = 0; h < t.corner.size(); ++h)
      {
        const double from = one[surface.caller_vertex(t.corner[h])],
                     to = one[surface.caller_vertex(t.corner[next_halfedge(h)])];
        EXPECT_LE(std::abs(from - to), t.length[h] * t.scale * (1. + round_off));
      }
  }
}

TEST(Window_propagation, distance_is_minimum_over_sources)
{
  const Array_surface surface(hilly_square(24, 0.2));
  const std::vector<Index> vertices = {0, 300, 301, 450, 620};
  const std::vector<double> offsets = {0.1, -0.3, -0.25, 5., 0.};
  std::vector<internal::Front_source> sources;
  std::vector<std::vector<double>> single;
  for(std::size_t i = 0; i < vertices.size(); ++i)
  {
    sources.push_back(surface.source(vertices[i], offsets[i]));
    single.push_back(run(surface, {sources.back()}));
  }
  Window_propagation windows(surface.triangles());
  for(const bool is_reversed : {false, true})
  {
    if(is_reversed)
      std::reverse(sources.begin(), sources.end());
    ASSERT_TRUE(windows.run(sources));
    const auto d = surface.distances(windows);
    for(Index i = 0; i < surface.size(); ++i)
    {
      double min_distance = infinity;
      for(const auto& one : single)
        min_distance = std::min(min_distance, one[i]);
      EXPECT_NEAR(d[i], min_distance, round_off);
      const Index source = windows.source(surface.vertex(i));
      EXPECT_NEAR(single[is_reversed ? vertices.size() - 1 - source : source][i], min_distance,
                  round_off);
      const Index before = windows.predecessor(surface.vertex(i));
      if(before != none)
      {
        EXPECT_LT(windows.distance(before), windows.distance(surface.vertex(i)));
      }
    }
    EXPECT_EQ(windows.predecessor(surface.vertex(300)), none);
  }
}

// If offsets differ, a source can be the nearest one in the middle of an edge only. On coarse
// surfaces, such intervals are long.
TEST(Window_propagation, distance_is_minimum_over_random_sources_with_offsets)
{
  const std::vector<Triangulation> surfaces = {grid(1, 1,
                                                    [](double u, double v) {
                                                      return Point{u, v, 0.};
                                                    }),
                                               square(3, 0.2),
                                               icosphere(1),
                                               torus(6, 4),
                                               hilly_square(6, 0.3),
                                               annulus(6, 2, 1., 2.)};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-0.6, 0.6);
  for(const Triangulation& shape : surfaces)
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = surface.t();
    Window_propagation together(surface.triangles()), one(surface.triangles());
    for(int repetition = 0; repetition < 200; ++repetition)
    {
      std::vector<internal::Front_source> sources;
      for(int i = 0; i < 3; ++i)
      {
        sources.push_back({{random_location(t, random)}, offset(random)});
        if(random() % 3 == 0 && sources.back().polyline[0].triangle != none)
        {
          Surface_location end = sources.back().polyline[0];
          std::rotate(end.barycentric.begin(), end.barycentric.begin() + 1, end.barycentric.end());
          sources.back().polyline.push_back(end);
        }
      }
      ASSERT_TRUE(together.run(sources));
      std::vector<double> expected(t.number_of_vertices(), infinity);
      const Surface_location location = random_location(t, random);
      double expected_at_location = infinity;
      for(const internal::Front_source& source : sources)
      {
        ASSERT_TRUE(one.run({source}));
        for(Index v = 0; v < expected.size(); ++v)
          expected[v] = std::min(expected[v], one.distance(v));
        expected_at_location = std::min(expected_at_location, one.distance(location));
      }
      for(Index v = 0; v < expected.size(); ++v)
        EXPECT_NEAR(together.distance(v), expected[v], round_off);
      EXPECT_NEAR(together.distance(location), expected_at_location, round_off);
    }
  }
}

TEST(Window_propagation, accepts_polyline_sources)
{
  const Triangulation plane = square(20, 0.24);
  const Array_surface surface(plane);
  // Along edges: the lower boundary.
  std::vector<Index> boundary_edge(21);
  std::iota(boundary_edge.begin(), boundary_edge.end(), 0);
  EXPECT_LT(largest_error(run(surface, {surface.line(boundary_edge, 0.5)}),
                          [&](Index i) { return 0.5 + plane.points[i][1]; }),
            round_off);
  // A part of the boundary, and a segment inside a face.
  EXPECT_LT(
      largest_error(
          run(surface, {surface.line({boundary_edge.begin() + 5, boundary_edge.begin() + 9})}),
          [&](Index i)
          { return distance_to_segment(plane.points[i], plane.points[5], plane.points[8]); }),
      round_off);
  for(const Index face : {0, 333, 500})
  {
    const Surface_location begin = surface.in(face, {0.5, 0.3, 0.2}),
                           end = surface.in(face, {0.1, 0.2, 0.7});
    const Point p = point_at(*surface.triangles(), begin), q = point_at(*surface.triangles(), end);
    EXPECT_LT(largest_error(run(surface, {internal::Front_source{{begin, end}, 0., 0}}),
                            [&](Index i) { return distance_to_segment(plane.points[i], p, q); }),
              round_off);
  }
}

TEST(Window_propagation, respects_maximum_distance)
{
  const Array_surface surface(hilly_square(30, 0.1));
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(480, -0.1)}));
  const auto full = surface.distances(windows);
  Front_limits limits;
  limits.maximum_distance = 0.25 / surface.scale();
  ASSERT_TRUE(windows.run({surface.source(480, -0.1)}, limits));
  const auto partial = surface.distances(windows);
  std::size_t near = 0;
  for(Index i = 0; i < surface.size(); ++i)
  {
    EXPECT_EQ(partial[i], full[i] <= 0.25 ? full[i] : infinity);
    near += full[i] <= 0.25;
  }
  EXPECT_EQ(windows.reached().size(), near);
  for(const Index vertex : windows.reached())
    EXPECT_LT(windows.distance(vertex), infinity);
}

TEST(Window_propagation, distances_of_targets_match_full_run)
{
  const Array_surface surface(hilly_square(30, 0.1));
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(480)}));
  const auto full = surface.distances(windows);
  Front_limits limits;
  limits.targets = {surface.at(490), surface.at(500), surface.in(870, {0.2, 0.3, 0.5})};
  ASSERT_TRUE(windows.run({surface.source(480)}, limits));
  EXPECT_LT(windows.reached().size(), std::size_t(surface.size() * 3 / 4));
  const auto partial = surface.distances(windows);
  for(const Index i : {490, 500})
    EXPECT_EQ(partial[i], full[i]);
  for(Index i = 0; i < surface.size(); ++i)
    EXPECT_TRUE(partial[i] == full[i] || partial[i] == infinity);
}

TEST(Window_propagation, cancelled_run_keeps_final_distances)
{
  const Array_surface surface(jittered(icosphere(5), 0.003));
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(0)}));
  const auto full = surface.distances(windows);
  int calls = 0;
  Front_limits limits;
  limits.callback = [&](double partial)
  {
    EXPECT_GE(partial, 0.);
    EXPECT_LE(partial, 1.);
    return ++calls < 5;
  };
  EXPECT_FALSE(windows.run({surface.source(0)}, limits));
  EXPECT_GT(windows.reached().size(), 0u);
  EXPECT_LT(windows.reached().size(), std::size_t(surface.size()));
  const auto partial = surface.distances(windows);
  for(Index i = 0; i < surface.size(); ++i)
    EXPECT_TRUE(partial[i] == full[i] || partial[i] == infinity);
  // The next query does not depend on the cancelled one.
  ASSERT_TRUE(windows.run({surface.source(0)}));
  EXPECT_EQ(surface.distances(windows), full);
}

TEST(Window_propagation, copies_run_concurrently)
{
  const Array_surface surface(hilly_square(30, 0.1));
  Window_propagation a(surface.triangles()), b(a);
  const auto first = run(surface, {surface.source(0)}),
             second = run(surface, {surface.source(900)});
  std::thread other([&] { b.run({surface.source(900)}); });
  a.run({surface.source(0)});
  other.join();
  EXPECT_EQ(surface.distances(a), first);
  EXPECT_EQ(surface.distances(b), second);
}

TEST(Window_propagation, does_not_reach_other_components_and_isolated_vertices)
{
  Triangulation shape = disjoint_union(icosphere(2), square(4));
  shape.points.push_back({5., 5., 5.});
  const Array_surface surface(shape);
  const auto d = run(surface, {surface.source(0)});
  for(Index i = 0; i < surface.size(); ++i)
    EXPECT_EQ(d[i] < infinity, i < icosphere(2).points.size());
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(surface.size() - 1, 2.)}));
  EXPECT_EQ(windows.reached().size(), 1u);
  EXPECT_EQ(surface.distances(windows).back(), 2.);
}

TEST(Window_propagation, distances_inside_faces_are_exact)
{
  const Triangulation plane = square(20, 0.24);
  const Array_surface flat(plane);
  Window_propagation windows(flat.triangles());
  std::mt19937 random(1);
  const Surface_location begin = flat.in(333, {0.5, 0.3, 0.2}), end = flat.in(333, {0.1, 0.2, 0.7});
  const Point p = point_at(*flat.triangles(), begin), q = point_at(*flat.triangles(), end);
  for(int i = 0; i < 20; ++i)
  {
    const Surface_location at = random_location(*flat.triangles(), random);
    const Point r = point_at(*flat.triangles(), at);
    ASSERT_TRUE(windows.run({flat.source(100, 0.5)}));
    EXPECT_NEAR(flat.scale() * windows.distance(at), 0.5 + distance(plane.points[100], r),
                round_off);
    ASSERT_TRUE(windows.run({flat.source(begin, -0.5)}));
    EXPECT_NEAR(flat.scale() * windows.distance(at), -0.5 + distance(p, r), round_off);
    ASSERT_TRUE(windows.run({internal::Front_source{{begin, end}, 0., 0}}));
    EXPECT_NEAR(flat.scale() * windows.distance(at), distance_to_segment(r, p, q), round_off);
  }
  // The distance inside a face equals that of the reverse query.
  for(const Triangulation& shape :
      {hilly_square(24, 0.2), jittered(icosphere(3), 0.1), l_shaped_room(12, 0.2)})
  {
    const Array_surface surface(shape);
    Window_propagation there(surface.triangles()), back(surface.triangles());
    ASSERT_TRUE(there.run({surface.source(0), surface.source(surface.size() / 3, 0.1)}));
    for(int i = 0; i < 20; ++i)
    {
      const Surface_location at = random_location(*surface.triangles(), random);
      ASSERT_TRUE(back.run({surface.source(at)}));
      const double min_distance =
          std::min(back.distance(surface.vertex(0)),
                   back.distance(surface.vertex(surface.size() / 3)) + 0.1 / surface.scale());
      EXPECT_NEAR(there.distance(at), min_distance, round_off);
    }
  }
}

TEST(Window_propagation, path_length_equals_distance)
{
  for(const Triangulation& shape :
      {square(16, 0.24), hilly_square(24, 0.2), jittered(icosphere(3), 0.1), l_shaped_room(12, 0.2),
       cone(12, 6, 9.), square(12)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    std::mt19937 random(1);
    Window_propagation windows(surface.triangles());
    const std::vector<std::vector<internal::Front_source>> queries = {
        {surface.source(0)},
        {surface.source(surface.size() / 3, 0.2), surface.source(random_location(t, random))},
        {{{surface.in(7, {0.2, 0.2, 0.6}), surface.in(7, {0.1, 0.8, 0.1})}, 0., 0}}};
    for(const auto& sources : queries)
    {
      ASSERT_TRUE(windows.run(sources));
      for(int i = 0; i < 40; ++i)
      {
        const Surface_location from =
            i % 2 == 0 ? random_location(t, random) : surface.at(Index(random() % surface.size()));
        const double expected = windows.distance(from);
        const auto path = windows.path(from).locations;
        if(!(expected < infinity))
        {
          EXPECT_TRUE(path.empty());
          continue;
        }
        ASSERT_FALSE(path.empty());
        EXPECT_TRUE(is_same_point(t, path.front(), canonical(t, from)));
        // The path ends on one of the sources.
        // Tracing adds round-off errors at each edge.
        const double tracing_error = 1e-10;
        double min_distance = infinity;
        for(const internal::Front_source& source : sources)
        {
          const Point end = point_at(t, path.back()), p = point_at(t, source.polyline.front()),
                      q = point_at(t, source.polyline.back());
          const double distance_to_source =
              p == q ? distance(end, p) : distance_to_segment(end, p, q);
          if(distance_to_source < tracing_error)
            min_distance = std::min(min_distance, source.offset);
        }
        EXPECT_NEAR(min_distance + path_length(t, path), expected, tracing_error);
      }
    }
  }
}

TEST(Window_propagation, paths_pass_through_lattice_vertices)
{
  const std::size_t n = 200;
  const Array_surface surface(square(n));
  Window_propagation windows(surface.triangles());
  // Half of the lines from this vertex to other vertices pass through vertices, after up to 100
  // edges.
  ASSERT_TRUE(windows.run({surface.source(Index((n + 1) * 192 + 121))}));
  std::mt19937 random(1);
  for(int i = 0; i < 200; ++i)
  {
    const Surface_location from = surface.at(Index(random() % surface.size()));
    const auto path = windows.path(from).locations;
    ASSERT_FALSE(path.empty());
    const double expected = windows.distance(from);
    EXPECT_NEAR(path_length(*surface.triangles(), path), expected, round_off * expected);
  }
}

TEST(Window_propagation, departure_reproduces_target_by_tracing)
{
  // On convex surfaces no shortest path bends at a vertex.
  for(const Triangulation& shape : {square(16, 0.24), icosphere(3), cone(12, 6, 5.)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    std::mt19937 random(1);
    Window_propagation windows(surface.triangles());
    for(const auto& source : {surface.source(surface.size() / 2, 0.5), surface.source(0),
                              surface.source(random_location(t, random))})
    {
      ASSERT_TRUE(windows.run({source}));
      for(int i = 0; i < 30; ++i)
      {
        const Surface_location to = random_location(t, random);
        const Departure departure = windows.departure(to);
        EXPECT_NEAR(departure.length, windows.distance(to) - source.offset, round_off);
        const auto line = trace_straightest(t, departure.from, departure.angle, departure.length);
        // The first segment of the path may be short, which limits the accuracy of its direction.
        EXPECT_LT(distance(point_at(t, line.locations.back()), point_at(t, to)), 1e-8);
      }
    }
  }
}

TEST(Window_propagation, polar_angles_are_counterclockwise_around_vertex)
{
  const Triangulation plane = square(16, 0.24);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  const Index center = 8 * 17 + 8, vertex = surface.vertex(center);
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(center)}));
  const auto direction = [&](const Point& p)
  { return std::atan2(p[1] - plane.points[center][1], p[0] - plane.points[center][0]); };
  const double first = direction(
      plane.points[surface.caller_vertex(t.corner[next_halfedge(t.ring[t.ring_begin[vertex]])])]);
  std::mt19937 random(1);
  for(int i = 0; i < 40; ++i)
  {
    const Surface_location to = random_location(t, random);
    const double angle_from_first = direction(point_at(t, to)) - first;
    EXPECT_NEAR(windows.departure(to).polar_angle,
                angle_from_first < 0. ? angle_from_first + 2. * pi : angle_from_first, round_off);
  }
  EXPECT_EQ(windows.departure(surface.at(center)).length, 0.);
}

TEST(Window_propagation, polar_angles_are_counterclockwise_around_edge_location)
{
  // The angle is measured from the edge, in the direction of its halfedge with the smaller index.
  const Triangulation plane = square(16, 0.24);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  const Surface_location on = surface.on(250, 1, 0.3);
  const Index corner = 3 * on.triangle + 1;
  const Point p = point_at(t, on), a = plane.points[surface.caller_vertex(t.corner[corner])];
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(on)}));
  double first = std::atan2(p[1] - a[1], p[0] - a[0]);
  if(t.twin[corner] < corner)
    first += pi;
  std::mt19937 random(1);
  for(int i = 0; i < 40; ++i)
  {
    const Surface_location to = random_location(t, random);
    const Point q = point_at(t, to);
    const double angle_from_first = std::atan2(q[1] - p[1], q[0] - p[0]) - first;
    EXPECT_NEAR(std::remainder(windows.departure(to).polar_angle - angle_from_first, 2. * pi), 0.,
                round_off);
  }
}

TEST(Window_propagation, polar_angle_matches_departure)
{
  // Flat with boundary, convex, with saddles, with flat regions whose lines pass through vertices,
  // rough.
  for(const Triangulation& shape :
      {square(16, 0.24), icosphere(3), cone(12, 6, 5.), cone(12, 6, 7.5), torus(24, 12),
       tetrahedron(), double_torus(3), jittered(icosphere(3), 0.05)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    std::mt19937 random(1);
    Window_propagation windows(surface.triangles());
    for(const auto& source :
        {surface.source(surface.size() / 2, 0.5), surface.source(0),
         surface.source(surface.on(1, 1, 0.3)), surface.source(random_location(t, random))})
    {
      ASSERT_TRUE(windows.run({source}));
      const Surface_location from = canonical(t, source.polyline.front());
      double whole = 2. * pi; // angle sum at the source
      if(const Index vertex = vertex_of(t, from); vertex != none)
      {
        whole = 0.;
        for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
          whole += interior_angle(t, t.ring[i]);
      }
      for(const Index vertex : windows.reached())
      {
        const Departure departure = windows.departure(vertex_location(t, vertex));
        EXPECT_NEAR(departure.length, windows.distance(vertex) - source.offset, round_off);
        const double found = windows.polar_angle_of_departure(vertex);
        // The same tolerance as for the other directions.
        EXPECT_NEAR(std::remainder(found - departure.polar_angle, whole), 0., 1e-8);
      }
    }
  }
}

// Returns the number of shortest paths, and checks their lengths, their ends, and that they are
// different.
std::size_t number_of_paths(const Array_surface& surface, const Window_propagation& windows,
                            const Surface_location& from, double offset = 0.)
{
  const Surface_arrays& t = *surface.triangles();
  const double shortest = windows.distance(from) - offset;
  const auto paths = windows.paths(from, 1e-9);
  for(const auto& path : paths)
  {
    // The tolerance of paths() and round-off errors.
    EXPECT_NEAR(path_length(t, path), shortest, 2e-9 * shortest);
    EXPECT_TRUE(is_same_point(t, path.front(), canonical(t, from)));
    for(const auto& other : paths)
      EXPECT_EQ(&other == &path,
                other.size() == path.size() &&
                    std::equal(path.begin(), path.end(), other.begin(),
                               [&](const Surface_location& p, const Surface_location& q)
                               { return is_same_point(t, p, q); }));
  }
  return paths.size();
}

// Returns the 1-to-4 refinement; the vertices of the input keep their indices.
Triangulation subdivide(const Triangulation& surface)
{
  Triangulation result{surface.points, {}};
  std::map<std::pair<Index, Index>, Index> midpoints;
  const auto edge_midpoint = [&](Index a, Index b)
  {
    const auto [entry, is_new] = midpoints.emplace(std::minmax(a, b), Index(result.points.size()));
    if(is_new)
    {
      const Point &p = surface.points[a], &q = surface.points[b];
      result.points.push_back({(p[0] + q[0]) / 2., (p[1] + q[1]) / 2., (p[2] + q[2]) / 2.});
    }
    return entry->second;
  };
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
  {
    const Index *k = &surface.corners[c],
                m[] = {edge_midpoint(k[0], k[1]), edge_midpoint(k[1], k[2]),
                       edge_midpoint(k[2], k[0])};
    for(const Index corner :
        {k[0], m[0], m[2], m[0], k[1], m[1], m[2], m[1], k[2], m[0], m[1], m[2]})
      result.corners.push_back(corner);
  }
  return result;
}

TEST(Window_propagation, finds_all_shortest_paths_on_platonic_solids)
{
  const Triangulation octahedron{
      {{1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}, {0., 0., 1.}, {0., 0., -1.}},
      {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5}};
  const Triangulation cube{{{0., 0., 0.},
                            {1., 0., 0.},
                            {1., 1., 0.},
                            {0., 1., 0.},
                            {0., 0., 1.},
                            {1., 0., 1.},
                            {1., 1., 1.},
                            {0., 1., 1.}},
                           {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                            1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7}};
  // Octahedron: through the centers of four pairs of faces. Cube: over six edges.
  struct Case
  {
    Triangulation surface;
    Index from, to;
    std::size_t paths;
    double length;
  };
  std::vector<Case> cases = {{octahedron, 4, 5, 4, std::sqrt(6.)}, {cube, 0, 6, 6, std::sqrt(5.)}};
  for(int level = 0; level < 3; ++level)
    for(Case& solid : cases)
    {
      const Array_surface surface(solid.surface);
      Window_propagation windows(surface.triangles());
      ASSERT_TRUE(windows.run({surface.source(solid.from)}));
      EXPECT_NEAR(surface.scale() * windows.distance(surface.vertex(solid.to)), solid.length,
                  round_off);
      EXPECT_EQ(number_of_paths(surface, windows, surface.at(solid.to)), solid.paths);
      solid.surface = subdivide(solid.surface);
    }
}

TEST(Window_propagation, finds_shortest_paths_on_both_sides_of_hole)
{
  // A square with a square hole in the center: the paths to the left and right of it are equally
  // long.
  const std::size_t n = 12;
  Triangulation ring = square(n);
  std::vector<Index> corners;
  for(std::size_t f = 0; 3 * f < ring.corners.size(); ++f)
  {
    const std::size_t column = f / 2 % n, row = f / 2 / n;
    if(column < 4 || column >= 8 || row < 4 || row >= 8)
      corners.insert(corners.end(), &ring.corners[3 * f], &ring.corners[3 * f] + 3);
  }
  ring.corners = corners;
  const Array_surface surface(ring);
  const auto at = [&](std::size_t column, std::size_t row)
  { return Index(column + (n + 1) * row); };
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(at(6, 0))}));
  EXPECT_NEAR(surface.scale() * windows.distance(surface.vertex(at(6, 12))),
              1. / 3. + 2. * std::hypot(1. / 6., 1. / 3.), round_off);
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(6, 12))), 2u);
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(5, 12))), 1u);
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(6, 0))), 1u); // of length 0
  // Two point sources, to the left and right of the hole; then two segments.
  ASSERT_TRUE(windows.run({surface.source(at(0, 6)), surface.source(at(12, 6))}));
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(6, 12))), 2u);
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(6, 10))), 2u);
  std::vector<Index> left, right;
  for(std::size_t row = 0; row <= n; ++row)
  {
    left.push_back(at(0, row));
    right.push_back(at(12, row));
  }
  ASSERT_TRUE(windows.run({surface.line(left), surface.line(right)}));
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(6, 10))), 2u);
  EXPECT_EQ(number_of_paths(surface, windows, surface.at(at(5, 10))), 1u);
}

TEST(Window_propagation, shortest_path_is_unique_off_cut_locus)
{
  // Random locations, and vertices of surfaces without symmetry, are not on the cut locus. On a
  // cylinder the vertices opposite to the source are.
  for(const Triangulation& shape :
      {square(12, 0.24), jittered(icosphere(3), 0.02), jittered(cone(12, 6, 5.), 0.02),
       jittered(cone(12, 6, 8.), 0.02), hilly_square(12, 0.2)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    std::mt19937 random(1);
    Window_propagation windows(surface.triangles());
    for(const auto& source : {surface.source(surface.size() / 3), surface.source(0, 0.7),
                              surface.source(random_location(t, random))})
    {
      ASSERT_TRUE(windows.run({source}));
      for(int i = 0; i < 20; ++i)
      {
        EXPECT_EQ(number_of_paths(surface, windows, random_location(t, random), source.offset), 1u);
        EXPECT_EQ(
            number_of_paths(surface, windows, surface.at(random() % surface.size()), source.offset),
            1u);
      }
    }
  }
  const Triangulation pipe = rings(
      16, 8, [](double) { return 1.; }, [](double s) { return 2. * s; }, 0.);
  const Array_surface surface(pipe);
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(Index(16 * 2))}));
  for(const Index ring : {0, 1, 3, 5, 8})
  {
    EXPECT_EQ(number_of_paths(surface, windows, surface.at(16 * ring + 8)), 2u);
    EXPECT_EQ(number_of_paths(surface, windows, surface.at(16 * ring + 7)), 1u);
  }
}

TEST(Window_propagation, passes_pinched_vertex)
{
  // Two squares that share a vertex: the last one of the first, the first one of the second.
  Triangulation shape = square(8, 0.24), other = square(8, 0.24, 2);
  const Index shared = Index(shape.points.size()) - 1, first = Index(shape.points.size());
  for(const Point& p : other.points)
    shape.points.push_back({1. + p[0], 1. + p[1], 0.});
  for(const Index corner : other.corners)
    shape.corners.push_back(corner == 0 ? shared : first + corner);
  const Array_surface surface(shape);
  const auto d = run(surface, {surface.source(3)});
  const Point pinch = {1., 1., 0.};
  EXPECT_LT(largest_error(d,
                          [&](Index i)
                          {
                            if(i == first) // isolated
                              return infinity;
                            return i < first ? distance(shape.points[i], shape.points[3])
                                             : distance(pinch, shape.points[3]) +
                                                   distance(pinch, shape.points[i]);
                          }),
            round_off);
}

TEST(Window_propagation, handles_needles_and_zero_length_edges)
{
  // A square with columns of zero and of nearly zero width, a square projected to a line,
  // coincident vertices, and two coincident faces without area.
  Triangulation squeezed = square(12);
  for(Point& p : squeezed.points)
    p[0] = p[0] < 0.3 ? p[0] : p[0] < 0.6 ? 0.3 : p[0] < 0.9 ? 0.3 + 1e-13 * p[0] : p[0];
  Triangulation flat = scaled(square(12, 0.24), 1., 0., 0.), point = scaled(square(6), 0., 0., 0.);
  const Triangulation pillow{{{0., 0., 0.}, {1., 0., 0.}, {3., 0., 0.}}, {0, 1, 2, 0, 2, 1}};
  const Triangulation thin{{{0., 0., 0.}, {1., 1e-9, 0.}, {3., 0., 0.}}, {0, 1, 2, 0, 2, 1}};
  for(const Triangulation& shape : {squeezed, flat, point, pillow, thin})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    for(const Index source : {Index(0), Index(surface.size() / 2)})
    {
      const auto d = run(surface, {surface.source(source)});
      for(Index i = 0; i < surface.size(); ++i)
      {
        EXPECT_TRUE(std::isfinite(d[i]));
        // At least the Euclidean distance in space.
        EXPECT_GE(d[i], distance(shape.points[i], shape.points[source]) - round_off);
      }
      for(Index h = 0; h < t.corner.size(); ++h)
        EXPECT_LE(d[surface.caller_vertex(t.corner[h])],
                  d[surface.caller_vertex(t.corner[next_halfedge(h)])] +
                      t.length[h] * t.scale * (1. + round_off) + round_off);
    }
  }
}

TEST(Window_propagation, distances_do_not_depend_on_triangulation)
{
  // Stretched triangles with bends, and the intrinsic Delaunay triangulation of the same surface.
  std::mt19937 random(4);
  std::uniform_real_distribution<double> height(-0.03, 0.03);
  const Array_surface surface(grid(
      12, 60,
      [&](double u, double v) {
        return Point{3. * u, v, height(random)};
      },
      0.24));
  const Intrinsic_triangulation delaunay(surface.t());
  ASSERT_FALSE(delaunay.is_empty());
  Window_propagation on_mesh(surface.triangles()), on_delaunay(delaunay.triangles());
  for(const Index source : {0u, 400u})
  {
    on_mesh.run({surface.source(source)});
    on_delaunay.run({surface.source(source)});
    for(Index i = 0; i < surface.size(); ++i)
      // Each flip has round-off errors of 1e-16 in the lengths of edges of needles.
      EXPECT_NEAR(on_mesh.distance(i), on_delaunay.distance(i), 1e-11) << i;
  }
}

// Surfaces on which waves diverge, converge, bend around obstacles and meet.
std::vector<Triangulation> surfaces_for_approximation()
{
  return {jittered(icosphere(4), 0.1), // waves converge behind the equator
          grid(
              40, 40,
              [](double u, double v) {
                return Point{u, v, 0.15 * std::sin(9. * u) * std::cos(7. * v)};
              },
              0.24),
          square(20, 0.24), cylinder(200, 3, 1., 1e-3),
          grid(
              24, 24,
              [](double u, double v) {
                return Point{u, v, 0.05 * std::sin(1e5 * u + 3e4 * v)};
              },
              0.24)};
}

TEST(Window_propagation, relative_tolerance_gives_certified_bounds)
{
  for(const Triangulation& shape : surfaces_for_approximation())
  {
    const Array_surface surface(shape);
    Window_propagation exact(surface.triangles()), approximate(surface.triangles());
    for(const double tolerance : {1e-6, 1e-3, 0.1})
      for(const Index source : {Index(0), surface.size() / 2})
      {
        exact.run({surface.source(source)});
        Front_limits limits;
        limits.relative_tolerance = tolerance;
        approximate.run({surface.source(source)}, limits);
        // The bounds contain the errors of thin triangles.
        const Distance_error error = distance_error_of_thin_triangles(surface.t());
        for(Index i = 0; i < surface.size(); ++i)
        {
          const double distance = exact.distance(i);
          EXPECT_LE(approximate.lower(i), distance * (1. + round_off));
          EXPECT_GE(approximate.upper(i), distance * (1. - round_off));
          // Errors are stored as floats.
          EXPECT_LE(approximate.upper(i) - error.shortfall,
                    (approximate.lower(i) + error.excess) * (1. + tolerance * (1. + 1e-6)));
          EXPECT_NEAR(approximate.distance(i), 0.5 * (approximate.lower(i) + approximate.upper(i)),
                      0.5 * (error.excess + error.shortfall) + round_off);
        }
      }
  }
}

// In a rectangle that is far wider than high, merged windows have sources far away, and differences
// of distances that are only round-off errors.
TEST(Window_propagation, relative_tolerance_gives_certified_bounds_on_needles)
{
  for(const double height : {1e-3, 3e-7, 1e-8})
    for(unsigned seed = 1; seed <= 6; ++seed)
    {
      const Array_surface surface(scaled(square(40, 0.1, seed), 1., height, 1.));
      Window_propagation windows(surface.triangles());
      const Index source = 17 * 41 + 13;
      Front_limits limits;
      limits.relative_tolerance = 1e-3;
      windows.run({surface.source(source)}, limits);
      for(Index i = 0; i < surface.size(); ++i)
      {
        const double distance = norm(surface.point(i) - surface.point(source)) / surface.scale();
        EXPECT_LE(windows.lower(surface.vertex(i)), distance * (1. + round_off));
        EXPECT_GE(windows.upper(surface.vertex(i)), distance * (1. - round_off));
      }
    }
}

TEST(Window_propagation, without_tolerance_bounds_equal_distance)
{
  const Array_surface surface(icosphere(3));
  Window_propagation windows(surface.triangles());
  Front_limits limits;
  limits.relative_tolerance = 0.1;
  windows.run({surface.source(0)}, limits);
  ASSERT_LT(windows.lower(50), windows.upper(50));
  windows.run({surface.source(0)});
  Window_propagation fresh(surface.triangles());
  fresh.run({surface.source(0)});
  for(Index i = 0; i < surface.size(); ++i)
  {
    EXPECT_EQ(windows.distance(i), fresh.distance(i));
    EXPECT_EQ(windows.lower(i), windows.distance(i));
    EXPECT_EQ(windows.upper(i), windows.distance(i));
  }
}

TEST(Window_propagation, bounds_at_locations_contain_exact_distance)
{
  const Array_surface surface(jittered(icosphere(3), 0.1));
  Window_propagation exact(surface.triangles()), approximate(surface.triangles());
  // A point in a face, and a polyline.
  std::mt19937 random(2);
  const Front_source point = surface.source(random_location(surface.t(), random), 0.1),
                     line = surface.line({0, 162, 42});
  Front_limits limits;
  limits.relative_tolerance = 0.01;
  // Some triangles are thin; the bounds contain their errors.
  const Distance_error error = distance_error_of_thin_triangles(surface.t());
  for(const Front_source& source : {point, line})
  {
    exact.run({source});
    approximate.run({source}, limits);
    std::vector<Surface_location> locations;
    for(int i = 0; i < 50; ++i)
      locations.push_back(random_location(surface.t(), random));
    const std::vector<double> distances = approximate.distances(locations);
    for(std::size_t i = 0; i < locations.size(); ++i)
    {
      const double distance = exact.distance(locations[i]);
      const Distance_bounds bounds = approximate.bounds(locations[i]);
      EXPECT_LE(bounds.lower, distance * (1. + round_off));
      EXPECT_GE(bounds.upper, distance * (1. - round_off));
      // Errors are stored as floats.
      EXPECT_LE(bounds.upper, bounds.lower * (1. + 0.01 * (1. + 1e-6)));
      EXPECT_NEAR(distances[i], 0.5 * (bounds.lower + bounds.upper),
                  0.5 * (error.excess + error.shortfall) + round_off);
      const Bounded_path path = approximate.path(locations[i]);
      // The offset of the source is no part of the path.
      EXPECT_NEAR(path.lower, bounds.lower - source.offset, round_off * bounds.lower);
      EXPECT_GE(path_length(surface.t(), path.locations), path.lower * (1. - round_off));
    }
    EXPECT_THROW(approximate.paths(locations[0], 1e-9), Unsupported_surface_error);
    EXPECT_THROW(approximate.departure(locations[0]), Unsupported_surface_error);
    EXPECT_THROW(approximate.polar_angle_of_departure(5), Unsupported_surface_error);
  }
}

TEST(Window_propagation, relative_tolerance_keeps_sources_apart_and_obstacles_closed)
{
  const Array_surface surface(square(16, 0.24));
  Window_propagation exact(surface.triangles()), approximate(surface.triangles());
  std::vector<double> slowness(surface.t().number_of_triangles(), 2.);
  for(Index f = 0; f < slowness.size(); f += 7)
    slowness[f] = infinity;
  Front_limits limits;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  const std::vector<Front_source> sources = {surface.source(0, 0., 3), surface.source(200, 0.2, 5)};
  exact.run(sources, limits);
  limits.relative_tolerance = 1e-3;
  approximate.run(sources, limits);
  for(Index i = 0; i < surface.size(); ++i)
  {
    if(!(exact.distance(i) < infinity))
    {
      EXPECT_EQ(approximate.upper(i), infinity);
      continue;
    }
    EXPECT_LE(approximate.lower(i), exact.distance(i) * (1. + round_off));
    EXPECT_GE(approximate.upper(i), exact.distance(i) * (1. - round_off));
    const Bounded_path path = approximate.path(surface.at(i));
    for(std::size_t k = 1; k < path.locations.size(); ++k)
    {
      const Index triangle = common_triangle(surface.t(), path.locations[k - 1], path.locations[k]);
      if(vertex_of(surface.t(), path.locations[k - 1]) == none &&
         vertex_of(surface.t(), path.locations[k]) == none)
      {
        EXPECT_LT(slowness[triangle], infinity);
      }
    }
  }
}

TEST(Window_propagation, terminates_on_needles_and_spikes)
{
  // Two coincident thin faces that a geodesic crosses alternately, and spikes 1,000 times as high
  // as wide around which geodesics wind.
  const Triangulation pillow{{{0., 0., 0.}, {1., 1e-6, 0.}, {3., 0., 0.}}, {0, 1, 2, 0, 2, 1}};
  const Triangulation spikes = grid(
      24, 24,
      [](double u, double v) {
        return Point{u, v, 40. * std::sin(1e5 * u + 3e4 * v)};
      },
      0.24);
  for(const Triangulation& shape : {pillow, spikes})
  {
    const Array_surface surface(shape);
    const Index a = 0, b = surface.size() / 2;
    const double there = run(surface, {surface.source(a)})[b],
                 back = run(surface, {surface.source(b)})[a];
    EXPECT_NEAR(there, back, round_off * there);
    EXPECT_GE(there, distance(shape.points[a], shape.points[b]) * (1. - round_off));
  }
}

TEST(Window_propagation, throws_on_point_sets_and_speeds)
{
  auto cloud = std::make_shared<Surface_arrays>();
  cloud->graph.begin = {0};
  EXPECT_THROW(Window_propagation{cloud}, Unsupported_surface_error);
  const Array_surface surface(square(2));
  Window_propagation windows(surface.triangles());
  std::vector<double> slowness(8, 1.);
  slowness[3] = 2.;
  Front_limits limits;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  EXPECT_THROW(windows.run({surface.source(0)}, limits), Unsupported_surface_error);
}

// The slowness that makes an obstacle of each triangle for which the predicate is true.
template <typename Predicate>
std::vector<double> obstacles(const Surface_arrays& t, const Predicate& is_obstacle,
                              double slowness = 1.)
{
  std::vector<double> result(t.number_of_triangles(), slowness);
  for(Index f = 0; f < result.size(); ++f)
    if(is_obstacle(f))
      result[f] = infinity;
  return result;
}

TEST(Window_propagation, distances_around_obstacles_are_those_without_their_triangles)
{
  // The quarter of the square that l_shaped_room() omits.
  const std::size_t n = 12;
  const Array_surface full(square(n)), room(l_shaped_room(n, 0.));
  const auto is_in_quarter = [&](Index f)
  {
    const Surface_arrays& t = full.t();
    double x = 0., y = 0.;
    for(Index k = 0; k < 3; ++k)
    {
      const Index i = full.caller_vertex(t.corner[3 * f + k]);
      x += double(i % (n + 1)) / double(n) / 3.;
      y += double(i / (n + 1)) / double(n) / 3.;
    }
    return x > 0.5 && y > 0.5;
  };
  for(const double slowness : {1., 3.})
  {
    Front_limits limits;
    limits.slowness =
        std::make_shared<const std::vector<double>>(obstacles(full.t(), is_in_quarter, slowness));
    Window_propagation windows(full.triangles()), expected(room.triangles());
    for(const Index source : {Index(0), Index(n), Index(5 * (n + 1) + 4)})
    {
      ASSERT_TRUE(windows.run({full.source(source)}, limits));
      ASSERT_TRUE(expected.run({room.source(source)}));
      const std::vector<double> distances = room.distances(expected);
      // The order of the triangles may differ.
      EXPECT_LE(
          largest_error(full.distances(windows), [&](Index i) { return slowness * distances[i]; }),
          slowness * round_off);
    }
    // The result of a query without obstacles is that of a new object.
    ASSERT_TRUE(windows.run({full.source(0)}));
    EXPECT_EQ(full.distances(windows), run(full, {full.source(0)}));
  }
}

TEST(Window_propagation, path_and_departure_avoid_obstacles)
{
  const Array_surface surface(square(10, 0.2));
  const Surface_arrays& t = surface.t();
  std::mt19937 random(2);
  std::vector<bool> is_obstacle(t.number_of_triangles());
  for(std::size_t f = 0; f < is_obstacle.size(); ++f)
    is_obstacle[f] = random() % 4 == 0;
  Front_limits limits;
  limits.slowness = std::make_shared<const std::vector<double>>(
      obstacles(t, [&](Index f) { return is_obstacle[f]; }));
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(60)}, limits));
  int number_of_paths = 0;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Surface_location from = {f, none, {0.2, 0.3, 0.5}};
    const double distance = windows.distance(from);
    const Bounded_path path = windows.path(from);
    EXPECT_EQ(path.locations.empty(), distance == infinity);
    if(is_obstacle[f])
    {
      EXPECT_EQ(distance, infinity);
    }
    if(distance == infinity)
      continue;
    ++number_of_paths;
    EXPECT_NEAR(path_length(t, path.locations), distance, round_off);
    EXPECT_NEAR(windows.departure(from).length, distance, round_off);
    EXPECT_LE(path.lower, distance);
    for(std::size_t i = 1; i < path.locations.size(); ++i)
    {
      // A segment inside a triangle or along an edge needs one triangle that is no obstacle.
      bool is_free = false;
      for(const Index triangle : triangles_at(t, path.locations[i]))
        is_free = is_free ||
                  (!is_obstacle[triangle] && barycentric_in(t, triangle, path.locations[i - 1]));
      EXPECT_TRUE(is_free);
    }
  }
  EXPECT_GT(number_of_paths, 50);
}

TEST(Window_propagation, distances_at_many_locations_equal_single_ones)
{
  for(const Triangulation& shape :
      {hilly_square(16, 0.2), jittered(icosphere(3), 0.1), l_shaped_room(12, 0.2)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = surface.t();
    std::mt19937 random(1);
    std::vector<Surface_location> locations;
    for(int i = 0; i < 60; ++i)
      locations.push_back(i % 3 == 0 ? surface.at(Index(random() % surface.size()))
                                     : random_location(t, random));
    locations.push_back(surface.on(3, 1, 0.3));
    Window_propagation windows(surface.triangles());
    const std::vector<std::vector<internal::Front_source>> queries = {
        {surface.source(0)},
        {surface.source(surface.size() / 3, 0.2), surface.source(random_location(t, random))},
        {{{surface.in(7, {0.2, 0.2, 0.6}), surface.in(7, {0.1, 0.8, 0.1})}, 0., 0}},
        {surface.line({0, 1, 2})}};
    for(const auto& sources : queries)
      for(const double maximum_distance : {infinity, 0.5})
      {
        Front_limits limits;
        limits.maximum_distance = maximum_distance / surface.scale();
        ASSERT_TRUE(windows.run(sources, limits));
        const std::vector<double> distances = windows.distances(locations);
        for(std::size_t i = 0; i < locations.size(); ++i)
        {
          const double expected = windows.distance(locations[i]);
          EXPECT_EQ(distances[i] < infinity, expected < infinity);
          if(expected < infinity)
          {
            EXPECT_NEAR(distances[i], expected, round_off);
          }
        }
      }
  }
}

TEST(Window_propagation, distance_at_a_target_crosses_edges_with_far_ends)
{
  // Needles across the way from the source to the target. Their ends are farther than the target.
  Triangulation strip;
  for(int i = 0; i <= 8; ++i)
    for(const double y : {-10., 10.})
      strip.points.push_back({0.1 * i, y + 0.01 * i, 0.});
  for(std::size_t i = 0; i + 3 < strip.points.size(); i += 2)
  {
    for(const std::size_t corner : {i, i + 2, i + 1, i + 1, i + 2, i + 3})
      strip.corners.push_back(Index(corner));
  }
  const Array_surface surface(strip);
  const Surface_location from = surface.in(0, {0.3, 0.3, 0.4}),
                         to = surface.in(15, {0.3, 0.3, 0.4});
  Front_limits limits;
  limits.targets = {to};
  Window_propagation windows(surface.triangles());
  ASSERT_TRUE(windows.run({surface.source(from)}, limits));
  const double expected =
      distance(point_at(surface.t(), from), point_at(surface.t(), to)) / surface.scale();
  EXPECT_NEAR(windows.distance(to), expected, round_off);
  EXPECT_NEAR(path_length(surface.t(), windows.path(to).locations), expected, round_off);
  limits.targets.clear();
  limits.maximum_distance = expected * 1.001;
  ASSERT_TRUE(windows.run({surface.source(from)}, limits));
  EXPECT_NEAR(windows.distance(to), expected, round_off);
}

} // namespace Window_propagation_test
