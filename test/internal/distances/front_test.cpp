// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <thread>

namespace front_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Kind = Front_kind;
constexpr Kind all_kinds[] = {Kind::dijkstra, Kind::planar, Kind::euclidean};

// Final vertices are corrected only if their distance changes by more than 1e-12. On these
// surfaces smaller errors are propagated some tens of times.
constexpr double flat_tolerance = 1e-10;
// Round-off error of a sum of some hundred lengths.
constexpr double round_off = 1e-12;

std::vector<double> run(const Array_surface& surface, Kind kind,
                        const std::vector<internal::Front_source>& sources,
                        const Front_limits& limits = {})
{
  Front front(surface.triangles(), kind);
  EXPECT_TRUE(front.run(sources, limits));
  return surface.distances(front);
}

Triangulation stretched_square(std::size_t n, double width, double height, unsigned seed)
{
  return grid(
      n, n,
      [=](double u, double v) {
        return Point{width * u, height * v, 0.};
      },
      0.24, seed);
}

Triangulation prism(std::size_t n, std::size_t rows, double width, double height)
{
  const double radius = 0.5 * width / std::sin(pi / n);
  return rings(
      n, rows, [=](double) { return radius; }, [=](double s) { return s * height; }, 0.);
}

TEST(Front, is_exact_on_flat_convex_meshes)
{
  // Angles up to 145 degrees.
  for(const unsigned seed : {1u, 2u, 3u, 4u, 5u})
  {
    const Triangulation plane = square(30, 0.24, seed);
    const Array_surface surface(plane);
    for(const Index source : {0, 15 * 31 + 15, 30, 7 * 31 + 22, 28 * 31 + 3})
    {
      const auto d = run(surface, Kind::euclidean, {surface.source(source)});
      EXPECT_LT(largest_error(d, [&](Index i)
                              { return distance(plane.points[i], plane.points[source]); }),
                flat_tolerance);
    }
  }
}

TEST(Front, is_exact_on_flat_meshes_of_obtuse_triangles)
{
  // Angles up to 168 degrees. A vertex may propagate before the correct front arrives around a
  // needle. Then its descendants must be invalidated.
  for(const double height : {0.2, 0.3, 5.})
    for(const unsigned seed : {1u, 2u, 3u})
    {
      const std::size_t n = height == 0.3 ? 150 : 30;
      const Triangulation plane = stretched_square(n, 1., height, seed);
      const Array_surface surface(plane);
      for(const std::size_t source : {std::size_t(0), n / 2 * (n + 2), n})
      {
        const auto d = run(surface, Kind::euclidean, {surface.source(Index(source))});
        EXPECT_LT(largest_error(d, [&](Index i)
                                { return distance(plane.points[i], plane.points[source]); }),
                  flat_tolerance * std::max(1., height));
      }
    }
}

TEST(Front, is_exact_on_cylinder)
{
  const std::size_t n = 24;
  const double width = 0.25;
  const Triangulation cylinder = prism(n, 30, width, 4.);
  const Array_surface surface(cylinder);
  for(const Index source : {Index(0), Index(15 * n + 3)})
  {
    const auto d = run(surface, Kind::euclidean, {surface.source(source)});
    const auto exact_distance = [&](Index i)
    {
      const std::size_t steps = (i + n - source % n) % n;
      return std::hypot(width * std::min(steps, n - steps),
                        cylinder.points[i][2] - cylinder.points[source][2]);
    };
    EXPECT_LT(largest_error(d, exact_distance), flat_tolerance * 4.);
  }
}

TEST(Front, is_exact_on_cones_and_behind_saddles)
{
  for(const double total_angle : {0.3 * pi, pi, 1.7 * pi, 2. * pi, 2.5 * pi, 3.5 * pi})
  {
    const Index n = 36, rows = 12;
    const Array_surface surface(cone(n, rows, total_angle));
    for(const Index ring : {Index(0), Index(5)})
    {
      const auto d = run(surface, Kind::euclidean, {surface.source(1 + n * ring)});
      const auto exact_distance = [&](Index i)
      {
        return i == 0 ? ring + 1.
                      : distance_on_cone(ring + 1., (i - 1) / n + 1., (i - 1) % n * total_angle / n,
                                         total_angle);
      };
      // If the total angle exceeds 3 pi, the boundary of the shadow passes through the interior of
      // triangles, in which a circle is fitted to the distances of two fronts.
      EXPECT_LT(largest_error(d, exact_distance),
                total_angle < 3. * pi ? flat_tolerance * rows : 0.01)
          << "total angle " << total_angle << " ring " << ring;
    }
    const auto d = run(surface, Kind::euclidean, {surface.source(0)});
    EXPECT_LT(largest_error(d, [&](Index i) { return i == 0 ? 0. : (i - 1) / n + 1.; }),
              flat_tolerance * rows);
  }
}

// A square without the wall [0.5, 0.5 + 1/n] x [0, 0.5]. Shortest paths bend at the wall's two
// upper corners.
struct Square_with_wall
{
  static constexpr std::size_t n = 32;
  Triangulation surface = square(n, 0.24);
  const Point corner[2] = {{0.5, 0.5, 0.}, {0.5 + 1. / n, 0.5, 0.}};

  Square_with_wall()
  {
    for(std::size_t j = 0; j <= n; ++j)
      for(std::size_t i = n / 2; i <= n / 2 + 1; ++i)
        surface.points[i + (n + 1) * j] = {double(i) / n, double(j) / n, 0.};
    for(std::size_t i = 0; i <= n; ++i) // the upper edge of the wall
      surface.points[i + (n + 1) * (n / 2)][1] = 0.5;
    std::vector<Index> corners;
    for(std::size_t cell = 0; cell < n * n; ++cell)
      if(cell % n != n / 2 || cell / n >= n / 2)
        corners.insert(corners.end(), surface.corners.begin() + 6 * cell,
                       surface.corners.begin() + 6 * cell + 6);
    surface.corners = corners;
  }

  bool is_visible(const Point& p, const Point& q) const
  {
    // In the wall's range of x, the segment must not be below the wall's upper edge.
    const double low = std::min(p[0], q[0]), high = std::max(p[0], q[0]);
    const double from = std::max(low, corner[0][0]), to = std::min(high, corner[1][0]);
    if(from >= to)
      return true;
    const auto height = [&](double x) { return p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]); };
    return std::min(height(from), height(to)) >= 0.5 - 1e-12;
  }

  double exact_distance(const Point& p, const Point& q) const
  {
    if(is_visible(p, q))
      return distance(p, q);
    double result = infinity;
    for(const Point& c : corner)
      for(const Point& e : corner)
        if(is_visible(p, c) && is_visible(e, q))
          result = std::min(result, distance(p, c) + distance(c, e) + distance(e, q));
    return result;
  }
};

