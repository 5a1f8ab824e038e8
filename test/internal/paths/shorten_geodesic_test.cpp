// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/shorten_geodesic.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>
#include "core/unfold.h"

#include "Array_surface.h"
#include "path_checks.h"

namespace shorten_geodesic_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Lengths are sums of at most a few thousand terms.
constexpr double round_off = 1e-12;

// Corners are cut if this shortens the path by more than round-off errors, which is quadratic in
// the angle. So the error of angles is at most the square root of round-off errors.
constexpr double angle_tolerance = 1e-6;

Locally_shortest_path checked_shortening(const Array_surface& surface,
                                         const std::vector<Surface_location>& path,
                                         double tolerance = angle_tolerance)
{
  const Surface_arrays& t = surface.t();
  const Locally_shortest_path result = shorten_geodesic(t, path);
  expect_path_on_surface(t, result.locations, path.front(), path.back());
  expect_locally_shortest(result, tolerance);
  const double length_before = path_length(t, path);
  EXPECT_LE(result.length, length_before * (1. + round_off));
  EXPECT_NEAR(result.length, path_length(t, result.locations), round_off * length_before);
  EXPECT_NEAR(shorten_geodesic(t, result.locations).length, result.length,
              round_off * length_before);
  return result;
}

TEST(Shorten_geodesic, is_exact_on_irregular_flat_mesh)
{
  const Array_surface surface(square(25, 0.25));
  Path_finder finder(surface.triangles());
  std::mt19937 random(1);
  for(int i = 0; i < 200; ++i)
  {
    const Surface_location p = random_location(surface.t(), random);
    const Surface_location q =
        i % 2 == 0 ? random_location(surface.t(), random) : surface.at(Index(random() % (26 * 26)));
    const auto path = checked_shortening(surface, finder(p, q));
    const double expected = distance(point_at(surface.t(), p), point_at(surface.t(), q));
    EXPECT_NEAR(path.length * surface.t().scale, expected, round_off);
  }
}

TEST(Shorten_geodesic, is_exact_through_lattice_vertices)
{
  const Array_surface surface(square(16));
  // The path follows the lower and the right boundary. The shortest path is the diagonal.
  std::vector<Index> vertices;
  for(Index i = 0; i <= 16; ++i)
    vertices.push_back(i);
  for(Index j = 1; j <= 16; ++j)
    vertices.push_back(16 + 17 * j);
  const auto path = checked_shortening(surface, surface.along(vertices));
  EXPECT_NEAR(path.length * surface.t().scale, std::sqrt(2.), round_off);
}

TEST(Shorten_geodesic, keeps_homotopy_class_around_cone_apex)
{
  const std::size_t n = 12;
  const double total = 1.5 * pi, step = total / n;
  const Array_surface surface(cone(n, 5, total));
  // From ring 4 in direction 0 to ring 3 in direction k, along ring 4 counterclockwise.
  for(Index k = 1; k < n; ++k)
  {
    std::vector<Index> vertices;
    for(Index i = 0; i <= k; ++i)
      vertices.push_back(Index(1 + n * 4 + i));
    vertices.push_back(Index(1 + n * 3 + k));
    const auto path = checked_shortening(surface, surface.along(vertices));
    // If the angle at the apex is below pi, the path stays on this side; otherwise it passes to the
    // other side.
    const double angle = k * step < pi ? k * step : total - k * step;
    EXPECT_NEAR(path.length * surface.t().scale, std::sqrt(25. + 16. - 2. * 20. * std::cos(angle)),
                10. * round_off)
        << k;
  }
}

