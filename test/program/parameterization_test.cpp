// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands flatten, atlas, logmap and decal.
#include "Program.h"
#include "io/Image.h"
#include "readers/Surface_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace parameterization_test {

using namespace program_test;

TEST_F(Program, flatten_preserves_a_planar_square)
{
  // Linear systems, and up to 50 iterations of the method arap; measured are 2e-12.
  constexpr double solver_tolerance = 1e-10;
  for(const std::string method : {"glle", "mds", "lscm", "arap", "glle --injective"})
  {
    const nlohmann::json flat =
        json("flatten square.ply --values f.txt -o f.obj --base-points 30 --method " + method);
    EXPECT_EQ(flat["flips"], 0) << method;
    EXPECT_NEAR(flat["symmetric_dirichlet"].get<double>(), 4., solver_tolerance) << method;
    const std::vector<double> uv = numbers("f.txt");
    ASSERT_EQ(uv.size(), 162u);
    if(method == "lscm")
      continue; // the scale of these maps is arbitrary
    // The distance between opposite corners.
    EXPECT_NEAR(std::hypot(uv[160] - uv[0], uv[161] - uv[1]), std::sqrt(2.), solver_tolerance)
        << method;
  }
  EXPECT_EQ(json("flatten square.ply --base-points 30 --flat -o flat.ply")["flips"], 0);
  // The tolerance of the solver. Measured: 6e-10.
  EXPECT_NEAR(json("info flat.ply")["area"].get<double>(), 1., 1e-8);
  EXPECT_EQ(json("flatten cloud.xyz --base-points 40 -o m.ply")["base_points"], 40);
  EXPECT_EQ(json("flatten square.ply --start lle --rigid-steps 0 -o f.obj")["flips"], 0);
  expect_failure("flatten square.ply --start flat", 1, "mds");
  expect_failure("flatten square.ply --method flat", 1, "glle");
  expect_failure("flatten square.ply --base-points 2", 2, "between 3 and 1000");
  expect_failure("flatten cloud.xyz --injective", 2, "needs a mesh");
  expect_failure("flatten cloud.xyz --method lscm", 2, "needs a mesh");
  expect_failure("flatten closed.off --injective", 2, "no boundary");
  expect_failure("flatten apart.off", 2, "not connected");
}

TEST_F(Program, flatten_by_other_methods_maps_the_component_of_the_longest_boundary)
{
  // An isolated vertex, a square of four triangles, and a smaller triangle.
  write("parts.off",
        "OFF\n9 5 0\n9 9 9\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 0\n5 0 0\n5.1 0 0\n5 .1 0\n"
        "3 1 2 5\n3 2 3 5\n3 3 4 5\n3 4 1 5\n3 6 7 8\n");
  for(const std::string method : {"arap", "authalic", "lscm"})
  {
    json("flatten parts.off --values f.txt -o f.obj --method " + method);
    const std::vector<double> uv = numbers("f.txt");
    ASSERT_EQ(uv.size(), 18u) << method;
    for(std::size_t i = 0; i < 9; ++i)
      EXPECT_EQ(std::isfinite(uv[2 * i]), i >= 1 && i <= 5) << method << ' ' << i;
    expect_failure("flatten pinched.off --method " + method, 2, "manifold");
  }
}

TEST_F(Program, atlas_is_injective)
{
  for(const std::string name : {"closed.off", "square.ply"})
  {
    SCOPED_TRACE(name);
    const nlohmann::json found = json("atlas " + name + " --number 3 --values uv.txt -o atlas.glb");
    EXPECT_GE(found["charts"], 3);
    EXPECT_EQ(found["flips"], 0);
    EXPECT_EQ(found["overlaps"], 0);
    EXPECT_TRUE(fs::exists(m_folder / "atlas.glb"));
    const std::vector<double> uv = numbers("uv.txt");
    ASSERT_EQ(uv.size(), 6 * found["faces"].get<std::size_t>());
    double area = 0.;
    for(std::size_t f = 0; f < uv.size(); f += 6)
    {
      const double* const p = &uv[f];
      const double twice = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
      EXPECT_GT(twice, 0.);
      area += twice / 2.;
    }
    EXPECT_GE(*std::min_element(uv.begin(), uv.end()), 0.);
    EXPECT_LE(*std::max_element(uv.begin(), uv.end()), 1.);
    EXPECT_NEAR(area, found["coverage"], 1e-9); // round-off errors of sums
  }
}

