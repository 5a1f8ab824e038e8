// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>
#include "core/unfold.h"

#include "Glued_surface.h"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

using Kind = Front_kind;
using Sources = std::vector<internal::Source>;

Voronoi voronoi(const std::shared_ptr<const Glued_triangles>& triangles, const Sources& sources,
                const Front_limits& limits = {}, Kind kind = Kind::euclidean)
{
  Index cells = 0;
  for(const internal::Source& source : sources)
    cells = std::max(cells, source.label + 1);
  return Voronoi(triangles, Front(triangles, kind), sources, cells, limits);
}

Sources sources_at(const std::vector<Location>& places)
{
  Sources result;
  for(const Location& place : places)
    result.push_back({{place}, 0., Index(result.size())});
  return result;
}

Sources spread(const std::shared_ptr<const Glued_triangles>& triangles, std::size_t number)
{
  return sources_at(farthest_points(triangles, number));
}

void expect_joined(const Glued_triangles& t, const Voronoi& cells)
{
  for(const Voronoi::Bisector& bisector : cells.bisectors())
  {
    EXPECT_NE(bisector.left, bisector.right);
    ASSERT_GE(bisector.line.size(), 2u);
    for(std::size_t i = 1; i < bisector.line.size(); ++i)
      EXPECT_NE(common_triangle(t, cleaned(t, bisector.line[i - 1]), cleaned(t, bisector.line[i])),
                none);
  }
}

// Lines end at a place of three cells or where the surface does, and together cross each side between
// two cells once.
void expect_consistent(const Glued_triangles& t, const Voronoi& cells)
{
  expect_joined(t, cells);
  std::size_t crossed = 0, triple = 0;
  for(Index side = 0; side < t.corner.size(); ++side)
    crossed += (t.twin[side] == none || t.twin[side] > side) &&
               cells.labels()[t.corner[side]] != cells.labels()[t.corner[next_side(side)]];
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    triple += std::set<Index>{cells.labels()[t.corner[3 * f]], cells.labels()[t.corner[3 * f + 1]],
                              cells.labels()[t.corner[3 * f + 2]]}
                  .size() == 3;
  std::size_t crossings = 0, ends = 0;
  for(const Voronoi::Bisector& bisector : cells.bisectors())
  {
    const std::vector<Location>& line = bisector.line;
    const auto is_inside = [](const Location& place)
    { return place.barycentric[0] * place.barycentric[1] * place.barycentric[2] > 0.; };
    const std::size_t inside = is_inside(line.front()) + is_inside(line.back());
    const bool is_loop =
        inside == 0 && is_same_point(t, cleaned(t, line.front()), cleaned(t, line.back()));
    crossings += line.size() - inside - is_loop;
    ends += inside;
  }
  EXPECT_EQ(crossings, crossed);
  EXPECT_EQ(ends, 3 * triple);
}

TEST(Voronoi, of_two_points_of_a_square_is_the_line_between)
{
  const Triangulation plane = square(20, 0.2, 4);
  const Glued_surface surface(plane);
  // Opposite corners: the other diagonal.
  const Voronoi cells = voronoi(surface.triangles(), sources_at({surface.at(0), surface.at(440)}));
  expect_consistent(surface.t(), cells);
  const auto bisectors = cells.bisectors();
  ASSERT_EQ(bisectors.size(), 1u);
  EXPECT_NEAR(surface.scale() * path_length(surface.t(), bisectors[0].line), std::sqrt(2.), 1e-9);
  const auto u = coordinates(surface.t(), bisectors[0].line.front()),
             v = coordinates(surface.t(), bisectors[0].line.back());
  // The first one's cell, around (0, 0), is on the left of the way up.
  const bool is_up = v[1] > u[1];
  EXPECT_EQ(bisectors[0].left, is_up ? 0u : 1u);
  EXPECT_EQ(bisectors[0].right, is_up ? 1u : 0u);
  for(const Location& place : bisectors[0].line)
  {
    const auto p = coordinates(surface.t(), place);
    EXPECT_NEAR(p[0] + p[1], 1., 1e-9);
  }
}

