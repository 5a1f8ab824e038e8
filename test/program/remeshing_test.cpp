// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands remesh, base, semiregular and wavelet.
#include "Program.h"
#include "readers/Surface_file.h"
#include "subdivided_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace remeshing_test {

using namespace program_test;

TEST_F(Program, base_of_a_cloud_locates_surfels_in_input_order)
{
  write("ball.xyz", ball_cloud());
  const nlohmann::json base = json("base ball.xyz --number 60 --values b.txt -o base.ply");
  EXPECT_GE(base["vertices_out"], 60);
  EXPECT_EQ(base["faces_out"], 2 * (base["vertices_out"].get<int>() - 2)); // Euler's formula
  EXPECT_EQ(base["folds"], 0);
  const program::Surface_file file = program::read_surface_file(m_folder / "base.ply"),
                              cloud = program::read_surface_file(m_folder / "ball.xyz");
  EXPECT_EQ(base["vertices_out"], file.points.size());
  const std::vector<double> locations = numbers("b.txt");
  ASSERT_EQ(locations.size(), 4 * cloud.points.size());
  for(std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const double* const location = &locations[4 * i];
    ASSERT_LT(location[0], base["faces_out"].get<double>());
    EXPECT_GE(*std::min_element(location + 1, location + 4), -round_off);
    EXPECT_NEAR(location[1] + location[2] + location[3], 1., round_off);
    // The projection of the point in the base face onto the sphere is close to the surfel.
    program::Point p = {0., 0., 0.};
    for(std::size_t k = 0; k < 3; ++k)
      for(std::size_t c = 0; c < 3; ++c)
        p[c] += location[1 + k] * file.points[file.corners[3 * std::size_t(location[0]) + k]][c];
    const double norm = std::hypot(p[0], p[1], p[2]);
    const program::Point& q = cloud.points[i];
    // The edge length of the base mesh is about 0.5.
    EXPECT_LT(std::hypot(p[0] / norm - q[0], p[1] / norm - q[1], p[2] / norm - q[2]), 0.1);
  }

  EXPECT_EQ(json("base ball.xyz --number 60 --divided -o divided.ply")["faces_out"],
            base["faces_out"]);
  const nlohmann::json divided = json("info divided.ply");
  EXPECT_GT(divided["faces"], 1280);
  EXPECT_EQ(divided["boundary_loops"], 0);
  EXPECT_EQ(divided["genus"], 0);
}

TEST_F(Program, semiregular_remeshes_a_cloud)
{
  write("ball.xyz", ball_cloud());
  const nlohmann::json found =
      json("semiregular ball.xyz --number 30 --levels 2 --values l.txt -o s.ply");
  EXPECT_EQ(found["folds"], 0);
  EXPECT_EQ(found["levels"], 2);
  EXPECT_EQ(found["faces_out"], 16 * found["base_faces"].get<int>());
  EXPECT_EQ(found["faces_out"], 2 * (found["vertices_out"].get<int>() - 2));
  EXPECT_EQ(numbers("l.txt").size(), found["vertices_out"]);
  const program::Surface_file file = program::read_surface_file(m_folder / "s.ply");
  EXPECT_EQ(file.number_of_polygons(), found["faces_out"]);
  for(const program::Point& p : file.points)
    EXPECT_NEAR(std::hypot(p[0], p[1], p[2]), 1., 0.01); // faces of the reconstruction are flat
  EXPECT_GT(json("semiregular ball.xyz --number 30 --quads -o q.ply")["faces_out"], 0);
  EXPECT_LE(json("semiregular ball.xyz --number 30 --maximum-deviation 0.1")["deviation"], 0.1);
}

TEST_F(Program, divided_base_preserves_area_and_boundary)
{
  const nlohmann::json base = json("base square.ply --number 20 -o base.ply"),
                       again = json("base square.ply --number 20 --divided -o divided.ply"),
                       whole = json("info square.ply"), divided = json("info divided.ply");
  EXPECT_EQ(again["faces_out"], base["faces_out"]);
  EXPECT_EQ(json("info base.ply")["faces"], base["faces_out"]);
  EXPECT_GT(divided["faces"], whole["faces"]);
  // Round-off errors of a sum of some hundred numbers.
  EXPECT_NEAR(divided["area"].get<double>(), whole["area"].get<double>(), 1e-13);
  EXPECT_EQ(divided["boundary_loops"], whole["boundary_loops"]);
}

