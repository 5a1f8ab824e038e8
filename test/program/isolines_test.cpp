// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command isolines.
#include "Program.h"

#include <cmath>
#include <string>
#include <vector>

namespace isolines_test {

using namespace program_test;

TEST_F(Program, isolines_of_corner_distance_are_quarter_circles)
{
  const nlohmann::json lines =
      json("isolines square.ply --source 0 --isovalues 0.25,0.5 --values d.txt -o lines.obj");
  EXPECT_EQ(lines["lines"], 2);
  EXPECT_EQ(lines["closed"], 0);
  // A segment in a triangle has at most the length c = sqrt(2) / 8. An inscribed polygon is shorter
  // than a circle of radius r by at most (c / r)^2 / 24, in the mean of both circles 1.1 %.
  const double length = 0.75 * std::acos(0.);
  EXPECT_LE(lines["length"].get<double>(), length);
  EXPECT_GE(lines["length"].get<double>(), 0.985 * length);
  EXPECT_EQ(numbers("d.txt").size(), 81u);
  EXPECT_NE(read_file(m_folder / "lines.obj").find("\nl "), std::string::npos);

  // Ten values by default. The largest distance is that of the opposite corner.
  EXPECT_EQ(json("isolines square.ply --source-at 0,0,0")["lines"], 10);
  // The radii 1/5, 2/5 and 3/5 of half of the diagonal are below one half.
  EXPECT_EQ(json("isolines square.ply --source 40 --number 4")["closed"], 3);
}

TEST_F(Program, isolines_of_boundary_distance_are_parallel)
{
  const nlohmann::json lines =
      json("isolines square.ply --source-border --isovalues 0.125 --method exact -o lines.vtp");
  EXPECT_EQ(lines["lines"], 1);
  EXPECT_EQ(lines["closed"], 1);
  EXPECT_NEAR(lines["length"].get<double>(), 3., round_off);
  EXPECT_EQ(json("info lines.vtp")["kind"], "cloud");
}

TEST_F(Program, isolines_of_properties_are_computed)
{
  write("height.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
        "property double z\nproperty double height\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0\n1 0 0 4\n0 1 0 0\n3 0 1 2\n");
  const nlohmann::json lines = json("isolines height.ply --property height --number 3");
  EXPECT_EQ(lines["lines"], 3);
  EXPECT_NEAR(lines["length"].get<double>(), 0.75 + 0.5 + 0.25, round_off);
  // A constant property has no isolines.
  EXPECT_EQ(json("isolines square.ply --property double_speed")["lines"], 0);
}

TEST_F(Program, isolines_rejects_invalid_options)
{
  expect_failure("isolines square.ply", 1, "--property");
  expect_failure("isolines square.ply --source 0 --property double_speed", 1, "--property");
  expect_failure("isolines square.ply --source 0 --isovalues 1,x", 1, "--isovalues");
  expect_failure("isolines square.ply --source 0 --isovalues 1,inf", 1, "--isovalues");
  expect_failure("isolines square.ply --source 81", 2, "81");
  expect_failure("isolines square.ply --source 0 --method nothing", 1, "nothing");
  expect_failure("isolines square.ply --source 0 -o a.off", 1, "a.off");
  expect_failure("isolines square.ply --property wind", 2, "only double_speed");
  expect_failure("isolines closed.off --source-border", 2, "no boundary");
  expect_failure("isolines cloud.xyz --source 0", 2, "triangles of a cloud overlap");
}

} // namespace isolines_test