TEST(Front, bends_around_boundary_corners)
{
  const Square_with_wall wall;
  const Array_surface surface(wall.surface);
  for(const Index source : {Index(0), Index(5 * 33 + 8), Index(12 * 33 + 14), Index(32)})
  {
    const auto d = run(surface, Kind::euclidean, {surface.source(source)});
    const auto exact_distance = [&](Index i)
    {
      // The isolated vertices inside the wall are not reached.
      return std::isinf(d[i])
                 ? infinity
                 : wall.exact_distance(wall.surface.points[source], wall.surface.points[i]);
    };
    // Errors of a fraction of an edge occur only along the boundary of the shadow, if a circle is
    // fitted to the distances of two fronts.
    EXPECT_LT(largest_error(d, exact_distance), 0.2 / wall.n) << "source " << source;
    EXPECT_LT(mean_relative_error(d, 1e-3, exact_distance), 5e-4) << "source " << source;
  }
}

// Returns the mean relative error at the vertices whose distance exceeds 5 % of the largest one.
double error_on_sphere(unsigned level, Kind kind)
{
  const Triangulation sphere = icosphere(level);
  const Array_surface surface(sphere);
  double sum = 0.;
  const Index sources[] = {0, 100, 517};
  for(const Index source : sources)
    sum += mean_relative_error(run(surface, kind, {surface.source(source)}), 0.05 * pi,
                               [&](Index i)
                               { return great_circle(sphere.points[source], sphere.points[i]); });
  return sum / 3.;
}

TEST(Front, converges_with_second_order_on_sphere)
{
  const double coarse = error_on_sphere(3, Kind::euclidean),
               middle = error_on_sphere(4, Kind::euclidean),
               fine = error_on_sphere(5, Kind::euclidean);
  // Each level halves the edges. The cut locus, at which the front meets itself, is a point.
  EXPECT_GT(std::log2(coarse / fine) / 2., 1.6);
  EXPECT_GT(std::log2(middle / fine), 1.5);
  EXPECT_LT(fine, 0.0015); // for 10,242 vertices
}

TEST(Front, is_accurate_on_skewed_grid)
{
  // A face of a cube projected to a sphere. If fronts enter each triangle only once, the errors
  // are up to 2.8 % (see reentry_ratio).
  const Triangulation cube_face = grid(60, 60,
                                       [](double u, double v)
                                       {
                                         const double x = 2. * u - 1., y = 2. * v - 1.,
                                                      size = std::sqrt(x * x + y * y + 1.);
                                         return Point{x / size, y / size, 1. / size};
                                       });
  const Array_surface surface(cube_face);
  for(const Index triangle : {100u, 3625u, 3638u, 3651u, 6053u, 7183u})
  {
    const std::array<double, 3> barycentric = {.52, .36, .12};
    Vec3 position = {0., 0., 0.};
    for(Index k = 0; k < 3; ++k)
      position = position + barycentric[k] * cube_face.points[cube_face.corners[3 * triangle + k]];
    const auto d =
        run(surface, Kind::euclidean, {surface.source(surface.in(triangle, barycentric))});
    for(Index i = 0; i < d.size(); ++i)
      // The error that reentry_ratio documents. The source is below the sphere by an eighth of a
      // squared edge length, 1e-4.
      EXPECT_NEAR(d[i] / great_circle(unit(position), cube_face.points[i]), 1.,
                  d[i] > 0.2 ? 2.5e-3 : 0.1)
          << triangle << " " << i;
  }
}

TEST(Front, planar_front_converges_with_first_order)
{
  const double coarse = error_on_sphere(3, Kind::planar), fine = error_on_sphere(5, Kind::planar);
  // The error is h log h: straight fronts are inaccurate close to the source. The logarithm
  // reduces the observed order by about one half.
  EXPECT_GT(std::log2(coarse / fine) / 2., 0.5);
  EXPECT_LT(fine, 0.02);
}

TEST(Front, planar_front_matches_five_point_scheme_on_right_triangles)
{
  // The upwind scheme of Rouy and Tourin on a grid, which the method of Kimmel and Sethian
  // generalizes.
  const std::size_t n = 20;
  const Array_surface surface(square(n));
  const auto d = run(surface, Kind::planar, {surface.source(Index(n))}); // at (1,0)
  const double h = 1. / n;
  std::vector<double> exact_distance(d.size());
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i) // i edges to the left of the source
    {
      double& value = exact_distance[j * (n + 1) + n - i];
      if(i == 0 || j == 0)
      {
        value = h * double(i + j);
        continue;
      }
      const double a = exact_distance[j * (n + 1) + n - i + 1],
                   b = exact_distance[(j - 1) * (n + 1) + n - i];
      value = 0.5 * (a + b + std::sqrt(2. * h * h - (a - b) * (a - b)));
    }
  EXPECT_LT(largest_error(d, [&](Index i) { return exact_distance[i]; }), round_off);
}

TEST(Front, dijkstra_is_not_consistent)
{
  // The distance along the diagonal that a regular grid does not contain.
  Triangulation plane = square(16);
  for(Point& p : plane.points)
    p[0] = 1. - p[0];
  for(std::size_t c = 0; c < plane.corners.size(); c += 3)
    std::swap(plane.corners[c], plane.corners[c + 1]);
  const Array_surface surface(plane);
  const auto d = run(surface, Kind::dijkstra, {surface.source(16)});
  EXPECT_NEAR(d[16 * 17], 2., round_off); // from (0,0) to (1,1): not sqrt(2)
}