TEST(Voronoi, is_that_of_the_plane)
{
  const Triangulation plane = square(50, 0.2, 3);
  const Glued_surface surface(plane);
  for(int trial = 0; trial < 5; ++trial)
  {
    const Sources sources = spread(surface.triangles(), 6 + 5 * trial);
    const Voronoi cells = voronoi(surface.triangles(), sources);
    EXPECT_TRUE(cells.is_finished());
    expect_consistent(surface.t(), cells);
    std::vector<Point> seeds;
    for(const internal::Source& source : sources)
      seeds.push_back(scaled_coordinates(surface.t(), source.polyline[0]));
    const double side = 1. / 50. / surface.scale();
    // Differences of squares of some fifty sides.
    const double rounding = 1e-10 * side;
    double sum = 0.;
    std::size_t count = 0;
    for(const Voronoi::Bisector& bisector : cells.bisectors())
      for(const Location& place : bisector.line)
      {
        const Point p = scaled_coordinates(surface.t(), place);
        const double to_left = distance(p, seeds[bisector.left]),
                     to_right = distance(p, seeds[bisector.right]);
        double least = infinity;
        for(const Point& seed : seeds)
          least = std::min(least, distance(p, seed));
        // On a side both cells are as far.
        if(corner_of(place) == none && side_of(place) != none)
        {
          EXPECT_NEAR(to_left, to_right, rounding);
        }
        // Where a third cell begins is known to within a triangle; its sides are up to two long.
        EXPECT_LT(std::max(to_left, to_right) - least, 2. * side);
        sum += std::max(to_left, to_right) - least;
        ++count;
      }
    EXPECT_LT(sum, 0.05 * side * double(count));
    for(Index site = 0; site < surface.size(); ++site)
    {
      double least = infinity;
      for(const Point& seed : seeds)
        least = std::min(least, distance(seed, surface.t().point[site]));
      EXPECT_NEAR(cells.distances()[site], least, rounding);
      EXPECT_NEAR(distance(seeds[cells.labels()[site]], surface.t().point[site]), least, rounding);
    }
    for(Index f = 0; f < surface.t().number_of_triangles(); ++f)
    {
      const Point centre = scaled_coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}});
      double least = infinity;
      for(const Point& seed : seeds)
        least = std::min(least, distance(seed, centre));
      // A cell that comes to the centre but to no corner is not seen.
      EXPECT_NEAR(distance(seeds[cells.label_of_triangle(f)], centre), least, side);
    }
  }
}

TEST(Voronoi, of_a_sphere_has_eulers_number)
{
  const Glued_surface surface(shaken(icosphere(4), 0.01));
  for(const std::size_t n : {4u, 10u, 40u})
  {
    const Voronoi cells = voronoi(surface.triangles(), spread(surface.triangles(), n));
    expect_consistent(surface.t(), cells);
    std::size_t ends = 0;
    const auto bisectors = cells.bisectors();
    for(const Voronoi::Bisector& bisector : bisectors)
      ends += 2 - 2 * is_same_point(surface.t(), cleaned(surface.t(), bisector.line.front()),
                                    cleaned(surface.t(), bisector.line.back()));
    // Cells are discs here, and three lines meet at each place.
    EXPECT_EQ(ends, 2 * bisectors.size());
    EXPECT_EQ(n - bisectors.size() + ends / 3, 2u);
  }
}

TEST(Voronoi, of_two_poles_is_a_loop)
{
  const Triangulation sphere = icosphere(4);
  const Glued_surface surface(sphere);
  const Point pole = sphere.points[0];
  Index opposite = 0;
  for(Index i = 0; i < surface.size(); ++i)
    if(distance(sphere.points[i], -1. * pole) < 1e-9)
      opposite = i;
  const Voronoi cells =
      voronoi(surface.triangles(), sources_at({surface.at(0), surface.at(opposite)}));
  expect_consistent(surface.t(), cells);
  const auto bisectors = cells.bisectors();
  ASSERT_EQ(bisectors.size(), 1u);
  EXPECT_TRUE(is_same_point(surface.t(), cleaned(surface.t(), bisectors[0].line.front()),
                            cleaned(surface.t(), bisectors[0].line.back())));
  // The equator; a chord may go below it, and fronts over triangles are off by some 0.1 percent.
  for(const Location& place : bisectors[0].line)
    EXPECT_NEAR(test::dot(coordinates(surface.t(), place), pole), 0., 2e-3);
}

