// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_path.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace geodesic_path_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Path = GP::Surface_path<Mesh>;

// Some tens of face crossings.
constexpr double round_off = 1e-12;

// Checks that a path lies on the surface and that each location matches its point. No point
// repeats, the length is correct and at least the Euclidean distance.
void expect_path_in(const Mesh& mesh, const Path& path, const Point& from, const Point& to,
                    double round_off)
{
  ASSERT_FALSE(path.empty());
  ASSERT_EQ(path.points.size(), path.locations.size());
  EXPECT_LT(distance(to_array(path.points.front()), from), round_off);
  EXPECT_LT(distance(to_array(path.points.back()), to), round_off);
  double length = 0.;
  for(std::size_t i = 0; i < path.points.size(); ++i)
  {
    EXPECT_LT(distance(point_of(mesh, path.locations[i]), to_array(path.points[i])), round_off);
    if(i > 0)
    {
      EXPECT_NE(path.points[i], path.points[i - 1]);
      length += distance(to_array(path.points[i]), to_array(path.points[i - 1]));
    }
  }
  EXPECT_NEAR(path.length, length, round_off);
  EXPECT_GE(path.length, distance(from, to) - round_off);
}

void expect_path(const Mesh& mesh, const Path& path, const Point& from, const Point& to)
{
  expect_path_in(mesh, path, from, to, round_off);
}

TEST(Geodesic_path, is_straight_in_plane)
{
  const Mesh mesh = mesh_of(square(15, 0.24));
  const GP::Mesh_domain<Mesh> domain(mesh);
  std::mt19937 random(1);
  // error  the error of the method
  const auto expect_straight = [&](const Path& path, const Point& p, const Point& q, double error)
  {
    expect_path(mesh, path, p, q);
    EXPECT_NEAR(path.length, distance(p, q), round_off);
    EXPECT_NEAR(path.front_distance, path.length, error);
  };
  for(int i = 0; i < 20; ++i)
  {
    const auto from = random_location_of(mesh, random), to = random_location_of(mesh, random);
    const Point p = point_of(mesh, from), q = point_of(mesh, to);
    expect_straight(GP::geodesic_path(domain, from, to), p, q, round_off);
    expect_straight(GP::geodesic_path<GP::Euclidean_front>(domain, from, to), p, q,
                    1e-10); // the front ignores smaller improvements
    // First order: at most two edges of length 1/15. Dijkstra: 41 %. Heat: some percent.
    expect_straight(GP::geodesic_path<GP::Fast_marching>(domain, from, to), p, q, 2. / 15.);
    expect_straight(GP::geodesic_path<GP::Dijkstra>(domain, from, to), p, q, 0.5);
    expect_straight(GP::geodesic_path<GP::Heat>(domain, from, to), p, q, 2. / 15.);
  }
}

TEST(Geodesic_path, is_shortest_by_default)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.1));
  const GP::Mesh_domain<Mesh> domain(mesh);
  std::mt19937 random(1);
  const auto expect_shortest = [&](const auto& from, const auto& to, const Point& p, const Point& q)
  {
    const Path path = GP::geodesic_path(domain, from, to);
    expect_path(mesh, path, p, q);
    EXPECT_NEAR(path.length, path.front_distance, round_off);
    EXPECT_NEAR(path.length, GP::geodesic_path<GP::Exact>(domain, to, from).length, round_off);
    EXPECT_LE(path.lower, path.length);
    EXPECT_GE(path.lower, path.length * (1. - 1e-11)); // the tolerance of exact paths
    const Path local = GP::geodesic_path<GP::Euclidean_front>(domain, from, to);
    EXPECT_LE(path.length, local.length + round_off);
    EXPECT_LE(local.lower, path.length);
  };
  for(int i = 0; i < 10; ++i)
  {
    const auto from = random_location_of(mesh, random), to = random_location_of(mesh, random);
    expect_shortest(from, to, point_of(mesh, from), point_of(mesh, to));
    const Vertex v(Mesh::size_type(random() % 600));
    expect_shortest(v, to, to_array(mesh.point(v)), point_of(mesh, to));
  }
}

