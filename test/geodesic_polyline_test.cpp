// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_polyline.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace geodesic_polyline_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

// Some hundred face crossings.
constexpr double round_off = 1e-12;

TEST(geodesic_polyline, is_polygon_in_plane)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Mesh mesh = mesh_of(scaled(square(15, 0.24), scale));
    const std::vector<Kernel::Point_3> points = {{0.1 * scale, 0.1 * scale, 0.},
                                                 {0.9 * scale, 0.2 * scale, 0.},
                                                 {0.9 * scale, 0.2 * scale, 0.},
                                                 {0.5 * scale, 0.9 * scale, 0.}};
    for(const bool is_closed : {false, true})
    {
      const auto path = GP::geodesic_polyline(mesh, points, GP::parameters::do_close(is_closed));
      double expected = 0.;
      ASSERT_EQ(path.corners.size(), is_closed ? 5u : 4u);
      ASSERT_EQ(path.points.size(), path.locations.size());
      for(std::size_t i = 0; i < path.corners.size(); ++i)
      {
        const Point corner = to_array(points[i % 4]);
        EXPECT_LT(distance(to_array(path.points[path.corners[i]]), corner), scale * round_off);
        if(i > 0)
          expected += distance(corner, to_array(points[i - 1]));
      }
      EXPECT_EQ(path.corners[1], path.corners[2]);
      EXPECT_EQ(path.corners.front(), 0u);
      EXPECT_EQ(path.corners.back(), path.points.size() - 1);
      EXPECT_NEAR(path.length, expected, scale * round_off);
      EXPECT_NEAR(path.front_distance, expected, scale * round_off);
      EXPECT_LE(path.lower, expected);
      EXPECT_NEAR(path.lower, expected, scale * 1e-10); // the documented relative error is 2e-12
      for(std::size_t i = 0; i + 1 < path.points.size(); ++i)
        EXPECT_NE(path.points[i], path.points[i + 1]);
    }
  }
}

TEST(geodesic_polyline, consists_of_shortest_paths)
{
  const Triangulation surface = icosphere(3);
  Numbered<CGAL::Polyhedron_3<Kernel>> numbered;
  fill(numbered, surface);
  const Mesh mesh = mesh_of(surface);
  const std::vector<std::size_t> indices = {0, 100, 300, 200};
  std::vector<Vertex> vertices;
  std::vector<Numbered<CGAL::Polyhedron_3<Kernel>>::Vertex> other_vertices;
  for(const std::size_t i : indices)
  {
    vertices.push_back(Vertex(Mesh::size_type(i)));
    other_vertices.push_back(numbered.vertices[i]);
  }
  const auto path = GP::geodesic_polyline(mesh, vertices);
  GP::Geodesic_path_finder<Mesh> finder(mesh);
  double length = 0.;
  for(std::size_t i = 0; i + 1 < vertices.size(); ++i)
    length += finder(vertices[i], vertices[i + 1]).length;
  EXPECT_EQ(path.length, length);
  EXPECT_EQ(GP::geodesic_polyline(numbered.mesh, other_vertices).length, length);
}

TEST(geodesic_polyline, passes_through_surfels)
{
  const Surfels cloud = sphere_surfels(3);
  const auto np = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  const std::vector<std::size_t> surfels = {0, 100, 300};
  const auto path = GP::geodesic_polyline(cloud, surfels, np);
  ASSERT_EQ(path.corners.size(), 3u);
  double expected = 0.;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Point corner = to_array(cloud[surfels[i]].first);
    EXPECT_LT(distance(to_array(path.points[path.corners[i]]), corner), 1e-3);
    if(i > 0)
    {
      const Point previous = to_array(cloud[surfels[i - 1]].first);
      expected += 2. * std::asin(0.5 * distance(corner, previous));
    }
  }
  // The sampling distance is 0.08; disks at that distance are 0.3 % above the sphere.
  EXPECT_NEAR(path.length, expected, 3e-3 * expected);
}

TEST(geodesic_polyline, is_empty_if_points_are_not_connected)
{
  const Mesh mesh = mesh_of(disjoint_union(square(2), square(2)));
  EXPECT_TRUE(
      GP::geodesic_polyline(mesh, std::vector<Vertex>{Vertex(0), Vertex(3), Vertex(12)}).empty());
  EXPECT_THROW(GP::geodesic_polyline(mesh, std::vector<Vertex>{Vertex(0)}),
               GP::Invalid_argument_error);
}

} // namespace geodesic_polyline_test
