// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <thread>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Kind = Front_kind;
constexpr Kind all_kinds[] = {Kind::arcs, Kind::planar, Kind::euclidean};

// A final site is corrected by one part in 10^12 or more; what is below is left, and on these surfaces
// passed on some tens of times.
constexpr double flat = 1e-10;
// Sums of some hundred lengths.
constexpr double rounding = 1e-12;

std::vector<double> run(const Glued_surface& surface, Kind kind,
                        const std::vector<internal::Source>& sources,
                        const Front_limits& limits = {})
{
  Front front(surface.triangles(), kind);
  EXPECT_TRUE(front.run(sources, limits));
  return surface.distances(front);
}

Triangulation stretched(std::size_t n, double width, double height, unsigned seed)
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

TEST(Front, is_exact_on_flat_convex_surfaces)
{
  // Angles up to 145 degrees.
  for(const unsigned seed : {1u, 2u, 3u, 4u, 5u})
  {
    const Triangulation plane = square(30, 0.24, seed);
    const Glued_surface surface(plane);
    for(const Index source : {0, 15 * 31 + 15, 30, 7 * 31 + 22, 28 * 31 + 3})
    {
      const auto d = run(surface, Kind::euclidean, {surface.source(source)});
      EXPECT_LT(largest_error(d, [&](Index i)
                              { return distance(plane.points[i], plane.points[source]); }),
                flat);
    }
  }
}

TEST(Front, is_exact_where_triangles_are_flat_as_well)
{
  // Angles up to 168 degrees: a site may hand on a front before the one that comes the long way
  // around a needle has turned its direction, and has to take back what it gave.
  for(const double height : {0.2, 0.3, 5.})
    for(const unsigned seed : {1u, 2u, 3u})
    {
      const std::size_t n = height == 0.3 ? 150 : 30;
      const Triangulation plane = stretched(n, 1., height, seed);
      const Glued_surface surface(plane);
      for(const std::size_t source : {std::size_t(0), n / 2 * (n + 2), n})
      {
        const auto d = run(surface, Kind::euclidean, {surface.source(Index(source))});
        EXPECT_LT(largest_error(d, [&](Index i)
                                { return distance(plane.points[i], plane.points[source]); }),
                  flat * std::max(1., height));
      }
    }
}

TEST(Front, is_exact_on_an_unrolled_cylinder)
{
  const std::size_t n = 24;
  const double width = 0.25;
  const Triangulation cylinder = prism(n, 30, width, 4.);
  const Glued_surface surface(cylinder);
  for(const Index source : {Index(0), Index(15 * n + 3)})
  {
    const auto d = run(surface, Kind::euclidean, {surface.source(source)});
    const auto truth = [&](Index i)
    {
      const std::size_t steps = (i + n - source % n) % n;
      return std::hypot(width * std::min(steps, n - steps),
                        cylinder.points[i][2] - cylinder.points[source][2]);
    };
    EXPECT_LT(largest_error(d, truth), flat * 4.);
  }
}

TEST(Front, is_exact_on_cones_and_behind_saddles)
{
  for(const double total : {0.3 * pi, pi, 1.7 * pi, 2. * pi, 2.5 * pi, 3.5 * pi})
  {
    const Index n = 36, rows = 12;
    const Glued_surface surface(cone(n, rows, total));
    for(const Index ring : {Index(0), Index(5)})
    {
      const auto d = run(surface, Kind::euclidean, {surface.source(1 + n * ring)});
      const auto truth = [&](Index i)
      {
        return i == 0
                   ? ring + 1.
                   : distance_on_cone(ring + 1., (i - 1) / n + 1., (i - 1) % n * total / n, total);
      };
      // Above 3 pi the shadow's edge passes through triangles of half of its size: there a circle
      // is fitted to two fronts.
      EXPECT_LT(largest_error(d, truth), total < 3. * pi ? flat * rows : 0.01)
          << "total angle " << total << " ring " << ring;
    }
    const auto d = run(surface, Kind::euclidean, {surface.source(0)});
    EXPECT_LT(largest_error(d, [&](Index i) { return i == 0 ? 0. : (i - 1) / n + 1.; }),
              flat * rows);
  }
}

// A square with a hole [0.5, 0.5 + 1/n] x [0, 0.5]: the border's two inner corners throw shadows.
struct Walled_square
{
  static constexpr std::size_t n = 32;
  Triangulation surface = square(n, 0.24);
  const Point corner[2] = {{0.5, 0.5, 0.}, {0.5 + 1. / n, 0.5, 0.}};

