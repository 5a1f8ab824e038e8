// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the program, whose file is GEODESIC_PROCESSING_PROGRAM.
#include "io/Image.h"
#include "io/Surface_file.h"
#include "subdivided_surfaces.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <sys/wait.h>

namespace program_test {

namespace fs = std::filesystem;

struct Run_result
{
  int code = -1;
  std::string out, err;
};

std::string read_file(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Returns a grayscale image as a PNG file. Each row of `rows` is a zero followed by `width` bytes.
std::string png(unsigned width, const std::string& rows)
{
  const auto big_endian = [](std::uint32_t x)
  {
    return std::string{static_cast<char>(x >> 24), static_cast<char>(x >> 16),
                       static_cast<char>(x >> 8), static_cast<char>(x)};
  };
  const auto chunk = [&](const std::string& bytes) // chunk name and chunk data
  {
    std::uint32_t crc = ~0u;
    for(const unsigned char byte : bytes)
    {
      crc ^= byte;
      for(int bit = 0; bit < 8; ++bit)
        crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
    }
    return big_endian(static_cast<std::uint32_t>(bytes.size() - 4)) + bytes + big_endian(~crc);
  };
  std::uint32_t a = 1, b = 0;
  for(const unsigned char byte : rows)
  {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  // A single uncompressed block.
  const auto size = static_cast<std::uint16_t>(rows.size());
  const auto low = [](unsigned x) { return static_cast<char>(x & 255); };
  const std::string zlib_stream =
      std::string{'\x78', '\x01', '\x01', low(size), low(size >> 8), low(~size), low(~size >> 8)} +
      rows + big_endian(b << 16 | a);
  const auto height = static_cast<std::uint32_t>(rows.size() / (width + 1));
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR" + big_endian(width) + big_endian(height) +
               std::string{'\x08', '\0', '\0', '\0', '\0'}) +
         chunk("IDAT" + zlib_stream) + chunk("IEND");
}

// Provides a new folder with input files. Removes the folder at the end.
class Program : public testing::Test
{
protected:
  Program()
  {
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::path(testing::TempDir()) / ("geodesic_" + std::string(test->name()));
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);

    // A unit square with 9 x 9 vertices, diagonals of alternating direction and a vertex property.
    std::ostringstream square;
    square << "ply\nformat ascii 1.0\nelement vertex 81\nproperty double x\nproperty double y\n"
              "property double z\nproperty float double_speed\nelement face 128\n"
              "property list uchar int vertex_indices\nend_header\n";
    for(int j = 0; j < 9; ++j)
      for(int i = 0; i < 9; ++i)
        square << i / 8. << ' ' << j / 8. << " 0 2\n";
    for(int j = 0; j < 8; ++j)
      for(int i = 0; i < 8; ++i)
      {
        const int a = 9 * j + i, b = a + 1, c = a + 10, d = a + 9;
        if((i + j) % 2 == 0)
          square << "3 " << a << ' ' << b << ' ' << c << "\n3 " << a << ' ' << c << ' ' << d
                 << '\n';
        else
          square << "3 " << a << ' ' << b << ' ' << d << "\n3 " << b << ' ' << c << ' ' << d
                 << '\n';
      }
    write("square.ply", square.str());

    write("closed.off",
          "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    write("apart.off",
          "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 5\n1 0 5\n0 1 5\n9 9 9\n3 0 1 2\n3 3 4 5\n");
    write("quads.off",
          "OFF\n6 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n4 0 1 4 3\n4 1 4 5 2\n");
    // Two triangles that share a vertex.
    write("pinched.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n");
    // Two tetrahedra that share a vertex.
    write("bowtie.off", "OFF\n7 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n0 -1 0\n0 0 -1\n"
                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 4 5\n3 0 6 4\n3 4 6 5\n3 5 6 0\n");
    std::ostringstream cloud;
    for(int j = 0; j < 12; ++j)
      for(int i = 0; i < 12; ++i)
        cloud << i / 11. << ' ' << j / 11. << " 0 0 0 1\n";
    write("cloud.xyz", cloud.str());
  }
  ~Program() override { fs::remove_all(m_folder); }

  void write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(m_folder / name, std::ios::binary) << bytes;
  }

  // Runs a command line in the folder.
  Run_result run(const std::string& arguments) const
  {
    const fs::path out = fs::path(m_folder.string() + ".out"), err = m_folder.string() + ".err";
    const std::string redirection =
        arguments.find('>') == std::string::npos ? " >'" + out.string() + "'" : "";
    const int status =
        std::system(("cd '" + m_folder.string() + "' && '" GEODESIC_PROCESSING_PROGRAM "' " +
                     arguments + redirection + " 2>'" + err.string() + "'")
                        .c_str());
    Run_result result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(out), read_file(err)};
    fs::remove(out);
    fs::remove(err);
    return result;
  }

  nlohmann::json json(const std::string& arguments) const
  {
    const Run_result result = run(arguments + " --json --quiet");
    EXPECT_EQ(result.code, 0) << arguments << ": " << result.err;
    return nlohmann::json::parse(result.out, nullptr, false);
  }

  std::vector<double> numbers(const std::string& name) const
  {
    std::istringstream stream(read_file(m_folder / name));
    std::vector<double> result;
    for(std::string word; stream >> word;)
      result.push_back(std::strtod(word.c_str(), nullptr));
    return result;
  }

  // Expects the exit code `code` and one error sentence that contains `text`.
  void expect_failure(const std::string& arguments, int code, const std::string& text) const
  {
    const std::size_t files = number_of_files();
    const Run_result result = run(arguments);
    EXPECT_EQ(result.code, code) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_PRED_FORMAT2(testing::IsSubstring, text, result.err);
    EXPECT_EQ(number_of_files(), files) << arguments << " left a file behind";
  }

  std::size_t number_of_files() const
  {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {}));
  }

  fs::path m_folder;
};

// Returns the lines of a file with the 642 vertices of an icosphere and their normals.
std::string ball_cloud()
{
  std::ostringstream lines;
  lines.precision(17);
  for(const auto& p : CGAL::Geodesic_processing::test::icosphere(3).points)
    lines << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[0] << ' ' << p[1] << ' ' << p[2]
          << '\n';
  return lines.str();
}

std::set<std::string> keys(const nlohmann::json& object)
{
  std::set<std::string> result;
  for(const auto& item : object.items())
    result.insert(item.key());
  return result;
}

TEST_F(Program, exits_with_1_on_wrong_usage)
{
  expect_failure("", 1, "a command is required; see geodesic --help");
  expect_failure("fly square.ply", 1, "there is no command 'fly'; see geodesic --help");
  expect_failure("--fly", 1, "there is no option '--fly'");
  expect_failure("info", 1, "INPUT");
  expect_failure("info square.ply --what", 1, "--what");
  expect_failure("distance square.ply", 1, "--source");
  expect_failure("distance square.ply --source one", 1, "'one'");
  expect_failure("distance square.ply --source 1,,2", 1, "not a vertex index");
  expect_failure("distance square.ply --source-at 1,2", 1, "x,y,z");
  expect_failure("distance square.ply --source-at 1,2,nan", 1, "x,y,z");
  expect_failure("distance square.ply --source 0,1 --method spectral", 1, "one source");
  expect_failure("distance square.ply --source 0 --basis 3", 1, "--basis");
  expect_failure("path square.ply --from 0 --to 1 --method spectral", 1,
                 "only the commands distance and matrix");
  for(const char* const command :
      {"distance square.ply --source 0", "matrix square.ply --number 2"})
    expect_failure(std::string(command) + " --method fast", 1,
                   "dijkstra, heat, spectral, emd and biharmonic");
  expect_failure("distance square.ply --source 0 --limit -1", 1, "--limit");
  expect_failure("distance square.ply --source 0 --relative-tolerance -1", 1, "negative");
  expect_failure("distance square.ply --source 0 --relative-tolerance nan", 1, "negative");
  expect_failure("distance square.ply --source 0 --relative-tolerance 1 --method heat", 1,
                 "only the method exact");
  expect_failure("distance square.ply --source 0 --speed colors --strength -1", 1, "--strength");
  expect_failure("distance square.ply --source 0 --speed colours --strength nan", 1, "--strength");
  expect_failure("distance square.ply --source 0 --method heat --density-image a.png", 1, "speeds");
  expect_failure("distance square.ply --source 0 --speed s --method heat", 1, "--speed");
  expect_failure("distance square.ply --source 0 -o a.xyz", 1, "a.xyz");
  expect_failure("distance square.ply --source 0 --picture a.jpg", 1, ".png");
  expect_failure("path square.ply --from 0", 1, "--to");
  expect_failure("path square.ply --from 0,1 --to 2", 1, "one vertex");
  expect_failure("path square.ply --from 0 --from-at 0,0,0 --to 2", 1, "--from");
  expect_failure("path square.ply --from 0 --to 80 -o a.off", 1, "a.off");
  expect_failure("path square.ply --from 0 --to 80 --method nothing", 1, "nothing");
  expect_failure("info square.ply --property distance", 1, "--picture");
  expect_failure("info square.ply --sides", 1, "--picture");
}