TEST(Front, dijkstra_matches_bellman_ford)
{
  for(const Triangulation& surface : {jittered(icosphere(3), 0.02), Square_with_wall().surface,
                                      disjoint_union(square(7, 0.24), tetrahedron())})
  {
    // Reference: the Bellman-Ford algorithm.
    std::vector<double> exact_distance(surface.points.size(), infinity);
    exact_distance[3] = 0.25;
    exact_distance[20] = 0.;
    for(bool changes = true; changes;)
    {
      changes = false;
      for(std::size_t c = 0; c < surface.corners.size(); ++c)
      {
        const Index a = surface.corners[c], b = surface.corners[next_halfedge(Index(c))];
        const double length = distance(surface.points[a], surface.points[b]);
        for(const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
          if(exact_distance[from] + length < exact_distance[to])
          {
            exact_distance[to] = exact_distance[from] + length;
            changes = true;
          }
      }
    }
    const Array_surface arrays(surface);
    const auto d = run(arrays, Kind::dijkstra, {arrays.source(3, 0.25), arrays.source(20)});
    EXPECT_LT(largest_error(d, [&](Index i) { return exact_distance[i]; }), round_off);
  }
}

TEST(Front, lies_between_euclidean_and_graph_distance)
{
  for(const Triangulation& sphere : {jittered(icosphere(3), 0.05), jittered(icosphere(4), 0.02)})
  {
    const Array_surface surface(sphere);
    const auto edges = run(surface, Kind::dijkstra, {surface.source(5)});
    for(const Kind kind : {Kind::planar, Kind::euclidean})
    {
      const auto d = run(surface, kind, {surface.source(5)});
      for(Index i = 0; i < d.size(); ++i)
      {
        EXPECT_GE(d[i], distance(sphere.points[5], sphere.points[i]) * (1. - round_off));
        EXPECT_LE(d[i], edges[i] * (1. + round_off));
      }
    }
  }
}

TEST(Front, accepts_sources_in_triangles_and_on_edges)
{
  const Triangulation plane = stretched_square(20, 1., 0.7, 5);
  const Array_surface surface(plane);
  std::mt19937 random(1);
  for(int i = 0; i < 40; ++i)
  {
    Surface_location location = random_location(*surface.triangles(), random);
    if(i % 2 == 0)
      location = {location.triangle, none,
                  barycentric_on_halfedge(3 * location.triangle + i / 2 % 3, 0.3)};
    if(i % 5 == 0)
      location = {location.triangle, none, barycentric_at_corner(3 * location.triangle + i % 3)};
    const Point p = point_at(*surface.triangles(), location);
    const auto exact_distance = [&](Index k) { return distance(p, plane.points[k]); };
    EXPECT_LT(
        largest_error(run(surface, Kind::euclidean, {surface.source(location)}), exact_distance),
        flat_tolerance);
    // First order: the error is at most two edges.
    EXPECT_LT(largest_error(run(surface, Kind::planar, {surface.source(location)}), exact_distance),
              0.1);
  }
}

TEST(Front, is_exact_in_triangle_of_source)
{
  const Triangulation plane = stretched_square(6, 1., 0.4, 3);
  const Array_surface surface(plane);
  std::mt19937 random(2);
  for(int i = 0; i < 60; ++i)
  {
    const Surface_location from = random_location(*surface.triangles(), random);
    Surface_location to = random_location(*surface.triangles(), random);
    to.triangle = from.triangle;
    for(const Kind kind : all_kinds)
    {
      Front front(surface.triangles(), kind);
      front.run({surface.source(from)});
      EXPECT_NEAR(
          surface.scale() * front.distance(to),
          distance(point_at(*surface.triangles(), from), point_at(*surface.triangles(), to)),
          round_off);
    }
  }
}

TEST(Front, is_straight_next_to_polyline_source)
{
  // Half of the middle column of edges; both ends are inside the square. The front is straight to
  // the left and right, and circular around the ends.
  Triangulation plane = square(24, 0.24);
  std::vector<Index> line;
  for(Index j = 6; j <= 18; ++j)
  {
    line.push_back(12 + 25 * j);
    plane.points[line.back()] = {0.5, j / 24., 0.};
  }
  const Array_surface surface(plane);
  const Point a = plane.points[line.front()], b = plane.points[line.back()];
  const auto exact_distance = [&](Index i) { return distance_to_segment(plane.points[i], a, b); };
  // Vertices whose triangles contain only a vertex of the line are first reached from that vertex.
  const double edge_length = 1. / 24.;
  const auto d = run(surface, Kind::euclidean, {surface.line(line)});
  EXPECT_LT(largest_error(d, exact_distance), 0.1 * edge_length);
  EXPECT_LT(largest_error(run(surface, Kind::planar, {surface.line(line)}), exact_distance),
            edge_length);
  std::reverse(line.begin(), line.end());
  const auto reversed = run(surface, Kind::euclidean, {surface.line(line)});
  EXPECT_LT(largest_error(reversed, [&](Index i) { return d[i]; }), round_off);
}

TEST(Front, is_exact_from_polyline_across_faces)
{
  // The polyline x = 0.31 across a regular grid; its ends are inside faces.
  const std::size_t n = 10;
  const Triangulation plane = square(n);
  const Array_surface surface(plane);
  internal::Front_source source;
  const double fraction = 0.1; // of the column 0.3 .. 0.4
  for(Index j = 0; j < n; ++j)
  {
    // The corners of face 2 c are (0,0), (1,0), (1,1) of cell c, those of face 2 c + 1 are (0,0),
    // (1,1), (0,1).
    const Index cell = 3 + n * j;
    source.polyline.push_back(surface.in(2 * cell, {1. - fraction, fraction, 0.}));
    source.polyline.push_back(surface.in(2 * cell, {1. - fraction, 0., fraction}));
  }
  source.polyline.push_back(surface.in(2 * (3 + n * (n - 1)) + 1, {0., fraction, 1. - fraction}));
  const auto d = run(surface, Kind::euclidean, {source});
  EXPECT_LT(largest_error(d, [&](Index i) { return std::abs(plane.points[i][0] - 0.31); }),
            flat_tolerance);
}

TEST(Front, measures_distance_from_boundary_of_annulus)
{
  const Index n = 48, rows = 10;
  const Triangulation annulus_mesh =
      annulus(n, rows, 1., 3.); // the first row of points is the outer boundary
  const Array_surface surface(annulus_mesh);
  for(const Index first : {Index(0), Index(n * rows)})
  {
    std::vector<Index> boundary_loop(n + 1);
    for(Index i = 0; i <= n; ++i)
      boundary_loop[i] = first + i % n;
    const auto d = run(surface, Kind::euclidean, {surface.line(boundary_loop)});
    const auto exact_distance = [&](Index i)
    {
      double result = infinity;
      for(Index k = 0; k < n; ++k)
        result = std::min(result, distance_to_segment(annulus_mesh.points[i],
                                                      annulus_mesh.points[boundary_loop[k]],
                                                      annulus_mesh.points[boundary_loop[k + 1]]));
      return result;
    };
    // The error is a fraction of an edge of length 0.2 to 0.4, between the fronts of two segments.
    EXPECT_LT(largest_error(d, exact_distance), 0.1 * 0.3)
        << "from the border that begins at " << first;
  }
}

TEST(Front, does_not_mix_fronts_of_several_sources)
{
  const Triangulation plane = stretched_square(30, 1., 1., 9);
  const Array_surface surface(plane);
  std::mt19937 random(3);
  for(const bool has_offsets : {false, true})
    for(const std::size_t number_of_sources : {2u, 3u, 10u, 100u})
    {
      std::vector<internal::Front_source> sources;
      std::vector<Index> points;
      std::vector<double> offsets;
      for(std::size_t i = 0; i < number_of_sources; ++i)
      {
        points.push_back(Index(random() % plane.points.size()));
        offsets.push_back(has_offsets ? 0.05 * double(random() % 1000) / 1000. : 0.);
        sources.push_back(surface.source(points.back(), offsets.back(), Index(i)));
      }
      const auto to_source = [&](Index i, std::size_t k)
      { return offsets[k] + distance(plane.points[i], plane.points[points[k]]); };
      const auto exact_distance = [&](Index i)
      {
        double result = infinity;
        for(std::size_t k = 0; k < number_of_sources; ++k)
          result = std::min(result, to_source(i, k));
        return result;
      };
      Front front(surface.triangles(), Kind::euclidean);
      front.run(sources);
      const auto d = surface.distances(front);
      // If two fronts meet in a triangle, each may arrive along an edge, which is at most half of
      // an edge too long.
      const double edge_length = 1. / 30.;
      EXPECT_LT(largest_error(d, exact_distance), 0.5 * edge_length)
          << number_of_sources << " sources " << has_offsets;
      // Few vertices are affected: the measured mean errors are up to 2e-5.
      EXPECT_LT(mean_relative_error(d, edge_length, exact_distance), 1e-4)
          << number_of_sources << " sources " << has_offsets;
      // The distance to the reported source is close to the minimum.
      for(Index i = 0; i < d.size(); ++i)
        EXPECT_LT(to_source(i, front.source(surface.vertex(i))),
                  exact_distance(i) + 0.5 * edge_length);
    }
}

TEST(Front, is_independent_of_order_of_sources)
{
  const Array_surface surface(jittered(icosphere(4), 0.01));
  std::vector<internal::Front_source> sources;
  for(Index i = 0; i < 20; ++i)
    sources.push_back(surface.source(i * 120, 0.001 * (i % 5), i));
  for(const Kind kind : all_kinds)
  {
    const auto d = run(surface, kind, sources);
    auto reversed = sources;
    std::reverse(reversed.begin(), reversed.end());
    const auto e = run(surface, kind, reversed);
    EXPECT_EQ(d, e);
  }
}

TEST(Front, ignores_sources_that_are_overtaken)
{
  const Triangulation plane = square(16, 0.24);
  const Array_surface surface(plane);
  // The front of the first source arrives at the second one before that starts.
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(0), surface.source(100, 3.)});
    const auto alone = run(surface, kind, {surface.source(0)});
    EXPECT_LT(largest_error(surface.distances(front), [&](Index i) { return alone[i]; }),
              round_off);
    for(Index i = 0; i < surface.size(); ++i)
      EXPECT_EQ(front.source(i), 0u);
  }
}