TEST_F(Program, atlas_of_a_cloud_is_injective)
{
  // A sphere. The upper half is red, the lower half is black.
  const auto ball = CGAL::Geodesic_processing::test::icosphere(3);
  std::ostringstream ply;
  ply.precision(17);
  ply << "ply\nformat ascii 1.0\nelement vertex " << ball.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nproperty double nx\n"
         "property double ny\nproperty double nz\nproperty uchar red\nproperty uchar green\n"
         "property uchar blue\nend_header\n";
  for(const auto& p : ball.points)
  {
    for(int k = 0; k < 6; ++k)
      ply << p[k % 3] << ' ';
    ply << (p[2] > 0. ? 255 : 0) << " 0 0\n";
  }
  write("ball.ply", ply.str());

  const nlohmann::json found = json("atlas ball.ply --number 3 --values uv.txt -o atlas.obj");
  EXPECT_GE(found["charts"], 3);
  EXPECT_EQ(found["flips"], 0);
  EXPECT_EQ(found["overlaps"], 0);
  const nlohmann::json mesh = json("info atlas.obj");
  EXPECT_EQ(mesh["vertices"], ball.points.size());
  EXPECT_EQ(mesh["faces"], ball.corners.size() / 3);
  EXPECT_EQ(mesh["boundary_loops"], 0);

  // One line per face of the output mesh. The texture has the colors of the surfels.
  const program::Surface_file file = program::read_surface_file(m_folder / "atlas.obj");
  const program::Image texture = program::read_image(m_folder / "atlas_texture.png");
  const std::vector<double> uv = numbers("uv.txt");
  ASSERT_EQ(uv.size(), 2 * file.corners.size());
  double area = 0.;
  for(std::size_t c = 0; c < file.corners.size(); c += 3)
  {
    const double* const p = &uv[2 * c];
    const double twice = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
    EXPECT_GT(twice, 0.);
    area += twice / 2.;
    const auto is_red = [&](std::size_t corner)
    { return file.points[file.corners[corner]][2] > 0.; };
    if(is_red(c) != is_red(c + 1) || is_red(c) != is_red(c + 2))
      continue;
    const auto color = texture.at((p[0] + p[2] + p[4]) / 3., (p[1] + p[3] + p[5]) / 3.);
    EXPECT_NEAR(color[0], is_red(c) ? 1. : 0., 0.01); // colors have 8 bits
    EXPECT_EQ(color[1], 0.);
  }
  EXPECT_NEAR(area, found["coverage"], 1e-9); // round-off errors of sums

  EXPECT_EQ(run("atlas ball.ply --number 3 --flat --quiet -o flat.obj").code, 0);
  EXPECT_NEAR(json("info flat.obj")["area"], area, 1e-9); // round-off errors of sums
}

TEST_F(Program, logmap_writes_normal_coordinates)
{
  for(const char* const method : {"gradient", "exact"})
  {
    const nlohmann::json map = json("logmap square.ply --base 40 --up 0,1,0 --radius 0.4 --values "
                                    "m.txt -o m.vtp --method " +
                                    std::string(method));
    EXPECT_EQ(map["cut"], 0);
    EXPECT_EQ(map["flips"], 0);
    const std::vector<double> uv = numbers("m.txt");
    ASSERT_EQ(uv.size(), 162u);
    std::size_t inside = 0;
    for(std::size_t i = 0; i < 81; ++i)
    {
      const double x = double(i % 9) / 8. - 0.5, y = double(i / 9) / 8. - 0.5;
      EXPECT_EQ(std::isfinite(uv[2 * i]), std::hypot(x, y) <= 0.4);
      if(!std::isfinite(uv[2 * i]))
        continue;
      ++inside;
      EXPECT_NEAR(uv[2 * i], x, round_off);
      EXPECT_NEAR(uv[2 * i + 1], y, round_off);
    }
    EXPECT_EQ(map["values"], inside);
  }
  EXPECT_EQ(json("logmap square.ply --base-at 0.3,0.3,1 --distances heat -o m.obj")["values"], 81);
  EXPECT_EQ(json("logmap cloud.xyz --base 50 -o m.ply")["values"], 144);
  EXPECT_EQ(json("logmap cloud.xyz --base 50 --method discrete-exponential")["values"], 144);
  expect_failure("logmap square.ply", 1, "--base");
  expect_failure("logmap square.ply --base 1 --base-at 0,0,0", 1, "--base");
  expect_failure("logmap square.ply --base 1 --method flat", 1, "gradient");
  expect_failure("logmap square.ply --base 1 --distances emd", 1, "--distances emd");
  expect_failure("logmap square.ply --base 40 --up 0,0,1", 2, "normal to the surface");
  EXPECT_EQ(json("logmap square.ply --base 40 --distances fast-marching --smoothing-steps 5 "
                 "--base-refinements 2")["values"],
            81);
  EXPECT_EQ(json("logmap cloud.xyz --base 50 --smoothing-steps 5")["values"], 144);
  expect_failure("logmap square.ply --base 1 --method exact --smoothing-steps 1", 1, "gradient");
  expect_failure("logmap square.ply --base 1 --method exact --base-refinements 1", 1, "gradient");
  expect_failure("logmap square.ply --base 1 --smoothing-steps 1001", 2, "smoothing steps");
  expect_failure("logmap cloud.xyz --base 1 --base-refinements 1", 2, "require a mesh");
}

