// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "triangulations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace mesh_arrays_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Expects the invariants of Surface_arrays on a mesh, and consistent maps to the indices of the
// caller.
void expect_valid(const Mesh_arrays& mesh, const Triangulation& surface)
{
  const Surface_arrays& t = mesh.arrays;
  ASSERT_EQ(t.number_of_vertices(), surface.points.size());
  ASSERT_EQ(t.corner.size(), surface.corners.size());
  EXPECT_FALSE(t.is_cloud());
  for(Index v = 0; v < t.number_of_vertices(); ++v)
    EXPECT_EQ(mesh.caller_vertex[mesh.internal_vertex[v]], v);
  double longest = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    EXPECT_EQ(mesh.face_of_triangle[mesh.triangle_of_face[f]], f);
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * f + k, vertex = surface.corners[3 * mesh.face_of_triangle[f] + k],
                  other = surface.corners[3 * mesh.face_of_triangle[f] + (k + 1) % 3];
      EXPECT_EQ(mesh.caller_vertex[t.corner[h]], vertex);
      // Two round-off errors of the largest coordinate.
      EXPECT_NEAR(t.scale * t.length[h], distance(surface.points[vertex], surface.points[other]),
                  1e-14 * t.scale);
      longest = std::max(longest, t.length[h]);
      if(t.twin[h] != none)
      {
        EXPECT_EQ(t.twin[t.twin[h]], h);
        EXPECT_EQ(t.corner[t.twin[h]], t.corner[next_halfedge(h)]);
        EXPECT_EQ(t.length[t.twin[h]], t.length[h]);
      }
    }
  }
  if(longest > 0.)
  {
    EXPECT_GE(longest, 1.);
    EXPECT_LT(longest, 2.);
  }
  // Each corner is listed once, at its vertex, and each fan is counterclockwise.
  std::set<Index> seen;
  for(Index v = 0; v < t.number_of_vertices(); ++v)
    for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    {
      EXPECT_EQ(t.corner[t.ring[i]], v);
      EXPECT_TRUE(seen.insert(t.ring[i]).second);
      const Index after = t.twin[previous_halfedge(t.ring[i])];
      if(after != none && i + 1 < t.ring_begin[v + 1] && !seen.count(after))
      {
        EXPECT_EQ(t.ring[i + 1], after);
      }
    }
  EXPECT_EQ(seen.size(), t.corner.size());
}

TEST(Mesh_arrays, represents_input_surface)
{
  for(const Triangulation& surface :
      {one_triangle(), tetrahedron(), square(9, 0.24), icosphere(2), annulus(12, 3, 1., 2.),
       disjoint_union(square(3), tetrahedron()), cone(12, 3, 3. * pi)})
    expect_valid(arrays_of(surface), surface);
}

TEST(Mesh_arrays, keeps_isolated_vertices)
{
  Triangulation surface = square(3);
  surface.points.push_back({5., 5., 5.});
  const Mesh_arrays mesh = arrays_of(surface);
  expect_valid(mesh, surface);
  const Index vertex = mesh.internal_vertex[16];
  EXPECT_EQ(mesh.arrays.ring_begin[vertex], mesh.arrays.ring_begin[vertex + 1]);
}

TEST(Mesh_arrays, handles_empty_input_and_points_without_faces)
{
  EXPECT_EQ(arrays_of({}).arrays.number_of_vertices(), 0u);
  const Mesh_arrays mesh = arrays_of({{{1., 2., 3.}, {4., 5., 6.}}, {}});
  EXPECT_EQ(mesh.arrays.number_of_vertices(), 2u);
  EXPECT_EQ(mesh.arrays.number_of_triangles(), 0u);
}

TEST(Mesh_arrays, ring_of_nonmanifold_vertex_lists_fans_consecutively)
{
  // Two triangles with the common point 0:   1   3
  //                                        |\ /|
  //                                        | 0 |
  //                                        |/ \|
  //                                        2   4
  const Triangulation surface = {
      {{0., 0., 0.}, {-1., 1., 0.}, {-1., -1., 0.}, {1., 1., 0.}, {1., -1., 0.}},
      {0, 1, 2, 0, 4, 3}};
  const Mesh_arrays mesh = arrays_of(surface);
  expect_valid(mesh, surface);
  const Index vertex = mesh.internal_vertex[0];
  EXPECT_EQ(mesh.arrays.ring_begin[vertex + 1] - mesh.arrays.ring_begin[vertex], 2u);
}

