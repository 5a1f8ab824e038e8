// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/fill_holes.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

namespace fill_holes_test {

using program::Hole_filling_result;
using program::Mesh;
using program::Point;
using program::Surface_file;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Mesh mesh_of(const std::vector<Point>& points, const Triangles& triangles)
{
  Surface_file file;
  file.points = points;
  for(const auto& triangle : triangles)
  {
    file.corners.insert(file.corners.end(), triangle.begin(), triangle.end());
    file.polygon_begin.push_back(file.corners.size());
  }
  return program::repair(std::move(file), "").domain->mesh();
}

// Returns a prism of height 1 without its end faces, over a regular polygon on the unit circle.
Mesh tube(std::uint32_t corners, double scale, bool with_hole = false)
{
  std::vector<Point> points;
  Triangles triangles;
  for(std::uint32_t i = 0; i < corners; ++i)
  {
    const double angle = 2. * CGAL_PI * i / corners;
    for(const double z : {0., 1.})
      points.push_back({scale * std::cos(angle), scale * std::sin(angle), scale * z});
    const std::uint32_t j = (i + 1) % corners;
    triangles.push_back({2 * i, 2 * j, 2 * j + 1});
    triangles.push_back({2 * i, 2 * j + 1, 2 * i + 1});
  }
  if(with_hole)
  {
    // A hole in the center of the last triangle.
    const auto [a, b, c] = triangles.back();
    triangles.pop_back();
    for(const double s : {0.2, 0.6})
      for(const double t : {0.2, 0.6})
        if(s + t < 1.)
        {
          Point p;
          for(std::size_t k = 0; k < 3; ++k)
            p[k] = points[a][k] + s * (points[b][k] - points[a][k]) +
                   t * (points[c][k] - points[a][k]);
          points.push_back(p);
        }
    const std::uint32_t d = 2 * corners, e = d + 2, f = d + 1; // close to a, b and c
    for(const auto& triangle :
        Triangles{{a, b, d}, {b, e, d}, {b, c, e}, {c, f, e}, {c, a, f}, {a, d, f}})
      triangles.push_back(triangle);
  }
  return mesh_of(points, triangles);
}

// Returns a sheet of squares of edge length 1, each divided into two triangles, without the
// triangles in `missing`.
Mesh sheet(std::uint32_t squares, const std::set<std::size_t>& missing = {})
{
  std::vector<Point> points;
  Triangles triangles;
  std::size_t triangle_index = 0;
  for(std::uint32_t j = 0; j <= squares; ++j)
    for(std::uint32_t i = 0; i <= squares; ++i)
      points.push_back({double(i), double(j), 0.});
  for(std::uint32_t j = 0; j < squares; ++j)
    for(std::uint32_t i = 0; i < squares; ++i)
    {
      const std::uint32_t a = j * (squares + 1) + i, b = a + 1, d = a + squares + 1, c = d + 1;
      for(const auto& triangle : Triangles{{a, b, c}, {a, c, d}})
        if(missing.count(triangle_index++) == 0)
          triangles.push_back(triangle);
    }
  return mesh_of(points, triangles);
}

std::size_t number_of_boundary_edges(const Mesh& mesh)
{
  const auto edges = mesh.edges();
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [&](auto e) { return mesh.is_border(e); }));
}

bool has_no_duplicate_edges(const Mesh& mesh)
{
  std::set<std::pair<Mesh::Vertex_index, Mesh::Vertex_index>> seen;
  for(const auto e : mesh.edges())
    if(!seen.insert(std::minmax(mesh.vertex(e, 0), mesh.vertex(e, 1))).second)
      return false;
  return true;
}

TEST(Fill_holes, closes_tube_with_planar_lids)
{
  for(const double scale : {1., 1e-160, 1e160})
    for(const std::uint32_t n : {3u, 12u, 150u, 600u})
    {
      Mesh mesh = tube(n, scale);
      const Hole_filling_result holes = program::fill_holes(mesh);
      EXPECT_EQ(holes.number_of_filled, 2u) << n;
      EXPECT_EQ(holes.number_of_left, 0u) << n;
      EXPECT_EQ(mesh.number_of_vertices(), 2 * n);
      EXPECT_TRUE(CGAL::is_closed(mesh));
      EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
      EXPECT_TRUE(has_no_duplicate_edges(mesh));
      for(auto& p : mesh.points())
        p = {p.x() / scale, p.y() / scale, p.z() / scale};
      const double volume = n * std::sin(2. * CGAL_PI / n) / 2.;
      EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(mesh), volume,
                  1e-12 * n); // n round-off errors
    }
}

