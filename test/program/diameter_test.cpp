// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command diameter.
#include "Program.h"

#include <cmath>
#include <string>

namespace diameter_program_test {

using namespace program_test;

TEST_F(Program, diameter_of_square_is_the_diagonal)
{
  const nlohmann::json exact =
      json("diameter square.ply --tolerance 0 --radius --values p.txt -o path.vtp");
  // Round-off errors of exact distances.
  EXPECT_NEAR(exact["lower"].get<double>(), std::sqrt(2.), 1e-11);
  EXPECT_NEAR(exact["upper"].get<double>(), std::sqrt(2.), 1e-11);
  EXPECT_NEAR(exact["radius_lower"].get<double>(), std::sqrt(0.5), 1e-11);
  EXPECT_NEAR(exact["radius_upper"].get<double>(), std::sqrt(0.5), 1e-11);
  EXPECT_EQ(exact["center"], 40);
  EXPECT_EQ(exact["converged"], true);
  EXPECT_FALSE(numbers("p.txt").empty());

  const nlohmann::json few = json("diameter square.ply --tolerance 0 --iterations 1");
  EXPECT_EQ(few["iterations"], 1);
  EXPECT_EQ(few["converged"], false);
  EXPECT_GE(few["upper"].get<double>(), std::sqrt(2.) - 1e-11);
  EXPECT_LE(few["lower"].get<double>(), std::sqrt(2.) + 1e-11);
}

TEST_F(Program, diameter_rejects_invalid_options)
{
  expect_failure("diameter square.ply --tolerance -1", 1, "--tolerance");
  expect_failure("diameter square.ply --iterations 0", 1, "--iterations");
  expect_failure("diameter square.ply -o a.off", 1, "a.off");
  expect_failure("diameter cloud.xyz", 2, "need a mesh");
}

} // namespace diameter_program_test