TEST(Front, adds_offset_of_source)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  for(const Kind kind : all_kinds)
  {
    const auto d = run(surface, kind, {surface.source(7)});
    for(const double offset : {-2., 0.5, 100.})
    {
      const auto e = run(surface, kind, {surface.source(7, offset)});
      // Round-off errors are relative to the offset.
      EXPECT_LT(largest_error(e, [&](Index i) { return offset + d[i]; }),
                1e-13 * (1. + std::abs(offset)));
    }
  }
}

TEST(Front, distance_is_symmetric)
{
  // On a curved surface both distances have the error of the method.
  const Array_surface surface(jittered(icosphere(4), 0.02));
  std::mt19937 random(4);
  double sum = 0.;
  for(int i = 0; i < 40; ++i)
  {
    const Index a = Index(random() % surface.size()), b = Index(random() % surface.size());
    if(a == b)
      continue;
    const double forward_distance = run(surface, Kind::euclidean, {surface.source(a)})[b],
                 backward_distance = run(surface, Kind::euclidean, {surface.source(b)})[a];
    // Measured: 0.4 %.
    EXPECT_NEAR(forward_distance, backward_distance, 0.01 * forward_distance);
    sum += std::abs(forward_distance / backward_distance - 1.);
    EXPECT_NEAR(run(surface, Kind::dijkstra, {surface.source(a)})[b],
                run(surface, Kind::dijkstra, {surface.source(b)})[a], round_off);
  }
  EXPECT_LT(sum / 40., 0.004); // measured: 0.0014
}

TEST(Front, satisfies_triangle_inequality)
{
  const Array_surface surface(jittered(icosphere(4), 0.02));
  std::mt19937 random(5);
  std::vector<std::vector<double>> d;
  std::vector<Index> points;
  for(int i = 0; i < 6; ++i)
  {
    points.push_back(Index(random() % surface.size()));
    d.push_back(run(surface, Kind::euclidean, {surface.source(points.back())}));
  }
  for(int a = 0; a < 6; ++a)
    for(int b = 0; b < 6; ++b)
      for(Index c = 0; c < surface.size(); ++c)
        // The factor allows twice the largest relative error of distance_is_symmetric.
        EXPECT_LE(d[a][c], (d[a][points[b]] + d[b][c]) * 1.04);
}

TEST(Front, scales_with_constant_speed)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const std::size_t triangles = surface.triangles()->number_of_triangles();
  for(const Kind kind : all_kinds)
  {
    Front_limits limits;
    limits.slowness = std::make_shared<const std::vector<double>>(triangles, 1.);
    const auto d = run(surface, kind, {surface.source(7)}, limits);
    limits.slowness = std::make_shared<const std::vector<double>>(triangles, 2.);
    const auto half = run(surface, kind, {surface.source(7)}, limits);
    for(Index i = 0; i < surface.size(); ++i)
      EXPECT_EQ(half[i], 2. * d[i]);
  }
}

TEST(Front, euclidean_front_with_different_speeds_equals_planar_front)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  std::vector<double> slowness(surface.triangles()->number_of_triangles(), 1.);
  slowness[0] = 2.;
  Front_limits limits;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  EXPECT_EQ(run(surface, Kind::euclidean, {surface.source(7)}, limits),
            run(surface, Kind::planar, {surface.source(7)}, limits));
}

