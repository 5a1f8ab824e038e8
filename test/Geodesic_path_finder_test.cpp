// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/Geodesic_path_finder.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "Mesh_of.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace Geodesic_path_finder_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

using Kernel = CGAL::Simple_cartesian<double>;
using Surface_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Sums of some tens of lengths.
constexpr double round_off = 1e-12;

TEST(Geodesic_path_finder, is_straight_in_plane)
{
  const Triangulation plane = square(10, 0.24);
  Numbered<Surface_mesh> mesh;
  fill(mesh, plane);
  Geodesic_path_finder<Surface_mesh> finder(mesh.mesh);
  std::mt19937 random(1);
  for(int i = 0; i < 100; ++i)
  {
    const Index a = Index(random() % plane.points.size()), f = Index(random() % 200);
    const auto to = location_in(mesh, plane, f, {0.2, 0.3, 0.5});
    const auto path = finder(mesh.vertices[a], to);
    const double expected = distance(plane.points[a], point_of(mesh.mesh, to));
    EXPECT_NEAR(path.length, expected, round_off);
    EXPECT_EQ(path.front_distance, path.length);
    ASSERT_EQ(path.points.size(), path.locations.size());
    EXPECT_LT(distance(to_array(path.points.front()), plane.points[a]), round_off);
    EXPECT_LT(distance(to_array(path.points.back()), point_of(mesh.mesh, to)), round_off);
  }
}

TEST(Geodesic_path_finder, is_single_point_from_vertex_to_itself)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, tetrahedron());
  Geodesic_path_finder<Surface_mesh> finder(mesh.mesh);
  const auto path = finder(mesh.vertices[2], mesh.vertices[2]);
  EXPECT_EQ(path.locations.size(), 1u);
  EXPECT_EQ(path.length, 0.);
}

TEST(Geodesic_path_finder, is_empty_between_components)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, disjoint_union(tetrahedron(), square(2)));
  Geodesic_path_finder<Surface_mesh> finder(mesh.mesh);
  const auto path = finder(mesh.vertices[0], mesh.vertices[8]);
  EXPECT_TRUE(path.empty());
  EXPECT_TRUE(path.points.empty());
  EXPECT_EQ(path.front_distance, internal::infinity);
}

TEST(Geodesic_path_finder, finds_equally_short_paths_with_landmarks)
{
  const Triangulation sphere = jittered(icosphere(3), 0.02);
  Numbered<Surface_mesh> mesh;
  fill(mesh, sphere);
  Geodesic_path_finder<Surface_mesh> plain(mesh.mesh), guided(plain);
  guided.add_landmarks(4);
  for(Index to = 1; to < sphere.points.size(); to += 13)
  {
    const double expected = plain(mesh.vertices[0], mesh.vertices[to]).length;
    EXPECT_NEAR(guided(mesh.vertices[0], mesh.vertices[to]).length, expected, round_off);
    // Of two equally long edge chains, either may be taken, on either side of a bump.
    EXPECT_NEAR(guided.locally_shortest_path(mesh.vertices[0], mesh.vertices[to]).length, expected,
                0.02 * expected);
    EXPECT_GE(expected, distance(sphere.points[0], sphere.points[to]) - round_off);
  }
}

// A tube of isosceles triangles is flat: ring j is shifted by j / 2 sides. The long way around
// stays the long way.
TEST(Geodesic_path_finder, shortens_polylines_in_their_homotopy_class)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, cylinder(24, 6, 1., 2.));
  Geodesic_path_finder<Surface_mesh> finder(mesh.mesh);
  const auto vertex = [&](std::size_t side, std::size_t ring)
  { return mesh.vertices[24 * ring + side]; };
  const std::vector<Surface_mesh::Vertex_index> polyline = {vertex(0, 0), vertex(6, 5),
                                                            vertex(12, 1), vertex(18, 3)};
  const auto path = finder.shorten(polyline);
  const double side_length = 2. * std::sin(internal::pi / 24.),
               height = std::hypot(2. / 6., 1. - std::cos(internal::pi / 24.));
  EXPECT_NEAR(path.length, std::hypot(19.5 * side_length, 3. * height), round_off);
  EXPECT_NEAR(finder(polyline.front(), polyline.back()).length,
              std::hypot(4.5 * side_length, 3. * height), round_off);
  EXPECT_EQ(to_array(path.points.front()), to_array(mesh.mesh.point(polyline.front())));
  EXPECT_EQ(to_array(path.points.back()), to_array(mesh.mesh.point(polyline.back())));
  EXPECT_THROW(finder.shorten(std::vector<Surface_mesh::Vertex_index>{vertex(0, 0)}),
               Invalid_argument_error);
}

TEST(Geodesic_path_finder, finds_great_circles_on_cloud)
{
  const Surfels surfels = sphere_surfels(3);
  const auto maps = parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  Geodesic_path_finder<Surfels> finder(surfels, maps), of_domain(make_domain(surfels, maps));
  for(std::size_t to = 1; to < surfels.size(); to += 97)
  {
    const auto path = finder(std::size_t(0), to);
    const double expected =
        2. *
        std::asin(0.5 * std::sqrt(CGAL::squared_distance(surfels[0].first, surfels[to].first)));
    EXPECT_NEAR(path.front_distance, expected, 1e-8); // fourth-order error with steps of 0.01
    EXPECT_FALSE(path.initial_path.empty());
    EXPECT_EQ(of_domain(std::size_t(0), to).points, path.points);
    EXPECT_EQ(finder.locally_shortest_path(std::size_t(0), to).points, path.points);
  }
}

TEST(Geodesic_path_finder, throws_on_locations_outside_faces)
{
  Numbered<Surface_mesh> mesh;
  fill(mesh, square(2));
  Geodesic_path_finder<Surface_mesh> finder(mesh.mesh);
  const Surface_path<Surface_mesh>::Location outside = {mesh.faces[0], {1.5, -0.5, 0.}};
  EXPECT_THROW(finder(mesh.vertices[0], outside), Invalid_argument_error);
}

} // namespace Geodesic_path_finder_test