  Walled_square()
  {
    for(std::size_t j = 0; j <= n; ++j)
      for(std::size_t i = n / 2; i <= n / 2 + 1; ++i)
        surface.points[i + (n + 1) * j] = {double(i) / n, double(j) / n, 0.};
    for(std::size_t i = 0; i <= n; ++i) // the top of the wall
      surface.points[i + (n + 1) * (n / 2)][1] = 0.5;
    std::vector<Index> corners;
    for(std::size_t cell = 0; cell < n * n; ++cell)
      if(cell % n != n / 2 || cell / n >= n / 2)
        corners.insert(corners.end(), surface.corners.begin() + 6 * cell,
                       surface.corners.begin() + 6 * cell + 6);
    surface.corners = corners;
  }

  bool sees(const Point& p, const Point& q) const
  {
    // Where the segment is in the wall's range of x it must not be below the wall's top.
    const double low = std::min(p[0], q[0]), high = std::max(p[0], q[0]);
    const double from = std::max(low, corner[0][0]), to = std::min(high, corner[1][0]);
    if(from >= to)
      return true;
    const auto height = [&](double x) { return p[1] + (x - p[0]) / (q[0] - p[0]) * (q[1] - p[1]); };
    return std::min(height(from), height(to)) >= 0.5 - 1e-12;
  }

  double truth(const Point& p, const Point& q) const
  {
    if(sees(p, q))
      return distance(p, q);
    double result = infinity;
    for(const Point& c : corner)
      for(const Point& e : corner)
        if(sees(p, c) && sees(e, q))
          result = std::min(result, distance(p, c) + distance(c, e) + distance(e, q));
    return result;
  }
};

TEST(Front, turns_around_the_corners_of_a_wall)
{
  const Walled_square wall;
  const Glued_surface surface(wall.surface);
  for(const Index source : {Index(0), Index(5 * 33 + 8), Index(12 * 33 + 14), Index(32)})
  {
    const auto d = run(surface, Kind::euclidean, {surface.source(source)});
    const auto truth = [&](Index i)
    {
      // The points under the wall, in no triangle, are not reached.
      return std::isinf(d[i]) ? infinity
                              : wall.truth(wall.surface.points[source], wall.surface.points[i]);
    };
    // Exact but along the shadow's edge, where a circle is fitted to two fronts: part of a side.
    EXPECT_LT(largest_error(d, truth), 0.2 / wall.n) << "source " << source;
    EXPECT_LT(mean_relative_error(d, 1e-3, truth), 5e-4) << "source " << source;
  }
}

// The mean error over vertices farther than 5 percent of the largest distance.
double error_on_sphere(unsigned level, Kind kind)
{
  const Triangulation sphere = icosphere(level);
  const Glued_surface surface(sphere);
  double sum = 0.;
  const Index sources[] = {0, 100, 517};
  for(const Index source : sources)
    sum += mean_relative_error(run(surface, kind, {surface.source(source)}), 0.05 * pi,
                               [&](Index i)
                               { return great_circle(sphere.points[source], sphere.points[i]); });
  return sum / 3.;
}

TEST(Front, has_about_second_order_on_a_sphere)
{
  const double coarse = error_on_sphere(3, Kind::euclidean),
               middle = error_on_sphere(4, Kind::euclidean),
               fine = error_on_sphere(5, Kind::euclidean);
  // Sides halve from one to the next.  The cut locus, where the front meets itself, is a point.
  EXPECT_GT(std::log2(coarse / fine) / 2., 1.6);
  EXPECT_GT(std::log2(middle / fine), 1.5);
  EXPECT_LT(fine, 0.0015); // the bar for 10,242 vertices
}

TEST(Front, is_as_near_where_a_grid_is_skew)
{
  // A side of a cube blown up to a sphere.  Where fronts pass its vertices on one side only, they went up to
  // 2.8 % too far.
  const Triangulation side = grid(60, 60,
                                  [](double u, double v)
                                  {
                                    const double x = 2. * u - 1., y = 2. * v - 1.,
                                                 size = std::sqrt(x * x + y * y + 1.);
                                    return Point{x / size, y / size, 1. / size};
                                  });
  const Glued_surface surface(side);
  for(const Index triangle : {100u, 3625u, 3638u, 3651u, 6053u, 7183u})
  {
    const std::array<double, 3> barycentric = {.52, .36, .12};
    Spatial place = {0., 0., 0.};
    for(Index k = 0; k < 3; ++k)
      place = place + barycentric[k] * side.points[side.corners[3 * triangle + k]];
    const auto d =
        run(surface, Kind::euclidean, {surface.source(surface.in(triangle, barycentric))});
    for(Index i = 0; i < d.size(); ++i)
      // What front.cpp says at worth_a_return; and the source lies by an eighth of the square of an edge, 1e-4,
      // below the sphere.
      EXPECT_NEAR(d[i] / great_circle(unit(place), side.points[i]), 1., d[i] > 0.2 ? 2.5e-3 : 0.1)
          << triangle << " " << i;
  }
}