TEST(Front, does_not_cross_obstacles)
{
  const std::size_t n = 20;
  const Triangulation plane = square(n, 0.24);
  const Array_surface surface(plane);
  for(const bool has_gap : {false, true})
  {
    // The cells with x in [0.5, 0.55] are an obstacle, except for the uppermost one if there is a
    // gap.
    std::vector<double> slowness(surface.triangles()->number_of_triangles(), 1.);
    for(Index j = 0; j < n - has_gap; ++j)
      for(Index k = 0; k < 2; ++k)
        slowness[surface.triangle(2 * Index(10 + n * j) + k)] = infinity;
    Front_limits limits;
    limits.slowness = std::make_shared<const std::vector<double>>(slowness);
    for(const Kind kind : all_kinds)
    {
      const auto d = run(surface, kind, {surface.source(0)}, limits);
      for(Index i = 0; i < d.size(); ++i)
      {
        const bool is_behind = i % (n + 1) > 10;
        if(!is_behind)
          EXPECT_LE(d[i], 2.); // along two boundary edges of the square
        else if(!has_gap)
          EXPECT_EQ(d[i], infinity);
        else
        {
          // The path passes through the gap, 0.95 < y < 1.
          EXPECT_GE(d[i], std::hypot(0.5, 0.95 - 0.3 / n));
          EXPECT_LT(d[i], infinity);
        }
      }
    }
  }
}

// Returns the travel time from (0.5, 0) to a point, with slowness 1 below y = 0.5 and slowness p
// above. The minimum over all paths is found by bisection of the derivative (Snell's law).
double time_through_layers(const Point& target, double p)
{
  if(target[1] <= 0.5)
  {
    const double straight_ray = std::hypot(target[0] - 0.5, target[1]);
    if(p >= 1.)
      return straight_ray;
    // The head wave runs along the interface in the faster medium; it enters and leaves at the
    // critical angle.
    const double horizontal = std::abs(target[0] - 0.5), vertical = 0.5 + 0.5 - target[1];
    const double head_wave = p * horizontal + vertical * std::sqrt(1. - p * p);
    return horizontal >= vertical * p / std::sqrt(1. - p * p) ? std::min(straight_ray, head_wave)
                                                              : straight_ray;
  }
  double low = std::min(0.5, target[0]), high = std::max(0.5, target[0]);
  const double height = target[1] - 0.5;
  for(int i = 0; i < 100; ++i)
  {
    const double x = 0.5 * (low + high);
    const double slope = (x - 0.5) / std::hypot(x - 0.5, 0.5) +
                         p * (x - target[0]) / std::hypot(x - target[0], height);
    (slope > 0. ? high : low) = x;
  }
  return std::hypot(low - 0.5, 0.5) + p * std::hypot(low - target[0], height);
}

TEST(Front, satisfies_snells_law)
{
  for(const double p : {0.5, 2., 4.})
  {
    double error[2];
    for(const int level : {0, 1})
    {
      const std::size_t n = level == 0 ? 40 : 80;
      Triangulation plane = square(n, 0.2);
      for(std::size_t i = 0; i <= n; ++i)
        plane.points[i + (n + 1) * (n / 2)][1] = 0.5;
      const Array_surface surface(plane);
      std::vector<double> slowness(2 * n * n);
      for(Index f = 0; f < 2 * n * n; ++f)
        slowness[surface.triangle(f)] = f < n * n ? 1. : p;
      Front_limits limits;
      limits.slowness = std::make_shared<const std::vector<double>>(slowness);
      const auto d = run(surface, Kind::planar, {surface.source(Index(n / 2))}, limits);
      error[level] = mean_relative_error(
          d, 0.05, [&](Index i) { return time_through_layers(plane.points[i], p); });
    }
    // First order up to a logarithm, h = 1/80.
    EXPECT_LT(error[1], 0.02) << p;
    EXPECT_GT(std::log2(error[0] / error[1]), 0.4) << p;
  }
}

TEST(Front, reaches_exactly_vertices_within_maximum_distance)
{
  const Array_surface surface(jittered(icosphere(4), 0.01));
  for(const Kind kind : all_kinds)
  {
    const auto all = run(surface, kind, {surface.source(30)});
    for(const double limit : {0., 0.1, 0.5, 2.})
    {
      Front front(surface.triangles(), kind);
      Front_limits limits;
      limits.maximum_distance = limit / surface.scale();
      front.run({surface.source(30)}, limits);
      std::size_t number_inside = 0;
      for(Index i = 0; i < surface.size(); ++i)
      {
        const double d = surface.scale() * front.distance(surface.vertex(i));
        // A front that stops has the same values, except for corrections from beyond its limit.
        if(all[i] <= limit * (1. - 1e-9))
        {
          EXPECT_NEAR(d, all[i], flat_tolerance) << "limit " << limit << " kind " << int(kind);
        }
        else if(all[i] > limit * (1. + 1e-9))
        {
          EXPECT_EQ(d, infinity) << "limit " << limit << " kind " << int(kind);
        }
        number_inside += d < infinity;
      }
      EXPECT_EQ(front.reached().size(), number_inside);
    }
  }
}

TEST(Front, lists_reached_vertices_once_and_nearly_sorted)
{
  const Array_surface surface(jittered(icosphere(4), 0.02));
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(3), surface.source(1000)});
    auto reached = front.reached();
    EXPECT_EQ(reached.size(), surface.size());
    for(std::size_t i = 1; i < reached.size(); ++i)
      // Up to the length of the longest edge, which is below 2 in the unit of the arrays.
      EXPECT_GT(front.distance(reached[i]), front.distance(reached[i - 1]) - 2.);
    std::sort(reached.begin(), reached.end());
    EXPECT_EQ(std::unique(reached.begin(), reached.end()), reached.end());
  }
}

TEST(Front, distances_of_targets_match_full_run)
{
  for(const Triangulation& shape : {jittered(icosphere(4), 0.02), Square_with_wall().surface})
  {
    const Array_surface surface(shape);
    std::mt19937 random(6);
    for(const Kind kind : all_kinds)
    {
      Front front(surface.triangles(), kind);
      front.run({surface.source(0)});
      const Front full = front;
      for(int i = 0; i < 30; ++i)
      {
        Front_limits limits;
        for(int k = 0; k <= i % 3; ++k)
          limits.targets.push_back(random_location(*surface.triangles(), random));
        front.run({surface.source(0)}, limits);
        for(const Surface_location& target : limits.targets)
          EXPECT_NEAR(front.distance(target), full.distance(target), flat_tolerance);
      }
      // The query stops after a target that is close to the source.
      Front_limits limits;
      limits.targets = {surface.at(1)};
      front.run({surface.source(0)}, limits);
      EXPECT_LT(front.reached().size(), surface.size());
    }
  }
}

TEST(Front, terminates_with_unreachable_target)
{
  const Array_surface surface(disjoint_union(tetrahedron(), square(4)));
  Front_limits limits;
  limits.targets = {surface.at(10)};
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    EXPECT_TRUE(front.run({surface.source(0)}, limits));
    EXPECT_EQ(front.distance(surface.vertex(10)), infinity);
    EXPECT_EQ(front.reached().size(), 4u);
  }
}