TEST_F(Program, wavelet_error_decreases_with_details_and_bits)
{
  using namespace CGAL::Geodesic_processing::test;
  const Triangulation surface = finest(icosphere(0), 4, onto_bumpy_sphere);
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << surface.points.size() << ' ' << surface.corners.size() / 3 << " 0\n";
  for(const auto& p : surface.points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(std::size_t c = 0; c < surface.corners.size(); c += 3)
    text << "3 " << surface.corners[c] << ' ' << surface.corners[c + 1] << ' '
         << surface.corners[c + 2] << '\n';
  write("levels.off", text.str());

  const nlohmann::json all = json("wavelet levels.off -o all.ply");
  EXPECT_EQ(all["levels"], 4);
  EXPECT_EQ(all["base_vertices"], 12);
  EXPECT_EQ(all["kept"], 2550);
  EXPECT_LT(all["rms"].get<double>(), 1e-12); // with all details: the same mesh
  double last = all["rms"];
  for(const std::string percent : {"50", "10", "1", "0"})
  {
    const nlohmann::json some =
        json("wavelet levels.off --keep " + percent + " -o some.ply --values d.txt");
    EXPECT_EQ(some["kept"], std::size_t(std::lround(25.5 * std::stod(percent))));
    EXPECT_GT(some["rms"].get<double>(), last);
    EXPECT_EQ(numbers("d.txt").size(), 2562u);
    last = some["rms"];
  }
  last = std::numeric_limits<double>::infinity();
  for(const std::string bits : {"2", "4", "8", "16"})
  {
    const nlohmann::json some = json("wavelet levels.off --bits " + bits + " -o some.gpw");
    EXPECT_LE(some["bits_per_vertex"].get<double>(), std::stod(bits));
    EXPECT_LT(some["rms"].get<double>(), last);
    EXPECT_EQ(json("info some.gpw")["vertices"], 2562);
    EXPECT_EQ(json("wavelet some.gpw")["levels"], 4); // a second time
    last = some["rms"];
  }
  // Measured: 2.2e-4.
  EXPECT_LT(last, 5e-4);
  EXPECT_EQ(json("wavelet levels.off --levels 1 --predictor linear")["base_vertices"], 642);
  expect_failure("wavelet levels.off --keep 101", 1, "percentage");
  expect_failure("wavelet levels.off --bits 0", 1, "positive");
  expect_failure("wavelet levels.off --bits 0.01", 2, "too small");
  expect_failure("wavelet levels.off --predictor magic", 1, "butterfly");
  expect_failure("wavelet levels.off -o a.stl", 1, ".gpw");
  expect_failure("wavelet square.ply", 2, "no coarser level");
  expect_failure("wavelet cloud.xyz", 2, "needs a mesh");
  write("bad.gpw", "GPW1 and more");
  expect_failure("info bad.gpw", 2, "header");
}

TEST_F(Program, remesh_preserves_a_square)
{
  for(const char* const options : {"", " --lloyd 3", " --speed double_speed", " --keep-sharp 30"})
    for(const int number : {4, 30, 200})
    {
      const nlohmann::json result = json("remesh square.ply -o r.ply --values r.txt --number " +
                                         std::to_string(number) + options);
      const std::size_t vertices = result["vertices_out"];
      EXPECT_EQ(vertices, number + result["added"].get<std::size_t>());
      const nlohmann::json remeshed = json("info r.ply");
      EXPECT_EQ(remeshed["vertices"], vertices);
      EXPECT_EQ(remeshed["faces"], result["faces_out"]);
      EXPECT_EQ(remeshed["boundary_loops"], 1);
      EXPECT_EQ(remeshed["genus"], 0);
      EXPECT_NEAR(remeshed["area"].get<double>(), 1., 1e-9); // corners are preserved
      EXPECT_EQ(numbers("r.txt").size(),
                6 * vertices); // three vertices of a face and three weights
    }
  // A closed surface has at least four vertices. Components without faces are omitted.
  EXPECT_GE(json("remesh closed.off --number 0")["vertices_out"], 4);
  EXPECT_GE(json("remesh apart.off --number 6 -o a.off")["vertices_out"], 6);
  EXPECT_EQ(json("info a.off")["components"], 2);
}

TEST_F(Program, remesh_adds_vertices_for_maximum_deviation)
{
  // A tent over the center of a square with 41 x 41 vertices.
  std::ostringstream tent;
  tent << "OFF\n1681 3200 0\n";
  for(int j = 0; j < 41; ++j)
    for(int i = 0; i < 41; ++i)
      tent << i << ' ' << j << ' ' << std::max(0, 10 - std::abs(i - 20) - std::abs(j - 20)) << '\n';
  for(int j = 0; j < 40; ++j)
    for(int i = 0; i < 40; ++i)
    {
      const int a = 41 * j + i;
      tent << "3 " << a << ' ' << a + 1 << ' ' << a + 42 << "\n3 " << a << ' ' << a + 42 << ' '
           << a + 41 << '\n';
    }
  write("tent.off", tent.str());
  const auto added = [&](const std::string& deviation)
  { return json("remesh tent.off --number 4 " + deviation)["added"].get<std::size_t>(); };
  const std::size_t few = added(""), more = added("--maximum-deviation 3"),
                    many = added("--maximum-deviation 0.5");
  EXPECT_LT(few, more);
  EXPECT_LT(more, many);
  EXPECT_EQ(added("--maximum-deviation inf"), few);
  EXPECT_EQ(added("--maximum-deviation 11"), few); // the height of the tent is 10
}

TEST_F(Program, remesh_fit_reduces_area_error)
{
  const auto ball = CGAL::Geodesic_processing::test::icosphere(3);
  std::ostringstream off;
  off << "OFF\n" << ball.points.size() << ' ' << ball.corners.size() / 3 << " 0\n";
  for(const auto& p : ball.points)
    off << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(std::size_t c = 0; c < ball.corners.size(); c += 3)
    off << "3 " << ball.corners[c] << ' ' << ball.corners[c + 1] << ' ' << ball.corners[c + 2]
        << '\n';
  write("ball.off", off.str());
  const auto area = [&](const std::string& option)
  {
    json("remesh ball.off --number 40 -o r.ply" + option);
    return json("info r.ply")["area"].get<double>();
  };
  // If all vertices lie on the sphere, the faces lie inside it.
  const double input = json("info ball.off")["area"].get<double>(), touching = area(""),
               fitted = area(" --fit");
  EXPECT_LT(touching, fitted);
  EXPECT_LT(std::abs(input - fitted), 0.5 * std::abs(input - touching));
}

TEST_F(Program, remesh_fills_holes)
{
  // A box of edge length 2 without its top face. One triangle of its bottom face is missing.
  write("box.off", "OFF\n8 9 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n2 2 2\n0 2 2\n"
                   "3 0 2 1\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n"
                   "3 3 4 7\n");
  for(const auto& [option, filled, area] :
      {std::tuple("", 0, 18.), std::tuple(" --fill-holes 3", 1, 20.),
       std::tuple(" --fill-holes", 2, 24.), std::tuple(" --fill-holes=4", 2, 24.)})
  {
    const nlohmann::json result = json(
        std::string("remesh box.off --number 60 --keep-sharp 60 -o r.ply --values r.txt") + option);
    EXPECT_EQ(result.value("holes_filled", 0), filled);
    EXPECT_EQ(result.value("holes_left", 0), 0);
    EXPECT_EQ(result["vertices"], 8); // number of vertices in the file
    EXPECT_EQ(result["faces"], 9);
    const nlohmann::json shape = json("info r.ply");
    EXPECT_EQ(shape["boundary_loops"], 2 - filled);
    EXPECT_EQ(shape["genus"], 0);
    EXPECT_NEAR(shape["area"].get<double>(), area, 1e-9); // edges are preserved
    // Locations refer to vertices of the file. Their faces may be new.
    const std::vector<double> locations = numbers("r.txt");
    ASSERT_EQ(locations.size(), 6 * shape["vertices"].get<std::size_t>());
    for(std::size_t i = 0; i < locations.size(); i += 6)
    {
      EXPECT_LT(std::max({locations[i], locations[i + 1], locations[i + 2]}), 8.);
      EXPECT_NEAR(locations[i + 3] + locations[i + 4] + locations[i + 5], 1.,
                  1e-15); // two round-off errors
    }
  }
  // Speeds are given at the vertices of the file. Hole filling adds no vertices.
  EXPECT_EQ(json("remesh square.ply --number 40 --speed double_speed --fill-holes")["holes_filled"],
            1);
  // The boundary of a single triangle is not filled. A message reports this.
  const Run_result outcome = run("remesh apart.off --number 9 --fill-holes");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "2 holes are left open", outcome.err);
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "holes filled    0", outcome.out);
  // `--fill-holes` takes an optional number. It must not consume the file name.
  EXPECT_EQ(run("remesh --number 9 --fill-holes square.ply").code, 0);
}

} // namespace remeshing_test