TEST_F(Program, exits_with_1_on_wrong_usage_of_sampling)
{
  expect_failure("sample square.ply --number 2 --speed double_speed --strength 1", 1, "--strength");
  expect_failure("voronoi square.ply --number 2 --strength 1", 1, "--strength");
  expect_failure("sample square.ply --number 2 --speed colours --density-image a.png", 1,
                 "--speed");
  expect_failure("voronoi square.ply", 1, "--number");
  expect_failure("voronoi square.ply --number 2 --seeds 1", 1, "--seeds");
  expect_failure("segment square.ply", 1, "--number");
  expect_failure("segment cloud.xyz --number 3 --disks", 2, "cloud.xyz");
  expect_failure("matrix square.ply", 1, "--limit");
  expect_failure("sample square.ply", 1, "--number");
  for(const char* const command : {"sample", "voronoi", "segment", "matrix"})
    expect_failure(std::string(command) + " square.ply --number -1", 1, "--number");
  expect_failure("sample square.ply --number 2 --spacing 1", 1, "--spacing");
  expect_failure("sample square.ply --spacing -1", 1, "--spacing");
  expect_failure("sample square.ply --spacing inf", 1, "--spacing");
  expect_failure("sample square.ply --number 2 --speed slow", 2, "slow");
  expect_failure("matrix square.ply --limit inf", 1, "--limit");
  expect_failure("matrix square.ply --number 0", 1, "at least one row");
  expect_failure("matrix square.ply --number 2 --sources 1", 1, "--sources");
  expect_failure("matrix square.ply --sources 1,2,1", 1, "vertex 1 is listed twice");
  expect_failure("matrix square.ply --number 2 --limit -1", 1, "--limit");
  expect_failure("matrix square.ply --number 2 --limit nan", 1, "--limit");
  expect_failure("matrix square.ply --number 2 --method biharmonic --limit 1", 1,
                 "not support --limit");
  expect_failure("matrix square.ply --number 2 -o a.ply", 1, ".mtx");
}

TEST_F(Program, exits_with_1_on_wrong_usage_of_remeshing)
{
  expect_failure("remesh square.ply", 1, "--number");
  expect_failure("remesh square.ply --number -1", 1, "--number");
  expect_failure("remesh square.ply --number 9 --lloyd -1", 1, "--lloyd");
  expect_failure("remesh square.ply --number 1000000000", 2, "2^31");
  expect_failure("remesh square.ply --number 9 --keep-sharp 181", 1, "--keep-sharp");
  for(const char* const deviation : {"0", "-1", "nan"})
    expect_failure(std::string("remesh square.ply --number 9 --maximum-deviation ") + deviation, 1,
                   "--maximum-deviation");
  for(const char* const edges : {"2", "-3", "many", "3.5"})
    expect_failure(std::string("remesh square.ply --number 9 --fill-holes ") + edges, 1,
                   "--fill-holes");
  for(const char* const spacing : {"-1", "nan", "inf"})
    expect_failure(std::string("remesh square.ply --number 9 --curve-spacing ") + spacing, 1,
                   "--curve-spacing");
  expect_failure("remesh square.ply --number 9 --speed slow", 2, "slow");
  expect_failure("base square.ply", 1, "--number");
  expect_failure("base square.ply --number 9 --coordinates polar", 1, "polar");
  expect_failure("atlas square.ply", 1, "--number");
  expect_failure("atlas square.ply --number 2 --texels 8", 1, "--texels");
  expect_failure("atlas square.ply --number 2 --gutter 300", 1, "--gutter");
  expect_failure("atlas square.ply --number 2 --image nowhere.png", 2, "nowhere.png");
  expect_failure("atlas square.ply --number 60 --texels 16", 2, "do not fit");
  expect_failure("semiregular square.ply --number 9 --levels 9", 1,
                 "--levels: 9 is not in the range [0, 8]");
  expect_failure("semiregular square.ply --number 9 --maximum-deviation -1", 1,
                 "--maximum-deviation");
}