TEST(Shorten_geodesic, passes_through_saddle_vertex)
{
  const std::size_t n = 12;
  const Array_surface surface(cone(n, 5, 3. * pi));
  std::vector<Index> vertices;
  for(Index i = 0; i <= 6; ++i)
    vertices.push_back(Index(1 + n * 4 + i));
  const auto path = checked_shortening(surface, surface.along(vertices));
  EXPECT_NEAR(path.length * surface.t().scale, 10., 10. * round_off);
  double min_angle = 0.;
  for(const Touched_vertex& touched : path.touched_vertices)
    if(vertex_of(surface.t(), path.locations[touched.location_index]) == surface.vertex(0))
      min_angle = std::min(touched.left_angle, touched.right_angle);
  EXPECT_NEAR(min_angle, 1.5 * pi, round_off);
}

TEST(Shorten_geodesic, keeps_winding_number_on_cylinder)
{
  const std::size_t n = 10, number_of_rings = 8;
  const double edge_length = 2. * std::sin(pi / n), perimeter = n * edge_length;
  const Array_surface surface(cylinder(n, number_of_rings, 1., 3.));
  for(Index number_of_turns = 1; number_of_turns < 4; ++number_of_turns)
  {
    // The path goes around ring 2 several times and then up two rings, which are rotated by one
    // step.
    std::vector<Index> vertices;
    for(Index i = 0; i <= number_of_turns * n; ++i)
      vertices.push_back(Index(2 * n + i % n));
    vertices.push_back(Index(3 * n));
    vertices.push_back(Index(4 * n));
    // Consecutive rings are rotated by half a step, so that the surface is not a prism and the
    // exact length is unknown. The test checks that the path is locally shortest and still winds.
    const auto path = checked_shortening(surface, surface.along(vertices));
    EXPECT_GT(path.length * surface.t().scale, 0.95 * number_of_turns * perimeter);
  }
  // A closed path around the cylinder, from a vertex to itself.
  std::vector<Index> loop;
  for(Index i = 0; i <= n; ++i)
    loop.push_back(Index(4 * n + i % n));
  const auto path = shorten_geodesic(surface.t(), surface.along(loop));
  // The three angles above and below each vertex of a ring add up to pi: it is a geodesic.
  EXPECT_GE(path.length * surface.t().scale, perimeter * (1. - round_off));
  EXPECT_LE(path.length * surface.t().scale, perimeter * (1. + round_off));
}

TEST(Shorten_geodesic, is_exact_on_prism)
{
  // The rings are not rotated, so that the surface unrolls to a flat band.
  const std::size_t n = 10;
  const double perimeter = n * 2. * std::sin(pi / n);
  const Array_surface surface(rings(
      n, 8, [](double) { return 1.; }, [](double s) { return 3. * s; }, 0.));
  for(Index number_of_turns = 0; number_of_turns < 4; ++number_of_turns)
    for(Index extra = 0; extra < n; ++extra)
    {
      std::vector<Index> vertices;
      for(Index i = 0; i <= number_of_turns * n + extra; ++i)
        vertices.push_back(Index(i % n));
      for(Index j = 1; j <= 8; ++j)
        vertices.push_back(Index(j * n + extra));
      const auto path = checked_shortening(surface, surface.along(vertices));
      EXPECT_NEAR(path.length * surface.t().scale,
                  std::hypot((number_of_turns + extra / double(n)) * perimeter, 3.),
                  100. * round_off);
    }
}

TEST(Shorten_geodesic, follows_boundary_of_hole)
{
  const std::size_t n = 24;
  const Array_surface surface(annulus(n, 4, 1., 3.));
  // The path follows half of the outer ring.
  std::vector<Index> vertices;
  for(Index i = 0; i <= n / 2; ++i)
    vertices.push_back(i);
  const auto path = checked_shortening(surface, surface.along(vertices));
  // The length is between those of the shortest paths around the inscribed and the circumscribed
  // circle of the hole.
  const auto taut_length = [](double r)
  { return 2. * std::sqrt(9. - r * r) + 2. * r * (pi / 2. - std::acos(r / 3.)); };
  EXPECT_GT(path.length * surface.t().scale, taut_length(std::cos(pi / n)) - round_off);
  EXPECT_LT(path.length * surface.t().scale, taut_length(1.) + round_off);
}