TEST(Front, is_cancelled_by_callback)
{
  const Array_surface surface(icosphere(5));
  for(const Kind kind : all_kinds)
  {
    const auto all = run(surface, kind, {surface.source(0)});
    Front front(surface.triangles(), kind);
    int calls = 0;
    double last = -1.;
    Front_limits limits;
    limits.callback = [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.);
      last = fraction;
      return ++calls < 2;
    };
    EXPECT_FALSE(front.run({surface.source(0)}, limits));
    EXPECT_EQ(calls, 2);
    const auto d = surface.distances(front);
    std::size_t finite = 0;
    for(Index i = 0; i < d.size(); ++i)
      if(d[i] < infinity)
      {
        ++finite;
        EXPECT_NEAR(d[i], all[i], 1e-3); // the last ones would still have been corrected
      }
    EXPECT_EQ(finite, front.reached().size());
    EXPECT_GT(finite, 0u);
    EXPECT_LT(finite, d.size());
    // The next query is complete.
    EXPECT_TRUE(front.run({surface.source(0)}));
    EXPECT_EQ(surface.distances(front), all);
  }
}

TEST(Front, predecessors_lead_to_source)
{
  for(const Triangulation& shape :
      {jittered(icosphere(4), 0.02), Square_with_wall().surface, cone(20, 8, 3. * pi)})
  {
    const Array_surface surface(shape);
    const Surface_arrays& t = *surface.triangles();
    for(const Kind kind : all_kinds)
    {
      Front front(surface.triangles(), kind);
      front.run({surface.source(0), surface.source(30, 0.01)});
      for(const Index vertex : front.reached())
      {
        std::size_t number_of_steps = 0;
        Index current = vertex;
        for(Index predecessor_vertex; (predecessor_vertex = front.predecessor(current)) != none;
            current = predecessor_vertex)
        {
          EXPECT_LT(front.distance(predecessor_vertex), front.distance(current));
          EXPECT_EQ(front.source(predecessor_vertex), front.source(current));
          EXPECT_NE(common_triangle(t, vertex_location(t, predecessor_vertex),
                                    vertex_location(t, current)),
                    none);
          ASSERT_LT(++number_of_steps, surface.size());
        }
        EXPECT_EQ(current, surface.vertex(front.source(vertex) == 0 ? 0 : 30))
            << "kind " << int(kind);
      }
    }
  }
}

TEST(Front, distances_inside_triangles_are_exact_in_plane)
{
  const Triangulation plane = stretched_square(16, 1., 0.6, 8);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  Front front(surface.triangles(), Kind::euclidean);
  front.run({surface.source(100)});
  std::mt19937 random(7);
  for(int i = 0; i < 500; ++i)
  {
    const Surface_location location = random_location(t, random);
    EXPECT_NEAR(surface.scale() * front.distance(location),
                distance(plane.points[100], point_at(t, location)), flat_tolerance);
  }
}

TEST(Front, distance_is_continuous_at_corners)
{
  const Array_surface surface(jittered(icosphere(3), 0.05));
  const Surface_arrays& t = *surface.triangles();
  std::mt19937 random(8);
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(17), surface.source(300)});
    for(Index f = 0; f < t.number_of_triangles(); ++f)
      for(Index k = 0; k < 3; ++k)
      {
        const double corner = front.distance(t.corner[3 * f + k]);
        EXPECT_EQ(front.distance(Surface_location{f, none, barycentric_at_corner(k)}), corner);
        // At most the distance through the corner.
        Surface_location location = random_location(t, random);
        location.triangle = f;
        const double distance_to_corner =
            distance_in_triangle(t, f, location.barycentric, barycentric_at_corner(k));
        EXPECT_LE(front.distance(location), corner + distance_to_corner + round_off);
      }
  }
}

TEST(Front, is_independent_of_previous_queries)
{
  const Array_surface surface(jittered(icosphere(4), 0.02));
  std::mt19937 random(9);
  for(const Kind kind : all_kinds)
  {
    Front reused(surface.triangles(), kind);
    for(int i = 0; i < 12; ++i)
    {
      std::vector<internal::Front_source> sources;
      for(int k = 0; k <= i % 4; ++k)
        sources.push_back(surface.source(random_location(*surface.triangles(), random)));
      Front_limits limits;
      if(i % 3 == 1)
        limits.maximum_distance = 0.4 / surface.scale();
      if(i % 4 == 2)
        limits.targets = {random_location(*surface.triangles(), random)};
      if(i % 5 == 3)
        limits.slowness = std::make_shared<const std::vector<double>>(
            surface.triangles()->number_of_triangles(), 0.5);
      Front fresh(surface.triangles(), kind);
      fresh.run(sources, limits);
      reused.run(sources, limits);
      EXPECT_EQ(surface.distances(reused), surface.distances(fresh));
      EXPECT_EQ(reused.reached(), fresh.reached());
      for(Index vertex = 0; vertex < surface.size(); ++vertex)
      {
        EXPECT_EQ(reused.source(vertex), fresh.source(vertex));
        EXPECT_EQ(reused.predecessor(vertex), fresh.predecessor(vertex));
      }
    }
  }
}

// After some queries, fronts read stored angles or fans.
TEST(Front, many_queries_do_not_change_results)
{
  for(const Triangulation& mesh : {square(20, 0.4), jittered(icosphere(3), 0.1)})
  {
    const Array_surface surface(mesh);
    std::vector<double> slowness(surface.triangles()->number_of_triangles());
    std::mt19937 random(3);
    for(double& value : slowness)
      value = std::uniform_real_distribution<double>(0.5, 2.)(random);
    Front_limits with_speeds;
    with_speeds.slowness = std::make_shared<const std::vector<double>>(slowness);
    for(const Kind kind : {Kind::planar, Kind::euclidean})
    {
      Front reused(surface.triangles(), kind);
      for(int i = 0; i < 20; ++i)
      {
        const std::vector<internal::Front_source> sources = {
            surface.source(random_location(*surface.triangles(), random))};
        // Of 20 queries, 6 without speeds come first.
        const Front_limits limits = i < 6 || i % 3 == 0 ? Front_limits{} : with_speeds;
        Front fresh(surface.triangles(), kind);
        fresh.run(sources, limits);
        reused.run(sources, limits);
        EXPECT_EQ(surface.distances(reused), surface.distances(fresh));
        EXPECT_EQ(reused.reached(), fresh.reached());
      }
    }
  }
}

