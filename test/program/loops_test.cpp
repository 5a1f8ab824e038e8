// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command loops.
#include "Program.h"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

namespace loops_test {

using namespace program_test;

// Writes a prism without base faces: `n` sides of length 1, `m` layers of height 1.
void write_tube(const std::filesystem::path& file, int n, int m)
{
  std::ofstream out(file);
  out.precision(17);
  const double pi = std::acos(-1.), radius = 0.5 / std::sin(pi / n);
  out << "OFF\n" << n * (m + 1) << ' ' << 2 * n * m << " 0\n";
  for(int j = 0; j <= m; ++j)
    for(int i = 0; i < n; ++i)
      out << radius * std::cos(2. * pi * i / n) << ' ' << radius * std::sin(2. * pi * i / n) << ' '
          << j << '\n';
  for(int j = 0; j < m; ++j)
    for(int i = 0; i < n; ++i)
    {
      const int a = n * j + i, b = n * j + (i + 1) % n;
      out << "3 " << a << ' ' << b << ' ' << a + n << "\n3 " << b << ' ' << b + n << ' ' << a + n
          << '\n';
    }
}

TEST_F(Program, loops_of_tube_have_its_circumference)
{
  write_tube(m_folder / "tube.off", 6, 3);
  const nlohmann::json basis = json("loops tube.off --values lengths.txt -o loops.obj");
  EXPECT_EQ(basis["loops"], 1);
  ASSERT_EQ(basis["lengths"].size(), 1u);
  EXPECT_NEAR(basis["length"].get<double>(), 6., round_off);
  EXPECT_EQ(numbers("lengths.txt").size(), 1u);
  EXPECT_NE(read_file(m_folder / "loops.obj").find("\nl "), std::string::npos);
  EXPECT_NEAR(json("loops tube.off --through 8")["length"].get<double>(), 6., round_off);
  EXPECT_NEAR(json("loops tube.off --through-at 1,0,1.3")["length"].get<double>(), 6., round_off);
  EXPECT_NEAR(json("loops tube.off --along 0,14,4")["length"].get<double>(), 6., round_off);
  EXPECT_GE(json("loops tube.off --edges")["length"].get<double>(), 6. - round_off);
  // A loop around one vertex shrinks to a point.
  EXPECT_EQ(json("loops tube.off --along 6,7,13")["length"], 0.);
}

TEST_F(Program, loops_do_not_exist_on_disk)
{
  EXPECT_EQ(json("loops square.ply")["loops"], 0);
  EXPECT_EQ(json("loops square.ply --through 40")["loops"], 0);
}

TEST_F(Program, loops_rejects_invalid_options)
{
  expect_failure("loops square.ply --through 0 --along 1,2", 1, "only one");
  expect_failure("loops square.ply --through 0,1", 1, "exactly one");
  expect_failure("loops square.ply --through 0 --edges", 1, "--edges");
  expect_failure("loops square.ply --through 81", 2, "81");
  expect_failure("loops square.ply --along 0,81", 2, "81");
  expect_failure("loops square.ply --through-at 1,2", 1, "--through-at");
  expect_failure("loops cloud.xyz", 2, "triangles of a cloud overlap");
}

TEST_F(Program, path_passes_through_vertices)
{
  // Along the boundary of the unit square with 8 x 8 cells.
  const nlohmann::json path = json("path square.ply --from 0 --to 80 --through 8 --values p.txt");
  EXPECT_NEAR(path["length"].get<double>(), 2., round_off);
  EXPECT_NEAR(
      json("path square.ply --from 0 --to 80 --through 8 --method exact")["length"].get<double>(),
      2., round_off);
  EXPECT_GT(json("path cloud.xyz --from 0 --to 143 --through 11")["length"].get<double>(),
            1.2 * json("path cloud.xyz --from 0 --to 143")["length"].get<double>());
  expect_failure("path square.ply --from 0 --to 80 --through 81", 2, "81");
  expect_failure("path square.ply --from 0 --to 80 --through x", 1, "--through");
}

} // namespace loops_test
