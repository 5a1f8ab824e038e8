// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command isolines.
#include "Program.h"

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <regex>
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
  json("isolines square.ply --source 0 --isovalues 0.25,0.5 -o lines.ply");
  EXPECT_NE(read_file(m_folder / "lines.ply").find("\nelement edge "), std::string::npos);

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

// Returns the area of the faces with each value of their only property, of a binary PLY file whose
// vertices have coordinates only.
std::map<std::uint32_t, double> areas_of_ply(const std::string& bytes)
{
  const auto count = [&](const std::string& element)
  { return std::stoul(bytes.substr(bytes.find("element " + element) + 9 + element.size())); };
  const char* next = bytes.data() + bytes.find("end_header\n") + 11;
  std::vector<std::array<double, 3>> points(count("vertex"));
  std::memcpy(points.data(), next, 24 * points.size());
  next += 24 * points.size();
  std::map<std::uint32_t, double> result;
  for(std::size_t f = 0; f < count("face"); ++f)
  {
    std::array<std::uint32_t, 4> face; // three corners and the property
    std::memcpy(face.data(), next + 1, sizeof face);
    next += 1 + sizeof face;
    const auto &p = points[face[0]], &q = points[face[1]], &r = points[face[2]];
    result[face[3]] += 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  EXPECT_EQ(next, bytes.data() + bytes.size());
  return result;
}

TEST_F(Program, isolines_divide_a_mesh)
{
  const nlohmann::json result =
      json("isolines square.ply --source-border --isovalues 0.15,0.3 --method exact --divided "
           "-o divided.ply");
  EXPECT_EQ(result["lines"], 2);
  EXPECT_EQ(result["closed"], 2);
  const nlohmann::json info = json("info divided.ply");
  EXPECT_EQ(info["vertices"], result["vertices_out"]);
  EXPECT_EQ(info["faces"], result["faces_out"]);
  EXPECT_EQ(info["boundary_loops"], 1);
  EXPECT_NEAR(info["area"].get<double>(), 1., round_off);

  // Diagonals end at the corners of the square, so that the isolines are squares.
  std::map<std::uint32_t, double> areas = areas_of_ply(read_file(m_folder / "divided.ply"));
  ASSERT_EQ(areas.size(), 3u);
  EXPECT_NEAR(areas[1] + areas[2], 0.49, round_off);
  EXPECT_NEAR(areas[2], 0.16, round_off);
  EXPECT_NEAR(areas[0] + areas[1] + areas[2], 1., round_off);

  // Faces without value have the largest number.
  json("isolines apart.off --source 0 --isovalues 0.5 --divided -o apart.ply");
  areas = areas_of_ply(read_file(m_folder / "apart.ply"));
  EXPECT_NEAR(areas[0xffffffff], 0.5, round_off);
  EXPECT_NEAR(areas[0] + areas[1], 0.5, round_off);
}

TEST_F(Program, isolines_are_drawn_in_the_plane)
{
  json("isolines square.ply --source-border --isovalues 0.125,0.25 --method exact -o lines.svg");
  const std::string svg = read_file(m_folder / "lines.svg");
  // The data of the paths: the boundary and two closed lines
  const std::regex path("<path[^>]* d=\"M([^\"]*) Z\"/>"), number("-?[0-9.]+(e-?[0-9]+)?");
  std::vector<double> lengths;
  for(std::sregex_iterator i(svg.begin(), svg.end(), path), end; i != end; ++i)
  {
    const std::string data = (*i)[1];
    std::vector<double> x;
    for(std::sregex_iterator k(data.begin(), data.end(), number); k != end; ++k)
      x.push_back(std::stod(k->str()));
    const std::size_t n = x.size();
    lengths.push_back(0.);
    for(std::size_t k = 0; k < n; k += 2)
      lengths.back() += std::hypot(x[(k + 2) % n] - x[k], x[(k + 3) % n] - x[k + 1]);
  }
  ASSERT_EQ(lengths.size(), 3u);
  // A plane is flattened without distortion. Errors of the minimization are measured as 2e-14.
  EXPECT_NEAR(lengths[0], 4., 1e-12);
  EXPECT_NEAR(lengths[1], 3., 1e-12);
  EXPECT_NEAR(lengths[2], 2., 1e-12);
  EXPECT_NE(svg.find("data-value=\"0.125\""), std::string::npos);
  EXPECT_NE(svg.find("viewBox"), std::string::npos);
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
  expect_failure("isolines square.ply --source 0 --divided -o a.svg", 1, "a.svg");
  expect_failure("isolines closed.off --source 0 -o a.svg", 2, "not a disk");
  expect_failure("isolines apart.off --source 0 -o a.svg", 2, "not a disk");
  expect_failure("isolines square.ply --property wind", 2, "only double_speed");
  expect_failure("isolines closed.off --source-border", 2, "no boundary");
  expect_failure("isolines cloud.xyz --source 0", 2, "triangles of a cloud overlap");
}

} // namespace isolines_test
