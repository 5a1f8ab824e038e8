// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/orient_triangles.h"

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <gtest/gtest.h>

#include <random>
#include <utility>

namespace orient_triangles_test {

using CGAL::Geodesic_processing::Soup_report;
using namespace CGAL::Geodesic_processing::internal;

TEST(Orient_triangles, flips_minority)
{
  std::vector<Index> corners = {0, 2, 1, 0, 3, 1, 1, 2, 3, 2, 0, 3};
  // Halfedges of the same edge, found by hand: 0-2, 2-1, 1-0, 0-3, 3-1 and 2-3.
  const std::vector<Index> opposites = {9, 6, 5, 10, 8, 2, 1, 11, 4, 0, 3, 7};
  Soup_report report;
  const std::vector<Index> twins = orient_triangles(corners, opposites, report);
  EXPECT_EQ(report.number_of_reversed_triangles, 1u);
  EXPECT_EQ(report.number_of_split_edges, 0u);
  EXPECT_EQ(report.number_of_components, 1u);
  EXPECT_EQ(corners, (std::vector<Index>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
  EXPECT_EQ(twins, twins_of_soup(4, corners));
}

TEST(Orient_triangles, splits_nonorientable_component)
{
  // A Moebius strip of n quadrilaterals. The ends are joined with opposite orientations.
  const Index n = 12;
  std::vector<Index> corners;
  for(Index i = 0; i < n; ++i)
  {
    const Index a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    corners.insert(corners.end(), {a, c, b, b, c, d});
  }
  std::vector<Index> opposites(corners.size(), none);
  for(Index g = 0; g < corners.size(); ++g)
    for(Index h = 0; h < g; ++h)
      if(std::minmax(corners[g], corners[next_halfedge(g)]) ==
         std::minmax(corners[h], corners[next_halfedge(h)]))
      {
        opposites[g] = h;
        opposites[h] = g;
      }
  Soup_report report;
  const std::vector<Index> twins = orient_triangles(corners, opposites, report);
  EXPECT_EQ(report.number_of_split_edges, 1u); // the shortest cut across the band is one edge
  EXPECT_EQ(report.number_of_components, 1u);
  measure_topology(count_fans(2 * n, corners, twins, report), twins, report);
  EXPECT_EQ(report.number_of_boundary_cycles, 1u); // that of a disk
  EXPECT_EQ(report.genus, 0u);
}

TEST(Measure_topology, of_two_tetrahedra_at_a_vertex)
{
  const std::vector<Index> corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3,
                                      0, 5, 4, 0, 4, 6, 4, 5, 6, 5, 0, 6};
  const std::vector<Index> twins = twins_of_soup(7, corners);
  Soup_report report;
  report.number_of_components = count_components(twins);
  EXPECT_EQ(report.number_of_components, 2u);
  measure_topology(count_fans(7, corners, twins, report), twins, report);
  EXPECT_EQ(report.number_of_nonmanifold_points, 1u);
  EXPECT_EQ(report.number_of_boundary_cycles, 0u);
  EXPECT_EQ(report.genus, 0u);
}

TEST(Measure_topology, of_torus)
{
  // A grid of 3 x 3 squares whose opposite sides are identified.
  std::vector<Index> corners;
  for(Index i = 0; i < 3; ++i)
    for(Index j = 0; j < 3; ++j)
    {
      const Index k = (i + 1) % 3, l = (j + 1) % 3;
      corners.insert(corners.end(), {3 * i + j, 3 * k + j, 3 * k + l});
      corners.insert(corners.end(), {3 * i + j, 3 * k + l, 3 * i + l});
    }
  const std::vector<Index> twins = twins_of_soup(9, corners);
  Soup_report report;
  report.number_of_components = count_components(twins);
  EXPECT_EQ(report.number_of_components, 1u);
  measure_topology(count_fans(9, corners, twins, report), twins, report);
  EXPECT_EQ(report.number_of_nonmanifold_points, 0u);
  EXPECT_EQ(report.number_of_boundary_cycles, 0u);
  EXPECT_EQ(report.genus, 1u);
}

} // namespace orient_triangles_test