TEST(Front, has_about_first_order_when_planar)
{
  const double coarse = error_on_sphere(3, Kind::planar), fine = error_on_sphere(5, Kind::planar);
  // h log h: the circle's bend around the source costs the logarithm, half an order here.
  EXPECT_GT(std::log2(coarse / fine) / 2., 0.5);
  EXPECT_LT(fine, 0.02);
}

TEST(Front, is_the_five_point_scheme_on_right_angles)
{
  // Rouy and Tourin's scheme on a grid, for which the fronts of Kimmel and Sethian were made.
  const std::size_t n = 20;
  const Glued_surface surface(square(n));
  const auto d = run(surface, Kind::planar, {surface.source(Index(n))}); // at (1,0)
  const double h = 1. / n;
  std::vector<double> truth(d.size());
  for(std::size_t j = 0; j <= n; ++j)
    for(std::size_t i = 0; i <= n; ++i) // i sides to the left of the source
    {
      double& value = truth[j * (n + 1) + n - i];
      if(i == 0 || j == 0)
      {
        value = h * double(i + j);
        continue;
      }
      const double a = truth[j * (n + 1) + n - i + 1], b = truth[(j - 1) * (n + 1) + n - i];
      value = 0.5 * (a + b + std::sqrt(2. * h * h - (a - b) * (a - b)));
    }
  EXPECT_LT(largest_error(d, [&](Index i) { return truth[i]; }), rounding);
}

TEST(Front, is_not_consistent_along_arcs)
{
  // The diagonal against the sides of a regular grid that has the other diagonals.
  Triangulation plane = square(16);
  for(Point& p : plane.points)
    p[0] = 1. - p[0];
  for(std::size_t c = 0; c < plane.corners.size(); c += 3)
    std::swap(plane.corners[c], plane.corners[c + 1]);
  const Glued_surface surface(plane);
  const auto d = run(surface, Kind::arcs, {surface.source(16)});
  EXPECT_NEAR(d[16 * 17], 2., rounding); // from (0,0) to (1,1): two sides, not sqrt(2)
}

TEST(Front, agrees_with_a_plain_dijkstra)
{
  for(const Triangulation& surface :
      {shaken(icosphere(3), 0.02), Walled_square().surface, apart(square(7, 0.24), tetrahedron())})
  {
    // Bellman and Ford: no queue at all.
    std::vector<double> truth(surface.points.size(), infinity);
    truth[3] = 0.25;
    truth[20] = 0.;
    for(bool changes = true; changes;)
    {
      changes = false;
      for(std::size_t c = 0; c < surface.corners.size(); ++c)
      {
        const Index a = surface.corners[c], b = surface.corners[next_side(Index(c))];
        const double length = distance(surface.points[a], surface.points[b]);
        for(const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}})
          if(truth[from] + length < truth[to])
          {
            truth[to] = truth[from] + length;
            changes = true;
          }
      }
    }
    const Glued_surface glued_surface(surface);
    const auto d =
        run(glued_surface, Kind::arcs, {glued_surface.source(3, 0.25), glued_surface.source(20)});
    EXPECT_LT(largest_error(d, [&](Index i) { return truth[i]; }), rounding);
  }
}

TEST(Front, never_goes_below_the_distance_in_space_nor_above_the_arcs)
{
  for(const Triangulation& sphere : {shaken(icosphere(3), 0.05), shaken(icosphere(4), 0.02)})
  {
    const Glued_surface surface(sphere);
    const auto arcs = run(surface, Kind::arcs, {surface.source(5)});
    for(const Kind kind : {Kind::planar, Kind::euclidean})
    {
      const auto d = run(surface, kind, {surface.source(5)});
      for(Index i = 0; i < d.size(); ++i)
      {
        EXPECT_GE(d[i], distance(sphere.points[5], sphere.points[i]) * (1. - rounding));
        EXPECT_LE(d[i], arcs[i] * (1. + rounding));
      }
    }
  }
}

