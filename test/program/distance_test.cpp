// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command distance and the speeds that it shares with other commands.
#include "Program.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace distance_test {

using namespace program_test;

TEST_F(Program, distance_on_a_square_is_euclidean)
{
  for(const char* const method : {"euclidean", "exact", "fast-marching", "dijkstra", "heat"})
  {
    const nlohmann::json result =
        json(std::string("distance square.ply --source 0 --values d.txt --method ") + method);
    const std::vector<double> values = numbers("d.txt");
    ASSERT_EQ(values.size(), 81u);
    EXPECT_EQ(values[0], 0.);
    EXPECT_EQ(result["unreached"], 0);
    EXPECT_EQ(result["max"].get<double>(), *std::max_element(values.begin(), values.end()));
    // The default is exact on flat surfaces. The errors of other methods are documented on their
    // pages. Dijkstra errs by 8 % between eight directions.
    const double tolerance = std::string(method)[0] == 'e' ? 1e-12 : 0.12;
    for(int i = 0; i < 81; ++i)
    {
      const double straight = std::hypot(i % 9 / 8., i / 9 / 8.);
      EXPECT_NEAR(values[static_cast<std::size_t>(i)], straight, tolerance) << method << ' ' << i;
    }
  }
}

TEST_F(Program, distance_accepts_all_source_kinds)
{
  json("distance square.ply --source-at 0.5,0.5,7 --values d.txt");
  EXPECT_NEAR(numbers("d.txt")[0], std::sqrt(0.5), round_off);
  json("distance square.ply --source-border --values d.txt");
  EXPECT_NEAR(numbers("d.txt")[40], 0.5, round_off);
  EXPECT_EQ(numbers("d.txt")[8], 0.);
  json("distance square.ply --source 0,80 --source-at 1,0,0 --values d.txt");
  const std::vector<double> values = numbers("d.txt");
  EXPECT_EQ(values[0] + values[80], 0.);
  EXPECT_NEAR(values[8], 0., round_off);
  EXPECT_NEAR(values[72], 1., round_off);
}

TEST_F(Program, distance_limit_leaves_vertices_unreached)
{
  const nlohmann::json result = json("distance square.ply --source 0 --limit 0.5 --values d.txt");
  const std::vector<double> values = numbers("d.txt");
  const auto unreached = std::count(values.begin(), values.end(), INFINITY);
  EXPECT_EQ(result["unreached"], unreached);
  EXPECT_LE(result["max"].get<double>(), 0.5);
  for(int i = 0; i < 81; ++i)
    EXPECT_EQ(std::isinf(values[static_cast<std::size_t>(i)]),
              std::hypot(i % 9 / 8., i / 9 / 8.) > 0.5 + 1e-12)
        << i;
}

TEST_F(Program, relative_tolerance_bounds_errors)
{
  std::ostringstream hills;
  hills << "OFF\n400 722 0\n";
  for(int i = 0; i < 400; ++i)
    hills << i % 20 << ' ' << i / 20 << ' ' << std::sin(0.7 * (i % 20)) * std::cos(0.5 * (i / 20))
          << '\n';
  for(int i = 0; i < 380; ++i)
    if(i % 20 < 19)
      hills << "3 " << i << ' ' << i + 1 << ' ' << i + 21 << "\n3 " << i << ' ' << i + 21 << ' '
            << i + 20 << '\n';
  write("hills.off", hills.str());
  json("distance hills.off --source 0 --values exact.txt");
  json("distance hills.off --source 0 --relative-tolerance 0.01 --values approximate.txt");
  const std::vector<double> exact = numbers("exact.txt"), approximate = numbers("approximate.txt");
  ASSERT_EQ(exact.size(), approximate.size());
  EXPECT_NE(exact, approximate);
  // The value is the mean of two bounds.
  for(std::size_t i = 0; i < exact.size(); ++i)
    EXPECT_NEAR(approximate[i], exact[i], 0.01 * exact[i]) << i;
}

