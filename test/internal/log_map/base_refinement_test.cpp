// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "log_map/base_refinement.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/distances/front.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace base_refinement_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Refines around a location up to the given distances, in the unit of the triangulation.
Base_refinement refined(const Array_surface& surface, const Surface_location& base, double radius,
                        double margin, std::size_t levels)
{
  return refine_around_base(surface.triangles(), canonical(surface.t(), base),
                            radius / surface.scale(), margin / surface.scale(), levels);
}

// Returns the coordinates of a vertex of the refined mesh in the unit of the triangulation.
Point fine_point(const Base_refinement& refinement, Index vertex)
{
  return coordinates(*refinement.refinement.triangles, {none, vertex, {}});
}

TEST(base_refinement, keeps_vertices_and_exact_distances)
{
  for(const double scale : {1e-6, 1., 1e6})
  {
    const Array_surface surface(scaled(jittered(icosphere(2), 0.1), scale));
    for(const Surface_location& base :
        {surface.at(17), surface.on(30, 1, 0.3), surface.in(40, {0.2, 0.3, 0.5})})
    {
      const Base_refinement fine = refined(surface, base, 0.3 * scale, 0.3 * scale, 3);
      const Surface_arrays& t = *fine.refinement.triangles;
      EXPECT_GT(t.number_of_triangles(), 3 * surface.t().number_of_triangles());
      for(Index v = 0; v < surface.size(); ++v)
      {
        ASSERT_NE(fine.fine_vertex[v], none);
        EXPECT_EQ(fine.coarse_vertex[fine.fine_vertex[v]], v);
        // One rounding of the translated coordinates.
        EXPECT_LT(distance(fine_point(fine, fine.fine_vertex[v]),
                           surface.point(surface.caller_vertex(v))),
                  1e-14 * scale);
      }
      Window_propagation coarse_windows(surface.triangles()),
          fine_windows(fine.refinement.triangles);
      coarse_windows.run({Front_source{{base}}});
      fine_windows.run({Front_source{to_fine(fine.refinement, {canonical(surface.t(), base)})}});
      for(Index v = 0; v < surface.size(); ++v)
        // Windows of some tens of faces, in the scale of the arrays.
        EXPECT_NEAR(fine.unit_size() * fine_windows.distance(fine.fine_vertex[v]),
                    coarse_windows.distance(v), 1e-12);
    }
  }
}

TEST(base_refinement, halves_edges_around_the_base)
{
  const Array_surface surface(square(20));
  const Surface_location base = surface.at(10 + 21 * 10);
  for(const std::size_t levels : {0, 1, 2, 4})
  {
    const Base_refinement fine = refined(surface, base, 0.1, 0.1, levels);
    const Surface_arrays& t = *fine.refinement.triangles;
    const double edge = 0.05 * std::sqrt(2.); // the longest one, a diagonal
    for(Index f = 0; f < t.number_of_triangles(); ++f)
    {
      double nearest = infinity, longest = 0.;
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        nearest = std::min(nearest, distance(fine_point(fine, t.corner[h]), {0.5, 0.5, 0.}));
        longest = std::max(longest, t.scale * t.length[h]);
      }
      const double round_off = 1e-12;
      if(nearest <= 0.1) // level k divides all faces up to 0.1 + 0.1 / 2^(k - 1)
      {
        EXPECT_LT(longest, std::ldexp(edge, -int(levels)) + round_off);
      }
      // Level 1 divides faces with a corner within 0.2, and their neighbors.
      if(nearest > 0.2 + 2. * edge)
      {
        EXPECT_GT(longest, edge - round_off);
      }
    }
  }
}

TEST(base_refinement, divides_a_large_face_that_contains_the_base)
{
  const Array_surface surface(one_triangle());
  const Base_refinement fine = refined(surface, surface.in(0, {0.3, 0.3, 0.4}), 1e-6, 1e-6, 6);
  EXPECT_GT(fine.refinement.triangles->number_of_triangles(), 18u); // at least three per level
  double area = 0.;
  for(const auto& corner : fine.refinement.corners)
    area += std::fabs((corner[1][0] - corner[0][0]) * (corner[2][1] - corner[0][1]) -
                      (corner[1][1] - corner[0][1]) * (corner[2][0] - corner[0][0]));
  EXPECT_NEAR(area, 1., 1e-13); // sums of dyadic areas; the children cover the face once
}

TEST(base_refinement, keeps_nonmanifold_and_isolated_vertices)
{
  const Array_surface bow_tie(
      {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}, {3., 3., 0.}},
       {0, 1, 2, 0, 3, 4}});
  const Base_refinement fine = refined(bow_tie, bow_tie.at(1), 0.2, 0.2, 2);
  EXPECT_EQ(fine.fine_vertex[bow_tie.vertex(5)], none);
  Front front(fine.refinement.triangles, Front_kind::euclidean);
  front.run({Front_source{{{none, fine.fine_vertex[bow_tie.vertex(1)], {}}}}});
  // The front passes the common vertex: 1 + 1 along the axes, up to round-off errors.
  EXPECT_NEAR(fine.refinement.triangles->scale *
                  front.distance(fine.fine_vertex[bow_tie.vertex(3)]),
              2., 1e-12);
}

TEST(base_refinement, does_not_split_tiny_edges)
{
  // The edges at the base are 1e-9 of the longest one, 64 times min_edge_length.
  const Array_surface surface(
      {{{0., 0., 0.}, {1e-9, 0., 0.}, {0., 1e-9, 0.}, {1., 1., 0.}}, {0, 1, 2, 1, 3, 2}});
  const Base_refinement fine = refined(surface, surface.at(0), 1e-10, 1e-10, 8);
  for(const double length : fine.refinement.triangles->length)
    EXPECT_GT(length, 4. * min_edge_length * (1. - 1e-6)); // rounding of coordinates
}

} // namespace base_refinement_test