TEST(Front, starts_anywhere)
{
  const Triangulation plane = stretched(20, 1., 0.7, 5);
  const Glued_surface surface(plane);
  std::mt19937 random(1);
  for(int i = 0; i < 40; ++i)
  {
    Location location = random_location(*surface.triangles(), random);
    if(i % 2 == 0)
      location = {location.triangle, none, on_side(3 * location.triangle + i / 2 % 3, 0.3)};
    if(i % 5 == 0)
      location = {location.triangle, none, at_corner(3 * location.triangle + i % 3)};
    const Point p = point_at(*surface.triangles(), location);
    const auto truth = [&](Index k) { return distance(p, plane.points[k]); };
    EXPECT_LT(largest_error(run(surface, Kind::euclidean, {surface.source(location)}), truth),
              flat);
    // First order: at most two of the 20 sides across.
    EXPECT_LT(largest_error(run(surface, Kind::planar, {surface.source(location)}), truth), 0.1);
  }
}

TEST(Front, is_exact_in_the_triangles_of_its_source)
{
  const Triangulation plane = stretched(6, 1., 0.4, 3);
  const Glued_surface surface(plane);
  std::mt19937 random(2);
  for(int i = 0; i < 60; ++i)
  {
    const Location from = random_location(*surface.triangles(), random);
    Location to = random_location(*surface.triangles(), random);
    to.triangle = from.triangle;
    for(const Kind kind : all_kinds)
    {
      Front front(surface.triangles(), kind);
      front.run({surface.source(from)});
      EXPECT_NEAR(
          surface.scale() * front.distance(to),
          distance(point_at(*surface.triangles(), from), point_at(*surface.triangles(), to)),
          rounding);
    }
  }
}

TEST(Front, leaves_a_polyline_as_a_straight_line)
{
  // The lower half of a column in the middle, with both ends inside: a wave on both sides, circles
  // around the ends.
  Triangulation plane = square(24, 0.24);
  std::vector<Index> line;
  for(Index j = 6; j <= 18; ++j)
  {
    line.push_back(12 + 25 * j);
    plane.points[line.back()] = {0.5, j / 24., 0.};
  }
  const Glued_surface surface(plane);
  const Point a = plane.points[line.front()], b = plane.points[line.back()];
  const auto truth = [&](Index i) { return distance_to_segment(plane.points[i], a, b); };
  // Sites in triangles that hold only a vertex of the line are first reached from there.
  const double side = 1. / 24.;
  const auto d = run(surface, Kind::euclidean, {surface.line(line)});
  EXPECT_LT(largest_error(d, truth), 0.1 * side);
  EXPECT_LT(largest_error(run(surface, Kind::planar, {surface.line(line)}), truth), side);
  std::reverse(line.begin(), line.end());
  const auto reversed = run(surface, Kind::euclidean, {surface.line(line)});
  EXPECT_LT(largest_error(reversed, [&](Index i) { return d[i]; }), 1e-9);
}

TEST(Front, leaves_a_line_across_faces)
{
  // From one point of a face to another: the polyline x = 0.31 across a regular grid.
  const std::size_t n = 10;
  const Triangulation plane = square(n);
  const Glued_surface surface(plane);
  internal::Source source;
  const double share = 0.1; // of the column 0.3 .. 0.4
  for(Index j = 0; j < n; ++j)
  {
    // Face 2 c has the corners (0,0), (1,0), (1,1) of its cell, face 2 c + 1 (0,0), (1,1), (0,1).
    const Index cell = 3 + n * j;
    source.polyline.push_back(surface.in(2 * cell, {1. - share, share, 0.}));
    source.polyline.push_back(surface.in(2 * cell, {1. - share, 0., share}));
  }
  source.polyline.push_back(surface.in(2 * (3 + n * (n - 1)) + 1, {0., share, 1. - share}));
  const auto d = run(surface, Kind::euclidean, {source});
  EXPECT_LT(largest_error(d, [&](Index i) { return std::abs(plane.points[i][0] - 0.31); }), flat);
}

TEST(Front, leaves_the_borders_of_an_annulus)
{
  const Index n = 48, rows = 10;
  const Triangulation ring = annulus(n, rows, 1., 3.); // the first row of points is the outer one
  const Glued_surface surface(ring);
  for(const Index first : {Index(0), Index(n * rows)})
  {
    std::vector<Index> border(n + 1);
    for(Index i = 0; i <= n; ++i)
      border[i] = first + i % n;
    const auto d = run(surface, Kind::euclidean, {surface.line(border)});
    const auto truth = [&](Index i)
    {
      double result = infinity;
      for(Index k = 0; k < n; ++k)
        result = std::min(result, distance_to_segment(ring.points[i], ring.points[border[k]],
                                                      ring.points[border[k + 1]]));
      return result;
    };
    // At the creases between the waves of two segments: part of a side, of length 0.2 to 0.4.
    EXPECT_LT(largest_error(d, truth), 0.1 * 0.3) << "from the border that begins at " << first;
  }
}