TEST(Mesh_arrays, scaling_by_powers_of_two_is_exact)
{
  const Triangulation surface = jittered(icosphere(2), 0.03);
  const Mesh_arrays mesh = arrays_of(surface);
  for(const int exponent : {-500, -30, 1, 40, 500})
  {
    Triangulation scaled = surface;
    for(Point& p : scaled.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    const Mesh_arrays other = arrays_of(scaled);
    EXPECT_EQ(other.arrays.length, mesh.arrays.length);
    EXPECT_EQ(other.arrays.corner, mesh.arrays.corner);
    EXPECT_EQ(other.arrays.point, mesh.arrays.point);
    EXPECT_EQ(other.arrays.scale, std::ldexp(mesh.arrays.scale, exponent));
  }
}

TEST(Mesh_arrays, nonmanifold_edges_become_boundary)
{
  // Three triangles at edge 01, and two triangles with 01 in the same direction.
  const std::vector<Index> fin = {0, 1, 2, 1, 0, 3, 0, 1, 4}, flipped = {0, 1, 2, 0, 1, 3};
  for(const auto& corners : {fin, flipped})
    for(const Index twin : twins_of_soup(5, corners))
      EXPECT_EQ(twin, none);
  const auto twins = twins_of_soup(4, {0, 1, 2, 1, 0, 3});
  EXPECT_EQ(twins, (std::vector<Index>{3, none, none, 0, none, none}));
}

TEST(Mesh_arrays, counts_degenerate_triangles)
{
  EXPECT_EQ(arrays_of(icosphere(2)).number_of_degenerate_triangles, 0u);
  const Triangulation surface = {
      {{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {0., 1., 0.}, {0., 1., 0.}, {1., 1e-20, 0.}},
      // collinear, zero edge, needle below round-off errors, not degenerate
      {0, 1, 2, 0, 3, 4, 0, 2, 5, 0, 2, 3}};
  EXPECT_EQ(arrays_of(surface).number_of_degenerate_triangles, 3u);
}

TEST(Mesh_arrays, every_edge_has_positive_length)
{
  Triangulation surface = square(8, 0.2);
  surface.points[30] = surface.points[31];
  surface.points[50] = surface.points[51] = surface.points[60];
  const Mesh_arrays mesh = arrays_of(surface);
  const std::vector<double>& length = mesh.arrays.length;
  for(Index h = 0; h < length.size(); ++h)
  {
    // Lengths are at least min_edge_length, 1.5e-11.
    EXPECT_GT(length[h], 1e-11);
    EXPECT_LE(length[h], length[next_halfedge(h)] + length[previous_halfedge(h)]);
    const Index twin = mesh.arrays.twin[h];
    EXPECT_EQ(length[h], length[twin == none ? h : twin]);
  }
  EXPECT_GE(mesh.number_of_degenerate_triangles,
            4u); // two at the first edge, two at another one
  // If all points coincide, all lengths stay zero.
  for(Point& p : surface.points)
    p = {3., 4., 5.};
  for(const double zero : arrays_of(surface).arrays.length)
    EXPECT_EQ(zero, 0.);
}

TEST(Mesh_arrays, labels_connected_components)
{
  const Triangulation surface =
      disjoint_union(disjoint_union(square(3), tetrahedron()), {{{9., 9., 9.}}, {}});
  const Mesh_arrays mesh = arrays_of(surface);
  const auto [label, count] = components(mesh.arrays);
  EXPECT_EQ(count, 3u);
  for(Index v = 0; v < surface.points.size(); ++v)
    for(const Index first : {0u, 16u, 20u})
      EXPECT_EQ(label[mesh.internal_vertex[v]] == label[mesh.internal_vertex[first]],
                (v < 16   ? 0u
                 : v < 20 ? 16u
                          : 20u) == first);
}

TEST(Mesh_arrays, throws_on_nonfinite_coordinates)
{
  Triangulation surface = square(2);
  surface.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(arrays_of(surface), Invalid_argument_error);
  surface.points[3][1] = infinity;
  EXPECT_THROW(arrays_of(surface), Invalid_argument_error);
}

TEST(Mesh_arrays, far_isolated_vertices_do_not_change_lengths)
{
  Triangulation surface = square(5, 0.24);
  surface.points.push_back({0.5, 0.5, 0.});
  const Mesh_arrays near = arrays_of(surface);
  for(const double distance : {1e9, 1e100, 1e300})
  {
    surface.points.back()[2] = distance;
    const Mesh_arrays far = arrays_of(surface);
    EXPECT_EQ(far.arrays.scale, near.arrays.scale);
    std::vector<double> lengths = near.arrays.length, far_lengths = far.arrays.length;
    std::sort(lengths.begin(), lengths.end());
    std::sort(far_lengths.begin(), far_lengths.end());
    EXPECT_EQ(lengths, far_lengths);
  }
}

// The coordinates are multiples of 1/4, so that their differences are exact at any distance from
// the origin.
TEST(Mesh_arrays, lengths_are_those_of_the_coordinates)
{
  Triangulation surface = square(4);
  surface.points.push_back({-0x1p30, 0., 0.});
  surface.corners.insert(surface.corners.end(), {0, 5, 25});
  const Mesh_arrays mesh = arrays_of(surface);
  for(std::size_t c = 0; c < 3 * 32; ++c)
  {
    const Index f = Index(c / 3), h = 3 * mesh.triangle_of_face[f] + Index(c % 3);
    const Point &p = surface.points[surface.corners[c]],
                &q = surface.points[surface.corners[c - c % 3 + (c + 1) % 3]];
    EXPECT_DOUBLE_EQ(mesh.arrays.scale * mesh.arrays.length[h],
                     std::hypot(p[0] - q[0], p[1] - q[1]));
  }
}

TEST(Mesh_arrays, throws_if_most_edges_are_too_short)
{
  Triangulation surface = square(5);
  surface.points[5][0] = 1e9; // the other edges have a length of 1/5
  EXPECT_NO_THROW(arrays_of(surface));
  for(const double far : {1e11, 1e160, 1e200, 1e300}) // squares of scaled lengths underflow
  {
    surface.points[5][0] = far;
    EXPECT_THROW(arrays_of(surface), Unsupported_surface_error) << far;
  }
  // A few short edges are accepted.
  surface = square(5);
  surface.points[8] = surface.points[7];
  surface.points[8][0] += 1e-13;
  EXPECT_NO_THROW(arrays_of(surface));
}

void expect_equal(const Mesh_arrays& mesh, const Mesh_arrays& other)
{
  EXPECT_EQ(mesh.internal_vertex, other.internal_vertex);
  EXPECT_EQ(mesh.caller_vertex, other.caller_vertex);
  EXPECT_EQ(mesh.triangle_of_face, other.triangle_of_face);
  EXPECT_EQ(mesh.face_of_triangle, other.face_of_triangle);
  EXPECT_EQ(mesh.number_of_degenerate_triangles, other.number_of_degenerate_triangles);
  EXPECT_EQ(mesh.arrays.corner, other.arrays.corner);
  EXPECT_EQ(mesh.arrays.twin, other.arrays.twin);
  EXPECT_EQ(mesh.arrays.length, other.arrays.length);
  EXPECT_EQ(mesh.arrays.ring_begin, other.arrays.ring_begin);
  EXPECT_EQ(mesh.arrays.ring, other.arrays.ring);
  EXPECT_EQ(mesh.arrays.point, other.arrays.point);
  EXPECT_EQ(mesh.arrays.scale, other.arrays.scale);
  EXPECT_EQ(mesh.arrays.origin, other.arrays.origin);
}

// A fan of triangles around its first point, closed or not.
Triangulation fan(Index degree, bool is_closed)
{
  Triangulation result = {{{0., 0., 0.}}, {}};
  for(Index i = 0; i < degree; ++i)
    result.points.push_back({std::cos(i), std::sin(i), 0.1 * i});
  for(Index i = 0; i + (is_closed ? 0 : 1) < degree; ++i)
    result.corners.insert(result.corners.end(), {1 + i, 1 + (i + 1) % degree, 0});
  return result;
}

TEST(Build_oriented_arrays, has_arrays_of_the_twins_of_a_soup)
{
  const Triangulation bowtie = {
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}}, {0, 1, 2, 0, 3, 4}};
  // Triangles on both sides of one triangle.
  const Triangulation two_sided = {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}, {0, 1, 2, 0, 2, 1}};
  std::mt19937 random(1);
  for(Triangulation surface : {bowtie, two_sided, square(30, 0.2), icosphere(4), fan(5, true),
                               fan(5, false), fan(100, true), fan(100, false), Triangulation()})
    for(int repetition = 0; repetition < 3; ++repetition)
    {
      const auto twins = twins_of_soup(surface.points.size(), surface.corners);
      const Mesh_arrays expected = build_mesh_arrays(surface.points, surface.corners, twins);
      std::set<std::pair<Index, Index>> fans; // a vertex, and the smallest corner of the fan
      for(Index c = 0; c < surface.corners.size(); ++c)
      {
        Index smallest = c, corner = c;
        do
          smallest = std::min(smallest, corner);
        while((corner = twins[previous_halfedge(corner)]) != none && corner != c);
        for(corner = c; twins[corner] != none && next_halfedge(twins[corner]) != c;)
          smallest = std::min(smallest, corner = next_halfedge(twins[corner]));
        fans.insert({surface.corners[c], smallest});
      }
      std::map<Index, int> fans_of_vertex;
      for(const auto& [vertex, corner] : fans)
        ++fans_of_vertex[vertex];
      for(const unsigned number_of_threads : {1u, 2u, 5u})
      {
        Mesh_counts counts;
        const auto mesh =
            build_oriented_arrays(surface.points, surface.corners, counts, number_of_threads);
        ASSERT_TRUE(mesh.has_value());
        expect_equal(*mesh, expected);
        EXPECT_EQ(counts.rings.number_of_fans, fans.size());
        EXPECT_EQ(counts.rings.number_of_nonmanifold_vertices,
                  std::size_t(std::count_if(fans_of_vertex.begin(), fans_of_vertex.end(),
                                            [](const auto& v) { return v.second > 1; })));
      }
      // Once more, with the triangles in another order.
      for(std::size_t f = surface.corners.size() / 3; f > 1; --f)
        std::swap_ranges(surface.corners.begin() + 3 * (f - 1), surface.corners.begin() + 3 * f,
                         surface.corners.begin() + 3 * (random() % f));
    }
}