TEST(Shorten_geodesic, contracts_null_homotopic_loop)
{
  const Array_surface surface(square(8, 0.25));
  const auto path =
      shorten_geodesic(surface.t(), surface.along({20, 21, 22, 31, 40, 39, 38, 29, 20}));
  ASSERT_EQ(path.locations.size(), 1u);
  EXPECT_EQ(path.length, 0.);
}

TEST(Shorten_geodesic, keeps_single_locations_and_segments_in_one_triangle)
{
  const Array_surface surface(square(4, 0.2));
  const Surface_arrays& t = surface.t();
  std::mt19937 random(3);
  for(int i = 0; i < 20; ++i)
  {
    const Surface_location p = random_location(t, random);
    Surface_location q = random_location(t, random);
    q.triangle = p.triangle;
    EXPECT_EQ(shorten_geodesic(t, {p}).locations.size(), 1u);
    EXPECT_EQ(shorten_geodesic(t, {p, p}).locations.size(), 1u);
    const auto path = checked_shortening(surface, {p, q});
    EXPECT_EQ(path.locations.size(), 2u);
    EXPECT_NEAR(path.length * t.scale, distance(point_at(t, p), point_at(t, q)), round_off);
  }
  EXPECT_EQ(shorten_geodesic(t, {surface.at(7)}).length, 0.);
}

TEST(Shorten_geodesic, ends_on_edges)
{
  const Array_surface surface(square(12, 0.25));
  const Surface_arrays& t = surface.t();
  Path_finder finder(surface.triangles());
  std::mt19937 random(4);
  for(int i = 0; i < 100; ++i)
  {
    Surface_location p = random_location(t, random), q = random_location(t, random);
    p.barycentric = barycentric_on_halfedge(Index(random() % 3), 0.3);
    q.barycentric = i % 3 == 0 ? std::array<double, 3>{0.5, 1e-15, 0.5 - 1e-15}
                               : barycentric_on_halfedge(Index(random() % 3), 0.999);
    const auto path = checked_shortening(surface, finder(p, q));
    EXPECT_NEAR(path.length * t.scale, distance(point_at(t, p), point_at(t, q)), round_off);
  }
}

TEST(Shorten_geodesic, passes_straight_through_pinched_vertex)
{
  //  0---1      4
  //   \ / \    / \       two fans share vertex 2 only
  //    5---2--+   |
  //        |   \ /
  const Array_surface surface(
      Triangulation{{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}},
                    {0, 1, 2, 0, 3, 4}});
  const auto path = checked_shortening(surface, surface.along({1, 0, 3}));
  EXPECT_NEAR(path.length * surface.t().scale, 2., round_off);
  ASSERT_EQ(path.touched_vertices.size(), 1u);
  EXPECT_EQ(path.touched_vertices[0].left_angle, infinity);
  EXPECT_EQ(path.touched_vertices[0].right_angle, infinity);
}

TEST(Shorten_geodesic, shortens_random_walks_on_rough_surfaces)
{
  for(unsigned seed = 1; seed <= 6; ++seed)
  {
    // Edges are about 0.15 long: the surfaces range from smooth to crumpled.
    const Array_surface surface(jittered(icosphere(3), 0.02 * seed, seed));
    const Surface_arrays& t = surface.t();
    std::mt19937 random(seed);
    for(int i = 0; i < 60; ++i)
    {
      // A random walk along edges has many loops and reversals.
      Index vertex = Index(random() % t.number_of_vertices());
      std::vector<Surface_location> path = {vertex_location(t, vertex)};
      for(int k = 0; k < 40; ++k)
      {
        const Index degree = t.ring_begin[vertex + 1] - t.ring_begin[vertex];
        vertex = t.corner[next_halfedge(t.ring[t.ring_begin[vertex] + random() % degree])];
        path.push_back(vertex_location(t, vertex));
      }
      const Locally_shortest_path result = shorten_geodesic(t, path);
      expect_path_on_surface(t, result.locations, path.front(), path.back());
      expect_locally_shortest(result, angle_tolerance);
      EXPECT_LE(result.length, path_length(t, path) * (1. + round_off));
      EXPECT_NEAR(result.length, path_length(t, result.locations), 10. * round_off);
    }
  }
}

