// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/Surface.h"
#include "repair/complete_normals.h"
#include "io/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace repair_test {

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

TEST(Repair, keeps_vertices_and_replaces_polygons_by_triangles)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  const Surface surface = program::repair(soup(points, {{0, 1, 2, 3}, {4, 4, 0}, {0, 1, 4}}), "");
  EXPECT_TRUE(surface.is_repaired);
  EXPECT_EQ(surface.file.points, points);
  EXPECT_EQ(surface.file.polygon_begin, (std::vector<std::size_t>{0, 3, 6, 9}));
  EXPECT_EQ(surface.domain->report().number_of_reversed_triangles, 1u);
  // The corners are those of the mesh.
  const program::Mesh& mesh = surface.domain->mesh();
  for(const auto face : mesh.faces())
    EXPECT_EQ(surface.file.corners[3 * face], std::uint32_t(mesh.source(mesh.halfedge(face))));
}

TEST(Repair, keeps_clean_triangles)
{
  const Surface surface = program::repair(
      soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{2, 0, 1}, {0, 3, 1}}), "");
  EXPECT_FALSE(surface.is_repaired);
  EXPECT_EQ(surface.file.corners, (std::vector<std::uint32_t>{2, 0, 1, 0, 3, 1}));
}

TEST(Repair, rejects_meshes_without_triangles)
{
  EXPECT_THROW(program::repair(soup({{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}), "name"),
               program::Input_error);
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
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1., 1e-15); // round-off error
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
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1., 1e-15); // round-off error
  }
}

} // namespace repair_test
