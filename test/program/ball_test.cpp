// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command ball.
#include "Program.h"

#include <cmath>
#include <string>

namespace ball_program_test {

using namespace program_test;

TEST_F(Program, ball_in_plane_is_a_disk)
{
  const double pi = 2. * std::acos(0.);
  const nlohmann::json ball =
      json("ball square.ply --source 40 --radius 0.25 --values c.txt -o circle.obj");
  // Round-off errors.
  EXPECT_NEAR(ball["area"].get<double>(), pi / 16., 1e-12);
  EXPECT_EQ(ball["circles"], 1);
  EXPECT_LT(ball["length"].get<double>(), pi / 2.);
  EXPECT_GT(ball["faces_inside"], 0);
  EXPECT_FALSE(numbers("c.txt").empty());
  EXPECT_NE(read_file(m_folder / "circle.obj").find("\nl "), std::string::npos);
  // The boundary cuts the ball around a corner.
  EXPECT_NEAR(json("ball square.ply --source-at 0,0,0 --radius 0.5")["area"].get<double>(),
              pi / 16., 1e-12);
}

TEST_F(Program, ball_rejects_invalid_options)
{
  expect_failure("ball square.ply --radius 1", 1, "--source");
  expect_failure("ball square.ply --source 0", 1, "--radius");
  expect_failure("ball square.ply --source 0 --radius -1", 1, "--radius");
  expect_failure("ball square.ply --source x --radius 1", 1, "--source");
  expect_failure("ball square.ply --source 81 --radius 1", 2, "81");
  expect_failure("ball square.ply --source 0 --radius 1 -o a.off", 1, "a.off");
  expect_failure("ball cloud.xyz --source 0 --radius 1", 2, "triangles of a cloud overlap");
}

} // namespace ball_program_test
