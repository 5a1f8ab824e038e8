// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>

#include "Array_surface.h"
#include "path_checks.h"

#include <memory>

namespace Path_finder_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

constexpr double round_off = 1e-12; // a few hundred round-off errors of lengths below 10

TEST(Path_finder, connects_arbitrary_locations)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const Surface_arrays& t = surface.t();
  Path_finder finder(surface.triangles());
  std::mt19937 random(1);
  for(int i = 0; i < 300; ++i)
  {
    Surface_location from = random_location(t, random), to = random_location(t, random);
    if(i % 3 == 0)
      from.barycentric = {0.5, 0., 0.5};
    if(i % 5 == 0)
      to = vertex_location(t, Index(random() % t.number_of_vertices()));
    const auto path = finder(from, to);
    expect_path_on_surface(t, path, from, to);
    const double length = shorten_geodesic(t, path).length * t.scale;
    EXPECT_GE(length, distance(point_at(t, from), point_at(t, to)) - round_off);
    // The reversed query can return another path if two have almost the same length.
    EXPECT_NEAR(shorten_geodesic(t, finder(to, from)).length * t.scale, length, 0.02 * length);
  }
}

TEST(Path_finder, yields_shortest_paths_on_sphere)
{
  const Array_surface surface(icosphere(4));
  const Surface_arrays& t = surface.t();
  Path_finder finder(surface.triangles());
  std::mt19937 random(2);
  const double edge_length = 2. / 16.; // approximate length of an edge, h
  for(int i = 0; i < 100; ++i)
  {
    const Index a = Index(random() % 2562), b = Index(random() % 2562);
    const Point p = point_at(t, surface.at(a)), q = point_at(t, surface.at(b));
    const double angle = 2. * std::asin(std::min(1., distance(p, q) / 2.));
    const double length =
        shorten_geodesic(t, finder(surface.at(a), surface.at(b))).length * t.scale;
    // Paths are compared with great circles. The polyhedron is inside the sphere, at a depth below
    // h^2 / 8 times the radius.
    EXPECT_LE(length, angle * (1. + round_off) + round_off);
    EXPECT_GE(length, angle * (1. - edge_length * edge_length / 4.) - round_off);
  }
}

TEST(Path_finder, returns_only_end_points_in_common_triangle)
{
  const Array_surface surface(square(5, 0.2));
  Path_finder finder(surface.triangles());
  std::mt19937 random(3);
  Surface_location p = random_location(surface.t(), random), q = p;
  q.barycentric = {0.1, 0.1, 0.8};
  EXPECT_EQ(finder(p, p).size(), 1u);
  EXPECT_EQ(finder(p, q).size(), 2u);
  EXPECT_EQ(finder(surface.at(7), surface.at(7)).size(), 1u);
  EXPECT_EQ(finder(surface.at(7), surface.at(8)).size(), 2u);
}

TEST(Path_finder, is_empty_when_not_connected)
{
  Triangulation shape = disjoint_union(square(4), icosphere(1));
  shape.points.push_back({5., 5., 5.});
  const Array_surface surface(shape);
  const Index isolated = Index(shape.points.size() - 1);
  Path_finder finder(surface.triangles());
  for(int pass = 0; pass < 2; ++pass)
  {
    EXPECT_TRUE(finder(surface.at(0), surface.at(30)).empty());
    EXPECT_TRUE(finder(surface.at(30), surface.at(isolated)).empty());
    EXPECT_TRUE(finder(surface.at(isolated), surface.at(30)).empty());
    EXPECT_EQ(finder(surface.at(isolated), surface.at(isolated)).size(), 1u);
    EXPECT_FALSE(finder(surface.at(1), surface.at(23)).empty());
    finder.add_landmarks(4);
  }
}

TEST(Path_finder, works_without_point_coordinates)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  auto without_points = std::make_shared<Surface_arrays>(surface.t());
  without_points->point.clear();
  Path_finder finder(surface.triangles()), bare_finder(without_points);
  for(Index k = 1; k < 600; k += 37)
  {
    const auto a = finder(surface.at(0), surface.at(k)),
               b = bare_finder(surface.at(0), surface.at(k));
    // Both are shortest paths in the same graph, whose shortcut lengths are floats.
    EXPECT_NEAR(shorten_geodesic(surface.t(), a).length, shorten_geodesic(surface.t(), b).length,
                1e-2);
    EXPECT_LE(finder.number_of_visited_vertices(), bare_finder.number_of_visited_vertices());
  }
}

