// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands info and surfels.
#include "Program.h"

#include <cmath>
#include <fstream>
#include <string>

namespace info_test {

using namespace program_test;

TEST_F(Program, surfels_reports_radii_and_graph)
{
  const nlohmann::json lattice = json("surfels cloud.xyz --values r.txt -o s.ply");
  // Inside a lattice, the eighth neighbor is a diagonal away. The file has six digits.
  EXPECT_NEAR(lattice["radius"].get<double>(), 1. / 11., 1e-6);
  EXPECT_EQ(numbers("r.txt").size(), 144u);
  EXPECT_EQ(lattice["components"], 1);
  EXPECT_EQ(lattice["noise"], 0.);
  EXPECT_EQ(run("surfels s.ply --quiet").code, 0);
  EXPECT_EQ(json("surfels s.ply")["radius"], lattice["radius"]);
  // Spheres of influence of lattice points intersect along edges and diagonals of the lattice. At
  // a distance of two edges they touch, or fail to touch by round-off errors.
  const int number_of_sides = 2 * 11 * 12, number_of_diagonals = 2 * 11 * 11,
            number_of_double_sides = 2 * 10 * 12;
  const int number_of_edges = json("surfels cloud.xyz --surfel-graph spheres")["arcs"];
  EXPECT_GE(number_of_edges, number_of_sides + number_of_diagonals);
  EXPECT_LE(number_of_edges, number_of_sides + number_of_diagonals + number_of_double_sides);
  EXPECT_EQ(json("surfels cloud.xyz --arcs -o a.ply")["arcs"], lattice["arcs"]);

  write("far.xyz", read_file(m_folder / "cloud.xyz") + "50 50 50 0 0 1\n");
  const nlohmann::json far = json("surfels far.xyz --outliers 0.6 -o near.xyz.ply --values n.txt");
  EXPECT_GE(far["outliers"].get<int>(), 1);
  EXPECT_EQ(numbers("n.txt").size(), 145u - far["outliers"].get<std::size_t>());
  EXPECT_LT(json("info near.xyz.ply")["bounding_box"][1][0].get<double>(), 2.);
  expect_failure("surfels far.xyz --outliers 101", 1, "--outliers");
  expect_failure("surfels far.xyz --surfel-graph none", 1, "extended-spheres");
}

TEST_F(Program, info_reports_topology_and_area)
{
  const nlohmann::json square = json("info square.ply");
  EXPECT_EQ(square["boundary_loops"], 1);
  EXPECT_EQ(square["genus"], 0);
  EXPECT_EQ(square["components"], 1);
  EXPECT_EQ(square["manifold"], true);
  EXPECT_EQ(square["repaired"], false);
  EXPECT_NEAR(square["area"].get<double>(), 1., 1e-14);                  // 128 round-off errors
  EXPECT_NEAR(square["min_angle"].get<double>(), 45., 100. * round_off); // in degrees
  EXPECT_NEAR(square["max_angle"].get<double>(), 90., 100. * round_off);
  EXPECT_EQ(square["bounding_box"], nlohmann::json::parse("[[0,0,0],[1,1,0]]"));
  EXPECT_DOUBLE_EQ(square["diagonal"].get<double>(), std::sqrt(2.));
  EXPECT_EQ(json("info apart.off")["components"], 2);
  EXPECT_EQ(json("info pinched.off")["manifold"], false);
}

TEST_F(Program, info_counts_cloud_components)
{
  EXPECT_EQ(json("info cloud.xyz")["components"], 1);
  std::string two = read_file(m_folder / "cloud.xyz");
  for(int i = 0; i < 100; ++i) // a separate sheet far above
    two += std::to_string(i % 10 / 10.) + ' ' + std::to_string(i / 10 / 10.) + " 9 0 0 1\n";
  std::ofstream(m_folder / "two.xyz") << two;
  EXPECT_EQ(json("info two.xyz")["components"], 2);
}

TEST_F(Program, info_converts_formats)
{
  for(const char* const name : {"a.ply", "a.off", "a.obj", "a.vtp"})
  {
    EXPECT_EQ(run(std::string("info square.ply -o ") + name).code, 0);
    const nlohmann::json again = json(std::string("info ") + name);
    EXPECT_EQ(again["vertices"], 81);
    EXPECT_EQ(again["faces"], 128);
    EXPECT_EQ(again["repaired"], false);
  }
}

} // namespace info_test