TEST_F(Program, exits_with_2_on_bad_input)
{
  expect_failure("info nowhere.ply", 2, "nowhere.ply: there is no such file");
  write("cut.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
  for(const char* const command :
      {"info cut.off", "distance cut.off --source 0", "path cut.off --from 0 --to 1",
       "voronoi cut.off --number 1", "matrix cut.off --number 1", "remesh cut.off --number 1"})
    expect_failure(command, 2, "cut.off: ");
  expect_failure("distance square.ply --source 81", 2, "square.ply: there is no vertex 81");
  expect_failure("matrix square.ply --sources 3,81", 2, "square.ply: there is no vertex 81");
  expect_failure("matrix cloud.xyz --number 2 --method exact", 2, "needs a mesh");
  expect_failure("remesh cloud.xyz --number 9 --fill-holes", 2, "needs a mesh");
  expect_failure("distance square.ply --source 0 --speed wind", 2, "only double_speed");
  expect_failure("voronoi square.ply --number 2 --speed wind", 2, "only double_speed");
  expect_failure("sample square.ply --number 2 --speed colours", 2, "no red, green and blue");
  expect_failure("distance closed.off --source-border", 2, "no boundary");
  expect_failure("distance cloud.xyz --source-border", 2, "no boundary");
  expect_failure("distance cloud.xyz --source 0 --method exact", 2, "needs a mesh");
  expect_failure("path cloud.xyz --from 0 --to 1 --method exact", 2, "needs a mesh");
  expect_failure("surfels square.ply", 2, "needs a cloud");
  expect_failure("logmap cloud.xyz --base 1 --method exact", 2, "needs a mesh");
  expect_failure("logmap cloud.xyz --base 1 --distances exact", 2, "needs a mesh");
  expect_failure("decal cloud.xyz --base 1 --method exact", 2, "needs a mesh");
  expect_failure("decal cloud.xyz --base 1 -o d.obj", 2, "no faces");
  expect_failure("decal square.ply --base 81", 2, "square.ply: there is no vertex 81");
  expect_failure("decal square.ply --base 40 --image none.png", 2,
                 "none.png: there is no such file");
  expect_failure("path apart.off --from 0 --to 3", 2, "no path");
  expect_failure("path apart.off --from 0 --to 6 -o a.vtp", 2, "no path");
}

TEST_F(Program, exits_with_3_if_output_cannot_be_written)
{
  expect_failure("info square.ply -o none/a.ply", 3, "none");
  expect_failure("distance square.ply --source 0 --values none/a.txt", 3, "none");
  expect_failure("matrix square.ply --number 2 -o none/a.mtx", 3, "none");
  if(!fs::exists("/dev/full"))
    return;
  EXPECT_EQ(run("distance square.ply --source 0 --values /dev/full").code, 3);
  EXPECT_EQ(run("matrix square.ply --number 2 --values /dev/full").code, 3);
  EXPECT_EQ(run("info square.ply --json > /dev/full").code, 3);
  EXPECT_EQ(run("--help > /dev/full").code, 3);
}

TEST_F(Program, json_has_documented_keys)
{
  const std::set<std::string> common = {"input",    "repaired", "kind",
                                        "vertices", "faces",    "seconds"};
  const auto expect_keys = [&](const std::string& arguments, std::set<std::string> own)
  {
    const nlohmann::json object = json(arguments);
    own.insert(common.begin(), common.end());
    EXPECT_EQ(keys(object), own) << arguments;
    EXPECT_EQ(keys(object["seconds"]),
              (std::set<std::string>{"read", "prepare", "query", "write"}));
  };
  expect_keys("info square.ply", {"components", "boundary_loops", "genus", "manifold", "area",
                                  "min_angle", "max_angle", "bounding_box", "degenerate_faces"});
  expect_keys("info cloud.xyz", {"components", "bounding_box"});
  expect_keys("distance square.ply --source 0", {"max", "unreached"});
  expect_keys("distance cloud.xyz --source 0", {"max", "unreached"});
  expect_keys("path square.ply --from 0 --to 80", {"length", "front_distance", "lower", "points"});
  expect_keys("path cloud.xyz --from 0 --to 143",
              {"length", "front_distance", "lower", "points", "start_length"});
  expect_keys("logmap square.ply --base 40", {"values", "cut", "folded_faces"});
  expect_keys("decal square.ply --base 40", {"covered"});
  for(const char* file : {"square.ply", "cloud.xyz"})
    expect_keys(std::string("flatten ") + file,
                {"base_points", "flips", "conformal", "authalic", "symmetric_dirichlet",
                 "l2_stretch", "linf_stretch"});
  expect_keys("surfels cloud.xyz", {"outliers", "components", "arcs", "radius", "noise"});
  expect_keys("voronoi square.ply --number 3", {"seeds", "unreached"});
  expect_keys("segment square.ply --number 3", {"charts", "energy", "energies", "unreached"});
  expect_keys("sample square.ply --number 3", {"samples", "covering_radius"});
  expect_keys("remesh square.ply --number 20",
              {"vertices_out", "faces_out", "added", "self_intersections"});
  expect_keys("remesh square.ply --number 20 --allow-self-intersections",
              {"vertices_out", "faces_out", "added"});
  for(const std::string file : {"square.ply", "cloud.xyz"})
  {
    expect_keys("base " + file + " --number 20",
                {"vertices_out", "faces_out", "folds", "repaired_faces"});
    expect_keys("semiregular " + file + " --number 20 --levels 1",
                {"vertices_out", "faces_out", "folds", "levels", "base_faces"});
    expect_keys("semiregular " + file + " --number 20 --levels 1 --maximum-deviation 1",
                {"vertices_out", "faces_out", "folds", "levels", "base_faces", "deviation"});
    expect_keys("atlas " + file + " --number 4",
                {"charts", "flips", "overlaps", "coverage", "texels_per_length", "conformal",
                 "authalic", "symmetric_dirichlet"});
  }
  expect_keys(
      "remesh square.ply --number 20 --fill-holes",
      {"vertices_out", "faces_out", "added", "self_intersections", "holes_filled", "holes_left"});
  expect_keys("matrix square.ply --number 3", {"rows", "entries", "sources"});
  expect_keys("matrix square.ply --limit 0.2", {"rows", "entries"});
  expect_keys("emd square.ply --from 0 --to 80",
              {"value", "lower", "upper", "estimate", "iterations", "residual", "converged"});
  expect_keys("plan square.ply --from 0 --to 80,8",
              {"value", "lower", "upper", "iterations", "residual", "converged", "arrivals"});
  expect_keys("barycenter square.ply --points 0,80",
              {"value", "lower", "upper", "iterations", "residual", "converged", "distances",
               "point", "point_value"});
  expect_keys(
      "feature-distance square.ply --feature 0",
      {"max", "unreached", "value", "lower", "upper", "iterations", "residual", "converged"});
  expect_keys("streamlines square.ply --from 0 --to 80",
              {"value", "lower", "upper", "iterations", "residual", "converged", "lines", "arrived",
               "mean_length"});
  expect_keys("fuzzy square.ply --from 0 --to 80",
              {"value", "lower", "upper", "iterations", "residual", "converged"});
  expect_keys("fuzzy square.ply --from 0 --to 80 --by-distances", {});
  expect_keys("emd square.ply --from 0 --to 80 --basis 5",
              {"basis", "value", "lower", "upper", "iterations", "residual", "converged"});
  expect_keys("emd square.ply --from 0 --to 80 --bound-above --refine 1",
              {"value", "lower", "upper", "upper_continuous", "estimate", "iterations", "residual",
               "converged"});
}

TEST_F(Program, json_prints_nothing_else)
{
  for(const char* const command :
      {"info quads.off", "distance quads.off --source 0", "path quads.off --from 0 --to 5",
       "voronoi quads.off --number 2", "sample quads.off --number 2", "remesh quads.off --number 9",
       "matrix quads.off --sources 0,5"})
  {
    const Run_result result = run(std::string(command) + " --json");
    EXPECT_EQ(result.code, 0);
    EXPECT_TRUE(nlohmann::json::accept(result.out)) << result.out;
    EXPECT_TRUE(nlohmann::json::parse(result.out)["repaired"].get<bool>());
    EXPECT_EQ(run(std::string(command) + " --quiet").out, "");
  }
}

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

TEST_F(Program, transport_distances_decrease_with_basis_size)
{
  const auto farthest = [&](const std::string& method)
  {
    const nlohmann::json found =
        json("distance square.ply --source 0 --values d.txt --method " + method);
    EXPECT_EQ(numbers("d.txt").size(), 81u);
    EXPECT_EQ(found["unreached"], 0);
    return found["max"].get<double>();
  };
  const double spectral = farthest("spectral"), some = farthest("emd --basis 5"),
               many = farthest("emd --basis 40"), biharmonic = farthest("biharmonic");
  EXPECT_EQ(json("distance square.ply --source 0 --method spectral")["basis"], 0);
  EXPECT_GE(json("distance square.ply --source 0 --method emd --basis 5")["basis"], 5);
  EXPECT_GT(some, many);
  // Masses are distributed over triangles of size 1/8, which shortens distances. Otherwise they are
  // never too short.
  EXPECT_GT(many, std::sqrt(2.) - 2. / 8.);
  EXPECT_GT(spectral, many);
  EXPECT_GT(biharmonic, 0.);
  const nlohmann::json matrix =
      json("matrix square.ply --sources 0,80 --method spectral --values m.txt");
  EXPECT_EQ(matrix["entries"], 4);
  const std::vector<double> entries = numbers("m.txt");
  EXPECT_EQ(entries[1], entries[2]);
  EXPECT_NEAR(entries[1], spectral, 1e-6); // single precision
  EXPECT_EQ(run("distance cloud.xyz --source 0 --method spectral --quiet").code, 0);
}

TEST_F(Program, emd_matches_known_costs)
{
  // From one corner of the unit square to the opposite corner.
  const nlohmann::json diagonal =
      json("emd square.ply --from 0 --to 80 --values p.txt -o e.ply --hodge --bound-above");
  const double exact = std::sqrt(2.);
  EXPECT_LE(diagonal["lower"].get<double>(), exact * (1. + 1e-9));   // round-off errors
  EXPECT_NEAR(diagonal["value"].get<double>(), exact, 1e-3 * exact); // relative gap
  EXPECT_GE(diagonal["upper_continuous"].get<double>(), exact);
  const std::vector<double> potential = numbers("p.txt");
  ASSERT_EQ(potential.size(), 81u);
  EXPECT_NEAR(potential[80] - potential[0], diagonal["lower"].get<double>(), 1e-9);
  const std::string ply = read_file(m_folder / "e.ply");
  for(const char* const field : {"flow_z", "gradient_x", "rotation_y", "harmonic_z"})
    EXPECT_NE(ply.find(std::string("property double ") + field + "\n"), std::string::npos);
  EXPECT_EQ(json("info e.ply")["faces"], 128);

  // Masses as properties and as files. All mass moves by 0.25.
  std::string from, to;
  for(int i = 0; i < 81; ++i)
  {
    from += i % 9 == 2 ? "1\n" : "0\n";
    to += i % 9 == 4 ? "0.5\n" : "0\n";
  }
  write("from.txt", from);
  write("to.txt", to);
  expect_failure("emd square.ply --from from.txt --to to.txt", 2, "total masses");
  EXPECT_NEAR(json("emd square.ply --from from.txt --to to.txt --normalize")["value"].get<double>(),
              0.25, 1e-3);
  EXPECT_EQ(run("emd square.ply --from from.txt --to to.txt --normalize -o p.vtp --quiet").code, 0);
  EXPECT_EQ(json("emd p.vtp --from potential --to potential --density")["value"], 0.);
  EXPECT_NEAR(
      json("emd square.ply --from 0 --to 8 --refine 1 --method admm --tolerance 0.01")["value"]
          .get<double>(),
      1., 0.01);
  // A lattice on the unit square.
  EXPECT_NEAR(json("emd cloud.xyz --from 0 --to 11 -o e.vtp")["value"].get<double>(), 1., 0.02);
  EXPECT_EQ(run("emd e.vtp --from flow_x --to flow_x --quiet").code, 0);

  // With a basis, results equal those of the distance commands. Mass distributions and flows are
  // supported too.
  const nlohmann::json some = json("emd square.ply --from 0 --to 80 --basis 5 --hodge -o b.ply");
  const auto entries =
      json("matrix square.ply --sources 0,80 --method emd --basis 5 --values d.txt");
  EXPECT_EQ(some["basis"], entries["basis"]);
  EXPECT_NEAR(some["value"].get<double>(), numbers("d.txt")[1], 1e-3 * exact);
  EXPECT_GT(some["lower"].get<double>(), 0.9 * exact); // masses are distributed around points
  const std::string flow = read_file(m_folder / "b.ply");
  EXPECT_NE(flow.find("property double rotation_x\n"), std::string::npos);
  EXPECT_EQ(flow.find("potential"), std::string::npos);
  const double lines =
      json("emd square.ply --from from.txt --to to.txt --normalize --basis 0")["value"];
  EXPECT_GT(lines, 0.25);
  EXPECT_LT(lines, 0.3); // the flow bends at the ends, whose mass per width is doubled
  EXPECT_EQ(run("emd cloud.xyz --from 0 --to 11 --basis 3 -o c.vtp --quiet").code, 0);

  expect_failure("emd square.ply --from 0", 1, "--to");
  expect_failure("emd square.ply --from 0 --to 80 --basis some", 1, "--basis some");
  expect_failure("emd square.ply --from 0 --to 80 --basis -1", 1, "--basis");
  expect_failure("emd square.ply --from 0 --to 80 --basis 3 --refine 1", 1, "complete");
  expect_failure("emd square.ply --from 0 --to 80 --basis 3 --values p.txt", 1, "complete");
  expect_failure("emd square.ply --from 0 --to 80 --method none", 1, "interior-point");
  expect_failure("emd square.ply --from 0 --to 80 --tolerance 0", 1, "--tolerance");
  expect_failure("emd square.ply --from 0 --to 80 -o e.obj", 1, "ply");
  expect_failure("emd square.ply --from 0 --to 81", 2, "81");
  expect_failure("emd square.ply --from 0 --to nothing", 2, "nothing");
  write("short.txt", "1\n2\n");
  expect_failure("emd square.ply --from 0 --to short.txt", 2, "the number of masses is 2");
  expect_failure("emd cloud.xyz --from 0 --to 11 --bound-above", 2, "needs a mesh");
}

TEST_F(Program, plan_transports_to_a_region)
{
  // From the midpoints of the left and lower boundary edges to the two right corners.
  const nlohmann::json two = json("plan square.ply --from 45,6 --to 8,80 -o p.ply --hodge");
  EXPECT_NEAR(two["value"].get<double>(), 0.5 * (std::sqrt(1. + 9. / 64.) + 0.25), 2e-3);
  for(const double arrival : two["arrivals"])
    EXPECT_NEAR(arrival, 0.5,
                0.02); // the other corner is 0.07 farther away, which is fifty times the gap
  const std::string ply = read_file(m_folder / "p.ply");
  for(const char* const field : {"arrivals", "potential", "flow_x", "rotation_z"})
    EXPECT_NE(ply.find(std::string("property double ") + field + "\n"), std::string::npos);
  // To a property: the arrivals of the previous result.
  EXPECT_NEAR(json("plan p.ply --from 0 --to arrivals")["value"].get<double>(), 1., 1e-3);
  EXPECT_NEAR(json("plan cloud.xyz --from 0 --to 11,12")["value"].get<double>(), 1. / 11., 1e-3);

  // The nearest corner has too little capacity, given by numbers or by a property. Also tests
  // uniform spreading.
  const nlohmann::json full = json("plan square.ply --from 45 --to 8,80 --capacity 0.7,0.6");
  EXPECT_NEAR(full["arrivals"][1].get<double>(), 0.6, 0.02);
  const nlohmann::json halves = json("plan p.ply --from 45 --to arrivals --capacity arrivals");
  const double to_both = 0.5 * (std::hypot(1., 0.625) + std::hypot(1., 0.375));
  EXPECT_NEAR(halves["value"].get<double>(), to_both,
              0.02); // a fraction of an edge length at the split of the flow
  const nlohmann::json even = json("plan square.ply --from 45 --to 8,80 --spread 100");
  EXPECT_NEAR(even["arrivals"][0].get<double>(), 0.5, 0.01);
  // To a polyline from the corner (0, 0) to (1, 0.5), and to a location in a face.
  EXPECT_NEAR(json("plan square.ply --from 72 --to-path 0,44")["value"].get<double>(),
              2. / std::sqrt(5.), 2e-3);
  EXPECT_NEAR(
      json("plan square.ply --from 8 --to-at 0.52,0.33,0 --to 0 --capacity 0.5,0.5")["value"]
          .get<double>(),
      0.5 * (1. + std::hypot(0.48, 0.33)), 0.02); // same tolerance as above
  expect_failure("plan square.ply --from 0 --to-path 80", 1, "two vertices");
  expect_failure("plan square.ply --from 0 --to-path 80,81", 2, "81");
  expect_failure("plan square.ply --from 0 --to-at 1,2", 1, "--to-at");
  expect_failure("plan cloud.xyz --from 0 --to-at 0,0,0", 2, "need a mesh");
  expect_failure("plan square.ply --from 45 --to 8 --to-path 0,80 --capacity 0.7", 1, "paths");
  expect_failure("plan p.ply --from 45 --to-path 0,80 --capacity arrivals", 1, "--to-path");
  expect_failure("plan square.ply --from 45 --to 8,80 --capacity 0.7", 1, "must be 2");
  expect_failure("plan square.ply --from 45 --to 8,80 --capacity 0.3,0.6", 2, "capacity");
  expect_failure("plan square.ply --from 45 --to 8,80 --capacity none", 2, "none");
  expect_failure("plan square.ply --from 45 --to 8,80 --spread -1", 2, "spreading");
  expect_failure("plan square.ply --from 0", 1, "--to");
  expect_failure("plan square.ply --from 0 --to 81", 2, "81");
  expect_failure("plan square.ply --from 0 --to nothing", 2, "nothing");
  expect_failure("plan cloud.xyz --from 0 --to 11 --bound-above", 2, "needs a mesh");
}

TEST_F(Program, gradient_and_remainder_sum_to_the_tangential_flow_on_a_cloud)
{
  write("ball.xyz", ball_cloud());
  for(const char* const command :
      {"emd ball.xyz --from 0 --to 11", "emd ball.xyz --from 0 --to 11 --basis 3",
       "plan ball.xyz --from 0 --to 1,2", "emd cloud.xyz --from 0 --to 11"})
    for(const char* const name : {"h.ply", "h.vtp"})
    {
      SCOPED_TRACE(command);
      EXPECT_EQ(run(std::string(command) + " --hodge --quiet -o " + name).code, 0);
      const program::Surface_file file = program::read_surface_file(m_folder / name);
      double max_flow = 0., max_gradient = 0., max_error = 0.;
      for(std::size_t i = 0; i < file.points.size(); ++i)
      {
        const auto vector = [&](const std::string& field)
        {
          return program::Point{file.properties.at(field + "_x")[i],
                                file.properties.at(field + "_y")[i],
                                file.properties.at(field + "_z")[i]};
        };
        const program::Point flow = vector("flow"), gradient = vector("gradient"),
                             remainder = vector("remainder"), normal = file.normals[i];
        // The flow is the mean over triangles, so it has a small component along the normal.
        const double height = flow[0] * normal[0] + flow[1] * normal[1] + flow[2] * normal[2];
        for(std::size_t c = 0; c < 3; ++c)
        {
          max_flow = std::max(max_flow, std::abs(flow[c]));
          max_gradient = std::max(max_gradient, std::abs(gradient[c]));
          max_error = std::max(max_error,
                               std::abs(gradient[c] + remainder[c] - flow[c] + height * normal[c]));
        }
      }
      EXPECT_GT(max_flow, 0.);
      EXPECT_GT(max_gradient, 0.1 * max_flow);
      EXPECT_LT(max_error, 1e-12 * max_flow); // round-off errors
      EXPECT_EQ(file.properties.count("rotation_x"), 0u);
    }
}

TEST_F(Program, barycenter_lies_between_masses)
{
  // Barycenter of two opposite corners at distance sqrt(2).
  const nlohmann::json two = json("barycenter square.ply --points 0,80 --values b.txt -o b.ply");
  EXPECT_NEAR(two["value"].get<double>(), 1., 0.01); // relative gap
  EXPECT_EQ(two["point"], 40);
  EXPECT_NEAR(two["point_value"].get<double>(), 1., 1e-9);
  const std::string ply = read_file(m_folder / "b.ply");
  for(const char* const field : {"mass", "density"})
    EXPECT_NE(ply.find(std::string("property double ") + field + "\n"), std::string::npos);
  // The barycenter is equally far from both corners. The barycenter of it and itself is itself.
  EXPECT_NEAR(json("emd b.ply --from mass --to 0 --normalize")["value"].get<double>(),
              std::sqrt(0.5), 0.08);
  EXPECT_LT(json("barycenter b.ply --of mass --of b.txt")["value"], 1e-12);
  EXPECT_LT(json("barycenter b.ply --of density --of density --density")["value"], 1e-12);
  EXPECT_FALSE(json("barycenter b.ply --of 0,80 --of 8 --normalize").contains("point"));
  // One point has the whole weight.
  const nlohmann::json one =
      json("barycenter square.ply --points 0,80,8 --weight 0 --weight 0 --weight 2");
  EXPECT_EQ(one["value"], 0.);
  EXPECT_EQ(one["point"], 8);
  EXPECT_NEAR(json("barycenter cloud.xyz --points 0,11")["value"].get<double>(), 0.5, 0.02);

  expect_failure("barycenter square.ply", 1, "--of");
  expect_failure("barycenter square.ply --points 0,81", 2, "81");
  expect_failure("barycenter square.ply --of nothing", 2, "nothing");
  expect_failure("barycenter square.ply --points 0,80 --weight 1", 1, "--weight");
  expect_failure("barycenter square.ply --points 0,80 --weight 1 --weight -1", 2, "weight");
  expect_failure("barycenter square.ply --points 0,80 --density", 1, "--density");
  expect_failure("barycenter square.ply --points 0,80 --tolerance 0", 1, "--tolerance");
}

TEST_F(Program, streamlines_end_at_the_target)
{
  // From the lower left corner to the two adjacent corners.
  const nlohmann::json lines =
      json("streamlines square.ply --from 0 --to 8,72 --number 20 -o l.obj");
  EXPECT_EQ(lines["lines"], 20);
  EXPECT_EQ(lines["arrived"], 20);
  EXPECT_NEAR(lines["mean_length"].get<double>(), 1., 1e-9); // round-off errors
  EXPECT_NE(read_file(m_folder / "l.obj").find("\nl "), std::string::npos);
  EXPECT_NEAR(
      json("streamlines square.ply --from 0 --to 80 --seeds 0")["mean_length"].get<double>(),
      std::sqrt(2.), 1e-9);
  EXPECT_GE(
      json("streamlines square.ply --from 1 --to 78 --as-traced")["mean_length"].get<double>(),
      std::hypot(5. / 8., 1.));
  EXPECT_EQ(json("streamlines cloud.xyz --from 0 --to 11,12 --number 7")["arrived"], 7);

  expect_failure("streamlines square.ply --from 0", 1, "--to");
  expect_failure("streamlines square.ply --from 0 --to 81", 2, "81");
  expect_failure("streamlines square.ply --from 0 --to 80 --seeds 99", 2, "99");
}

TEST_F(Program, fuzzy_likelihood_is_high_between_endpoints)
{
  EXPECT_EQ(run("fuzzy square.ply --from 36 --to 44 --width 0.15 --values f.txt --quiet").code, 0);
  EXPECT_EQ(
      run("fuzzy square.ply --from 36 --to 44 --by-distances --values d.txt -o d.ply --quiet").code,
      0);
  const std::vector<double> flow = numbers("f.txt"), detour = numbers("d.txt");
  ASSERT_EQ(flow.size(), 81u);
  ASSERT_EQ(detour.size(), 81u);
  EXPECT_NEAR(detour[40], 1., 1e-9); // no detour up to round-off errors
  EXPECT_GT(flow[40], 0.5);
  for(const std::size_t corner : {0u, 8u, 72u, 80u})
  {
    EXPECT_LT(flow[corner], 0.1);
    EXPECT_LT(detour[corner], 0.01);
  }
  EXPECT_EQ(run("fuzzy cloud.xyz --from 0 --to 11 --quiet").code, 0);

  expect_failure("fuzzy square.ply --from 0", 1, "--to");
  expect_failure("fuzzy square.ply --from 0 --to 0", 1, "different");
  expect_failure("fuzzy square.ply --from 0 --to 9 --width 0", 1, "--width");
  expect_failure("fuzzy square.ply --from 0 --to 99", 2, "99");
}

TEST_F(Program, volume_computes_distances_and_paths)
{
  // An octahedron with a vertex at 1 and at -1 on each axis.
  write("o.off", "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n"
                 "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n");
  const nlohmann::json pair =
      json("volume o.off --from 0.2,0,0 --to=-0.2,0,0 --bound-above -o v.ply --values v.txt");
  EXPECT_GE(pair["lower"].get<double>(), 0.4);
  EXPECT_LE(pair["lower"].get<double>(), pair["value"].get<double>());
  EXPECT_LE(pair["value"].get<double>(), pair["upper"].get<double>());
  EXPECT_LE(pair["upper"].get<double>(), pair["upper_continuous"].get<double>() * (1. + 1e-9));
  EXPECT_NE(read_file(m_folder / "v.ply").find("property double potential\n"), std::string::npos);
  // Each octahedron vertex has unit mass.
  EXPECT_NEAR(json("volume o.off --from 1,0,0 --to 0,1,0")["value"].get<double>(), std::sqrt(2.),
              2e-3);
  const nlohmann::json slice =
      json("volume o.off --from 0.2,0,0 --slice z,0.1 --slice x,2 --resolution 7 --values s.txt "
           "-o s.ply");
  EXPECT_EQ(slice["points"], 98); // 7 x 7 points, twice
  EXPECT_LE(slice["gap"].get<double>(), 0.02);
  EXPECT_GE(slice["max"].get<double>(), 2.);
  EXPECT_NE(read_file(m_folder / "s.ply").find("property double distance\n"), std::string::npos);
  const nlohmann::json path =
      json("volume o.off --from 0.4,0.1,0 --to=-0.4,0.1,0 --path -o p.obj --values p.txt");
  EXPECT_TRUE(path["arrives"]);
  EXPECT_GE(path["length"].get<double>(), 0.8);

  expect_failure("volume o.off --from 0,0,0", 1, "--to or --slice");
  expect_failure("volume o.off --from 0,0,0 --to 1,1,1 --slice z,0", 1, "--to or --slice");
  expect_failure("volume o.off --from 0,0 --to 1,1,1", 1, "x,y,z");
  expect_failure("volume o.off --from 0,0,0 --slice w,0", 1, "like z,0.5");
  for(const char* const slice : {"z,a", "z,", "z", "z,inf", "z,1,2"})
    expect_failure(std::string("volume o.off --from 0,0,0 --slice ") + slice, 1,
                   std::string("--slice ") + slice + ": a slice must be an axis and a number");
  expect_failure("volume o.off --from 0,0,0 --to 1,0,0 --tolerance 0", 1, "--tolerance");
  expect_failure("volume o.off --from 0,0,0 --to 3,0,0 --path", 2, "different sides");
  expect_failure("volume square.ply --from 0,0,0 --to 1,0,0", 2, "not closed");
  expect_failure("volume cloud.xyz --from 0,0,0 --to 1,0,0", 2, "closed mesh");
}

TEST_F(Program, feature_distance_matches_known_distances)
{
  const nlohmann::json border =
      json("feature-distance square.ply --border --values d.txt -o d.ply");
  const std::vector<double> distances = numbers("d.txt");
  ASSERT_EQ(distances.size(), 81u);
  EXPECT_EQ(distances[0], 0.);
  EXPECT_LE(border["max"].get<double>(), 0.5 * (1. + 1e-9)); // round-off errors
  EXPECT_NEAR(border["max"].get<double>(), 0.5,
              0.5 / 16.); // a fraction of an edge length at the crease
  EXPECT_NEAR(border["value"].get<double>(), 1. / 6., 0.01); // same error of the integral
  // The feature consists of all vertices except the boundary. A corner is as far as its nearest
  // interior vertex.
  EXPECT_NEAR(json("feature-distance d.ply --feature distance")["max"].get<double>(),
              std::sqrt(2.) / 8., 0.02);
  EXPECT_EQ(run("feature-distance cloud.xyz --feature 0,1 --quiet").code, 0);
  // For locations in faces, the distance is at most a fraction of the edge length 0.125 too short.
  EXPECT_NEAR(json("feature-distance square.ply --feature-at 0.52,0.33,0")["max"].get<double>(),
              std::hypot(0.52, 0.67), 0.05);
  EXPECT_NEAR(json("feature-distance square.ply --feature-path 0,44")["max"].get<double>(),
              2. / std::sqrt(5.), 0.01);
  EXPECT_NEAR(json("feature-distance square.ply --feature 72 --feature-path 0,44,8 --border")["max"]
                  .get<double>(),
              0.375, 0.05);

  expect_failure("feature-distance square.ply", 1, "--feature");
  expect_failure("feature-distance square.ply --feature 99", 2, "99");
  expect_failure("feature-distance cloud.xyz --border", 2, "no boundary");
  expect_failure("feature-distance cloud.xyz --feature-path 0,1", 2, "need a mesh");
}

TEST_F(Program, flatten_preserves_a_planar_square)
{
  for(const std::string method : {"glle", "mds", "lscm", "arap", "glle --injective"})
  {
    const nlohmann::json flat =
        json("flatten square.ply --values f.txt -o f.obj --base-points 30 --method " + method);
    EXPECT_EQ(flat["flips"], 0) << method;
    EXPECT_NEAR(flat["symmetric_dirichlet"].get<double>(), 4., 1e-6) << method;
    const std::vector<double> uv = numbers("f.txt");
    ASSERT_EQ(uv.size(), 162u);
    if(method == "lscm")
      continue; // the scale of these maps is arbitrary
    // The distance between opposite corners.
    EXPECT_NEAR(std::hypot(uv[160] - uv[0], uv[161] - uv[1]), std::sqrt(2.), 1e-4) << method;
  }
  EXPECT_EQ(json("flatten square.ply --base-points 30 --flat -o flat.ply")["flips"], 0);
  EXPECT_NEAR(json("info flat.ply")["area"].get<double>(), 1., 1e-4);
  EXPECT_EQ(json("flatten cloud.xyz --base-points 40 -o m.ply")["base_points"], 40);
  expect_failure("flatten square.ply --method flat", 1, "glle");
  expect_failure("flatten square.ply --base-points 2", 2, "between 3 and 1000");
  expect_failure("flatten cloud.xyz --injective", 2, "needs a mesh");
  expect_failure("flatten cloud.xyz --method lscm", 2, "needs a mesh");
  expect_failure("flatten closed.off --injective", 2, "no boundary");
  expect_failure("flatten apart.off", 2, "not connected");
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
  EXPECT_NEAR(json("info flat.obj")["area"], area, 1e-9);
}

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
    EXPECT_GE(*std::min_element(location + 1, location + 4), -1e-12);
    EXPECT_NEAR(location[1] + location[2] + location[3], 1., 1e-12);
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

TEST_F(Program, rejects_clouds_without_area)
{
  std::string equal;
  for(int i = 0; i < 50; ++i)
    equal += "1 2 3 0 0 1\n";
  write("0.xyz", "");
  write("1.xyz", "1 2 3 0 0 1\n");
  write("3.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n2 0 0 0 0 1\n");
  write("equal.xyz", equal);
  for(const std::string name : {"0.xyz", "1.xyz", "3.xyz", "equal.xyz"})
  {
    expect_failure("atlas " + name + " --number 2 -o a.glb --values v.txt", 2, name + ": ");
    for(const char* const command : {"base ", "semiregular "})
      expect_failure(command + name + " --number 9 -o a.ply --values v.txt", 2, name + ": ");
    for(const char* const command : {"emd ", "plan "})
      expect_failure(command + name + " --from 0 --to 0 --hodge -o a.ply", 2, name + ": ");
  }
  // Three surfels that are not collinear are a triangle.
  write("triangle.xyz", "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
  EXPECT_EQ(json("base triangle.xyz --number 3")["faces_out"], 1);
  EXPECT_EQ(json("atlas triangle.xyz --number 1")["charts"], 1);
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
  EXPECT_LT(last, 1e-3);
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

TEST_F(Program, logmap_writes_normal_coordinates)
{
  for(const char* const method : {"gradient", "exact"})
  {
    const nlohmann::json map = json("logmap square.ply --base 40 --up 0,1,0 --radius 0.4 --values "
                                    "m.txt -o m.vtp --method " +
                                    std::string(method));
    EXPECT_EQ(map["cut"], 0);
    EXPECT_EQ(map["folded_faces"], 0);
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
      EXPECT_NEAR(uv[2 * i], x, 1e-12);
      EXPECT_NEAR(uv[2 * i + 1], y, 1e-12);
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

TEST_F(Program, cloud_path_is_not_longer_than_initial_path)
{
  for(const char* const method : {"projected-quadrics", "projected-spheres", "projected-planes",
                                  "spheres", "robust-spheres", "planes", "disks"})
  {
    const nlohmann::json path = json("path cloud.xyz --from 5 --to 143 --start -o p.vtp "
                                     "--surfel-path-method " +
                                     std::string(method));
    EXPECT_LE(path["front_distance"], path["start_length"]);
    EXPECT_NEAR(path["front_distance"].get<double>(), std::hypot(6. / 11., 1.), 1e-3) << method;
  }
  EXPECT_LT(json("path cloud.xyz --from 5 --to 143 --control-points 3")["points"],
            json("path cloud.xyz --from 5 --to 143")["points"]);
}

TEST_F(Program, info_reports_topology_and_area)
{
  const nlohmann::json square = json("info square.ply");
  EXPECT_EQ(square["boundary_loops"], 1);
  EXPECT_EQ(square["genus"], 0);
  EXPECT_EQ(square["components"], 1);
  EXPECT_EQ(square["manifold"], true);
  EXPECT_EQ(square["repaired"], false);
  EXPECT_NEAR(square["area"].get<double>(), 1., 1e-14); // 128 round-off errors
  EXPECT_NEAR(square["min_angle"].get<double>(), 45., 1e-12);
  EXPECT_NEAR(square["max_angle"].get<double>(), 90., 1e-12);
  EXPECT_EQ(square["bounding_box"], nlohmann::json::parse("[[0,0,0],[1,1,0]]"));
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

TEST_F(Program, sample_reports_covering_radius)
{
  // The corners of a square with 9 x 9 vertices, which the file numbers row by row.
  const nlohmann::json four = json("sample square.ply --number 4 --values s.txt -o s.ply");
  EXPECT_EQ(four["samples"], 4);
  // Half of the diagonal.
  EXPECT_NEAR(four["covering_radius"].get<double>(), std::sqrt(0.5), 1e-12);
  std::istringstream lines(read_file(m_folder / "s.txt"));
  std::set<std::size_t> corners;
  for(std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::size_t vertex[3];
    double barycentric[3];
    words >> vertex[0] >> vertex[1] >> vertex[2] >> barycentric[0] >> barycentric[1] >>
        barycentric[2];
    ASSERT_TRUE(words);
    for(int k = 0; k < 3; ++k)
      if(barycentric[k] == 1.)
        corners.insert(vertex[k]);
  }
  EXPECT_EQ(corners, (std::set<std::size_t>{0, 8, 72, 80}));
  EXPECT_EQ(json("info s.ply")["vertices"], 4);
  EXPECT_EQ(json("info s.ply")["bounding_box"], nlohmann::json::parse("[[0,0,0],[1,1,0]]"));

  const nlohmann::json spaced = json("sample square.ply --spacing 0.3");
  EXPECT_LE(spaced["covering_radius"].get<double>(), 0.3);
  EXPECT_GT(spaced["samples"], 4);
  EXPECT_EQ(json("sample apart.off --number 1")["covering_radius"],
            nullptr); // one component has no sample

  EXPECT_EQ(json("sample cloud.xyz --number 5 --values s.txt -o s.ply")["samples"], 5);
  EXPECT_EQ(numbers("s.txt").size(), 5u); // surfels
  EXPECT_EQ(json("info s.ply")["vertices"], 5);
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

TEST_F(Program, results_are_independent_of_threads)
{
  for(const char* const command :
      {"distance cloud.xyz --source 5", "voronoi cloud.xyz --number 4",
       "sample cloud.xyz --number 4", "path cloud.xyz --from 0 --to 143",
       "matrix cloud.xyz --number 9", "matrix cloud.xyz --limit 0.2",
       "matrix square.ply --number 9 --method exact", "remesh square.ply --number 30 --lloyd 2",
       "atlas cloud.xyz --number 3", "base cloud.xyz --number 9"})
  {
    EXPECT_EQ(run(std::string(command) + " --threads 1 --values one.txt").code, 0);
    for(const char* const number_of_threads : {"0", "2", "7"})
    {
      EXPECT_EQ(
          run(std::string(command) + " --values more.txt --threads " + number_of_threads).code, 0);
      EXPECT_EQ(read_file(m_folder / "one.txt"), read_file(m_folder / "more.txt")) << command;
    }
  }
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
  EXPECT_NEAR(numbers("d.txt")[0], std::sqrt(0.5), 1e-12);
  json("distance square.ply --source-border --values d.txt");
  EXPECT_NEAR(numbers("d.txt")[40], 0.5, 1e-12);
  EXPECT_EQ(numbers("d.txt")[8], 0.);
  json("distance square.ply --source 0,80 --source-at 1,0,0 --values d.txt");
  const std::vector<double> values = numbers("d.txt");
  EXPECT_EQ(values[0] + values[80], 0.);
  EXPECT_NEAR(values[8], 0., 1e-12);
  EXPECT_NEAR(values[72], 1., 1e-12);
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
    json(std::string(
             "distance square.ply --source 0 --values s.txt --speed double_speed --method ") +
         method);
    json("distance square.ply --source 0 --values d.txt --method fast-marching");
    const std::vector<double> fast = numbers("s.txt"), plain = numbers("d.txt");
    for(std::size_t i = 0; i < 81; ++i)
      EXPECT_NEAR(2. * fast[i], plain[i], 1e-12) << method;
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

TEST_F(Program, distances_and_paths_cross_nonmanifold_vertices)
{
  for(const char* const name : {"pinched.off", "bowtie.off"})
  {
    const nlohmann::json result =
        json(std::string("distance ") + name + " --source 1 --values d.txt");
    EXPECT_EQ(result["unreached"], 0) << name;
    const std::size_t other = std::string(name) == "bowtie.off" ? 4 : 3;
    EXPECT_NEAR(numbers("d.txt")[other], 2., 1e-12) << name;
    const nlohmann::json path =
        json(std::string("path ") + name + " --from 1 --to " + std::to_string(other));
    EXPECT_NEAR(path["length"].get<double>(), 2., 1e-12) << name;
  }
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

TEST_F(Program, path_on_a_square_is_straight)
{
  const nlohmann::json corner_path = json("path square.ply --from 0 --to 80 --values p.txt");
  EXPECT_NEAR(corner_path["length"].get<double>(), std::sqrt(2.), 1e-12);
  EXPECT_NEAR(corner_path["front_distance"].get<double>(), std::sqrt(2.), 1e-12);
  const std::vector<double> points = numbers("p.txt");
  EXPECT_EQ(points.size(), 3 * corner_path["points"].get<std::size_t>());
  EXPECT_EQ((std::vector<double>(points.begin(), points.begin() + 3)),
            (std::vector<double>{0, 0, 0}));
  EXPECT_EQ((std::vector<double>(points.end() - 3, points.end())), (std::vector<double>{1, 1, 0}));

  const nlohmann::json inner_path =
      json("path square.ply --from-at 0.1,0.2,0 --to-at 0.9,0.3,1 -o p.vtp");
  EXPECT_NEAR(inner_path["length"].get<double>(), std::hypot(0.8, 0.1), 1e-12);
  EXPECT_EQ(json("info p.vtp")["vertices"], inner_path["points"]);
  EXPECT_EQ(json("path square.ply --from 3 --to 3")["length"], 0.);

  for(const char* const method : {"dijkstra", "fast-marching", "euclidean", "heat"})
  {
    const nlohmann::json path =
        json(std::string("path square.ply --from 9 --to 71 --method ") + method);
    // Paths are straightened, whatever distances they follow.
    EXPECT_NEAR(path["length"].get<double>(), std::hypot(1., 0.75), 1e-12) << method;
  }
  // These distances are the method's own. Dijkstra passes 6 diagonals and 2 edges.
  EXPECT_NEAR(
      json("path square.ply --from 9 --to 71 --method dijkstra")["front_distance"].get<double>(),
      (6. * std::sqrt(2.) + 2.) / 8., 1e-12);
  const nlohmann::json exact =
      json("path square.ply --from-at 0.1,0.2,0 --to-at 0.9,0.3,1 --method exact");
  EXPECT_NEAR(exact["length"].get<double>(), std::hypot(0.8, 0.1), 1e-12);
  EXPECT_NEAR(exact["front_distance"].get<double>(), std::hypot(0.8, 0.1), 1e-12);
}

TEST_F(Program, path_on_a_cloud_joins_endpoints)
{
  const nlohmann::json path = json("path cloud.xyz --from 0 --to 143 --values p.txt");
  // On a flat grid, the path is at least as long as the straight line and at most 1 % longer.
  EXPECT_GE(path["length"].get<double>(), std::sqrt(2.) * (1. - 1e-12));
  EXPECT_LE(path["length"].get<double>(), std::sqrt(2.) * 1.01);
  const std::vector<double> points = numbers("p.txt");
  ASSERT_GE(points.size(), 6u);
  EXPECT_NEAR(points[0] + points[1], 0., 1e-12);
  EXPECT_NEAR(points[points.size() - 3] + points[points.size() - 2], 2., 1e-12);
}

TEST_F(Program, voronoi_labels_nearest_seed)
{
  const nlohmann::json result = json("voronoi square.ply --seeds 0,80 --values l.txt");
  EXPECT_EQ(result["seeds"], nlohmann::json::parse("[0,80]"));
  const std::vector<double> labels = numbers("l.txt");
  ASSERT_EQ(labels.size(), 81u);
  for(int i = 0; i < 81; ++i)
    if(i % 9 + i / 9 != 8) // vertices on the bisector may have either label
    {
      EXPECT_EQ(labels[static_cast<std::size_t>(i)], i % 9 + i / 9 > 8 ? 1. : 0.);
    }
}

TEST_F(Program, segment_makes_charts_of_equal_size)
{
  // A square with 8 x 8 cells of two triangles each.
  const nlohmann::json result =
      json("segment square.ply --number 4 --discs --values l.txt -o charts.ply");
  EXPECT_EQ(result["charts"], 4);
  EXPECT_EQ(result["unreached"], 0);
  const std::vector<double> energies = result["energies"];
  EXPECT_TRUE(std::is_sorted(energies.rbegin(), energies.rend()));
  EXPECT_EQ(energies.back(), result["energy"]);
  const std::vector<double> labels = numbers("l.txt");
  ASSERT_EQ(labels.size(), 128u);
  for(const double label : {0., 1., 2., 3.})
  {
    // A quarter has 32 faces. Each chart has its center in one quarter and a boundary that follows
    // edges.
    EXPECT_GE(std::count(labels.begin(), labels.end(), label), 22);
    EXPECT_LE(std::count(labels.begin(), labels.end(), label), 42);
  }
  // If the mesh is cut along the chart boundaries, the charts are four components of genus zero.
  const nlohmann::json charts = json("info charts.ply");
  EXPECT_EQ(charts["components"], 4);
  EXPECT_EQ(charts["boundary_loops"], 4);
  EXPECT_EQ(charts["faces"], 128);

  // The isolated vertex and components without a center belong to no chart.
  EXPECT_EQ(json("segment apart.off --number 2")["unreached"], 0);
  EXPECT_GT(json("segment apart.off --number 1")["unreached"], 0);
  EXPECT_EQ(json("segment cloud.xyz --number 5 --values c.txt")["charts"], 5);
  EXPECT_EQ(numbers("c.txt").size(), 144u);
}

TEST_F(Program, voronoi_seeds_cover_every_component)
{
  const nlohmann::json two = json("voronoi apart.off --number 2 --values l.txt");
  EXPECT_EQ(two["unreached"], 1); // the isolated vertex gets no seed
  std::set<bool> components;
  for(const std::size_t seed : two["seeds"].get<std::vector<std::size_t>>())
    components.insert(seed < 3);
  EXPECT_EQ(components.size(), 2u);
  EXPECT_EQ(numbers("l.txt")[6], -1.);
  EXPECT_EQ(json("voronoi apart.off --number 100")["seeds"].size(), 6u);
  write("one.xyz", "1 2 3\n1 2 3\n");
  EXPECT_EQ(json("voronoi one.xyz --number 5")["seeds"].size(), 1u);
}

TEST_F(Program, voronoi_seeds_are_far_apart)
{
  for(const char* const name : {"square.ply", "cloud.xyz"})
  {
    const auto seeds = json(std::string("voronoi ") + name + " --number 5 --seed 7")["seeds"]
                           .get<std::vector<std::size_t>>();
    ASSERT_EQ(seeds.size(), 5u);
    const std::size_t n = name == std::string("square.ply") ? 9 : 12;
    for(std::size_t i = 0; i < 5; ++i)
      for(std::size_t j = 0; j < i; ++j)
      {
        const auto x = [n](std::size_t s) { return static_cast<double>(s % n) / (n - 1.); };
        const auto y = [n](std::size_t s) { return static_cast<double>(s / n) / (n - 1.); };
        // Five points in a square can be 0.7 apart. Farthest point sampling achieves at least half
        // of this.
        EXPECT_GE(std::hypot(x(seeds[i]) - x(seeds[j]), y(seeds[i]) - y(seeds[j])), 0.35);
      }
    EXPECT_EQ(json(std::string("voronoi ") + name + " --number 5 --seed 7")["seeds"], seeds);
  }
}

TEST_F(Program, matrix_has_all_pairs)
{
  const std::vector<int> vertices = {80, 3, 40, 11};
  for(const char* const method : {"euclidean", "exact", "fast-marching", "dijkstra", "heat"})
  {
    const nlohmann::json result = json(
        std::string("matrix square.ply --sources 80,3,40,11 --values m.txt -o m.mtx --method ") +
        method);
    EXPECT_EQ(result["rows"], 4);
    EXPECT_EQ(result["entries"], 16);
    EXPECT_EQ(result["sources"], nlohmann::json(vertices));
    const std::string text = read_file(m_folder / "m.txt");
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
    const std::vector<double> values = numbers("m.txt");
    ASSERT_EQ(values.size(), 16u);
    // Same tolerances as in distance_on_a_square_is_euclidean.
    const double tolerance = std::string(method)[0] == 'e' ? 1e-12 : 0.12;
    for(std::size_t i = 0; i < 4; ++i)
      for(std::size_t j = 0; j < 4; ++j)
      {
        const int p = vertices[i], q = vertices[j];
        EXPECT_NEAR(values[4 * i + j], std::hypot(p % 9 - q % 9, p / 9 - q / 9) / 8., tolerance)
            << method << ' ' << p << ' ' << q;
      }

    // The same numbers in column-major order.
    std::istringstream market(read_file(m_folder / "m.mtx"));
    std::string head;
    std::getline(market, head);
    EXPECT_EQ(head, "%%MatrixMarket matrix array real general");
    std::size_t rows = 0, columns = 0;
    market >> rows >> columns;
    EXPECT_EQ(rows, 4u);
    EXPECT_EQ(columns, 4u);
    for(std::size_t j = 0; j < 4; ++j)
      for(std::size_t i = 0; i < 4; ++i)
      {
        double value = -1.;
        market >> value;
        EXPECT_EQ(value, values[4 * i + j]);
      }
    EXPECT_TRUE(market);
  }
}

TEST_F(Program, matrix_limit_keeps_near_pairs)
{
  for(const char* const method : {"euclidean", "exact"})
  {
    const nlohmann::json result = json(
        std::string("matrix square.ply --limit 0.3 --values m.txt -o m.mtx --method ") + method);
    EXPECT_EQ(result["rows"], 81);
    const std::vector<double> values = numbers("m.txt");
    ASSERT_EQ(values.size(), 3 * result["entries"].get<std::size_t>());
    // Row, column and distance of each pair within the limit, in order.
    auto value = values.begin();
    for(int i = 0; i < 81; ++i)
      for(int j = 0; j < 81; ++j)
      {
        const double straight = std::hypot(i % 9 - j % 9, i / 9 - j / 9) / 8.;
        if(straight > 0.3)
          continue;
        ASSERT_GE(values.end() - value, 3);
        EXPECT_EQ(*value++, i);
        EXPECT_EQ(*value++, j);
        EXPECT_NEAR(*value++, straight, 1e-12);
      }
    EXPECT_EQ(value, values.end());

    std::istringstream market(read_file(m_folder / "m.mtx"));
    std::string head;
    std::getline(market, head);
    EXPECT_EQ(head, "%%MatrixMarket matrix coordinate real general");
    std::size_t rows = 0, columns = 0, entries = 0;
    market >> rows >> columns >> entries;
    EXPECT_EQ(rows, 81u);
    EXPECT_EQ(columns, 81u);
    EXPECT_EQ(entries, result["entries"].get<std::size_t>());
    for(std::size_t i = 0; i < entries; ++i)
    {
      double row = 0., column = 0., distance = -1.;
      market >> row >> column >> distance;
      EXPECT_EQ(row, values[3 * i] + 1.);
      EXPECT_EQ(column, values[3 * i + 1] + 1.);
      EXPECT_EQ(distance, values[3 * i + 2]);
    }
    EXPECT_TRUE(market);
  }
  // Rows and columns are numbered in the order of the sources.
  EXPECT_EQ(json("matrix square.ply --sources 80,0,1 --limit 0.3 --values m.txt")["entries"], 5);
  EXPECT_EQ(numbers("m.txt"),
            (std::vector<double>{0, 0, 0, 1, 1, 0, 1, 2, 0.125, 2, 1, 0.125, 2, 2, 0}));
}

TEST_F(Program, matrix_has_infinity_between_components)
{
  EXPECT_EQ(json("matrix apart.off --sources 0,1,3,6 --values m.txt")["entries"], 6);
  EXPECT_EQ(numbers("m.txt"),
            (std::vector<double>{0, 1, INFINITY, INFINITY, 1, 0, INFINITY, INFINITY, INFINITY,
                                 INFINITY, 0, INFINITY, INFINITY, INFINITY, INFINITY, 0}));
  // Only pairs within the limit: 3 x 3 in both triangles, and the isolated vertex with itself.
  EXPECT_EQ(json("matrix apart.off --limit 10")["entries"], 19);
}

TEST_F(Program, matrix_and_voronoi_choose_same_vertices)
{
  for(const char* const name : {"square.ply", "cloud.xyz", "apart.off"})
    EXPECT_EQ(json(std::string("matrix ") + name + " --number 5 --seed 7")["sources"],
              json(std::string("voronoi ") + name + " --number 5 --seed 7")["seeds"]);
}

TEST_F(Program, picture_fails_early_without_display)
{
  const Run_result result = run("distance square.ply --source 0 --picture a.png --quiet");
  if(result.code == 0)
  {
    EXPECT_EQ(read_file(m_folder / "a.png").substr(1, 3), "PNG");
    for(const char* const command :
        {"voronoi square.ply --number 3", "path square.ply --from 0 --to 80", "info cloud.xyz",
         "distance cloud.xyz --source 0", "voronoi cloud.xyz --number 3",
         "matrix square.ply --number 3", "matrix square.ply --limit 0.2",
         "matrix cloud.xyz --sources 0,7 --limit 0.2"})
    {
      EXPECT_EQ(run(std::string(command) + " --picture b.png --quiet").code, 0) << command;
      EXPECT_GT(fs::file_size(m_folder / "b.png"), 1000u) << command;
      fs::remove(m_folder / "b.png");
    }
    EXPECT_EQ(run("distance cloud.xyz --source 0 -o d.ply --quiet").code, 0);
    EXPECT_EQ(run("info d.ply --property distance --picture b.png --quiet").code, 0);
    expect_failure("info d.ply --property other --picture b.png", 2, "'other'");
    const auto shown = [&](const std::string& options)
    {
      EXPECT_EQ(run("info square.ply --picture b.png --quiet" + options).code, 0);
      return read_file(m_folder / "b.png");
    };
    EXPECT_NE(shown(" --sides"), shown(""));
    expect_failure("info cloud.xyz --sides --picture b.png", 1, "--sides");
  }
  // Without a display server or without VTK, the program fails before it reads a file.
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  ::unsetenv("DISPLAY");
  expect_failure("distance nowhere.ply --source 0 --picture c.png", 1, "--picture");
  ::setenv("PATH", path.c_str(), 1);
}

TEST_F(Program, accepts_non_ascii_file_names)
{
  fs::copy_file(m_folder / "closed.off", m_folder / "a b \xc3\xa9.off");
  EXPECT_EQ(json("info 'a b \xc3\xa9.off' -o 'c d.ply'")["vertices"], 4);
  EXPECT_TRUE(fs::exists(m_folder / "c d.ply"));
}

} // namespace program_test
