// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command curve.
#include "Program.h"

#include <cmath>
#include <string>

namespace curve_program_test {

using namespace program_test;

TEST_F(Program, curve_in_plane_is_a_parabola)
{
  const nlohmann::json curve =
      json("curve square.ply --points 0,8,80 --subdivisions 8 --values p.txt -o curve.obj");
  // The points are (2 t - t^2, t^2). The length of this parabola is 1 + asinh(1) / sqrt(2), that of
  // a polyline with 2^8 segments is shorter by at most 4^-8.
  const double length = 1. + std::asinh(1.) / std::sqrt(2.);
  EXPECT_LE(curve["length"].get<double>(), length);
  EXPECT_GE(curve["length"].get<double>(), length - std::pow(4., -8.));
  EXPECT_GE(curve["points"], 257);
  EXPECT_NE(read_file(m_folder / "curve.obj").find("\nl "), std::string::npos);
}

TEST_F(Program, curve_can_be_a_spline)
{
  // A spline of degree one is its control polygon.
  EXPECT_NEAR(json("curve square.ply --points 0,8,80 --spline --degree 1")["length"].get<double>(),
              2., 1e-11);
  EXPECT_NEAR(json("curve square.ply --points 0,8 --point-at 1,1,0 --spline --degree 1 "
                   "--closed")["length"]
                  .get<double>(),
              2. + std::sqrt(2.), 1e-11);
}

TEST_F(Program, curve_rejects_invalid_options)
{
  expect_failure("curve square.ply", 1, "--points");
  expect_failure("curve square.ply --points 1", 1, "--points");
  expect_failure("curve square.ply --points 1,x", 1, "--points");
  expect_failure("curve square.ply --points 1,81", 2, "81");
  expect_failure("curve square.ply --points 1,2 --closed", 1, "--closed");
  expect_failure("curve square.ply --points 1,2 --spline --degree 0", 1, "--degree");
  expect_failure("curve square.ply --points 1,2 --subdivisions 21", 1, "--subdivisions");
  expect_failure("curve apart.off --points 0,3", 2, "not connected");
  expect_failure("curve apart.off --points 0,6", 2, "vertex 6 has no face");
  expect_failure("curve cloud.xyz --points 0,1", 2, "need a mesh");
}

} // namespace curve_program_test
