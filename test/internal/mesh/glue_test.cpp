// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/glue.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "triangulations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

namespace {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The invariants of Glued_triangles on a mesh, and the way back to the caller's numbers.
void expect_valid(const Glued_mesh& mesh, const Triangulation& surface)
{
  const Glued_triangles& t = mesh.triangles;
  ASSERT_EQ(t.number_of_sites(), surface.points.size());
  ASSERT_EQ(t.corner.size(), surface.corners.size());
  EXPECT_FALSE(t.is_cloud());
  for(Index v = 0; v < t.number_of_sites(); ++v)
    EXPECT_EQ(mesh.vertex_of_site[mesh.site_of_vertex[v]], v);
  double longest = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    EXPECT_EQ(mesh.face_of_triangle[mesh.triangle_of_face[f]], f);
    for(Index k = 0; k < 3; ++k)
    {
      const Index side = 3 * f + k, vertex = surface.corners[3 * mesh.face_of_triangle[f] + k],
                  other = surface.corners[3 * mesh.face_of_triangle[f] + (k + 1) % 3];
      EXPECT_EQ(mesh.vertex_of_site[t.corner[side]], vertex);
      // Two roundings of the largest coordinate.
      EXPECT_NEAR(t.scale * t.length[side], distance(surface.points[vertex], surface.points[other]),
                  1e-14 * t.scale);
      longest = std::max(longest, t.length[side]);
      if(t.twin[side] != none)
      {
        EXPECT_EQ(t.twin[t.twin[side]], side);
        EXPECT_EQ(t.corner[t.twin[side]], t.corner[next_side(side)]);
        EXPECT_EQ(t.length[t.twin[side]], t.length[side]);
      }
    }
  }
  if(longest > 0.)
  {
    EXPECT_GE(longest, 1.);
    EXPECT_LT(longest, 2.);
  }
  // Each corner once, at its own site; each fan counterclockwise.
  std::set<Index> seen;
  for(Index v = 0; v < t.number_of_sites(); ++v)
    for(Index i = t.first[v]; i < t.first[v + 1]; ++i)
    {
      EXPECT_EQ(t.corner[t.star[i]], v);
      EXPECT_TRUE(seen.insert(t.star[i]).second);
      const Index after = t.twin[previous_side(t.star[i])];
      if(after != none && i + 1 < t.first[v + 1] && !seen.count(after))
      {
        EXPECT_EQ(t.star[i + 1], after);
      }
    }
  EXPECT_EQ(seen.size(), t.corner.size());
}

TEST(Glue, keeps_the_surface)
{
  for(const Triangulation& surface :
      {one_triangle(), tetrahedron(), square(9, 0.24), icosphere(2), annulus(12, 3, 1., 2.),
       apart(square(3), tetrahedron()), cone(12, 3, 3. * pi)})
    expect_valid(glued(surface), surface);
}

TEST(Glue, keeps_isolated_points)
{
  Triangulation surface = square(3);
  surface.points.push_back({5., 5., 5.});
  const Glued_mesh mesh = glued(surface);
  expect_valid(mesh, surface);
  const Index site = mesh.site_of_vertex[16];
  EXPECT_EQ(mesh.triangles.first[site], mesh.triangles.first[site + 1]);
}

TEST(Glue, takes_no_points_and_points_alone)
{
  EXPECT_EQ(glued({}).triangles.number_of_sites(), 0u);
  const Glued_mesh mesh = glued({{{1., 2., 3.}, {4., 5., 6.}}, {}});
  EXPECT_EQ(mesh.triangles.number_of_sites(), 2u);
  EXPECT_EQ(mesh.triangles.number_of_triangles(), 0u);
}

TEST(Glue, puts_the_fans_of_a_pinched_site_one_after_another)
{
  // Two triangles that touch in point 0:   1   3
  //                                        |\ /|
  //                                        | 0 |
  //                                        |/ \|
  //                                        2   4
  const Triangulation surface = {
      {{0., 0., 0.}, {-1., 1., 0.}, {-1., -1., 0.}, {1., 1., 0.}, {1., -1., 0.}},
      {0, 1, 2, 0, 4, 3}};
  const Glued_mesh mesh = glued(surface);
  expect_valid(mesh, surface);
  const Index site = mesh.site_of_vertex[0];
  EXPECT_EQ(mesh.triangles.first[site + 1] - mesh.triangles.first[site], 2u);
}