TEST(Geodesic_path, accepts_all_kinds_of_locations)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  const GP::Location<Mesh> inside = location_of(100, {0.2, 0.3, 0.5}),
                           on_edge = location_of(500, {0.2, 0.8, 0.}),
                           at_vertex = location_of(900, {0., 1., 0.});
  const auto expect = [&](const auto& from, const auto& to, const Point& p, const Point& q)
  {
    const Path path = GP::geodesic_path(mesh, from, to);
    expect_path(mesh, path, p, q);
    // On a mesh of this size the front errs by 1 %, and one of several equivalent paths is found.
    EXPECT_NEAR(path.length, path.front_distance, 0.02 * path.front_distance + 1e-3);
  };
  const Vertex vertex(17);
  const Point v = to_array(mesh.point(vertex)), p = point_of(mesh, inside),
              q = point_of(mesh, on_edge), r = point_of(mesh, at_vertex);
  expect(vertex, inside, v, p);
  expect(inside, vertex, p, v);
  expect(inside, on_edge, p, q);
  expect(on_edge, at_vertex, q, r);
  expect(at_vertex, inside, r, p);
  expect(vertex, Vertex(400), v, to_array(mesh.point(Vertex(400))));
  // Both ends in one face, and both ends on one edge.
  expect(inside, location_of(100, {0.5, 0.3, 0.2}), p,
         point_of(mesh, location_of(100, {0.5, 0.3, 0.2})));
  const Vertex next = mesh.target(mesh.halfedge(vertex)) == vertex
                          ? mesh.source(mesh.halfedge(vertex))
                          : mesh.target(mesh.halfedge(vertex));
  const Path edge = GP::geodesic_path(mesh, vertex, next);
  EXPECT_EQ(edge.points.size(), 2u);
}

TEST(Geodesic_path, is_single_point_from_location_to_itself)
{
  const Mesh mesh = mesh_of(icosphere(2));
  const Path path_at_vertex = GP::geodesic_path(mesh, Vertex(9), Vertex(9));
  EXPECT_EQ(path_at_vertex.points.size(), 1u);
  EXPECT_EQ(path_at_vertex.length, 0.);
  EXPECT_EQ(path_at_vertex.front_distance, 0.);
  const auto inside = location_of(30, {0.2, 0.3, 0.5});
  const Path path_at_location = GP::geodesic_path(mesh, inside, inside);
  EXPECT_EQ(path_at_location.points.size(), 1u);
  EXPECT_EQ(path_at_location.length, 0.);
}

TEST(Geodesic_path, ends_at_nearest_source)
{
  const Mesh mesh = mesh_of(square(15, 0.24));
  const std::vector<Vertex> corners = {Vertex(0), Vertex(15), Vertex(240), Vertex(255)};
  for(const Vertex v : mesh.vertices())
  {
    const Point p = to_array(mesh.point(v));
    double min_distance = infinity, second_distance = infinity;
    Vertex nearest;
    for(const Vertex corner : corners)
    {
      const double d = distance(p, to_array(mesh.point(corner)));
      if(d < min_distance)
        nearest = corner;
      second_distance = std::min(second_distance, std::max(d, min_distance));
      min_distance = std::min(min_distance, d);
    }
    if(second_distance - min_distance <
       2. / 15.) // near the cell boundary, either source may be chosen
      continue;
    expect_path(mesh, GP::geodesic_path(mesh, v, corners), p, to_array(mesh.point(nearest)));
  }
}

TEST(Geodesic_path, is_empty_when_not_connected)
{
  const Mesh mesh = mesh_of(disjoint_union(square(4), tetrahedron()));
  const Path path = GP::geodesic_path(mesh, Vertex(26), Vertex(0));
  EXPECT_TRUE(path.empty());
  EXPECT_TRUE(path.points.empty());
  EXPECT_EQ(path.front_distance, infinity);
  EXPECT_EQ(path.length, 0.);
}

TEST(Geodesic_path, is_scale_invariant)
{
  for(const double scale : {1e-160, 1e-6, 1e6, 1e160})
  {
    const Triangulation surface = scaled(square(8, 0.24), scale);
    const Mesh mesh = mesh_of(surface);
    const Path path = GP::geodesic_path(mesh, Vertex(0), Vertex(80));
    EXPECT_NEAR(path.length / scale, std::sqrt(2.), round_off);
    EXPECT_NEAR(path.front_distance / scale, std::sqrt(2.), round_off);
  }
}

TEST(Geodesic_path, accepts_named_parameters)
{
  Mesh mesh = mesh_of(square(8, 0.24));
  auto points = mesh.add_property_map<Vertex, Kernel::Point_3>().first;
  for(const Vertex v : mesh.vertices())
    points[v] = Kernel::Point_3(3. * mesh.point(v).x(), mesh.point(v).y(), 0.);
  EXPECT_NEAR(
      GP::geodesic_path(mesh, Vertex(0), Vertex(8), GP::parameters::vertex_point_map(points))
          .length,
      3., round_off);
  // Targets beyond the maximum distance yield an empty path.
  EXPECT_TRUE(
      GP::geodesic_path(mesh, Vertex(0), Vertex(8), GP::parameters::maximum_distance(0.5)).empty());
}

TEST(Geodesic_path, accepts_polyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  Numbered<Polyhedron> mesh;
  fill(mesh, square(8, 0.24));
  const auto path = GP::geodesic_path(mesh.mesh, mesh.vertices[0], mesh.vertices[80]);
  EXPECT_NEAR(path.length, std::sqrt(2.), round_off);
}