TEST_F(Program, decal_writes_colors_and_textures)
{
  // A compass rose from 0.2 to 0.8. The centers of its upper and right rays are at 0.5.
  const nlohmann::json decal =
      json("decal square.ply --base 40 --up 1,0,0 --width 0.6 --values c.txt "
           "-o d.ply");
  EXPECT_EQ(decal["covered"], 25);
  EXPECT_EQ(decal["faces"], 6 * 6 * 2);
  const std::vector<double> colors = numbers("c.txt");
  ASSERT_EQ(colors.size(), 3u * 81u);
  const auto color = [&](int column, int row)
  {
    const auto begin = colors.begin() + 3 * (9 * row + column);
    return std::vector<double>(begin, begin + 3);
  };
  const std::vector<double> plain = {204., 209., 217.}; // color of a surface without vertex colors
  EXPECT_EQ(color(0, 0), plain);
  EXPECT_EQ(color(2, 2), plain); // outside of the ring
  EXPECT_NE(color(4, 4), plain);
  EXPECT_NE(color(6, 4), plain);
  EXPECT_EQ(json("info d.ply")["vertices"], 81);

  // Two decals. The second one has its own size and covers the first.
  const nlohmann::json two =
      json("decal square.ply --base 40,0 --up 0,1,0 --width 0.6 --width 0.3 --height 0.6 "
           "--height 0.2 --method exact -o two.obj");
  EXPECT_GT(two["faces"].get<int>(), 72);
  EXPECT_EQ(read_file(m_folder / "two.obj").substr(0, 15), "mtllib two.mtl\n");
  EXPECT_NE(read_file(m_folder / "two.mtl").find("map_Kd two_texture.png\n"), std::string::npos);
  EXPECT_EQ(read_file(m_folder / "two_texture.png").substr(1, 3), "PNG");
  EXPECT_EQ(json("info two.obj")["faces"], 128);

  // A black image. The decal height follows from the aspect ratio of the image.
  write("black.png", png(4, std::string(2 * 5, '\0')));
  EXPECT_EQ(json("decal square.ply --base-at 0.5,0.5,0 --up 0,1,0 --width 0.6 --image black.png "
                 "--values c.txt")["covered"],
            5 * 3);
  EXPECT_EQ(numbers("c.txt")[3 * 40], 0.);
  EXPECT_EQ(json("decal cloud.xyz --base 65 --image black.png -o c.ply --values c.txt")["faces"],
            0);
  EXPECT_EQ(numbers("c.txt")[3 * 65], 0.);

  expect_failure("decal square.ply", 1, "--base");
  expect_failure("decal square.ply --base 1 --base-at 0,0,0", 1, "--base");
  expect_failure("decal square.ply --base 1,2,3 --width 1 --width 2", 1, "each of the 3");
  expect_failure("decal square.ply --base 1 --width 0", 1, "--width");
  expect_failure("decal square.ply --base 1 --height nan", 1, "--height");
  expect_failure("decal square.ply --base 1 --up 1,2", 1, "--up");
  expect_failure("decal square.ply --base 1 --method flat", 1, "gradient");
  expect_failure("decal square.ply --base 1 --texels -1", 1, "--texels");
  expect_failure("decal square.ply --base 40 --texels 100000000", 2, "texels");
  expect_failure("decal square.ply --base 1 -o d.off", 1, ".obj");
  expect_failure("decal square.ply --base 40 --up 0,0,1", 2, "normal to the surface");
}

} // namespace parameterization_test