TEST(Glue, is_exactly_scaled_by_powers_of_two)
{
  const Triangulation surface = shaken(icosphere(2), 0.03);
  const Glued_mesh mesh = glued(surface);
  for(const int exponent : {-500, -30, 1, 40, 500})
  {
    Triangulation scaled = surface;
    for(Point& p : scaled.points)
      for(double& x : p)
        x = std::ldexp(x, exponent);
    const Glued_mesh other = glued(scaled);
    EXPECT_EQ(other.triangles.length, mesh.triangles.length);
    EXPECT_EQ(other.triangles.corner, mesh.triangles.corner);
    EXPECT_EQ(other.triangles.point, mesh.triangles.point);
    EXPECT_EQ(other.triangles.scale, std::ldexp(mesh.triangles.scale, exponent));
  }
}

TEST(Glue, leaves_sides_on_the_border_that_no_pair_claims)
{
  // Three triangles at the side 0-1; two triangles that run along 0-1 the same way.
  const std::vector<Index> fin = {0, 1, 2, 1, 0, 3, 0, 1, 4}, flipped = {0, 1, 2, 0, 1, 3};
  for(const auto& corners : {fin, flipped})
    for(const Index twin : twins_of_soup(5, corners))
      EXPECT_EQ(twin, none);
  const auto twins = twins_of_soup(4, {0, 1, 2, 1, 0, 3});
  EXPECT_EQ(twins, (std::vector<Index>{3, none, none, 0, none, none}));
}

TEST(Glue, counts_triangles_without_area)
{
  EXPECT_EQ(glued(icosphere(2)).degenerate, 0u);
  const Triangulation surface = {
      {{0., 0., 0.}, {1., 0., 0.}, {2., 0., 0.}, {0., 1., 0.}, {0., 1., 0.}, {1., 1e-20, 0.}},
      {0, 1, 2, 0, 3, 4, 0, 2, 5, 0, 2, 3}}; // collinear, zero side, needle below rounding, none
  EXPECT_EQ(glued(surface).degenerate, 3u);
}

TEST(Glue, gives_each_side_a_length)
{
  Triangulation surface = square(8, 0.2);
  surface.points[30] = surface.points[31];
  surface.points[50] = surface.points[51] = surface.points[60];
  const Glued_mesh mesh = glued(surface);
  const std::vector<double>& length = mesh.triangles.length;
  for(Index side = 0; side < length.size(); ++side)
  {
    EXPECT_GT(length[side], 1e-11);
    EXPECT_LE(length[side], length[next_side(side)] + length[previous_side(side)]);
    const Index twin = mesh.triangles.twin[side];
    EXPECT_EQ(length[side], length[twin == none ? side : twin]);
  }
  EXPECT_GE(mesh.degenerate, 4u); // two beside the first side, two beside one of the others
  // Where there is no other length either, there is none to be given.
  for(Point& p : surface.points)
    p = {3., 4., 5.};
  for(const double zero : glued(surface).triangles.length)
    EXPECT_EQ(zero, 0.);
}

TEST(Glue, numbers_components)
{
  const Triangulation surface = apart(apart(square(3), tetrahedron()), {{{9., 9., 9.}}, {}});
  const Glued_mesh mesh = glued(surface);
  const auto [label, count] = components(mesh.triangles);
  EXPECT_EQ(count, 3u);
  for(Index v = 0; v < surface.points.size(); ++v)
    for(const Index first : {0u, 16u, 20u})
      EXPECT_EQ(label[mesh.site_of_vertex[v]] == label[mesh.site_of_vertex[first]],
                (v < 16   ? 0u
                 : v < 20 ? 16u
                          : 20u) == first);
}

TEST(Glue, refuses_what_is_not_finite)
{
  Triangulation surface = square(2);
  surface.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(glued(surface), Invalid_argument_error);
  surface.points[3][1] = infinity;
  EXPECT_THROW(glued(surface), Invalid_argument_error);
}

} // namespace
