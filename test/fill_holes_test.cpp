// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/fill_holes.h>

#include <CGAL/Geodesic_processing/Soup_domain.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

namespace fill_holes_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::Hole_filling_method;
using GP::Hole_filling_result;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const Hole_filling_method methods[] = {Hole_filling_method::minimal_dihedral_angles,
                                       Hole_filling_method::unfolding};

// Returns the mesh of triangles, which can touch each other at vertices.
Mesh mesh_from(const std::vector<Point>& points, const Triangles& triangles)
{
  std::vector<Kernel::Point_3> kernel_points;
  for(const Point& p : points)
    kernel_points.emplace_back(p[0], p[1], p[2]);
  return GP::make_domain(kernel_points, triangles).mesh();
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
  return mesh_from(points, triangles);
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
  return mesh_from(points, triangles);
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

// Returns whether the links of a mesh are consistent, also if several fans share a vertex.
bool is_linked(const Mesh& mesh)
{
  for(const auto h : mesh.halfedges())
    if(mesh.prev(mesh.next(h)) != h || mesh.source(mesh.next(h)) != mesh.target(h) ||
       mesh.face(mesh.next(h)) != mesh.face(h) ||
       (mesh.is_border(h) && !mesh.is_border(mesh.halfedge(mesh.target(h)))))
      return false;
  for(const Vertex v : mesh.vertices())
    if(mesh.halfedge(v) != Mesh::null_halfedge() && mesh.target(mesh.halfedge(v)) != v)
      return false;
  return true;
}

TEST(fill_holes, closes_tube_with_planar_lids)
{
  for(const double scale : {1., 1e-6, 1e6, 1e-160, 1e160})
    for(const std::uint32_t n : {3u, 12u, 150u, 600u, 6000u})
    {
      if(n == 6000 && scale != 1.)
        continue;
      const Hole_filling_method method = methods[(n / 3) % 2];
      Mesh mesh = tube(n, scale);
      const Hole_filling_result holes =
          GP::fill_holes(mesh, GP::parameters::hole_filling_method(method));
      EXPECT_EQ(holes.number_of_holes, 2u) << n;
      EXPECT_EQ(holes.number_of_filled, 2u) << n;
      EXPECT_EQ(holes.number_of_failed, 0u) << n;
      EXPECT_EQ(holes.number_of_faces, 2 * n - 4) << n;
      // Only unfolding fills holes of more than 5,000 edges.
      EXPECT_EQ(holes.number_of_unfolded,
                method == Hole_filling_method::unfolding || n > 5000 ? 2u : 0u);
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

TEST(fill_holes, respects_max_edges)
{
  for(const auto& [max_edges, filled] : {std::pair(2, 0), {3, 1}, {9, 1}, {10, 3}})
  {
    Mesh mesh = tube(10, 1., true);
    const Hole_filling_result holes =
        GP::fill_holes(mesh, GP::parameters::maximum_number_of_edges(std::size_t(max_edges)));
    EXPECT_EQ(holes.number_of_filled, static_cast<std::size_t>(filled));
    EXPECT_EQ(holes.number_of_failed, 0u);
    EXPECT_EQ(CGAL::is_closed(mesh), filled == 3);
  }
}

TEST(fill_holes, adds_no_duplicate_edges)
{
  for(const Hole_filling_method method : methods)
  {
    Mesh mesh = sheet(4);
    EXPECT_EQ(GP::fill_holes(mesh, GP::parameters::hole_filling_method(method)).number_of_filled,
              1u);
    EXPECT_TRUE(CGAL::is_closed(mesh));
    EXPECT_TRUE(has_no_duplicate_edges(mesh));
  }
}

TEST(fill_holes, fills_holes_sharing_a_vertex)
{
  // Opposite triangles around the center vertex.
  Mesh mesh = sheet(4, {11, 20});
  EXPECT_EQ(number_of_boundary_edges(mesh), 16u + 6u);
  const Hole_filling_result holes =
      GP::fill_holes(mesh, GP::parameters::maximum_number_of_edges(3));
  EXPECT_EQ(holes.number_of_filled, 2u);
  EXPECT_EQ(holes.number_of_failed, 0u);
  EXPECT_EQ(number_of_boundary_edges(mesh), 16u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
}

TEST(fill_holes, does_not_join_touching_components)
{
  // Two tetrahedra with one missing face each. They share a vertex of both missing faces.
  Mesh open =
      mesh_from({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
                {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 6, 4}, {4, 6, 5}, {5, 6, 0}});
  EXPECT_EQ(GP::fill_holes(open).number_of_filled, 2u);
  EXPECT_EQ(open.number_of_faces(), 8u);
  EXPECT_EQ(number_of_boundary_edges(open), 0u);
  EXPECT_EQ(open.number_of_edges(), 12u);

  // The boundary cycle around a single triangle is not a hole.
  Mesh single =
      mesh_from({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  const Hole_filling_result holes = GP::fill_holes(single);
  EXPECT_EQ(holes.number_of_filled, 0u);
  EXPECT_EQ(holes.number_of_failed, 2u);
  EXPECT_EQ(single.number_of_faces(), 2u);
}

TEST(fill_holes, accepts_coincident_vertices)
{
  // A prism over ten corners. At either end, two adjacent vertices are moved to the same point.
  for(std::uint32_t i = 0; i < 10; ++i)
  {
    Mesh mesh = tube(10, 1.);
    const auto move = [&](std::uint32_t v, std::uint32_t to)
    { mesh.point(Mesh::Vertex_index(v)) = mesh.point(Mesh::Vertex_index(to)); };
    move(2 * i, 2 * ((i + 1) % 10));
    move(2 * ((i + 4) % 10) + 1, 2 * ((i + 5) % 10) + 1);
    const Hole_filling_result holes = GP::fill_holes(mesh);
    EXPECT_EQ(holes.number_of_filled + holes.number_of_failed, 2u);
    EXPECT_EQ(CGAL::is_closed(mesh), holes.number_of_failed == 0);
    EXPECT_EQ(mesh.number_of_faces(), 20 + 8 * holes.number_of_filled);
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  }
}

TEST(fill_holes, accepts_boundaries_of_any_shape)
{
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
      // If the first method fails, the other one is used.
      const Hole_filling_method method = methods[shape % 2];
      Mesh mesh = mesh_from(points, triangles);
      const Hole_filling_result holes =
          GP::fill_holes(mesh, GP::parameters::hole_filling_method(method));
      EXPECT_EQ(holes.number_of_filled + holes.number_of_failed, 1u);
      EXPECT_EQ(CGAL::is_closed(mesh), holes.number_of_filled == 1);
      EXPECT_TRUE(has_no_duplicate_edges(mesh));
      EXPECT_EQ(mesh.number_of_faces(), holes.number_of_filled == 1 ? 2 * n - 2 : n);
      EXPECT_TRUE(shape > 1 || holes.number_of_filled == 0);
    }
}

TEST(fill_holes, planar_hole_is_filled_with_its_area)
{
  // A square of 20 x 20 squares without a part that is not convex.
  std::set<std::size_t> missing;
  for(std::size_t j = 4; j < 14; ++j)
    for(std::size_t i = 3; i < 16; ++i)
      if(i < 7 || j < 9)
        missing.insert({2 * (20 * j + i), 2 * (20 * j + i) + 1});
  for(const double scale : {1., 1e-6, 1e6})
    for(const Hole_filling_method method : methods)
    {
      Mesh mesh = sheet(20, missing);
      for(auto& p : mesh.points())
        p = {scale * p.x(), scale * p.y(), scale * p.z()};
      std::vector<Face> added;
      // The outer boundary has the length 80.
      const Hole_filling_result holes =
          GP::fill_holes(mesh, GP::parameters::maximum_perimeter(79.9 * scale)
                                   .hole_filling_method(method)
                                   .face_output(std::back_inserter(added)));
      EXPECT_EQ(holes.number_of_holes, 2u);
      EXPECT_EQ(holes.number_of_filled, 1u);
      EXPECT_EQ(holes.number_of_failed, 0u);
      EXPECT_EQ(holes.number_of_faces, added.size());
      EXPECT_EQ(added.size(), 2u * (13 + 10) - 2);
      const double area = double(missing.size()) * 0.5 * scale * scale;
      // Coordinates are integers times the scale.
      EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(added, mesh), area, 1e-12 * area);
      for(const Face f : added)
      {
        const auto h = mesh.halfedge(f);
        EXPECT_GT(
            CGAL::cross_product(mesh.point(mesh.target(h)) - mesh.point(mesh.source(h)),
                                mesh.point(mesh.target(mesh.next(h))) - mesh.point(mesh.source(h)))
                .z(),
            0.);
      }
    }
}

// Each filled hole increases the Euler characteristic by one.
TEST(fill_holes, topology_is_that_of_closed_holes)
{
  std::mt19937 random(4);
  const Triangulation sphere = icosphere(3);
  for(int run = 0; run < 30; ++run)
  {
    std::vector<Point> points = sphere.points;
    Triangles triangles;
    // Holes of all sizes, with many vertices that several boundary cycles visit.
    for(std::size_t c = 0; c < sphere.corners.size(); c += 3)
      if(random() % 30 > std::size_t(run) % 15)
        triangles.push_back({sphere.corners[c], sphere.corners[c + 1], sphere.corners[c + 2]});
    Mesh mesh = mesh_from(points, triangles);
    const auto characteristic = [&]
    {
      return std::ptrdiff_t(mesh.number_of_vertices()) - std::ptrdiff_t(mesh.number_of_edges()) +
             std::ptrdiff_t(mesh.number_of_faces());
    };
    const std::ptrdiff_t before = characteristic();
    const std::size_t boundary_edges = number_of_boundary_edges(mesh);
    std::size_t filled = 0, added = 0;
    for(const std::size_t max_edges : {3u, 6u, 50u, 1000u})
    {
      const Hole_filling_result holes = GP::fill_holes(
          mesh,
          GP::parameters::maximum_number_of_edges(max_edges).hole_filling_method(methods[run % 2]));
      filled += holes.number_of_filled;
      added += holes.number_of_faces;
      EXPECT_EQ(characteristic() - before, std::ptrdiff_t(filled));
      // A hole of k edges has k - 2 triangles.
      EXPECT_EQ(number_of_boundary_edges(mesh), boundary_edges - added - 2 * filled);
      EXPECT_TRUE(has_no_duplicate_edges(mesh));
      EXPECT_TRUE(is_linked(mesh));
    }
    EXPECT_GT(filled, 0u);
  }
}

template <typename TriangleMesh>
std::pair<Hole_filling_result, std::size_t> fill_sphere_with_holes()
{
  Triangulation surface = icosphere(2);
  // Four triangles that subdivide one, and a single triangle elsewhere.
  surface.corners.erase(surface.corners.begin() + 600, surface.corners.begin() + 603);
  surface.corners.erase(surface.corners.begin(), surface.corners.begin() + 12);
  Numbered<TriangleMesh> numbered;
  fill(numbered, surface);
  const Hole_filling_result holes = GP::fill_holes(numbered.mesh);
  EXPECT_TRUE(CGAL::is_closed(numbered.mesh));
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(numbered.mesh));
  return {holes, num_faces(numbered.mesh)};
}

TEST(fill_holes, accepts_all_mesh_types)
{
  const auto [holes, faces] = fill_sphere_with_holes<Mesh>();
  EXPECT_EQ(holes.number_of_holes, 2u);
  EXPECT_EQ(faces, 320u);
  EXPECT_EQ(holes.number_of_holes, holes.number_of_filled);
  using Exact_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto [same_holes, same_faces] = fill_sphere_with_holes<CGAL::Polyhedron_3<Exact_kernel>>();
  EXPECT_EQ(same_holes.number_of_filled, holes.number_of_filled);
  EXPECT_EQ(same_faces, faces);
}

TEST(fill_holes, accepts_closed_and_empty_meshes)
{
  Mesh empty, closed = mesh_of(tetrahedron());
  for(Mesh* mesh : {&empty, &closed})
  {
    const Hole_filling_result holes = GP::fill_holes(*mesh);
    EXPECT_EQ(holes.number_of_holes, 0u);
    EXPECT_EQ(holes.number_of_faces, 0u);
  }
}

TEST(fill_holes, cancels_without_change)
{
  Mesh mesh = tube(10, 1., true);
  std::vector<Face> added;
  int calls = 0;
  EXPECT_THROW(
      GP::fill_holes(mesh, GP::parameters::callback([&](double fraction)
                                                    { return ++calls < 3 && fraction < 1.; })
                               .face_output(std::back_inserter(added))),
      GP::Cancelled);
  EXPECT_EQ(calls, 3);
  EXPECT_TRUE(added.empty());
  EXPECT_EQ(number_of_boundary_edges(mesh), 23u);
}

TEST(fill_holes, throws_on_invalid_arguments)
{
  Mesh mesh = sheet(2);
  for(const double perimeter : {-1., std::nan("")})
    EXPECT_THROW(GP::fill_holes(mesh, GP::parameters::maximum_perimeter(perimeter)),
                 GP::Invalid_argument_error);
  mesh.point(Vertex(0)) = {std::nan(""), 0., 0.};
  EXPECT_THROW(GP::fill_holes(mesh), GP::Invalid_argument_error);
  EXPECT_EQ(mesh.number_of_faces(), 8u);
}

} // namespace fill_holes_test