TEST(Front, never_mixes_the_fronts_of_several_sources)
{
  const Triangulation plane = stretched(30, 1., 1., 9);
  const Glued_surface surface(plane);
  std::mt19937 random(3);
  for(const bool has_offsets : {false, true})
    for(const std::size_t count : {2u, 3u, 10u, 100u})
    {
      std::vector<internal::Source> sources;
      std::vector<Index> points;
      std::vector<double> offsets;
      for(std::size_t i = 0; i < count; ++i)
      {
        points.push_back(Index(random() % plane.points.size()));
        offsets.push_back(has_offsets ? 0.05 * double(random() % 1000) / 1000. : 0.);
        sources.push_back(surface.source(points.back(), offsets.back(), Index(i)));
      }
      const auto to_source = [&](Index i, std::size_t k)
      { return offsets[k] + distance(plane.points[i], plane.points[points[k]]); };
      const auto truth = [&](Index i)
      {
        double result = infinity;
        for(std::size_t k = 0; k < count; ++k)
          result = std::min(result, to_source(i, k));
        return result;
      };
      Front front(surface.triangles(), Kind::euclidean);
      front.run(sources);
      const auto d = surface.distances(front);
      // Where two fronts meet in a triangle, each may have to go along a side: half of it at most.
      // One percent of many sides of 1/30 in a cell of three sides, few of which are concerned.
      const double side = 1. / 30.;
      EXPECT_LT(largest_error(d, truth), 0.5 * side) << count << " sources " << has_offsets;
      EXPECT_LT(mean_relative_error(d, side, truth), 0.01) << count << " sources " << has_offsets;
      // The label is that of a source that explains the distance.
      for(Index i = 0; i < d.size(); ++i)
        EXPECT_LT(to_source(i, front.source(surface.site(i))), truth(i) + 0.5 * side);
    }
}

TEST(Front, does_not_depend_on_the_order_of_sources)
{
  const Glued_surface surface(shaken(icosphere(4), 0.01));
  std::vector<internal::Source> sources;
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

TEST(Front, takes_a_source_that_another_one_overtakes)
{
  const Triangulation plane = square(16, 0.24);
  const Glued_surface surface(plane);
  // The second starts later than the first one arrives there.
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(0), surface.source(100, 3.)});
    const auto alone = run(surface, kind, {surface.source(0)});
    EXPECT_LT(largest_error(surface.distances(front), [&](Index i) { return alone[i]; }), rounding);
    for(Index i = 0; i < surface.size(); ++i)
      EXPECT_EQ(front.source(i), 0u);
  }
}

TEST(Front, adds_offsets)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  for(const Kind kind : all_kinds)
  {
    const auto d = run(surface, kind, {surface.source(7)});
    for(const double offset : {-2., 0.5, 100.})
    {
      const auto e = run(surface, kind, {surface.source(7, offset)});
      // Roundings of the offset's size.
      EXPECT_LT(largest_error(e, [&](Index i) { return offset + d[i]; }),
                1e-13 * (1. + std::abs(offset)));
    }
  }
}

TEST(Front, is_symmetric)
{
  // Exact where the surface is flat between them; elsewhere each way has the method's error.
  const Glued_surface surface(shaken(icosphere(4), 0.02));
  std::mt19937 random(4);
  double sum = 0.;
  for(int i = 0; i < 40; ++i)
  {
    const Index a = Index(random() % surface.size()), b = Index(random() % surface.size());
    if(a == b)
      continue;
    const double there = run(surface, Kind::euclidean, {surface.source(a)})[b],
                 back = run(surface, Kind::euclidean, {surface.source(b)})[a];
    EXPECT_NEAR(there, back, 0.02 * there);
    sum += std::abs(there / back - 1.);
    EXPECT_NEAR(run(surface, Kind::arcs, {surface.source(a)})[b],
                run(surface, Kind::arcs, {surface.source(b)})[a], rounding);
  }
  EXPECT_LT(sum / 40., 0.004);
}

TEST(Front, obeys_the_triangle_inequality)
{
  const Glued_surface surface(shaken(icosphere(4), 0.02));
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
        // Twice the largest relative error of a distance, see is_symmetric.
        EXPECT_LE(d[a][c], (d[a][points[b]] + d[b][c]) * 1.04);
}

TEST(Front, is_exactly_scaled_by_speed)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
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

TEST(Front, of_speed_one_is_the_planar_one)
{
  const Glued_surface surface(shaken(icosphere(3), 0.02));
  Front_limits limits;
  limits.slowness =
      std::make_shared<const std::vector<double>>(surface.triangles()->number_of_triangles(), 1.);
  const auto planar = run(surface, Kind::planar, {surface.source(7)});
  EXPECT_EQ(run(surface, Kind::planar, {surface.source(7)}, limits), planar);
  EXPECT_EQ(run(surface, Kind::euclidean, {surface.source(7)}, limits), planar);
}