TEST(Fill_holes, respects_max_edges)
{
  for(const auto& [max_edges, filled] : {std::pair(2, 0), {3, 1}, {9, 1}, {10, 3}})
  {
    Mesh mesh = tube(10, 1., true);
    const Hole_filling_result holes =
        program::fill_holes(mesh, static_cast<std::size_t>(max_edges));
    EXPECT_EQ(holes.number_of_filled, static_cast<std::size_t>(filled));
    EXPECT_EQ(holes.number_of_left, 0u);
    EXPECT_EQ(CGAL::is_closed(mesh), filled == 3);
  }
}

TEST(Fill_holes, adds_no_duplicate_edges)
{
  Mesh mesh = sheet(4);
  EXPECT_EQ(program::fill_holes(mesh).number_of_filled, 1u);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(has_no_duplicate_edges(mesh));
}

TEST(Fill_holes, fills_holes_sharing_a_vertex)
{
  // Opposite triangles around the center vertex.
  Mesh mesh = sheet(4, {11, 20});
  EXPECT_EQ(number_of_boundary_edges(mesh), 16u + 6u);
  const Hole_filling_result holes = program::fill_holes(mesh, 3);
  EXPECT_EQ(holes.number_of_filled, 2u);
  EXPECT_EQ(holes.number_of_left, 0u);
  EXPECT_EQ(number_of_boundary_edges(mesh), 16u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
}

TEST(Fill_holes, does_not_join_touching_components)
{
  // Two tetrahedra with one missing face each. They share a vertex of both missing faces.
  Mesh open =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
              {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}});
  EXPECT_EQ(program::fill_holes(open).number_of_filled, 2u);
  EXPECT_EQ(open.number_of_faces(), 8u);
  EXPECT_EQ(number_of_boundary_edges(open), 0u);
  EXPECT_EQ(open.number_of_edges(), 12u);

  // The boundary cycle around a single triangle is not a hole.
  Mesh single =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  const Hole_filling_result holes = program::fill_holes(single);
  EXPECT_EQ(holes.number_of_filled, 0u);
  EXPECT_EQ(holes.number_of_left, 2u);
  EXPECT_EQ(single.number_of_faces(), 2u);
}

TEST(Fill_holes, accepts_coincident_vertices)
{
  // A prism over ten corners. At either end, two adjacent vertices are moved to the same point.
  for(std::uint32_t i = 0; i < 10; ++i)
  {
    Mesh mesh = tube(10, 1.);
    const auto move = [&](std::uint32_t v, std::uint32_t to)
    { mesh.point(Mesh::Vertex_index(v)) = mesh.point(Mesh::Vertex_index(to)); };
    move(2 * i, 2 * ((i + 1) % 10));
    move(2 * ((i + 4) % 10) + 1, 2 * ((i + 5) % 10) + 1);
    const Hole_filling_result holes = program::fill_holes(mesh);
    EXPECT_EQ(holes.number_of_filled + holes.number_of_left, 2u);
    EXPECT_EQ(CGAL::is_closed(mesh), holes.number_of_left == 0);
    EXPECT_EQ(mesh.number_of_faces(), 20 + 8 * holes.number_of_filled);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  }
}

TEST(Fill_holes, leaves_degenerate_or_expensive_holes)
{
  Mesh large_tube = tube(6000, 1.);
  EXPECT_EQ(program::fill_holes(large_tube).number_of_left, 2u);
  EXPECT_EQ(number_of_boundary_edges(large_tube), 12000u);

  // Fans around boundary cycles of any shape: all points coincide, lie on a line, lie on two skew
  // lines, or are random. The Delaunay triangulation of points on two skew lines has the maximum
  // size.
  std::mt19937 random(1);
  const auto coordinate = [&] { return static_cast<double>(random()) / 4294967296.; };
  for(int shape = 0; shape < 4; ++shape)
    for(const std::uint32_t n : {20u, 200u, 1000u})
    {
      std::vector<Point> points = {{2., 2., 2.}};
      Triangles triangles;
      for(std::uint32_t i = 0; i < n; ++i)
      {
        const double t = 2. * i / n;
        if(shape == 0)
          points.push_back({0., 0., 0.});
        else if(shape == 1)
          points.push_back({double(i % 7), 0., 0.});
        else if(shape == 2)
          points.push_back(t < 1. ? Point{t, 0., 0.} : Point{0.5, t - 1.5, 1.});
        else
          points.push_back({coordinate(), coordinate(), coordinate()});
        triangles.push_back({0, i + 1, (i + 1) % n + 1});
      }
      Mesh mesh = mesh_of(points, triangles);
      const Hole_filling_result holes = program::fill_holes(mesh);
      EXPECT_EQ(holes.number_of_filled + holes.number_of_left, 1u);
      EXPECT_EQ(CGAL::is_closed(mesh), holes.number_of_filled == 1);
      EXPECT_TRUE(has_no_duplicate_edges(mesh));
      EXPECT_EQ(mesh.number_of_faces(), holes.number_of_filled == 1 ? 2 * n - 2 : n);
      EXPECT_TRUE(shape > 1 || holes.number_of_filled == 0);
    }
}

} // namespace fill_holes_test
