// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Intrinsic_triangulation.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace Intrinsic_triangulation_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The vertices keep their positions. In a plane, the triangles of the triangulation are those of
// the plane, so that a location has coordinates in both.
Vec3 point_in(const Surface_arrays& mesh, const Surface_arrays& triangles,
              const Surface_location& location)
{
  Vec3 result = {0., 0., 0.};
  for(int k = 0; k < 3; ++k)
    result = result + location.barycentric[k] *
                          mesh.point[triangles.corner[3 * std::size_t(location.triangle) + k]];
  return result;
}

// A flat mesh of stretched triangles: a fifth of their edges is flipped.
Triangulation stretched_plane()
{
  return grid(
      15, 15,
      [](double u, double v) {
        return Point{4. * u, v, 0.};
      },
      0.24, 3);
}

// Positions have scaled coordinates below 2 and pass through tens of flips.
constexpr double round_off = 1e-13;

void expect_canonical(const Surface_location& location)
{
  ASSERT_NE(location.triangle, none);
  for(const double weight : location.barycentric)
    EXPECT_GE(weight, 0.);
  EXPECT_NEAR(std::accumulate(location.barycentric.begin(), location.barycentric.end(), 0.), 1.,
              1e-15); // three round-off errors
}

TEST(Intrinsic_triangulation, keeps_positions_in_plane)
{
  const Array_surface surface(stretched_plane());
  const Surface_arrays& mesh = surface.t();
  const Intrinsic_triangulation triangulation(mesh);
  ASSERT_FALSE(triangulation.is_empty());
  std::mt19937 random(1);
  for(int i = 0; i < 500; ++i)
  {
    const Surface_location location = canonical(mesh, random_location(mesh, random));
    const Surface_location image = triangulation.locate(location);
    expect_canonical(image);
    EXPECT_LT(norm(point_in(mesh, *triangulation.triangles(), image) -
                   scaled_coordinates(mesh, location)),
              round_off);
  }
}

// Returns the distance of two locations in the same triangle.
double distance_in(const Surface_arrays& triangles, const Surface_location& p,
                   const Surface_location& q)
{
  return distance_in_triangle(triangles, p.triangle, p.barycentric, q.barycentric);
}

TEST(Intrinsic_triangulation, keeps_distances_if_long_edges_are_bisected)
{
  const Array_surface surface(graded_square(15));
  const Surface_arrays& mesh = surface.t();
  const Intrinsic_triangulation triangulation(mesh, Bisected_edges::long_edges);
  const Surface_arrays& triangles = *triangulation.triangles();
  ASSERT_GT(triangles.number_of_vertices(), mesh.number_of_vertices() + 20);
  std::mt19937 random(1);
  std::vector<std::pair<Surface_location, Surface_location>> pairs; // on the mesh, and its image
  for(int i = 0; i < 2000; ++i)
  {
    const Surface_location location = canonical(mesh, random_location(mesh, random));
    const Surface_location image = triangulation.locate(location);
    expect_canonical(image);
    for(const auto& [other, other_image] : pairs)
      if(other_image.triangle == image.triangle)
      {
        EXPECT_NEAR(distance_in(triangles, image, other_image),
                    norm(scaled_coordinates(mesh, location) - scaled_coordinates(mesh, other)),
                    round_off);
      }
    pairs.emplace_back(location, image);
  }
  for(Index corner = 0; corner < mesh.corner.size(); ++corner)
    EXPECT_EQ(vertex_of(triangles,
                        triangulation.locate({corner / 3, none, barycentric_at_corner(corner)})),
              mesh.corner[corner]);
}

TEST(Intrinsic_triangulation, pieces_of_segment_cover_it_if_long_edges_are_bisected)
{
  const Array_surface surface(graded_square(15));
  const Surface_arrays& mesh = surface.t();
  const Intrinsic_triangulation triangulation(mesh, Bisected_edges::long_edges);
  std::mt19937 random(2);
  std::size_t number_of_pieces = 0;
  for(int i = 0; i < 300; ++i)
  {
    const Surface_location begin = random_location(mesh, random);
    Surface_location end = random_location(mesh, random);
    end.triangle = begin.triangle;
    double length = 0.;
    for(const auto& [from, to] :
        triangulation.locate_segment(begin.triangle, begin.barycentric, end.barycentric))
    {
      ++number_of_pieces;
      EXPECT_EQ(from.triangle, to.triangle);
      length += distance_in(*triangulation.triangles(), from, to);
    }
    EXPECT_NEAR(length, norm(scaled_coordinates(mesh, begin) - scaled_coordinates(mesh, end)),
                round_off);
  }
  EXPECT_GT(number_of_pieces, 330u); // some segments cross edges
}

TEST(Intrinsic_triangulation, keeps_vertices)
{
  // On a closed mesh, a mesh with boundary, needles of width 1e-9, and a needle of area zero.
  Triangulation flat_needle = square(3);
  flat_needle.points[5] = {1. / 3., 0., 0.}; // on the lower side
  for(const Triangulation& surface :
      {jittered(icosphere(2), 0.1), square(8, 0.24), cylinder(300, 3, 1., 1e-9), flat_needle})
  {
    const Array_surface arrays(surface);
    const Intrinsic_triangulation triangulation(arrays.t());
    ASSERT_FALSE(triangulation.is_empty());
    const Surface_arrays& triangles = *triangulation.triangles();
    for(Index corner = 0; corner < arrays.t().corner.size(); ++corner)
    {
      const Surface_location image =
          triangulation.locate({corner / 3, none, barycentric_at_corner(corner)});
      EXPECT_EQ(vertex_of(triangles, image), arrays.t().corner[corner]);
    }
    for(Index vertex = 0; vertex < arrays.size(); ++vertex)
      EXPECT_EQ(vertex_of(triangles, triangulation.locate({none, vertex, {}})), vertex);
  }
}