TEST(Front, stops_at_obstacles)
{
  const std::size_t n = 20;
  const Triangulation plane = square(n, 0.24);
  const Glued_surface surface(plane);
  for(const bool has_gap : {false, true})
  {
    // The column of cells at x in [0.5, 0.55] is an obstacle; but for the uppermost, if there is
    // a gap.
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
          EXPECT_LE(d[i], 2.); // along the sides of a square
        else if(!has_gap)
          EXPECT_EQ(d[i], infinity);
        else
        {
          // Over the gap, between heights 0.95 and 1.
          EXPECT_GE(d[i], std::hypot(0.5, 0.95 - 0.3 / n));
          EXPECT_LT(d[i], infinity);
        }
      }
    }
  }
}

// Through a medium of slowness 1 below y = 0.5 into one of slowness p above: Fermat's shortest time
// from (0.5, 0) to a point, by bisection of its derivative (Snell's law).
double time_through_layers(const Point& target, double p)
{
  if(target[1] <= 0.5)
  {
    const double direct = std::hypot(target[0] - 0.5, target[1]);
    if(p >= 1.)
      return direct;
    // Along the border of the faster medium, entered and left at the critical angle.
    const double across = std::abs(target[0] - 0.5), depth = 0.5 + 0.5 - target[1];
    const double head = p * across + depth * std::sqrt(1. - p * p);
    return across >= depth * p / std::sqrt(1. - p * p) ? std::min(direct, head) : direct;
  }
  double low = std::min(0.5, target[0]), high = std::max(0.5, target[0]);
  const double up = target[1] - 0.5;
  for(int i = 0; i < 100; ++i)
  {
    const double x = 0.5 * (low + high);
    const double slope =
        (x - 0.5) / std::hypot(x - 0.5, 0.5) + p * (x - target[0]) / std::hypot(x - target[0], up);
    (slope > 0. ? high : low) = x;
  }
  return std::hypot(low - 0.5, 0.5) + p * std::hypot(low - target[0], up);
}

TEST(Front, is_refracted_by_snells_law)
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
      const Glued_surface surface(plane);
      std::vector<double> slowness(2 * n * n);
      for(Index f = 0; f < 2 * n * n; ++f)
        slowness[surface.triangle(f)] = f < n * n ? 1. : p;
      Front_limits limits;
      limits.slowness = std::make_shared<const std::vector<double>>(slowness);
      const auto d = run(surface, Kind::planar, {surface.source(Index(n / 2))}, limits);
      error[level] = mean_relative_error(
          d, 0.05, [&](Index i) { return time_through_layers(plane.points[i], p); });
    }
    // First order but for the logarithm, with h = 1/80.
    EXPECT_LT(error[1], 0.02) << p;
    EXPECT_GT(std::log2(error[0] / error[1]), 0.4) << p;
  }
}

TEST(Front, reaches_what_is_within_the_maximum_distance)
{
  const Glued_surface surface(shaken(icosphere(4), 0.01));
  for(const Kind kind : all_kinds)
  {
    const auto all = run(surface, kind, {surface.source(30)});
    for(const double limit : {0., 0.1, 0.5, 2.})
    {
      Front front(surface.triangles(), kind);
      Front_limits limits;
      limits.maximum_distance = limit / surface.scale();
      front.run({surface.source(30)}, limits);
      std::size_t inside = 0;
      for(Index i = 0; i < surface.size(); ++i)
      {
        const double d = surface.scale() * front.distance(surface.site(i));
        // A gain of 1e-9 is one that the front may leave.
        if(all[i] <= limit * (1. - 1e-9))
        {
          EXPECT_NEAR(d, all[i], 1e-8) << "limit " << limit << " kind " << int(kind);
        }
        else if(all[i] > limit * (1. + 1e-9))
        {
          EXPECT_EQ(d, infinity) << "limit " << limit << " kind " << int(kind);
        }
        inside += d < infinity;
      }
      EXPECT_EQ(front.reached().size(), inside);
    }
  }
}

TEST(Front, keeps_what_it_reached_in_order_and_once)
{
  const Glued_surface surface(shaken(icosphere(4), 0.02));
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(3), surface.source(1000)});
    auto reached = front.reached();
    EXPECT_EQ(reached.size(), surface.size());
    for(std::size_t i = 1; i < reached.size(); ++i)
      // Nearly: by less than the longest side, which is below 2 in the domain's scale.
      EXPECT_GT(front.distance(reached[i]), front.distance(reached[i - 1]) - 2.);
    std::sort(reached.begin(), reached.end());
    EXPECT_EQ(std::unique(reached.begin(), reached.end()), reached.end());
  }
}

