// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Command line, exit codes and output that all commands share.
#include "Program.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>

namespace usage_test {

using namespace program_test;

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
  expect_failure("distance square.ply --source 0 --method heat --heat-time-step 0", 1, "positive");
  expect_failure("distance square.ply --source 0 --heat-time-step 2", 1, "only the method heat");
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
  expect_failure("matrix square.ply --number 2 --float32 -o a.mtx", 1, "need a .npy file");
  expect_failure("matrix square.ply --average -o a.npy", 1, "needs --regions");
  expect_failure("matrix square.ply --rows 3 -o a.npy", 1, "is not a range");
  expect_failure("matrix square.ply --rows 3:82 -o a.npy", 1, "has only 81 rows");
  expect_failure("matrix square.ply --values a.txt -o a.npy", 1, "cannot be combined");
  expect_failure("matrix square.ply --method spectral -o a.npy", 1, "does not support .npy");
  expect_failure("matrix square.ply --regions none.txt -o a.npy", 2, "none.txt");
  expect_failure("merge-matrices --part square.ply -o a.npy", 3, "it is not a .npy file");
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

// Returns the first word of each entry of a help text after a title. Entries are indented by two
// characters.
std::set<std::string> entries_of_help(const std::string& help, const std::string& title)
{
  std::set<std::string> result;
  std::istringstream lines(help.substr(std::min(help.find(title), help.size())));
  for(std::string line, word; std::getline(lines, line);)
    if(line.find_first_not_of(' ') == 2 && std::istringstream(line) >> word)
      result.insert(word);
  return result;
}

TEST_F(Program, manual_page_has_all_commands_and_options)
{
  const Run_result page = run("--manual-page");
  EXPECT_EQ(page.code, 0);
  EXPECT_EQ(page.out.rfind(".TH GEODESIC 1 ", 0), 0u);

  const std::set<std::string> commands = entries_of_help(run("--help").out, "Subcommands:");
  EXPECT_EQ(commands.count("distance") + commands.count("view"), 2u);
  for(const std::string& command : commands)
    EXPECT_NE(page.out.find("\n.SS " + command + '\n'), std::string::npos) << command;

  const std::set<std::string> options = entries_of_help(run("distance --help").out, "Options:");
  EXPECT_EQ(options.count("--source") + options.count("-o,--output"), 2u);
  for(const std::string& option : options)
  {
    std::string label;
    for(const char c : option)
      label += c == '-' ? "\\-" : std::string(1, c);
    EXPECT_NE(page.out.find("\n.B \\&" + label), std::string::npos) << option;
  }
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
  expect_keys("info square.ply",
              {"components", "boundary_loops", "genus", "manifold", "area", "min_angle",
               "max_angle", "bounding_box", "diagonal", "degenerate_faces"});
  expect_keys("info cloud.xyz", {"components", "bounding_box", "diagonal"});
  expect_keys("distance square.ply --source 0", {"max", "unreached"});
  expect_keys("distance cloud.xyz --source 0", {"max", "unreached"});
  expect_keys("isolines square.ply --source 0", {"lines", "closed", "length"});
  expect_keys("loops square.ply", {"loops", "lengths", "length"});
  expect_keys("ball square.ply --source 40 --radius 0.3",
              {"area", "faces_inside", "circles", "length"});
  expect_keys("diameter square.ply", {"lower", "upper", "from", "to", "converged", "iterations"});
  expect_keys("diameter square.ply --radius",
              {"lower", "upper", "from", "to", "converged", "iterations", "radius_lower",
               "radius_upper", "center", "radius_converged", "radius_iterations"});
  expect_keys("curve square.ply --points 0,8,80", {"length", "points"});
  expect_keys("path square.ply --from 0 --to 80", {"length", "front_distance", "lower", "points"});
  expect_keys("path cloud.xyz --from 0 --to 143",
              {"length", "front_distance", "lower", "points", "start_length"});
  expect_keys("logmap square.ply --base 40", {"values", "cut", "flips"});
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
  expect_keys("karcher-mean square.ply --points 0,80",
              {"mean", "value", "gradient_norm", "converged", "iterations"});
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

} // namespace usage_test