TEST(Intrinsic_triangulation, pieces_of_segment_cover_it)
{
  const Array_surface surface(stretched_plane());
  const Surface_arrays& mesh = surface.t();
  const Intrinsic_triangulation triangulation(mesh);
  std::mt19937 random(2);
  std::size_t number_of_pieces = 0;
  for(int i = 0; i < 300; ++i)
  {
    const Surface_location begin = random_location(mesh, random);
    Surface_location end = random_location(mesh, random);
    end.triangle = begin.triangle;
    const Vec3 p = scaled_coordinates(mesh, begin), q = scaled_coordinates(mesh, end);
    double length = 0.;
    for(const auto& [from, to] :
        triangulation.locate_segment(begin.triangle, begin.barycentric, end.barycentric))
    {
      ++number_of_pieces;
      expect_canonical(from);
      expect_canonical(to);
      EXPECT_EQ(from.triangle, to.triangle);
      const Vec3 a = point_in(mesh, *triangulation.triangles(), from),
                 b = point_in(mesh, *triangulation.triangles(), to);
      length += norm(b - a);
      for(const Vec3& point : {a, b}) // on the segment: the triangle inequality is an equation
        EXPECT_NEAR(norm(point - p) + norm(point - q), norm(p - q), round_off);
    }
    EXPECT_NEAR(length, norm(p - q), round_off);
  }
  EXPECT_GT(number_of_pieces, 330u); // some segments cross edges
}

TEST(Intrinsic_triangulation, every_edge_is_kept_or_removed)
{
  for(const Triangulation& surface : {jittered(icosphere(3), 0.1), square(10, 0.24)})
  {
    const Array_surface arrays(surface);
    const Surface_arrays& mesh = arrays.t();
    const Intrinsic_triangulation triangulation(mesh);
    const Surface_arrays& triangles = *triangulation.triangles();
    std::size_t number_of_removed = 0;
    for(Index h = 0; h < mesh.corner.size(); ++h)
    {
      const Index from = mesh.corner[h], to = mesh.corner[next_halfedge(h)];
      bool is_kept = false;
      for(Index k = 0; k < triangles.corner.size(); ++k)
        is_kept = is_kept ||
                  (((triangles.corner[k] == from && triangles.corner[next_halfedge(k)] == to) ||
                    (triangles.corner[k] == to && triangles.corner[next_halfedge(k)] == from)) &&
                   triangles.length[k] == mesh.length[h]);
      const auto [begin, end] = triangulation.removed_edges(from);
      const bool is_removed = std::any_of(
          begin, end,
          [&](const auto& edge) { return edge.vertex == to && edge.length == mesh.length[h]; });
      EXPECT_NE(is_kept, is_removed);
      number_of_removed += is_removed;
    }
    EXPECT_GT(number_of_removed, 0u);
  }
}

TEST(Intrinsic_triangulation, of_delaunay_mesh_is_empty)
{
  EXPECT_TRUE(Intrinsic_triangulation(Array_surface(icosphere(3)).t()).is_empty());
}

TEST(Intrinsic_triangulation, uniformly_stretched_mesh_is_not_bisected)
{
  // Rectangles of 12 to 1: their diagonals are 3.5 times the root of the area per vertex, and no
  // angles sum to more than pi.
  const auto stretched = [](double u, double v) { return Point{12. * u, v, 0.}; };
  const Array_surface surface(grid(30, 30, stretched, 0., 3));
  EXPECT_TRUE(Intrinsic_triangulation(surface.t(), Bisected_edges::long_edges).is_empty());
}

TEST(Intrinsic_triangulation, handles_vertex_of_two_fans)
{
  // Two flat rhombi that share a vertex only; the long diagonal of each is flipped.
  const Triangulation surface = {{{0., 0., 0.},
                                  {4., 0., 0.},
                                  {2., 0.5, 0.},
                                  {2., -0.5, 0.},
                                  {-4., 0., 0.},
                                  {-2., 0.5, 0.},
                                  {-2., -0.5, 0.}},
                                 {0, 1, 2, 1, 0, 3, 4, 0, 5, 0, 4, 6}};
  const Array_surface arrays(surface);
  const Intrinsic_triangulation triangulation(arrays.t());
  ASSERT_FALSE(triangulation.is_empty());
  for(Index face = 0; face < 4; ++face)
  {
    const Surface_location location = arrays.in(face, {0.5, 0.3, 0.2});
    EXPECT_LT(
        norm(point_in(arrays.t(), *triangulation.triangles(), triangulation.locate(location)) -
             scaled_coordinates(arrays.t(), location)),
        round_off);
  }
}

TEST(Intrinsic_triangulation, is_shared_while_in_use)
{
  const Array_surface surface(square(5, 0.24));
  const auto first = shared_intrinsic_triangulation(surface.t(), Bisected_edges::none);
  EXPECT_EQ(shared_intrinsic_triangulation(surface.t(), Bisected_edges::none), first);
  EXPECT_NE(shared_intrinsic_triangulation(surface.t(), Bisected_edges::long_edges), first);
}

} // namespace Intrinsic_triangulation_test
