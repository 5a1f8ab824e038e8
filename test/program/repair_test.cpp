// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/Surface.h"
#include "io/errors.h"

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace repair_test {

using program::Connectivity;
using program::Point;
using program::Surface;
using program::Surface_file;

Surface_file soup(std::vector<Point> points, const std::vector<std::vector<std::uint32_t>>& faces)
{
  Surface_file surface;
  surface.points = std::move(points);
  for(const auto& face : faces)
  {
    surface.corners.insert(surface.corners.end(), face.begin(), face.end());
    surface.polygon_begin.push_back(surface.corners.size());
  }
  return surface;
}

double area(const Surface_file& surface)
{
  double sum = 0.;
  for(std::size_t f = 0; f < surface.number_of_polygons(); ++f)
  {
    const Point &a = surface.points[surface.corners[3 * f]],
                &b = surface.points[surface.corners[3 * f + 1]],
                &c = surface.points[surface.corners[3 * f + 2]];
    const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    sum += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]) /
           2.;
  }
  return sum;
}

const std::vector<Point> tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(Triangulate, concave_polygons_keep_their_area)
{
  // A star-shaped polygon with ten corners, in planes orthogonal to each axis. The scales cover
  // extremely small and large units.
  for(const double scale : {1., 1e-160, 1e160})
    for(std::size_t axis = 0; axis < 3; ++axis)
    {
      std::vector<Point> points;
      std::vector<std::uint32_t> face;
      double expected = 0.;
      for(std::uint32_t i = 0; i < 10; ++i)
      {
        const double r = i % 2 == 0 ? 1. : 0.3, angle = 0.62831853071795865 * i;
        Point p = {0., 0., 0.};
        p[axis] = 0.25 * scale;
        p[(axis + 1) % 3] = scale * r * std::cos(angle);
        p[(axis + 2) % 3] = scale * r * std::sin(angle);
        points.push_back(p);
        face.push_back(i);
        expected += 0.3 * std::sin(0.62831853071795865) / 2.;
      }
      Surface_file surface = soup(points, {face});
      EXPECT_TRUE(program::triangulate(surface, ""));
      EXPECT_EQ(surface.number_of_polygons(), 8u);
      for(Point& p : surface.points)
        for(double& x : p)
          x /= scale;
      EXPECT_NEAR(area(surface), expected, 1e-14); // round-off errors of ten products of order one
    }
}

TEST(Triangulate, polygon_with_n_corners_has_n_minus_2_triangles)
{
  // Self-intersecting, degenerate and single-point polygons are also accepted.
  std::mt19937 random(7);
  for(int round = 0; round < 200; ++round)
  {
    const std::uint32_t n = 4 + random() % 12;
    std::vector<Point> points(n);
    std::vector<std::uint32_t> face(n);
    for(std::uint32_t i = 0; i < n; ++i)
    {
      face[i] = i;
      for(std::size_t c = 0; c < 3; ++c)
        points[i][c] = random() % (round % 5 + 1);
    }
    Surface_file surface = soup(points, {face});
    program::triangulate(surface, "");
    EXPECT_EQ(surface.number_of_polygons(), n - 2);
  }
}

TEST(Triangulate, removes_repeated_corners_and_duplicates)
{
  Surface_file surface = soup(
      tetrahedron, {{0, 1, 1}, {0, 1}, {2}, {}, {0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {3, 3, 1, 2}});
  EXPECT_TRUE(program::triangulate(surface, ""));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0, 3, 1, 2}));
}

TEST(Triangulate, keeps_triangles)
{
  Surface_file surface = soup(tetrahedron, {{2, 0, 1}, {0, 1, 3}});
  EXPECT_FALSE(program::triangulate(surface, ""));
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{2, 0, 1, 0, 1, 3}));
}

TEST(Triangulate, rejects_polygons_with_too_many_corners)
{
  std::vector<Point> points(10001, Point{0., 0., 0.});
  std::vector<std::uint32_t> face(10001);
  for(std::uint32_t i = 0; i < 10001; ++i)
    face[i] = i;
  Surface_file surface = soup(points, {face});
  EXPECT_THROW(program::triangulate(surface, "name"), program::Input_error);
}

