// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/intrinsic_delaunay.h"

#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace intrinsic_delaunay_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

double area(const Surface_arrays& t)
{
  double sum = 0.;
  for(std::size_t c = 0; c < t.length.size(); c += 3)
    sum += 0.5 * twice_area(t.length[c], t.length[c + 1], t.length[c + 2]);
  return sum;
}

void expect_delaunay(const Surface_arrays& t)
{
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index twin = t.twin[h];
    if(twin == none)
      continue;
    EXPECT_EQ(t.twin[twin], h);
    EXPECT_EQ(t.length[twin], t.length[h]);
    EXPECT_EQ(t.corner[twin], t.corner[next_halfedge(h)]);
    if(twin / 3 != h / 3)
    {
      EXPECT_LE(interior_angle(t, previous_halfedge(h)) +
                    interior_angle(t, previous_halfedge(twin)),
                pi + 1e-9); // flips end at a sine of 1e-12; the tolerance includes its square root
    }
  }
}

TEST(Intrinsic_delaunay, opposite_angles_sum_to_at_most_pi)
{
  for(const Triangulation& surface :
      {jittered(icosphere(3), 0.08), square(15, 0.24), annulus(40, 2, 1., 3.),
       cylinder(5, 40, 1., 0.4), cone(8, 5, 3. * pi)})
  {
    Surface_arrays t = *Array_surface(surface).triangles();
    const double before = area(t);
    flip_to_delaunay(t);
    expect_delaunay(t);
    EXPECT_NEAR(area(t), before, 1e-10 * before); // thousands of round-off errors
    EXPECT_TRUE(is_delaunay(t));
    EXPECT_TRUE(flip_to_delaunay(t).empty());
  }
}

TEST(Intrinsic_delaunay, planar_lengths_stay_euclidean)
{
  // New edges join vertices of the plane, so that their lengths are known.
  const Triangulation plane = square(15, 0.24);
  const Array_surface surface(plane);
  Surface_arrays t = *surface.triangles();
  EXPECT_FALSE(is_delaunay(t));
  EXPECT_FALSE(flip_to_delaunay(t).empty());
  for(Index h = 0; h < t.corner.size(); ++h)
    EXPECT_NEAR(surface.scale() * t.length[h],
                distance(surface.point(surface.caller_vertex(t.corner[h])),
                         surface.point(surface.caller_vertex(t.corner[next_halfedge(h)]))),
                1e-12); // some flips with a few round-off errors each
}

TEST(Intrinsic_delaunay, long_diagonal_is_flipped)
{
  // A flat rhombus with diagonals 4 and 1, divided by the long one.
  const Triangulation rhombus = {{{-2., 0., 0.}, {2., 0., 0.}, {0., 0.5, 0.}, {0., -0.5, 0.}},
                                 {0, 1, 2, 1, 0, 3}};
  const Array_surface surface(rhombus);
  Surface_arrays t = *surface.triangles();
  EXPECT_EQ(flip_to_delaunay(t).size(), 1u);
  expect_delaunay(t);
  // The round-off error of one unfolding.
  EXPECT_NEAR(surface.scale() * *std::min_element(t.length.begin(), t.length.end()), 1., 1e-15);
}

TEST(Intrinsic_delaunay, edges_within_the_tolerance_are_kept)
{
  // A flat rhombus with the diagonals 2 and 2 * 0.9; its angles at the short one sum to 192
  // degrees.
  const Triangulation rhombus = {{{-1., 0., 0.}, {1., 0., 0.}, {0., 0.9, 0.}, {0., -0.9, 0.}},
                                 {0, 1, 2, 1, 0, 3}};
  const Surface_arrays t = *Array_surface(rhombus).triangles();
  const auto number_of_flips = [&](double tolerance)
  {
    Surface_arrays copy = t;
    return flip_to_delaunay(copy, tolerance).size();
  };
  EXPECT_EQ(number_of_flips(11. * pi / 180.), 1u);
  EXPECT_FALSE(is_delaunay(t, 11. * pi / 180.));
  EXPECT_EQ(number_of_flips(13. * pi / 180.), 0u);
  EXPECT_TRUE(is_delaunay(t, 13. * pi / 180.));
}

