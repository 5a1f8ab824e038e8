// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfels.h>

#include "Glued_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::vector<Location> path_down(const Glued_triangles& t, const Front& front, const Location& from,
                                const std::vector<internal::Source>& sources)
{
  return path_to_sources(
      t, from, sources, [&](Index i) { return front.distance(i); },
      [&](Index i) { return front.predecessor(i); }, [&](Index i) { return front.source(i); });
}

TEST(Path_to_sources, is_straight_in_the_plane)
{
  const Glued_surface surface(square(20, 0.24));
  const Glued_triangles& t = *surface.triangles();
  std::mt19937 random(1);
  for(const Front_kind kind : {Front_kind::arcs, Front_kind::planar, Front_kind::euclidean})
  {
    Front front(surface.triangles(), kind);
    for(int i = 0; i < 20; ++i)
    {
      const Location from = random_location(t, random), to = random_location(t, random);
      front.run({surface.source(to)});
      const auto path = path_down(t, front, from, {surface.source(to)});
      expect_path_on_surface(t, path, from, to);
      // Straightening makes any path in a convex region of the plane the straight one.
      EXPECT_NEAR(surface.scale() * path_length(t, path),
                  distance(point_at(t, from), point_at(t, to)), 1e-12); // some tens of crossings
    }
  }
}

TEST(Path_to_sources, ends_at_a_nearest_source)
{
  const Triangulation plane = square(20, 0.24);
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  const std::vector<internal::Source> sources = {surface.source(0), surface.source(20),
                                                 surface.source(220, 0.2), surface.source(440)};
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run(sources);
  for(Index i = 0; i < surface.size(); ++i)
  {
    const auto path = path_down(t, front, surface.at(i), sources);
    ASSERT_FALSE(path.empty());
    const Index end = site_of(t, path.back());
    const auto source =
        std::find_if(sources.begin(), sources.end(),
                     [&](const internal::Source& one) { return one.polyline[0].site == end; });
    ASSERT_NE(source, sources.end());
    expect_path_on_surface(t, path, surface.at(i), source->polyline[0]);
    // Where two are about as near it may be either: their distances differ by less than a side.
    const double length = surface.scale() * (source->offset + path_length(t, path)),
                 distance = surface.scale() * front.distance(surface.site(i));
    EXPECT_GT(length, distance - 0.5 / 20.);
    EXPECT_LT(length, distance + 1. / 20.);
  }
}

TEST(Path_to_sources, is_a_location_from_a_source_to_itself)
{
  const Glued_surface surface(icosphere(2));
  const Glued_triangles& t = *surface.triangles();
  Front front(surface.triangles(), Front_kind::euclidean);
  for(const Location& place : {surface.at(5), surface.on(7, 1, 0.4), surface.in(9, {.2, .3, .5})})
  {
    front.run({surface.source(place)});
    EXPECT_EQ(path_down(t, front, place, {surface.source(place)}).size(), 1u);
  }
}

TEST(Path_to_sources, is_empty_where_no_source_can_be_reached)
{
  Triangulation shape = apart(square(4), tetrahedron());
  shape.points.push_back({9., 9., 9.});
  const Glued_surface surface(shape);
  const Glued_triangles& t = *surface.triangles();
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run({surface.source(0)});
  for(const Location& from : {surface.at(25), surface.in(33, {.2, .3, .5}), surface.at(29)})
    EXPECT_TRUE(path_down(t, front, from, {surface.source(0)}).empty());
  front.run({surface.source(29)});
  EXPECT_EQ(path_down(t, front, surface.at(29), {surface.source(29)}).size(), 1u);
  EXPECT_TRUE(path_down(t, front, surface.at(0), {surface.source(29)}).empty());
}

TEST(Path_to_sources, comes_down_to_the_nearest_place_of_a_polyline)
{
  const Triangulation plane = square(20, 0.24);
  const Glued_surface surface(plane);
  const Glued_triangles& t = *surface.triangles();
  std::vector<Index> side(21);
  for(Index i = 0; i <= 20; ++i)
    side[i] = i; // y = 0
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run({surface.line(side)});
  std::mt19937 random(2);
  for(int i = 0; i < 30; ++i)
  {
    const Location from = random_location(t, random);
    const auto path = path_down(t, front, from, {surface.line(side)});
    ASSERT_FALSE(path.empty());
    // The end of a traced path is kept: by first order in the side 1/20 beside the foot, which
    // costs by second order.
    const Point p = point_at(t, from), q = point_at(t, path.back());
    EXPECT_NEAR(q[1], 0., 1e-15);
    EXPECT_LT(surface.scale() * path_length(t, path), p[1] * 1.02 + 1e-3);
  }
}

TEST(Path_to_sources, on_a_cloud_joins_its_ends)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit;
  std::vector<Point> points(2000);
  for(Point& p : points)
    p = {unit(random), unit(random), 0.};
  const Glued_surfels surfels =
      glue_surfels(points, std::vector<Point>(points.size(), Point{0., 0., 1.}));
  const auto triangles = std::make_shared<const Glued_triangles>(surfels.triangles);
  Front front(triangles, Front_kind::euclidean);
  const Location to = {none, surfels.site_of_surfel[0], {}};
  front.run({{{to}, 0., 0}});
  for(Index i = 1; i < 200; ++i)
  {
    const Location from = {none, surfels.site_of_surfel[i], {}};
    const auto path = path_down(*triangles, front, from, {{{to}, 0., 0}});
    ASSERT_GE(path.size(), 2u);
    const double chord = distance(points[0], points[i]);
    EXPECT_LT(distance(point_at(*triangles, path.front()), points[i]), 1e-14);
    EXPECT_LT(distance(point_at(*triangles, path.back()), points[0]), 1e-14);
    const double length = triangles->scale * polyline_length(*triangles, path);
    EXPECT_GE(length, chord * (1. - 1e-12));
    // Near the border a path may have to turn around a gap of some radii, 0.06.
    EXPECT_LE(length, 1.02 * chord + 0.02);
  }
}

} // namespace
