// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/oriented_rings.h"

#include "triangulations.h"

#include <gtest/gtest.h>

namespace oriented_rings_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The corners need not be sorted.
TEST(Build_oriented_rings, has_twins_of_soup_and_rings_of_mesh)
{
  const Triangulation bowtie = {
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {-1., 0., 0.}, {0., -1., 0.}}, {0, 1, 2, 0, 3, 4}};
  for(const Triangulation& surface :
      {bowtie, one_triangle(), square(6), icosphere(3), Triangulation()})
  {
    const std::size_t n = surface.points.size();
    Surface_arrays expected;
    expected.corner = surface.corners;
    expected.twin = twins_of_soup(n, surface.corners);
    build_rings(expected, n);
    for(const unsigned number_of_threads : {1u, 2u, 5u})
    {
      Surface_arrays arrays;
      arrays.corner = surface.corners;
      const auto counts = build_oriented_rings(arrays, n, number_of_threads);
      ASSERT_TRUE(counts.has_value());
      EXPECT_EQ(arrays.twin, expected.twin);
      EXPECT_EQ(arrays.ring_begin, expected.ring_begin);
      EXPECT_EQ(arrays.ring, expected.ring);
      // Only the bowtie has a vertex with two fans.
      const bool is_bowtie = surface.corners == bowtie.corners;
      EXPECT_EQ(counts->number_of_fans, n + (is_bowtie ? 1 : 0));
      EXPECT_EQ(counts->number_of_nonmanifold_vertices, is_bowtie ? 1u : 0u);
    }
  }
}

TEST(Build_oriented_rings, refuses_edge_of_three_triangles_and_opposite_orientations)
{
  Surface_arrays arrays;
  arrays.corner = {0, 1, 2, 1, 0, 3, 0, 1, 4};
  EXPECT_FALSE(build_oriented_rings(arrays, 5, 1).has_value());
  arrays.corner = {0, 1, 2, 0, 1, 3};
  EXPECT_FALSE(build_oriented_rings(arrays, 4, 1).has_value());
}

} // namespace oriented_rings_test