TEST(Voronoi, of_several_sources_of_a_cell)
{
  const Triangulation plane = square(20, 0.2, 4);
  const Glued_surface surface(plane);
  Sources sources = sources_at({surface.at(0), surface.at(440), surface.at(20)});
  sources[2].label = 0;
  const Voronoi cells = voronoi(surface.triangles(), sources);
  expect_consistent(surface.t(), cells);
  for(const Index label : cells.labels())
    EXPECT_LT(label, 2u);
  // From the middle of the left or upper side to that of the right: two straight pieces.
  double length = 0.;
  for(const auto& bisector : cells.bisectors())
    length += surface.scale() * path_length(surface.t(), bisector.line);
  // Where the fronts of the two sources of a cell meet, it bends inside a triangle.
  EXPECT_NEAR(length, 0.5 + std::sqrt(0.5), 0.05);
}

TEST(Voronoi, ends_where_fronts_do)
{
  const Triangulation plane = square(30, 0.2, 4);
  const Glued_surface surface(plane);
  Front_limits limits;
  limits.maximum_distance = 0.4 / surface.scale();
  const Voronoi near = voronoi(
      surface.triangles(), sources_at({surface.at(5 * 31 + 10), surface.at(5 * 31 + 20)}), limits);
  std::size_t unreached = 0;
  for(Index site = 0; site < surface.size(); ++site)
  {
    EXPECT_EQ(near.labels()[site] == none, near.distances()[site] == infinity);
    unreached += near.labels()[site] == none;
  }
  EXPECT_GT(unreached, 0u);
  ASSERT_EQ(near.bisectors().size(), 1u);

  // A wall between two halves: each cell its own.
  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(std::abs(scaled_coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0]) *
           surface.scale() <
       0.06)
      slowness[f] = infinity;
  limits.maximum_distance = infinity;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  const Voronoi apart = voronoi(
      surface.triangles(), sources_at({surface.at(15 * 31), surface.at(15 * 31 + 30)}), limits);
  for(Index i = 0; i < surface.size(); ++i)
    if(const Index label = apart.labels()[surface.site(i)]; label != none)
    {
      EXPECT_EQ(label, plane.points[i][0] < 0.5 ? 0u : 1u);
    }
}

TEST(Voronoi, moves_with_speed_and_with_offsets)
{
  const Triangulation plane = square(40, 0.2, 4);
  const Glued_surface surface(plane);
  const std::vector<Location> ends = {surface.at(20 * 41), surface.at(20 * 41 + 40)};
  // Where the lines cross the middle, between two points one apart.
  const auto middle = [&](const Voronoi& cells)
  {
    double x = infinity, least = infinity;
    for(const auto& bisector : cells.bisectors())
      for(const Location& place : bisector.line)
        if(const auto p = coordinates(surface.t(), place); std::abs(p[1] - 0.5) < least)
        {
          least = std::abs(p[1] - 0.5);
          x = p[0];
        }
    return x;
  };
  Sources later = sources_at(ends);
  later[1].offset = 0.2 / surface.scale();
  // A line crosses sides, the nearest crossing is within one of them, 1/40.
  EXPECT_NEAR(middle(voronoi(surface.triangles(), later)), 0.6, 0.02);

  std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
  for(Index f = 0; f < slowness.size(); ++f)
    if(scaled_coordinates(surface.t(), {f, none, {1. / 3., 1. / 3., 1. / 3.}})[0] > 0.)
      slowness[f] = 2.;
  Front_limits limits;
  limits.slowness = std::make_shared<const std::vector<double>>(slowness);
  // From the left 0.5 + 2 (x - 0.5), from the right 2 (1 - x); the planar front is off by a percent.
  EXPECT_NEAR(middle(voronoi(surface.triangles(), sources_at(ends), limits)), 0.625, 0.02);
}