TEST(Path_finder, visits_fewer_vertices_with_landmarks)
{
  const Array_surface surface(jittered(icosphere(5), 0.002));
  Path_finder finder(surface.triangles()), guided(surface.triangles());
  guided.add_landmarks(3);
  guided.add_landmarks(5);
  Path_finder guided_more = guided;
  guided_more.add_landmarks(8);
  std::mt19937 random(4);
  std::size_t visited = 0, number_visited_guided_more = 0;
  for(int i = 0; i < 50; ++i)
  {
    const Surface_location from = random_location(surface.t(), random),
                           to = random_location(surface.t(), random);
    const double a = shorten_geodesic(surface.t(), finder(from, to)).length;
    const double b = shorten_geodesic(surface.t(), guided(from, to)).length;
    // A larger lower bound excludes more vertices, and landmarks increase it.
    EXPECT_LE(guided.number_of_visited_vertices(), finder.number_of_visited_vertices());
    guided_more(from, to);
    EXPECT_LE(guided_more.number_of_visited_vertices(), guided.number_of_visited_vertices());
    visited += finder.number_of_visited_vertices();
    number_visited_guided_more += guided_more.number_of_visited_vertices();
    // Paths can differ if their lengths are equal in single precision.
    EXPECT_NEAR(a, b, 1e-2 * a);
  }
  // The bound of a landmark is tight if the goal is between it and the vertex. On a sphere, this
  // is rare: with eight landmarks, a search visits two thirds of the vertices, with sixteen fewer
  // than half.
  EXPECT_LT(2 * number_visited_guided_more, visited);
  const Index vertex = 17, corner = surface.t().ring[surface.t().ring_begin[vertex]];
  finder(vertex_location(surface.t(), vertex),
         vertex_location(surface.t(), surface.t().corner[next_halfedge(corner)]));
  EXPECT_EQ(finder.number_of_visited_vertices(), 0u); // joined by an edge
}

TEST(Path_finder, is_independent_of_previous_queries)
{
  const Array_surface surface(jittered(icosphere(3), 0.05));
  Path_finder finder(surface.triangles());
  std::mt19937 random(5);
  for(int i = 0; i < 50; ++i)
  {
    const Surface_location from = random_location(surface.t(), random),
                           to = random_location(surface.t(), random);
    const auto reused = finder(from, to);
    const auto fresh = Path_finder(surface.triangles())(from, to);
    ASSERT_EQ(reused.size(), fresh.size());
    for(std::size_t k = 0; k < reused.size(); ++k)
      EXPECT_TRUE(is_same_point(surface.t(), reused[k], fresh[k]));
  }
}

TEST(Path_finder, follows_proximity_graph_of_cloud)
{
  //  0 - 1 - 2        4 is isolated
  //    \     |
  //      ----3
  Surface_arrays cloud;
  cloud.ring_begin.assign(6, 0);
  cloud.point = {{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {2., -1., 0.}, {5., 0., 0.}};
  cloud.normal.assign(5, {0., 0., 1.});
  cloud.graph.begin = {0, 2, 4, 6, 8, 8};
  cloud.graph.target = {1, 3, 0, 2, 1, 3, 0, 2};
  Path_finder finder(std::make_shared<const Surface_arrays>(cloud));
  const auto vertices_of_path = [&](Index a, Index b)
  {
    std::vector<Index> result;
    for(const Surface_location& location :
        finder(vertex_location(cloud, a), vertex_location(cloud, b)))
      result.push_back(location.vertex);
    return result;
  };
  EXPECT_EQ(vertices_of_path(0, 2), (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(vertices_of_path(3, 0), (std::vector<Index>{3, 0}));
  EXPECT_EQ(vertices_of_path(1, 3), (std::vector<Index>{1, 2, 3}));
  EXPECT_EQ(vertices_of_path(1, 1), (std::vector<Index>{1}));
  EXPECT_TRUE(vertices_of_path(1, 4).empty());
}

} // namespace Path_finder_test