TEST(Geodesic_path, goes_around_slow_faces)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    Triangulation shape = square(40, 0.24);
    for(Point& p : shape.points)
      p = {scale * p[0], scale * p[1], 0.};
    Mesh mesh = mesh_of(shape);
    auto speed = mesh.add_property_map<Face, double>("f:speed", 1.).first;
    for(const Face face : mesh.faces())
    {
      const auto center = point_of(mesh, GP::Location<Mesh>{face, {1. / 3., 1. / 3., 1. / 3.}});
      if(std::abs(center[0] / scale - 0.5) < 0.2 && std::abs(center[1] / scale - 0.5) < 0.4)
        speed[face] = 0.05;
    }
    const Path path =
        GP::geodesic_path(mesh, Vertex(0), Vertex(1680), GP::parameters::face_speed_map(speed));
    expect_path_in(mesh, path, shape.points[0], shape.points[1680], round_off * scale);
    // Around the corner (0.7, 0.1) or (0.3, 0.9) of the slow faces, which are up to one edge away
    // from it.
    const double two_edges = 2. / 40.;
    const double around = std::hypot(0.7, 0.1) + std::hypot(0.3, 0.9);
    EXPECT_NEAR(path.length / scale, around, two_edges);
    EXPECT_NEAR(path.front_distance / scale, around, two_edges);
  }
}

TEST(Geodesic_path, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(square(3));
  EXPECT_THROW(GP::geodesic_path(mesh, Vertex(0), std::vector<Vertex>()),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_path(mesh, Mesh::null_vertex(), Vertex(0)), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_path(mesh, location_of(0, {2., -1., 0.}), Vertex(0)),
               GP::Invalid_argument_error);
}

TEST(Geodesic_path, joins_end_points_on_point_set)
{
  const Surfels cloud = flat_surfels(3000);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const GP::Surfel_domain<Surfels> domain(cloud, np);
  for(std::size_t i = 1; i < 60; ++i)
  {
    const auto path = GP::geodesic_path(domain, i, std::size_t(0));
    ASSERT_GE(path.points.size(), 2u);
    const double chord = std::sqrt(CGAL::squared_distance(cloud[i].first, cloud[0].first));
    // Squares of round-off errors.
    EXPECT_LT(CGAL::squared_distance(path.points.front(), cloud[i].first), 1e-26);
    EXPECT_LT(CGAL::squared_distance(path.points.back(), cloud[0].first), 1e-26);
    EXPECT_GE(path.length, chord - round_off);
    EXPECT_LE(path.length, 1.01 * chord + 0.02); // a gap at the boundary may require a detour
    for(std::size_t k = 1; k < path.points.size(); ++k)
      EXPECT_NE(path.points[k], path.points[k - 1]);
  }
  const auto path_to_itself = GP::geodesic_path(domain, std::size_t(4), std::size_t(4));
  EXPECT_EQ(path_to_itself.points.size(), 1u);
}

TEST(Geodesic_path, minimizes_energy_on_cloud)
{
  const Surfels cloud = sphere_surfels(3);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const auto domain = GP::make_domain(cloud, np);
  const std::vector<std::size_t> sources = {17, 300, 511};
  for(std::size_t from = 1; from < cloud.size(); from += 97)
  {
    double expected = 4.;
    for(const std::size_t source : sources)
      expected =
          std::min(expected, 2. * std::asin(0.5 * std::sqrt(CGAL::squared_distance(
                                                      cloud[from].first, cloud[source].first))));
    const auto path = GP::geodesic_path(domain, from, sources);
    EXPECT_NEAR(path.front_distance, expected, 1e-8); // fourth-order error with steps of 0.01
    EXPECT_FALSE(path.initial_path.empty());
    EXPECT_GE(path.initial_length, path.front_distance * (1. - 1e-12)); // round-off errors
    EXPECT_EQ(GP::geodesic_path(cloud, from, sources, np).points, path.points);
    // A front has other paths, and so have speeds.
    const auto traced = GP::geodesic_path<GP::Euclidean_front>(domain, from, sources);
    EXPECT_TRUE(traced.initial_path.empty());
    EXPECT_NEAR(traced.front_distance, expected, 0.02 * expected); // edges of 0.15 are straight
    const std::vector<double> speed(cloud.size(), 0.5);
    const auto slow = GP::geodesic_path(domain, from, sources,
                                        GP::parameters::speed_map(CGAL::make_property_map(speed)));
    EXPECT_TRUE(slow.initial_path.empty());
    EXPECT_NEAR(slow.front_distance, 2. * expected, 0.05 * 2. * expected); // edges of 0.15
  }
}

TEST(Geodesic_path, is_empty_between_components_of_cloud)
{
  Surfels cloud = flat_surfels(200);
  for(const auto& [p, n] : flat_surfels(200, 2))
    cloud.emplace_back(p + Kernel::Vector_3(5., 0., 0.), n);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const auto path = GP::geodesic_path(cloud, std::size_t(0), std::size_t(300), np);
  EXPECT_TRUE(path.empty());
  EXPECT_EQ(path.front_distance, GP::internal::infinity);
}

} // namespace geodesic_path_test