// Of the triangle that holds a place, in the domain's scale.
double area_of_cut(const Glued_triangles& t, const Voronoi::Cut& cut, std::size_t triangle)
{
  std::array<Spatial, 3> p;
  for(std::size_t k = 0; k < 3; ++k)
    p[k] = scaled_coordinates(t, cut.vertices[cut.corners[3 * triangle + k]]);
  return 0.5 * norm(internal::cross(p[1] - p[0], p[2] - p[0]));
}

TEST(Voronoi, cut_has_the_area_and_the_shape_of_the_surface)
{
  const std::vector<Triangulation> surfaces = {square(20, 0.2, 4), shaken(icosphere(3), 0.01),
                                               annulus(24, 5, 0.3, 1.)};
  for(const Triangulation& triangulation : surfaces)
    for(const std::size_t number : {2u, 9u, 40u})
    {
      const Glued_surface surface(triangulation);
      const Glued_triangles& t = surface.t();
      const Voronoi cells = voronoi(surface.triangles(), spread(surface.triangles(), number));
      const Voronoi::Cut cut = cells.cut();
      double whole = 0., parts = 0.;
      for(Index f = 0; f < t.number_of_triangles(); ++f)
        whole += 0.5 * twice_area(t.length[3 * f], t.length[3 * f + 1], t.length[3 * f + 2]);
      for(std::size_t f = 0; f < cut.labels.size(); ++f)
      {
        parts += area_of_cut(t, cut, f);
        ASSERT_LT(cut.labels[f], number);
        // Sites belong to their own cells alone.
        for(std::size_t k = 0; k < 3; ++k)
          if(const Index site = cut.corners[3 * f + k]; site < surface.size())
          {
            EXPECT_EQ(cut.labels[f], cells.labels()[site]);
          }
      }
      EXPECT_NEAR(parts, whole, 1e-12 * whole); // rounding

      // As many borders as there were, each side twice at most and both ways,
      // and Euler's number.
      std::set<std::pair<Index, Index>> sides;
      for(std::size_t c = 0; c < cut.corners.size(); ++c)
        EXPECT_TRUE(sides.insert({cut.corners[c], cut.corners[next_side(Index(c))]}).second);
      const auto euler = [](std::size_t vertices, std::size_t corners, std::size_t borders)
      { return long(vertices) - long(corners + borders) / 2 + long(corners) / 3; };
      std::size_t borders = 0, borders_before = 0, crossed = 0;
      for(const auto& [a, b] : sides)
        borders += sides.count({b, a}) == 0;
      for(Index side = 0; side < t.corner.size(); ++side)
        if(t.twin[side] == none)
        {
          ++borders_before;
          crossed += cells.labels()[t.corner[side]] != cells.labels()[t.corner[next_side(side)]];
        }
      EXPECT_EQ(borders, borders_before + crossed);
      EXPECT_EQ(euler(cut.vertices.size(), cut.corners.size(), borders),
                euler(surface.size(), t.corner.size(), borders_before));
    }
}

TEST(Voronoi, cut_of_a_square_has_its_two_halves)
{
  const Glued_surface surface(square(20, 0.2, 4));
  const Voronoi cells = voronoi(surface.triangles(), sources_at({surface.at(0), surface.at(440)}));
  const Voronoi::Cut cut = cells.cut();
  double halves[2] = {0., 0.};
  for(std::size_t f = 0; f < cut.labels.size(); ++f)
    halves[cut.labels[f]] += area_of_cut(surface.t(), cut, f);
  const double square_of_scale = surface.scale() * surface.scale();
  EXPECT_NEAR(halves[0] * square_of_scale, 0.5,
              1e-9); // as the line, in its own test
  EXPECT_NEAR(halves[1] * square_of_scale, 0.5, 1e-9);
}

