// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/topology_repair.h"

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace topology_repair_test {

using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// A surface with samples at vertices.
struct Sampled_surface
{
  Sampled_surface(const Triangulation& triangulation, const std::vector<Index>& samples)
      : arrays(triangulation), surface(arrays.triangles(), {}),
        sampling(arrays.triangles(), Front(arrays.triangles(), Front_kind::euclidean),
                 Sample_location::triangle)
  {
    std::vector<Surface_location> locations;
    for(const Index i : samples)
      locations.push_back(arrays.at(i));
    sampling.add(locations);
  }

  Array_surface arrays;
  Refined_surface surface;
  Sampling sampling;
};

TEST(Topology_repair, cells_of_samples_partition_the_vertices)
{
  const Sampled_surface s(icosphere(3), {0, 5, 11});
  const Cells cells = connected_cells(s.arrays.t(), s.sampling);
  EXPECT_EQ(cells.samples, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(cells.labels, s.sampling.labels());
}

TEST(Topology_repair, farthest_vertices_are_no_samples)
{
  const Sampled_surface s(tetrahedron(), {0, 1, 2});
  const Cells cells = connected_cells(s.arrays.t(), s.sampling);
  // The fourth vertex belongs to one of the cells; the other cells consist of their samples.
  int number_of_vertices = 0;
  for(const Index vertex : farthest_vertices(cells, s.sampling))
    if(vertex != none)
    {
      ++number_of_vertices;
      EXPECT_EQ(vertex, s.arrays.vertex(3));
    }
  EXPECT_EQ(number_of_vertices, 1);
}

TEST(Topology_repair, one_cell_of_a_closed_surface_is_invalid)
{
  Sampled_surface s(icosphere(2), {0});
  const Cells cells = connected_cells(s.arrays.t(), s.sampling);
  const Topology_check check = check_topology(s.surface, s.sampling, cells);
  EXPECT_FALSE(check.is_valid());
  const Topology_repair repair = repair_topology(s.surface, s.sampling, cells, check);
  ASSERT_EQ(repair.samples.size(), 1u);
  EXPECT_TRUE(repair.unresolved.empty());
  // The new sample is the farthest vertex.
  EXPECT_EQ(s.sampling.distances()[repair.samples[0].vertex], s.sampling.covering_radius());
}

TEST(Topology_repair, additional_samples_are_new_vertices_of_the_repaired_cells)
{
  Sampled_surface s(icosphere(2), {0});
  const Cells cells = connected_cells(s.arrays.t(), s.sampling);
  const Topology_check check = check_topology(s.surface, s.sampling, cells);
  const Index first = repair_topology(s.surface, s.sampling, cells, check).samples.at(0).vertex;
  const std::size_t number_of_others = cells.labels.size() - 2;
  for(const std::size_t number : {std::size_t(1), std::size_t(7), 10 * number_of_others})
  {
    const Topology_repair repair = repair_topology(s.surface, s.sampling, cells, check, number);
    std::set<Index> vertices;
    for(const Surface_location& sample : repair.samples)
    {
      EXPECT_GT(s.sampling.distances()[sample.vertex], 0.);
      vertices.insert(sample.vertex);
    }
    EXPECT_EQ(repair.samples[0].vertex, first);
    EXPECT_EQ(vertices.size(), repair.samples.size());
    // Equal steps are rounded up, so that more than half of the number is found.
    EXPECT_GT(2 * (vertices.size() - 1), std::min(number, number_of_others));
    EXPECT_LE(vertices.size() - 1, std::min(number, number_of_others));
  }
}

TEST(Topology_repair, repair_ends_with_a_valid_dual)
{
  for(const Triangulation& triangulation :
      {icosphere(3), torus(24, 12), cylinder(16, 20, 1., 1.), square(10)})
  {
    Sampled_surface s(triangulation, {0});
    bool is_valid = false;
    for(int round = 0; round < 100 && !is_valid; ++round)
    {
      const Cells cells = connected_cells(s.arrays.t(), s.sampling);
      const Topology_check check = check_topology(s.surface, s.sampling, cells);
      is_valid = check.is_valid();
      const Topology_repair repair = repair_topology(s.surface, s.sampling, cells, check);
      EXPECT_EQ(repair.samples.empty(), is_valid);
      s.sampling.add(repair.samples);
    }
    EXPECT_TRUE(is_valid);
  }
}

TEST(Topology_repair, cells_of_samples_off_the_boundary_must_not_touch_it)
{
  Sampled_surface s(square(10), {60}); // the center of 11 x 11 vertices
  const Cells cells = connected_cells(s.arrays.t(), s.sampling);
  EXPECT_EQ(check_topology(s.surface, s.sampling, cells).off_feature_cells,
            (std::vector<Index>{0}));
}

TEST(Topology_repair, cells_without_further_vertices_are_unresolved)
{
  const Sampled_surface s(tetrahedron(), {0, 1, 2, 3});
  const Cells cells = connected_cells(s.arrays.t(), s.sampling);
  Topology_check check = check_topology(s.surface, s.sampling, cells);
  EXPECT_TRUE(check.is_valid());
  check.off_feature_cells.clear();
  check.dual.non_disks = {2};
  const Topology_repair repair = repair_topology(s.surface, s.sampling, cells, check);
  EXPECT_TRUE(repair.samples.empty());
  EXPECT_EQ(repair.unresolved, (std::vector<Index>{2}));
}

} // namespace topology_repair_test