TEST(Front, gives_targets_what_the_full_run_gives)
{
  for(const Triangulation& shape : {shaken(icosphere(4), 0.02), Walled_square().surface})
  {
    const Glued_surface surface(shape);
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
        for(const Location& target : limits.targets)
          EXPECT_NEAR(front.distance(target), full.distance(target), 1e-8); // see `flat`
      }
      // A near one is reached without the rest.
      Front_limits limits;
      limits.targets = {surface.at(1)};
      front.run({surface.source(0)}, limits);
      EXPECT_LT(front.reached().size(), surface.size());
    }
  }
}

TEST(Front, goes_on_to_the_end_for_a_target_out_of_reach)
{
  const Glued_surface surface(apart(tetrahedron(), square(4)));
  Front_limits limits;
  limits.targets = {surface.at(10)};
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    EXPECT_TRUE(front.run({surface.source(0)}, limits));
    EXPECT_EQ(front.distance(surface.site(10)), infinity);
    EXPECT_EQ(front.reached().size(), 4u);
  }
}

TEST(Front, is_cancelled_by_its_callback)
{
  const Glued_surface surface(icosphere(5));
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
        EXPECT_NEAR(d[i], all[i], 1e-3); // the last of them might still have been corrected
      }
    EXPECT_EQ(finite, front.reached().size());
    EXPECT_GT(finite, 0u);
    EXPECT_LT(finite, d.size());
    // And the next run is a whole one.
    EXPECT_TRUE(front.run({surface.source(0)}));
    EXPECT_EQ(surface.distances(front), all);
  }
}

TEST(Front, knows_a_predecessor_next_to_the_shortest_path)
{
  for(const Triangulation& shape :
      {shaken(icosphere(4), 0.02), Walled_square().surface, cone(20, 8, 3. * pi)})
  {
    const Glued_surface surface(shape);
    const Glued_triangles& t = *surface.triangles();
    for(const Kind kind : all_kinds)
    {
      Front front(surface.triangles(), kind);
      front.run({surface.source(0), surface.source(30, 0.01)});
      for(const Index site : front.reached())
      {
        std::size_t steps = 0;
        Index at = site;
        for(Index before; (before = front.predecessor(at)) != none; at = before)
        {
          EXPECT_LT(front.distance(before), front.distance(at));
          EXPECT_EQ(front.source(before), front.source(at));
          EXPECT_NE(common_triangle(t, at_site(t, before), at_site(t, at)), none);
          ASSERT_LT(++steps, surface.size());
        }
        EXPECT_EQ(at, surface.site(front.source(site) == 0 ? 0 : 30)) << "kind " << int(kind);
      }
    }
  }
}

TEST(Front, has_distances_everywhere)
{
  // Exact in the plane, inside of triangles as at their corners.
  const Triangulation plane = stretched(16, 1., 0.6, 8);
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  Front front(surface.triangles(), Kind::euclidean);
  front.run({surface.source(100)});
  std::mt19937 random(7);
  for(int i = 0; i < 500; ++i)
  {
    const Location location = random_location(t, random);
    EXPECT_NEAR(surface.scale() * front.distance(location),
                distance(plane.points[100], point_at(t, location)), flat);
  }
}

TEST(Front, is_continuous_inside_triangles)
{
  const Glued_surface surface(shaken(icosphere(3), 0.05));
  const Glued_triangles& t = *surface.triangles();
  std::mt19937 random(8);
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(17), surface.source(300)});
    for(Index f = 0; f < t.number_of_triangles(); ++f)
      for(Index k = 0; k < 3; ++k)
      {
        const double corner = front.distance(t.corner[3 * f + k]);
        EXPECT_EQ(front.distance(Location{f, none, at_corner(k)}), corner);
        // Never more than the way to a corner.
        Location location = random_location(t, random);
        location.triangle = f;
        const double way = distance_in_triangle(t, f, location.barycentric, at_corner(k));
        EXPECT_LE(front.distance(location), corner + way + rounding);
      }
  }
}

TEST(Front, gives_each_query_what_a_fresh_one_gives)
{
  const Glued_surface surface(shaken(icosphere(4), 0.02));
  std::mt19937 random(9);
  for(const Kind kind : all_kinds)
  {
    Front reused(surface.triangles(), kind);
    for(int i = 0; i < 12; ++i)
    {
      std::vector<internal::Source> sources;
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
      for(Index site = 0; site < surface.size(); ++site)
      {
        EXPECT_EQ(reused.source(site), fresh.source(site));
        EXPECT_EQ(reused.predecessor(site), fresh.predecessor(site));
      }
    }
  }
}