TEST(Shorten_geodesic, is_scale_invariant)
{
  Triangulation surface = jittered(icosphere(3), 0.03);
  const Array_surface reference(surface);
  for(const double unit : {1e-8, 1e8, 1e-150, 1e150})
  {
    Triangulation scaled = surface;
    for(Point& p : scaled.points)
      for(double& x : p)
        x *= unit;
    const Array_surface other(scaled);
    Path_finder finder(reference.triangles()), other_finder(other.triangles());
    for(Index k = 1; k < 600; k += 50)
    {
      const auto a = shorten_geodesic(reference.t(), finder(reference.at(0), reference.at(k)));
      const auto b = shorten_geodesic(other.t(), other_finder(other.at(0), other.at(k)));
      EXPECT_NEAR(b.length * (other.t().scale / unit), a.length * reference.t().scale, round_off);
    }
  }
}

TEST(Shorten_geodesic, handles_slivers_and_zero_length_edges)
{
  Triangulation flat = square(10);
  // Two columns of points coincide, and two rows almost do.
  for(std::size_t i = 0; i < flat.points.size(); ++i)
  {
    const std::size_t column = i % 11, row = i / 11;
    if(column == 4)
      flat.points[i][0] = 0.3;
    if(row == 5)
      flat.points[i][1] = 0.6 - 1e-9;
  }
  const Array_surface surface(flat);
  const Surface_arrays& t = surface.t();
  Path_finder finder(surface.triangles());
  std::mt19937 random(5);
  for(int i = 0; i < 200; ++i)
  {
    const Index p = Index(random() % 121), q = Index(random() % 121);
    const auto chain = finder(surface.at(p), surface.at(q));
    const auto path = shorten_geodesic(t, chain);
    expect_path_on_surface(t, path.locations, surface.at(p), surface.at(q));
    EXPECT_LE(path.length, path_length(t, chain) * (1. + round_off) + round_off);
    // The straight line is found across the degenerate triangles. The error is at most the width
    // of the slivers.
    EXPECT_NEAR(path.length * t.scale, distance(flat.points[p], flat.points[q]), 2e-9);
    expect_locally_shortest(path, angle_tolerance);
  }
}

TEST(Shorten_geodesic, is_locally_shortest_at_coincident_vertices)
{
  Triangulation sphere = icosphere(2);
  // Merge the endpoints of an edge, and all corners of another triangle.
  sphere.points[sphere.corners[0]] = sphere.points[sphere.corners[1]];
  for(std::size_t k = 1; k < 3; ++k)
    sphere.points[sphere.corners[600 + k]] = sphere.points[sphere.corners[600]];
  const Array_surface surface(sphere);
  Path_finder finder(surface.triangles());
  for(Index from = 0; from < surface.size(); from += 3)
    for(Index to = 0; to < surface.size(); ++to)
    {
      const auto path = shorten_geodesic(surface.t(), finder(surface.at(from), surface.at(to)));
      expect_locally_shortest(path, angle_tolerance);
    }
}

TEST(Shorten_geodesic, throws_on_invalid_path)
{
  const Array_surface surface(square(4));
  EXPECT_THROW(shorten_geodesic(surface.t(), {}), Invalid_argument_error);
  EXPECT_THROW(shorten_geodesic(surface.t(), surface.along({0, 24})), Invalid_argument_error);
}

} // namespace shorten_geodesic_test