TEST(Intrinsic_delaunay, number_of_flips_is_bounded)
{
  // On a sheared square, the number of flips per edge grows with the shear.
  const Array_surface surface(grid(20, 20,
                                   [](double u, double v) {
                                     return Point{u + 30. * v, v, 0.};
                                   }));
  Surface_arrays t = *surface.triangles();
  EXPECT_GT(flip_to_delaunay(t).size(), 1000u);
  EXPECT_TRUE(is_delaunay(t));
  t = *surface.triangles();
  const double before = area(t);
  EXPECT_EQ(flip_to_delaunay(t, delaunay_tolerance, 0).size(), 1000u);
  EXPECT_FALSE(is_delaunay(t));
  EXPECT_NEAR(area(t), before, 1e-10); // thousands of round-off errors
}

TEST(Intrinsic_delaunay, handles_triangles_that_share_two_edges)
{
  // Two triangles with the same three vertices: a flip makes an edge with the same vertex at both
  // ends.
  const Triangulation pillow = {{{0., 0., 0.}, {3., 0., 0.}, {1.5, 0.2, 0.}}, {0, 1, 2, 0, 2, 1}};
  Surface_arrays t = *Array_surface(pillow).triangles();
  const double before = area(t);
  flip_to_delaunay(t);
  expect_delaunay(t);
  // The round-off errors of a few flips.
  EXPECT_NEAR(area(t), before, 1e-12);
}

// Bisects the edges longer than half of the longest one, and flips to Delaunay.
void expect_bisected(const Triangulation& surface)
{
  Surface_arrays t = *Array_surface(surface).triangles();
  const std::size_t number_of_vertices = t.number_of_vertices(), before = t.number_of_triangles();
  const double total_area = area(t);
  const double max_length = 0.5 * *std::max_element(t.length.begin(), t.length.end());
  std::vector<Bisection> bisections;
  const std::size_t new_number =
      bisect_long_edges(t, number_of_vertices, max_length, 1000000, bisections);
  EXPECT_GT(new_number, number_of_vertices);
  EXPECT_EQ(t.number_of_triangles(), before + bisections.size());
  EXPECT_EQ(std::set<Index>(t.corner.begin(), t.corner.end()).size(), new_number);
  EXPECT_LE(*std::max_element(t.length.begin(), t.length.end()), max_length);
  EXPECT_NEAR(area(t), total_area, 1e-10 * total_area); // thousands of round-off errors
  flip_to_delaunay(t);
  expect_delaunay(t);
  // Thousands of round-off errors.
  EXPECT_NEAR(area(t), total_area, 1e-10 * total_area);
}

TEST(Intrinsic_delaunay, long_edges_are_bisected)
{
  for(const Triangulation& surface :
      {jittered(icosphere(2), 0.08), square(15, 0.24), annulus(40, 2, 1., 3.),
       cylinder(5, 40, 1., 0.4), cone(8, 5, 3. * pi), one_triangle(), tetrahedron()})
    expect_bisected(surface);
  expect_bisected({{{0., 0., 0.}, {3., 0., 0.}, {1.5, 0.2, 0.}}, {0, 1, 2, 0, 2, 1}});
}

TEST(Intrinsic_delaunay, bisection_stops_at_limit)
{
  Surface_arrays t = *Array_surface(square(4)).triangles();
  std::vector<Bisection> bisections;
  EXPECT_EQ(bisect_long_edges(t, 25, 1e-3, 40, bisections), 40u);
  Surface_arrays unchanged = *Array_surface(square(4)).triangles();
  bisections.clear();
  EXPECT_EQ(bisect_long_edges(unchanged, 25, 2., 1000, bisections), 25u);
  EXPECT_TRUE(bisections.empty());
}

TEST(Intrinsic_delaunay, mollification_is_minimal)
{
  Triangulation surface = square(6, 0.24);
  surface.points[23] = surface.points[24]; // an edge of length zero
  Surface_arrays t = *Array_surface(surface).triangles();
  const double slack = 1e-4;
  mollify(t, slack);
  double min_slack = infinity;
  for(Index h = 0; h < t.length.size(); ++h)
    min_slack = std::min(min_slack,
                         t.length[h] + t.length[next_halfedge(h)] - t.length[previous_halfedge(h)]);
  EXPECT_NEAR(min_slack, slack, 1e-15 * 4); // a few round-off errors of lengths below 2
  const auto lengths = t.length;
  mollify(t, 0.5 * slack);
  EXPECT_EQ(t.length, lengths);
}

} // namespace intrinsic_delaunay_test
