// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>

#include <CGAL/Geodesic_processing/internal/distances/front.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <gtest/gtest.h>

namespace path_to_sources_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

std::vector<Surface_location> find_path(const Surface_arrays& t, const Front& front,
                                        const Surface_location& from,
                                        const std::vector<internal::Front_source>& sources)
{
  return path_to_sources(
      t, from, sources, [&](Index i) { return front.distance(i); },
      [&](Index i) { return front.predecessor(i); }, [&](Index i) { return front.source(i); });
}

TEST(Path_to_sources, is_straight_in_plane)
{
  const Array_surface surface(square(20, 0.24));
  const Surface_arrays& t = *surface.triangles();
  std::mt19937 random(1);
  for(const Front_kind kind : {Front_kind::dijkstra, Front_kind::planar, Front_kind::euclidean})
  {
    Front front(surface.triangles(), kind);
    for(int i = 0; i < 20; ++i)
    {
      const Surface_location from = random_location(t, random), to = random_location(t, random);
      front.run({surface.source(to)});
      const auto path = find_path(t, front, from, {surface.source(to)});
      expect_path_on_surface(t, path, from, to);
      // In a convex region of the plane, every shortened path is straight.
      EXPECT_NEAR(surface.scale() * path_length(t, path),
                  distance(point_at(t, from), point_at(t, to)),
                  1e-12); // round-off errors of some tens of crossings
    }
  }
}

TEST(Path_to_sources, ends_at_nearest_source)
{
  const Triangulation plane = square(20, 0.24);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  const std::vector<internal::Front_source> sources = {
      surface.source(0), surface.source(20), surface.source(220, 0.2), surface.source(440)};
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run(sources);
  for(Index i = 0; i < surface.size(); ++i)
  {
    const auto path = find_path(t, front, surface.at(i), sources);
    ASSERT_FALSE(path.empty());
    const Index end = vertex_of(t, path.back());
    const auto source = std::find_if(sources.begin(), sources.end(),
                                     [&](const internal::Front_source& candidate)
                                     { return candidate.polyline[0].vertex == end; });
    ASSERT_NE(source, sources.end());
    expect_path_on_surface(t, path, surface.at(i), source->polyline[0]);
    // If two sources are almost equally far, the path may end at either. Their distances then
    // differ by less than the length of an edge.
    const double length_with_offset = surface.scale() * (source->offset + path_length(t, path)),
                 distance = surface.scale() * front.distance(surface.vertex(i));
    EXPECT_GT(length_with_offset, distance - 0.5 / 20.);
    EXPECT_LT(length_with_offset, distance + 1. / 20.);
  }
}

TEST(Path_to_sources, is_single_location_from_source_to_itself)
{
  const Array_surface surface(icosphere(2));
  const Surface_arrays& t = *surface.triangles();
  Front front(surface.triangles(), Front_kind::euclidean);
  for(const Surface_location& location :
      {surface.at(5), surface.on(7, 1, 0.4), surface.in(9, {.2, .3, .5})})
  {
    front.run({surface.source(location)});
    EXPECT_EQ(find_path(t, front, location, {surface.source(location)}).size(), 1u);
  }
}

TEST(Path_to_sources, is_empty_when_no_source_is_reachable)
{
  Triangulation shape = disjoint_union(square(4), tetrahedron());
  shape.points.push_back({9., 9., 9.});
  const Array_surface surface(shape);
  const Surface_arrays& t = *surface.triangles();
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run({surface.source(0)});
  for(const Surface_location& from : {surface.at(25), surface.in(33, {.2, .3, .5}), surface.at(29)})
    EXPECT_TRUE(find_path(t, front, from, {surface.source(0)}).empty());
  front.run({surface.source(29)});
  EXPECT_EQ(find_path(t, front, surface.at(29), {surface.source(29)}).size(), 1u);
  EXPECT_TRUE(find_path(t, front, surface.at(0), {surface.source(29)}).empty());
}

TEST(Path_to_sources, ends_at_nearest_point_of_polyline)
{
  const Triangulation plane = square(20, 0.24);
  const Array_surface surface(plane);
  const Surface_arrays& t = *surface.triangles();
  std::vector<Index> edge_vertices(21);
  for(Index i = 0; i <= 20; ++i)
    edge_vertices[i] = i; // y = 0
  Front front(surface.triangles(), Front_kind::euclidean);
  front.run({surface.line(edge_vertices)});
  std::mt19937 random(2);
  for(int i = 0; i < 30; ++i)
  {
    const Surface_location from = random_location(t, random);
    const auto path = find_path(t, front, from, {surface.line(edge_vertices)});
    ASSERT_FALSE(path.empty());
    const Point p = point_at(t, from), q = point_at(t, path.back());
    // A round-off error of a coordinate.
    EXPECT_NEAR(q[1], 0., 1e-15);
    // Shortening keeps the end of the traced path. Its error is of first order in the edge length
    // 1/20, so that the error of the length is of second order.
    EXPECT_LT(surface.scale() * path_length(t, path), p[1] * 1.02 + 1e-3);
  }
}

TEST(Path_to_sources, joins_end_points_on_point_set)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit;
  std::vector<Point> points(2000);
  for(Point& p : points)
    p = {unit(random), unit(random), 0.};
  const Surfel_arrays surfels =
      build_surfel_arrays(points, std::vector<Point>(points.size(), Point{0., 0., 1.}));
  const auto triangles = std::make_shared<const Surface_arrays>(surfels.arrays);
  Front front(triangles, Front_kind::euclidean);
  const Surface_location to = {none, surfels.internal_vertex[0], {}};
  front.run({{{to}, 0., 0}});
  for(Index i = 1; i < 200; ++i)
  {
    const Surface_location from = {none, surfels.internal_vertex[i], {}};
    const auto path = find_path(*triangles, front, from, {{{to}, 0., 0}});
    ASSERT_GE(path.size(), 2u);
    const double chord = distance(points[0], points[i]);
    // Round-off errors of coordinates near 1.
    EXPECT_LT(distance(point_at(*triangles, path.front()), points[i]), 1e-14);
    EXPECT_LT(distance(point_at(*triangles, path.back()), points[0]), 1e-14);
    const double length = triangles->scale * polyline_length(*triangles, path);
    EXPECT_GE(length, chord * (1. - 1e-12)); // round-off errors of a sum of lengths
    // Near the boundary, a path may have to go around a gap of some radii, 0.06.
    EXPECT_LE(length, 1.02 * chord + 0.02);
  }
}

} // namespace path_to_sources_test