TEST(Front, can_run_in_threads)
{
  const Glued_surface surface(shaken(icosphere(5), 0.01));
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

TEST(Front, survives_triangles_without_area)
{
  // A row of points on a line, twice the same point, and a face with one corner on its own side.
  Triangulation surface = square(8, 0.24);
  for(int i = 0; i < 5; ++i)
    surface.points[40 + i] = surface.points[40];
  for(Index i = 10; i < 17; ++i)
    surface.points[i][1] = surface.points[10][1];
  const Glued_surface glued_surface(surface);
  for(const Kind kind : all_kinds)
    for(const Index source : {0, 12, 42, 80})
    {
      const auto d = run(glued_surface, kind, {glued_surface.source(Index(source))});
      for(Index i = 0; i < d.size(); ++i)
      {
        EXPECT_TRUE(d[i] < infinity);
        // The surface turns over at these points; there the method errs by a percent.
        EXPECT_GE(d[i], 0.98 * distance(surface.points[source], surface.points[i]) - rounding);
      }
      for(int i = 1; i < 5; ++i)
        EXPECT_NEAR(d[40 + i], d[40], flat);
    }
}

TEST(Front, passes_pinched_sites)
{
  // Two squares that share a corner point: (1, 1) of the first is (0, 0) of the second.
  const Index n = 6, m = (n + 1) * (n + 1);
  Triangulation second = square(n, 0.24, 2);
  for(Point& p : second.points)
    for(int k = 0; k < 2; ++k)
      p[k] += 1.;
  Triangulation surface = apart(square(n, 0.24), second);
  for(Index& corner : surface.corners)
    if(corner == m)
      corner = m - 1;
  const Glued_surface glued_surface(surface);
  const auto d = run(glued_surface, Kind::euclidean, {glued_surface.source(0)});
  for(Index i = 0; i < d.size(); ++i)
  {
    if(i == m) // in no triangle any more
      EXPECT_EQ(d[i], infinity);
    else if(i < m)
      EXPECT_NEAR(d[i], distance(surface.points[0], surface.points[i]), flat);
    else
      EXPECT_NEAR(d[i], std::sqrt(2.) + distance(surface.points[m - 1], surface.points[i]), flat);
  }
}

TEST(Front, does_nothing_without_sources)
{
  const Glued_surface surface(tetrahedron());
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

TEST(Front, goes_on_only_where_it_improves_what_is_known)
{
  const Triangulation plane = square(30, 0.2, 3);
  const Glued_surface surface(plane);
  const Glued_triangles& t = surface.t();
  for(const Kind kind : all_kinds)
  {
    Front front(surface.triangles(), kind);
    front.run({surface.source(0)});
    std::vector<double> known(surface.size());
    for(Index site = 0; site < surface.size(); ++site)
      known[site] = front.distance(site);
    front.run({surface.source(960)});
    std::vector<double> alone(surface.size());
    for(Index site = 0; site < surface.size(); ++site)
      alone[site] = front.distance(site);

    Front_limits limits;
    limits.known = &known;
    EXPECT_TRUE(front.run({surface.source(960)}, limits));
    // Both are straight in the plane; the sites halfway may be told by other triangles.
    double worst = 0.;
    std::vector<bool> is_near(surface.size(), false);
    for(Index f = 0; f < t.number_of_triangles(); ++f)
    {
      bool has_improved = false;
      for(Index k = 0; k < 3; ++k)
        has_improved =
            has_improved || front.distance(t.corner[3 * f + k]) < known[t.corner[3 * f + k]];
      for(Index k = 0; k < 3; ++k)
        if(has_improved)
        {
          is_near[t.corner[3 * f + k]] = true;
          // The ring beyond is known, but for chains of arcs that need none.
          if(kind != Kind::arcs)
          {
            EXPECT_LT(front.distance(t.corner[3 * f + k]), infinity);
          }
        }
    }
    for(Index site = 0; site < surface.size(); ++site)
    {
      worst = std::max(worst, std::min(front.distance(site), known[site]) -
                                  std::min(alone[site], known[site]));
      if(!is_near[site])
      {
        EXPECT_EQ(front.distance(site), infinity);
      }
    }
    // A side is 1/30, in units of the domain.
    EXPECT_LE(worst, kind == Kind::arcs ? 0. : 0.02 / 30. / surface.scale());
  }
}

} // namespace