TEST(Orient, flips_minority_orientation)
{
  Surface_file surface = soup(tetrahedron, {{0, 2, 1}, {0, 3, 1}, {1, 2, 3}, {2, 0, 3}});
  const Connectivity connectivity = program::orient(surface);
  EXPECT_EQ(connectivity.number_of_flipped_faces, 1u);
  EXPECT_EQ(surface.corners, (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_TRUE(connectivity.is_manifold());
  EXPECT_EQ(connectivity.genus(4), 0);
  EXPECT_EQ(connectivity.number_of_boundary_loops, 0u);
  EXPECT_EQ(std::count(connectivity.twins.begin(), connectivity.twins.end(), program::no_halfedge),
            0);
}

TEST(Orient, cuts_nonmanifold_edges)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  Surface_file surface = soup(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Connectivity connectivity = program::orient(surface);
  EXPECT_EQ(connectivity.number_of_cut_edges, 1u);
  EXPECT_EQ(connectivity.number_of_components, 3u);
  EXPECT_EQ(connectivity.number_of_nonmanifold_vertices, 2u);
  EXPECT_FALSE(connectivity.is_manifold());
}

TEST(Orient, cuts_moebius_strip)
{
  std::vector<Point> points;
  std::vector<std::vector<std::uint32_t>> faces;
  const std::uint32_t n = 12;
  for(std::uint32_t i = 0; i < n; ++i)
    for(const double s : {-0.2, 0.2})
    {
      const double angle = 0.52359877559829887 * i;
      const double r = 1. + s * std::cos(angle / 2.);
      points.push_back({r * std::cos(angle), r * std::sin(angle), s * std::sin(angle / 2.)});
    }
  for(std::uint32_t i = 0; i < n; ++i)
  {
    // The ends are joined with opposite orientations.
    const std::uint32_t a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  Surface_file surface = soup(points, faces);
  const Connectivity connectivity = program::orient(surface);
  EXPECT_EQ(connectivity.number_of_cut_edges, 1u); // the shortest cut across the band is one edge
  EXPECT_EQ(connectivity.number_of_components, 1u);
  EXPECT_EQ(connectivity.number_of_boundary_loops, 1u);
  EXPECT_EQ(connectivity.genus(faces.size()), 0);
}

TEST(Make_mesh, keeps_nonmanifold_vertices)
{
  // Three triangles that share a vertex.
  const Surface surface = program::repair(
      soup({{0, 0, 0}, {1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {-1, 1, 0}, {0, 2, 0}, {1, 3, 0}},
           {{0, 2, 1}, {0, 4, 3}, {0, 5, 6}}),
      "");
  EXPECT_EQ(surface.connectivity.number_of_nonmanifold_vertices, 1u);
  EXPECT_EQ(surface.connectivity.number_of_boundary_loops, 3u);
  const program::Mesh mesh = program::make_mesh(surface);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(mesh.number_of_vertices(), 7u);
  EXPECT_EQ(mesh.degree(program::Mesh::Vertex_index(0)), 6u);
}

TEST(Make_mesh, is_valid_for_random_triangles)
{
  std::mt19937 random(3);
  for(int round = 0; round < 100; ++round)
  {
    std::vector<Point> points(8);
    for(Point& p : points)
      for(double& x : p)
        x = random() / 4294967296.;
    std::vector<std::vector<std::uint32_t>> faces;
    for(int f = 0; f < 1 + round / 4; ++f)
      faces.push_back({static_cast<std::uint32_t>(random() % 8),
                       static_cast<std::uint32_t>(random() % 8),
                       static_cast<std::uint32_t>(random() % 8)});
    Surface surface;
    try
    {
      surface = program::repair(soup(points, faces), "");
    }
    catch(const program::Input_error&)
    {
      continue; // no face with three corners
    }
    const program::Mesh mesh = program::make_mesh(surface);
    for(const auto h : mesh.halfedges())
    {
      EXPECT_EQ(mesh.prev(mesh.next(h)), h);
      EXPECT_EQ(mesh.target(h), mesh.source(mesh.next(h)));
    }
    for(const auto f : mesh.faces())
      EXPECT_EQ(mesh.degree(f), 3u);
    EXPECT_EQ(mesh.number_of_vertices(), 8u);
    EXPECT_EQ(mesh.number_of_faces(), surface.file.number_of_polygons());
    EXPECT_GE(surface.connectivity.genus(mesh.number_of_faces()), 0);
  }
}

// Returns points of a sphere around (offset, offset, offset), along a spiral.
std::vector<Point> sphere(std::size_t n, double radius, double offset)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < n; ++i)
  {
    const double z = 1. - (2. * static_cast<double>(i) + 1.) / static_cast<double>(n),
                 r = std::sqrt(1. - z * z), angle = 2.399963229728653 * static_cast<double>(i);
    points.push_back({offset + radius * r * std::cos(angle), offset + radius * r * std::sin(angle),
                      offset + radius * z});
  }
  return points;
}

TEST(Complete_normals, point_outwards_on_sphere_at_any_scale)
{
  for(const double scale : {1., 1e-160, 1e160})
  {
    Surface_file cloud;
    cloud.points = sphere(500, scale, 0.);
    EXPECT_FALSE(program::complete_normals(cloud)); // given normals are preserved
    for(std::size_t i = 0; i < cloud.points.size(); ++i)
    {
      const Point &p = cloud.points[i], &n = cloud.normals[i];
      // 500 points are 0.16 apart; planes through 16 of them deviate by less than 0.1
      EXPECT_GT((p[0] * n[0] + p[1] * n[1] + p[2] * n[2]) / scale, 0.99);
    }
  }
}

TEST(Complete_normals, normalizes_lengths_and_fills_zeros)
{
  Surface_file cloud;
  cloud.points = sphere(500, 1., 0.);
  cloud.normals = cloud.points;
  for(std::size_t i = 0; i < 500; ++i)
    for(double& x : cloud.normals[i])
      x *= i % 10 == 0 ? 0. : i % 3 == 0 ? 1e-200 : -1e200;
  for(std::size_t i = 0; i < 500; ++i)
    if(i % 3 == 0)
      for(double& x : cloud.normals[i])
        x = -x;
  EXPECT_TRUE(program::complete_normals(cloud));
  std::size_t inwards = 0;
  for(std::size_t i = 0; i < 500; ++i)
  {
    const Point &p = cloud.points[i], &n = cloud.normals[i];
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1., 1e-15);
    inwards += p[0] * n[0] + p[1] * n[1] + p[2] * n[2] < -0.99 ? 1 : 0;
  }
  EXPECT_EQ(inwards, 500u);
}

TEST(Complete_normals, gives_unit_vectors_for_degenerate_clouds)
{
  const std::vector<std::vector<Point>> clouds = {
      {{1, 2, 3}},
      {{1, 2, 3}, {1, 2, 3}},
      {{0, 0, 0}, {1, 1, 1}},
      std::vector<Point>(500, Point{1e8, 0, 0}),
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1e300, 0, 0}}};
  for(const std::vector<Point>& points : clouds)
  {
    Surface_file cloud;
    cloud.points = points;
    program::complete_normals(cloud);
    ASSERT_EQ(cloud.normals.size(), points.size());
    for(const Point& n : cloud.normals)
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1., 1e-15);
  }
}

} // namespace repair_test