TEST_F(Program, doubling_speed_halves_distance)
{
  for(const char* const method : {"euclidean", "fast-marching"})
  {
    const std::string command = std::string("distance square.ply --source 0 --method ") + method;
    json(command + " --values s.txt --speed double_speed");
    json(command + " --values d.txt");
    const std::vector<double> fast = numbers("s.txt"), plain = numbers("d.txt");
    for(std::size_t i = 0; i < 81; ++i)
      EXPECT_NEAR(2. * fast[i], plain[i], round_off) << method;
  }
}

TEST_F(Program, speed_depends_on_curvature)
{
  // A flat square has no curvature, so that speeds are equal and distances are exact.
  for(const char* const speed : {"curvature-attractive", "curvature-repulsive"})
  {
    json(std::string("distance square.ply --source 0 --values s.txt --strength 3 --speed ") +
         speed);
    json("distance square.ply --source 0 --values d.txt");
    const std::vector<double> bent = numbers("s.txt"), plain = numbers("d.txt");
    for(std::size_t i = 0; i < 81; ++i)
      EXPECT_NEAR(bent[i], plain[i], 1e-12); // round-off errors
  }
  // A square pipe with 12 by 24 vertices. Speeds are low, or high, on its sharp edges.
  std::ostringstream pipe;
  pipe << "OFF\n288 552 0\n";
  for(int j = 0; j < 24; ++j)
    for(int i = 0; i < 12; ++i)
    {
      const int side = i / 3;
      const double step = (i % 3 * 2 - 3) / 3.; // -1 at a corner
      const double x[] = {step, 1., -step, -1.}, y[] = {-1., step, 1., -step};
      pipe << x[side] << ' ' << y[side] << ' ' << j << '\n';
    }
  for(int j = 0; j < 23; ++j)
    for(int i = 0; i < 12; ++i)
    {
      const int a = 12 * j + i, b = 12 * j + (i + 1) % 12, c = b + 12, d = a + 12;
      pipe << "3 " << a << ' ' << b << ' ' << c << "\n3 " << a << ' ' << c << ' ' << d << '\n';
    }
  write("pipe.off", pipe.str());
  const auto along_edge = [&](const std::string& speed)
  {
    json("distance pipe.off --source 0 --values d.txt" + speed);
    return numbers("d.txt")[12 * 23];
  };
  const double plain = along_edge("");
  EXPECT_GT(along_edge(" --speed curvature-attractive"), 1.2 * plain);
  EXPECT_LT(along_edge(" --speed curvature-repulsive"), plain / 1.2);
  EXPECT_GT(along_edge(" --speed curvature-attractive --strength 1"),
            along_edge(" --speed curvature-attractive"));

  // Along the center line of a side. Its curvature equals that at vertex 145 except near the ends.
  // Vertex 144 lies on a sharp edge, whose curvature differs.
  const auto along_side = [&](const std::string& vertex)
  {
    json("distance pipe.off --source 1 --values d.txt --strength 1 --speed curvature-like-" +
         vertex);
    return numbers("d.txt")[12 * 23 + 1];
  };
  EXPECT_NEAR(along_side("145"), 23., 23. / 12.); // two of 24 rows
  EXPECT_GT(along_side("144"), 1.3 * 23.);
  expect_failure("distance pipe.off --source 0 --speed curvature-like-1,2", 1, "one vertex");
  expect_failure("distance pipe.off --source 0 --speed curvature-like-x", 1, "x");
  expect_failure("distance pipe.off --source 0 --speed curvature-like-288", 2, "288");

  for(const char* const command : {"sample pipe.off --number 12", "sample cloud.xyz --number 5",
                                   "voronoi cloud.xyz --number 4", "voronoi pipe.off --number 4",
                                   "remesh pipe.off --number 30", "remesh cloud.xyz --number 20"})
    for(const char* const speed : {"curvature-attractive", "curvature-repulsive"})
      json(std::string(command) + " --speed " + speed);
}