TEST(Front, copies_run_concurrently)
{
  const Array_surface surface(jittered(icosphere(5), 0.01));
  for(const Kind kind : all_kinds)
  {
    Front first(surface.triangles(), kind), second = first;
    const auto expected_first = run(surface, kind, {surface.source(0)}),
               expected_second = run(surface, kind, {surface.source(5000)});
    std::thread other([&] { second.run({surface.source(5000)}); });
    first.run({surface.source(0)});
    other.join();
    EXPECT_EQ(surface.distances(first), expected_first);
    EXPECT_EQ(surface.distances(second), expected_second);
  }
}

TEST(Front, handles_degenerate_triangles)
{
  // Coincident vertices, collinear vertices, and triangles of area zero.
  Triangulation surface = square(8, 0.24);
  for(int i = 0; i < 5; ++i)
    surface.points[40 + i] = surface.points[40];
  for(Index i = 10; i < 17; ++i)
    surface.points[i][1] = surface.points[10][1];
  const Array_surface arrays(surface);
  for(const Kind kind : all_kinds)
    for(const Index source : {0, 12, 42, 80})
    {
      const auto d = run(arrays, kind, {arrays.source(Index(source))});
      for(Index i = 0; i < d.size(); ++i)
      {
        EXPECT_TRUE(d[i] < infinity);
        // Some faces are inverted at these vertices, which causes errors of 1 %.
        EXPECT_GE(d[i], 0.98 * distance(surface.points[source], surface.points[i]) - round_off);
      }
      for(int i = 1; i < 5; ++i)
        EXPECT_NEAR(d[40 + i], d[40], flat_tolerance);
    }
}

TEST(Front, passes_pinched_vertices)
{
  // Two squares that share a vertex: (1, 1) of the first one is (0, 0) of the second one.
  const Index n = 6, m = (n + 1) * (n + 1);
  Triangulation second = square(n, 0.24, 2);
  for(Point& p : second.points)
    for(int k = 0; k < 2; ++k)
      p[k] += 1.;
  Triangulation surface = disjoint_union(square(n, 0.24), second);
  for(Index& corner : surface.corners)
    if(corner == m)
      corner = m - 1;
  const Array_surface arrays(surface);
  const auto d = run(arrays, Kind::euclidean, {arrays.source(0)});
  for(Index i = 0; i < d.size(); ++i)
  {
    if(i == m) // isolated
      EXPECT_EQ(d[i], infinity);
    else if(i < m)
      EXPECT_NEAR(d[i], distance(surface.points[0], surface.points[i]), flat_tolerance);
    else
      EXPECT_NEAR(d[i], std::sqrt(2.) + distance(surface.points[m - 1], surface.points[i]),
                  flat_tolerance);
  }
}

TEST(Front, reaches_nothing_without_sources)
{
  const Array_surface surface(tetrahedron());
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    EXPECT_TRUE(front.run({}));
    EXPECT_TRUE(front.reached().empty());
    EXPECT_EQ(front.distance(0), infinity);
    EXPECT_EQ(front.source(0), none);
    EXPECT_EQ(front.predecessor(0), none);
  }
}

TEST(Front, stops_where_known_distances_are_smaller)
{
  const Triangulation plane = square(30, 0.2, 3);
  const Array_surface surface(plane);
  const Surface_arrays& t = surface.t();
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(0)});
    std::vector<double> known(surface.size());
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
      known[vertex] = front.distance(vertex);
    front.run({surface.source(960)});
    std::vector<double> unbounded(surface.size());
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
      unbounded[vertex] = front.distance(vertex);

    Front_limits limits;
    limits.known_distance = &known;
    EXPECT_TRUE(front.run({surface.source(960)}, limits));
    // The distances differ by at most 2 % of an edge: close to the bisector they may be computed in
    // other triangles.
    double max_error = 0.;
    std::vector<bool> is_near_improvement(surface.size(), false);
    for(Index f = 0; f < t.number_of_triangles(); ++f)
    {
      bool has_improved = false;
      for(Index k = 0; k < 3; ++k)
        has_improved =
            has_improved || front.distance(t.corner[3 * f + k]) < known[t.corner[3 * f + k]];
      for(Index k = 0; k < 3; ++k)
        if(has_improved)
        {
          is_near_improvement[t.corner[3 * f + k]] = true;
          // One more ring of vertices is reached, except by Dijkstra's algorithm.
          if(kind != Kind::dijkstra)
          {
            EXPECT_LT(front.distance(t.corner[3 * f + k]), infinity);
          }
        }
    }
    // A Euclidean front also reaches the neighbors in the intrinsic Delaunay triangulation.
    if(kind == Kind::euclidean)
      for(Index f = 0; f < t.number_of_triangles(); ++f)
        if(front.distance(t.corner[3 * f]) < infinity)
          is_near_improvement[t.corner[3 * f]] = true;
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      max_error = std::max(max_error, std::min(front.distance(vertex), known[vertex]) -
                                          std::min(unbounded[vertex], known[vertex]));
      if(!is_near_improvement[vertex])
      {
        EXPECT_EQ(front.distance(vertex), infinity);
      }
    }
    // The length of an edge is 1/30.
    EXPECT_LE(max_error, kind == Kind::dijkstra ? 0. : 0.02 / 30. / surface.scale());
  }
}

// A flat rectangle of needles: their long edges are 500 times as long as the short ones.
Triangulation needle_sheet(unsigned seed)
{
  return grid(
      200, 4,
      [](double u, double v) {
        return Point{u, 10. * v, 0.};
      },
      0.24, seed);
}

TEST(Front, is_exact_and_fast_on_needles)
{
  const Triangulation plane = needle_sheet(5);
  const Array_surface surface(plane);
  std::mt19937 random(4);
  for(const Index source : {0u, 402u, 1004u})
  {
    Front front(surface.triangles(), Kind::euclidean);
    front.run({surface.source(source)});
    EXPECT_LT(largest_error(surface.distances(front), [&](Index i)
                            { return distance(plane.points[i], plane.points[source]); }),
              flat_tolerance);
    // Locations refer to the triangles of the mesh, which the front does not use.
    for(int i = 0; i < 100; ++i)
    {
      const Surface_location location = random_location(surface.t(), random);
      EXPECT_NEAR(surface.scale() * front.distance(location),
                  distance(point_at(surface.t(), location), plane.points[source]), flat_tolerance);
    }
  }
}

TEST(Front, is_exact_from_locations_on_needles)
{
  const Triangulation plane = needle_sheet(6);
  const Array_surface surface(plane);
  std::mt19937 random(5);
  for(int i = 0; i < 20; ++i)
  {
    const Surface_location source = random_location(surface.t(), random);
    const Point p = point_at(surface.t(), source);
    EXPECT_LT(largest_error(run(surface, Kind::euclidean, {surface.source(source)}),
                            [&](Index k) { return distance(plane.points[k], p); }),
              flat_tolerance);
  }
}