TEST(Build_oriented_arrays, does_not_depend_on_threads)
{
  const Triangulation surface = square(150, 0.2);
  Mesh_counts counts;
  const auto expected = build_oriented_arrays(surface.points, surface.corners, counts);
  ASSERT_TRUE(expected.has_value());
  EXPECT_EQ(counts.number_of_components, 1u);
  for(const unsigned number_of_threads : {2u, 5u})
  {
    Mesh_counts counts_here;
    const auto mesh =
        build_oriented_arrays(surface.points, surface.corners, counts_here, number_of_threads);
    ASSERT_TRUE(mesh.has_value());
    expect_equal(*mesh, *expected);
    EXPECT_EQ(counts_here.number_of_components, counts.number_of_components);
    EXPECT_EQ(counts_here.rings.number_of_fans, counts.rings.number_of_fans);
  }
}

TEST(Build_oriented_arrays, returns_nothing_if_an_edge_is_not_oriented_or_not_manifold)
{
  for(const Index degree : {5, 100})
    for(const bool is_closed : {false, true})
    {
      const Triangulation surface = fan(degree, is_closed);
      const auto is_refused = [&](std::vector<Index> corners)
      {
        auto points = surface.points;
        points.push_back({0., 0., -1.});
        Mesh_counts counts;
        return !build_oriented_arrays(points, corners, counts) &&
               !build_oriented_arrays(points, corners, counts, 2);
      };
      EXPECT_FALSE(is_refused(surface.corners));
      std::vector<Index> reversed = surface.corners;
      std::swap(reversed[3], reversed[4]);
      EXPECT_TRUE(is_refused(reversed));
      std::vector<Index> duplicate = surface.corners;
      duplicate.insert(duplicate.end(), {0, 1, 2});
      EXPECT_TRUE(is_refused(duplicate));
      std::vector<Index> third_triangle = surface.corners;
      third_triangle.insert(third_triangle.end(), {0, 3, degree + 1});
      EXPECT_TRUE(is_refused(third_triangle));
      // Two boundary halfedges of the same direction.
      std::vector<Index> second_triangle = surface.corners;
      second_triangle.insert(second_triangle.end(), {1, 2, degree + 1});
      EXPECT_TRUE(is_refused(second_triangle));
    }
}

} // namespace mesh_arrays_test