TEST_F(Program, speed_depends_on_colors_and_images)
{
  // Red grows linearly along x, so the speed is the same everywhere.
  std::string square = read_file(m_folder / "square.ply");
  const std::string one = "property float double_speed\n";
  square.replace(square.find(one), one.size(),
                 "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  std::size_t line = square.find("end_header\n") + 11;
  for(int i = 0; i < 81; ++i)
  {
    const std::size_t end = square.find('\n', line);
    const std::string color = std::to_string(30 * (i % 9)) + " 1 2";
    square.replace(end - 1, 1, color);
    line = end + color.size();
  }
  write("red.ply", square);
  json("distance square.ply --source 0 --values d.txt");
  const std::vector<double> plain = numbers("d.txt");
  for(const auto& [speed, factor] :
      {std::pair("colors --strength 1", 2.), std::pair("colours", 21.)})
  {
    json(std::string("distance red.ply --source 0 --values s.txt --speed ") + speed);
    const std::vector<double> slow = numbers("s.txt");
    for(std::size_t i = 0; i < 81; ++i)
      EXPECT_NEAR(slow[i], factor * plain[i], 1e-11); // round-off errors
  }

  const Run_result refused = run("sample square.ply --number 9 --density-image nowhere.png");
  if(refused.code == 1) // built without libpng
  {
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "libpng", refused.err);
    return;
  }
  expect_failure("sample square.ply --number 9 --density-image nowhere.png", 2, "no such file");
  expect_failure("sample square.ply --number 9 --density-image square.ply", 2, ".png");
  write("wrong.png", "\x89PNG\r\n\x1a\n no more");
  expect_failure("sample square.ply --number 9 --density-image wrong.png", 2, "wrong.png");
  // Black on the left half and white on the right half.
  std::string rows;
  for(int y = 0; y < 16; ++y)
    rows += '\0' + std::string(8, '\0') + std::string(8, '\xff');
  write("half.png", png(16, rows));
  json("distance square.ply --source 0 --values s.txt --density-image half.png");
  const std::vector<double> slow = numbers("s.txt");
  // Along the lower boundary: unchanged up to the center, then a step that takes longer.
  EXPECT_NEAR(slow[2], 0.25, 1e-12);
  EXPECT_GT(slow[8], 3.);
  // The texture coordinates map the whole surface to black pixels.
  std::string lines = "vt 0.1 0.1\n";
  std::istringstream obj((json("info square.ply -o plain.obj"), read_file(m_folder / "plain.obj")));
  for(std::string word; std::getline(obj, word); lines += word + '\n')
    if(word[0] == 'f')
    {
      std::istringstream corners(word.substr(1));
      word = "f";
      for(std::string corner; corners >> corner;)
        word += ' ' + corner + "/1";
    }
  write("black.obj", lines);
  json("distance black.obj --source 0 --values s.txt --density-image half.png");
  const std::vector<double> black = numbers("s.txt");
  for(std::size_t i = 0; i < 81; ++i)
    EXPECT_NEAR(black[i], plain[i], 1e-12); // round-off errors
}

TEST_F(Program, other_components_and_isolated_vertices_are_unreached)
{
  const nlohmann::json result = json("distance apart.off --source 0 --values d.txt");
  EXPECT_EQ(result["unreached"], 4);
  EXPECT_EQ(numbers("d.txt"),
            (std::vector<double>{0, 1, 1, INFINITY, INFINITY, INFINITY, INFINITY}));
  EXPECT_EQ(json("distance apart.off --source 6")["unreached"], 6);
}

TEST_F(Program, output_contains_distances)
{
  json("distance square.ply --source 0 -o d.ply --values d.txt");
  json("distance square.ply --source 0 -o d.vtp");
  // Reads the result back with --speed, which accepts any property. Speed zero at the source is
  // allowed.
  for(const char* const name : {"d.ply", "d.vtp"})
    EXPECT_EQ(run(std::string("distance ") + name + " --source 80 --speed distance").code, 0);
  EXPECT_EQ(run("distance square.ply --source 0 -o d.obj").code, 0);
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "vt 0 0.5", read_file(m_folder / "d.obj"));
  EXPECT_EQ(run("distance square.ply --source 0 -o d.off").code, 0);
  EXPECT_EQ(read_file(m_folder / "d.off").substr(0, 4), "COFF");
}

} // namespace distance_test