TEST(Front, is_exact_in_plane_if_long_edges_are_bisected)
{
  const Triangulation plane = graded_square(20);
  const Array_surface surface(plane);
  Front front(surface.triangles(), Kind::euclidean, Bisected_edges::long_edges);
  std::mt19937 random(1);
  for(const Index source : {0, 20, 10 * 21 + 15, 440})
  {
    ASSERT_TRUE(front.run({surface.source(source)}));
    EXPECT_LT(largest_error(surface.distances(front), [&](Index i)
                            { return distance(plane.points[i], plane.points[source]); }),
              flat_tolerance);
    for(int i = 0; i < 100; ++i)
    {
      const Surface_location location = random_location(surface.t(), random);
      const double expected =
          norm(scaled_coordinates(surface.t(), location) -
               scaled_coordinates(surface.t(), surface.source(source).polyline[0]));
      EXPECT_NEAR(front.distance(location), expected, flat_tolerance);
    }
  }
  // From the lower side, whose long edges are bisected.
  std::vector<Index> lower_side(21);
  std::iota(lower_side.begin(), lower_side.end(), Index(0));
  ASSERT_TRUE(front.run({{surface.along(lower_side)}}));
  EXPECT_LT(largest_error(surface.distances(front), [&](Index i) { return plane.points[i][1]; }),
            flat_tolerance);
}

// A closed cylinder of radius and height 1. As in CAD models, all of the 2n vertices are on the two
// circles, and long triangles join them.
Triangulation closed_cylinder(Index n)
{
  Triangulation result;
  for(const double z : {0., 1.})
    for(Index i = 0; i < n; ++i)
      result.points.push_back({std::cos(2. * pi * i / n), std::sin(2. * pi * i / n), z});
  const auto add = [&](Index a, Index b, Index c) {
    result.corners.insert(result.corners.end(), {a, b, c});
  };
  for(Index i = 0; i < n; ++i)
  {
    const Index next = (i + 1) % n;
    add(i, next, n + next);
    add(i, n + next, n + i);
  }
  // Parallel strips of triangles across both discs.
  for(Index low = 0, high = n - 1; low + 1 < high;)
  {
    const Index third = (low + high) % 2 == 0 ? high - 1 : low + 1;
    add(low, high, third);
    add(n + low, n + third, n + high);
    (third == high - 1 ? high : low) = third;
  }
  return result;
}

TEST(Front, is_more_accurate_if_long_edges_are_bisected)
{
  const Array_surface surface(closed_cylinder(40));
  const std::size_t n = surface.size();
  Window_propagation exact(surface.triangles());
  Front plain(surface.triangles(), Kind::euclidean),
      bisected(surface.triangles(), Kind::euclidean, Bisected_edges::long_edges);
  double plain_error = 0., bisected_error = 0.;
  for(Index source = 0; source < n; source += 7)
  {
    exact.run({{{{none, source, {}}}}});
    plain.run({{{{none, source, {}}}}});
    bisected.run({{{{none, source, {}}}}});
    double largest_distance = 0.;
    for(Index v = 0; v < n; ++v)
      largest_distance = std::max(largest_distance, exact.distance(v));
    for(Index v = 0; v < n; ++v)
      if(const double d = exact.distance(v); d > 0.05 * largest_distance)
      {
        plain_error = std::max(plain_error, std::abs(plain.distance(v) / d - 1.));
        bisected_error = std::max(bisected_error, std::abs(bisected.distance(v) / d - 1.));
      }
  }
  EXPECT_LT(bisected_error, 0.1 * plain_error);
}

TEST(Front, hides_midpoints_of_bisected_edges)
{
  const Array_surface surface(graded_square(20));
  Front front(surface.triangles(), Kind::euclidean, Bisected_edges::long_edges), fresh = front;
  ASSERT_TRUE(front.run({surface.source(200)}));
  std::vector<Index> reached = front.reached();
  std::sort(reached.begin(), reached.end());
  std::vector<Index> all(surface.size());
  std::iota(all.begin(), all.end(), Index(0));
  EXPECT_EQ(reached, all);
  for(const Index v : all)
  {
    const Index predecessor = front.predecessor(v);
    if(predecessor != none)
    {
      ASSERT_LT(predecessor, surface.size());
      EXPECT_LT(front.distance(predecessor), front.distance(v));
    }
  }
  // Speeds require the triangles of the surface; the next query uses midpoints again.
  Front_limits with_speeds;
  with_speeds.slowness =
      std::make_shared<std::vector<double>>(surface.t().number_of_triangles(), 2.);
  ASSERT_TRUE(front.run({surface.source(3)}, with_speeds));
  ASSERT_TRUE(front.run({surface.source(77)}));
  ASSERT_TRUE(fresh.run({surface.source(77)}));
  for(const Index v : all)
    EXPECT_EQ(front.distance(v), fresh.distance(v));
}

TEST(Front, is_unchanged_without_long_edges)
{
  const Array_surface surface(jittered(icosphere(3), 0.05));
  Front plain(surface.triangles(), Kind::euclidean),
      bisected(surface.triangles(), Kind::euclidean, Bisected_edges::long_edges);
  ASSERT_TRUE(plain.run({surface.source(5)}));
  ASSERT_TRUE(bisected.run({surface.source(5)}));
  EXPECT_EQ(surface.distances(plain), surface.distances(bisected));
}

TEST(Front, is_between_straight_line_and_edge_paths)
{
  // Needles, caps and folds: circular fronts are inaccurate here.
  for(const Triangulation& mesh :
      {jittered(cylinder(60, 4, 1., 8.), 0.12), jittered(icosphere(2), 0.25), needle_sheet(7),
       cone(40, 3, 3. * pi)})
  {
    const Array_surface surface(mesh);
    for(const Index source : {Index(0), Index(surface.size() / 2)})
    {
      const auto along_edges = run(surface, Kind::dijkstra, {surface.source(source)});
      for(const Kind kind : {Kind::planar, Kind::euclidean})
      {
        const auto d = run(surface, kind, {surface.source(source)});
        for(Index i = 0; i < surface.size(); ++i)
        {
          EXPECT_GE(d[i], distance(mesh.points[i], mesh.points[source]) * (1. - round_off) -
                              surface.scale() * round_off);
          if(kind == Kind::euclidean)
          {
            EXPECT_LE(d[i], along_edges[i] * (1. + round_off));
          }
        }
      }
    }
  }
}

} // namespace front_test