TEST(Voronoi, cut_has_no_gaps_where_fronts_end)
{
  const Glued_surface surface(square(30, 0.2, 4));
  Front_limits limits;
  limits.maximum_distance = 0.3 / surface.scale();
  const Voronoi::Cut cut =
      voronoi(surface.triangles(), sources_at({surface.at(15 * 31 + 12), surface.at(15 * 31 + 18)}),
              limits)
          .cut();
  EXPECT_EQ(std::set<Index>(cut.labels.begin(), cut.labels.end()), (std::set<Index>{0, 1, none}));
  std::set<std::pair<Index, Index>> sides;
  for(std::size_t c = 0; c < cut.corners.size(); ++c)
    EXPECT_TRUE(sides.insert({cut.corners[c], cut.corners[next_side(Index(c))]}).second);
  // The border of the square alone has no other side.
  std::size_t borders = 0;
  for(const auto& [a, b] : sides)
    borders += sides.count({b, a}) == 0;
  EXPECT_EQ(borders, 120u);
}

TEST(Voronoi, does_not_depend_on_scale)
{
  std::vector<std::vector<double>> all;
  for(const double scale : {1., 0x1p-20, 0x1p20})
  {
    const Triangulation sphere = scaled(icosphere(3), scale);
    const Glued_surface surface(sphere);
    all.emplace_back();
    for(const auto& bisector :
        voronoi(surface.triangles(), spread(surface.triangles(), 20)).bisectors())
      all.back().push_back(path_length(surface.t(), bisector.line));
  }
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
}

TEST(Voronoi, bears_what_is_degenerate)
{
  // More cells than triangles can tell apart, two sources at one place, needles, and all of these at
  // obstacles.
  const std::vector<Triangulation> surfaces = {one_triangle(), tetrahedron(), square(4),
                                               grid(
                                                   12, 12,
                                                   [](double u, double v) {
                                                     return Point{u, 1e-4 * v, 0.};
                                                   },
                                                   0.24, 3),
                                               grid(4, 4,
                                                    [](double u, double) {
                                                      return Point{u, u, 0.};
                                                    })};
  for(const Triangulation& triangulation : surfaces)
  {
    const Glued_surface surface(triangulation);
    Sources sources;
    for(Index i = 0; i < surface.size(); ++i)
      sources.push_back(surface.source(i / 2 * 2, 0., i));
    for(const Kind kind : {Kind::arcs, Kind::planar, Kind::euclidean})
    {
      expect_joined(surface.t(), voronoi(surface.triangles(), sources, {}, kind));
      Front_limits limits;
      std::vector<double> slowness(surface.t().number_of_triangles(), 1.);
      slowness[0] = infinity;
      limits.slowness = std::make_shared<const std::vector<double>>(slowness);
      const Voronoi cells = voronoi(surface.triangles(), sources, limits, kind);
      for(const auto& bisector : cells.bisectors())
        for(const Location& place : bisector.line)
          for(const double b : place.barycentric)
            EXPECT_TRUE(b >= 0. && b <= 1.);
    }
  }
}

TEST(Voronoi, can_be_cancelled)
{
  const Glued_surface surface(square(20));
  double last = 0.;
  Front_limits limits;
  limits.callback = [&](double done)
  {
    EXPECT_GE(done, last);
    last = done;
    return done < 0.5;
  };
  EXPECT_FALSE(voronoi(surface.triangles(), spread(surface.triangles(), 9), limits).is_finished());
}

TEST(Voronoi, of_a_cloud_has_labels)
{
  const Triangulation sphere = icosphere(3);
  const auto glued =
      std::make_shared<const Glued_surfels>(glue_surfels(sphere.points, sphere.points));
  const std::shared_ptr<const Glued_triangles> triangles(glued, &glued->triangles);
  const Sources sources = spread(triangles, 12);
  const Voronoi cells = voronoi(triangles, sources);
  for(Index site = 0; site < triangles->number_of_sites(); ++site)
  {
    double least = infinity;
    const Point p = sphere.points[glued->surfel_of_site[site]];
    const auto to = [&](const internal::Source& source)
    { return great_circle(p, sphere.points[glued->surfel_of_site[source.polyline[0].site]]); };
    for(const internal::Source& source : sources)
      least = std::min(least, to(source));
    ASSERT_LT(cells.labels()[site], 12u);
    // A front over local triangles is off by a percent or two.
    EXPECT_NEAR(to(sources[cells.labels()[site]]), least, 0.02);
  }
}

} // namespace
