// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checker of the mass test reports each invariant if it is violated.
#include "check_results.h"

#include "mesh_properties.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include <unistd.h>

namespace check_results_test {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>; // by name

// The correct results for the unit square of two triangles. All values are closed forms.
Files square_results(const std::string& surface)
{
  const std::string square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  const std::string diagonal = "1.4142135623730951";
  Files files;
  files["square.off"] = square;
  files["file"] = surface + "\n";
  files["target"] = "2\n";
  for(const char* const command : {"info", "exact", "front", "path", "sample", "voronoi", "segment",
                                   "remesh", "semiregular", "flatten", "atlas", "emd"})
    files["runs"] += std::string(command) + "\t0\t0.1\t0\t\n";
  files["info.json"] =
      R"({"kind": "mesh", "repaired": false, "vertices": 4, "faces": 2, "components": 1,)"
      R"( "boundary_loops": 1, "genus": 0, "manifold": true, "area": 1.0,)"
      R"( "degenerate_faces": 0})";
  files["info.txt"] = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  for(const std::string command : {"exact", "front"})
  {
    files[command + ".json"] = R"({"unreached": 0})";
    files[command + ".txt"] = "0\n1\n" + diagonal + "\n1\n";
  }
  files["path.json"] = R"({"length": )" + diagonal + R"(, "lower": )" + diagonal + "}";
  files["path.txt"] = "0 0 0\n0.5 0.5 0\n1 1 0\n";
  files["sample.json"] = R"({"samples": 3, "covering_radius": 0.5})";
  files["sample.txt"] = "0 1 2 1 0 0\n0 1 2 0 0 1\n0 2 3 0.5 0 0.5\n";
  files["voronoi.json"] = R"({"seeds": [0, 2], "unreached": 0})";
  files["voronoi.txt"] = "0\n0\n1\n1\n";
  files["segment.json"] = R"({"charts": 2, "energies": [2.0, 1.0]})";
  files["segment.txt"] = "0\n1\n";
  for(const std::string command : {"remesh", "semiregular"})
  {
    files[command + ".json"] =
        R"({"vertices_out": 4, "faces_out": 2, "self_intersections": 0, "folds": 0})";
    files[command + ".off"] = square;
  }
  files["flatten.json"] = R"({"flips": 0})";
  files["flatten.off"] = square;
  files["atlas.json"] = R"({"flips": 0, "overlaps": 0, "coverage": 1.0, "texels_per_length": 512})";
  files["atlas.obj"] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                       "f 1/1 2/2 3/3\nf 1/1/1 3/3/1 4/4/1\n";
  files["emd.json"] = R"({"lower": 1.414, "value": 1.4142, "upper": 1.4144,)"
                      R"( "upper_continuous": 1.5, "converged": true})";
  return files;
}

class Check_results : public ::testing::Test
{
protected:
  ~Check_results() override { fs::remove_all(m_folder); }

  Files good_results() const { return square_results((m_folder / "square.off").string()); }

  std::vector<std::string> check(const Files& files) const
  {
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
    for(const auto& [name, text] : files)
      std::ofstream(m_folder / name) << text;
    return mass_test::check_results(m_folder);
  }

private:
  const fs::path m_folder =
      fs::temp_directory_path() / ("check_results_" + std::to_string(getpid()));
};

TEST_F(Check_results, correct_results_have_no_violation)
{
  EXPECT_EQ(check(good_results()), std::vector<std::string>());
}

TEST_F(Check_results, refusal_with_one_sentence_is_no_violation)
{
  Files files = good_results();
  files["runs"] = "info\t2\t0.1\t1\tgeodesic: square.off: The file is empty.\n";
  EXPECT_EQ(check(files), std::vector<std::string>());
}

// Areas of a surface with large coordinates overflow, and the program writes null.
TEST_F(Check_results, areas_can_overflow)
{
  Files files = good_results();
  const auto replace =
      [&](const std::string& file, const std::string& text, const std::string& replacement)
  { files[file].replace(files[file].find(text), text.size(), replacement); };
  replace("info.json", "1.0", "null");
  EXPECT_EQ(check(files).size(), 1u);
  replace("info.json", "\"degenerate_faces\": 0",
          "\"degenerate_faces\": 0, \"bounding_box\": [[0, 0, 0], [1e155, 1e155, 0]]");
  EXPECT_EQ(check(files), std::vector<std::string>());
}

struct Change
{
  std::string file, text, replacement; // the first occurrence of the text is replaced
  std::string violation;               // one of the lines that follow from the change
};

// Each invariant, violated once
const std::vector<Change> changes = {
    {"runs", "emd\t0\t0.1\t0\t", "emd\t2\t0.1\t2\tNo.",
     "emd\tthe program does not print exactly one sentence when it returns 2"},
    {"runs", "emd\t0\t0.1\t0\t", "emd\t2\t0.1\t1\tno",
     "emd\tthe program does not print exactly one sentence when it returns 2"},
    {"emd.json", "}", "", "emd\tstandard output is not a JSON object"},
    {"emd.json", "1.4142", "null", "emd\tthe number \"value\" is not finite"},
    {"segment.json", "[2.0, 1.0]", "[null, 1.0]", "segment\tthe number \"energies\" is not finite"},
    {"emd.json", "lower", "low", "emd\tthe JSON object has no number \"lower\""},

    {"info.json", "\"vertices\": 4", "\"vertices\": 5",
     "info\tthe number of vertices differs from the number of points"},
    {"info.json", "\"faces\": 2", "\"faces\": 3",
     "info\tthe surface has 3 faces, and CGAL reads 2"},
    {"info.json", "true", "false", "info\tthe surface is not a manifold, but it is for CGAL"},
    {"square.off", "3 0 1 2", "3 0 2 1", "info\tthe surface is a manifold, but not for CGAL"},
    {"info.json", "\"genus\": 0", "\"genus\": 1",
     "info\tthe surface has 1 components, 1 boundary cycles and genus 1, and CGAL computes 1, 1 "
     "and 0"},

    {"exact.txt", "0\n1", "0\nnan", "exact\tline 2 of the values has a number that is not finite"},
    {"exact.txt", "0\n1", "0\n1 1", "exact\tline 2 of the values does not have 1 numbers"},
    {"exact.txt", "0\n1", "0\none", "exact\tline 2 of the values does not have 1 numbers"},
    {"exact.txt", "0\n1\n", "0\n",
     "exact\tthe number of distances differs from the number of vertices"},
    {"exact.txt", "0", "0.5", "exact\tthe distance of the source is 0.5"},
    {"exact.txt", "0\n1", "0\n-1", "exact\tthe distance of vertex 1 is negative"},
    {"exact.json", "0", "1", "exact\t0 vertices are unreached, and the JSON has another number"},
    {"exact.txt", "1.4142135623730951", "1.375",
     "exact\tthe distance of vertex 2 is 1.375, but its straight distance is 1.4142135623730951"},
    {"exact.txt", "1.4142135623730951", "1.5",
     "exact\tthe distance of vertex 2 is 1.5, but a path along edges has the length "
     "1.4142135623730951"},

    {"front.txt", "0\n1", "0\ninf",
     "front\tthe distance of vertex 1 is inf, but the exact distance is 1"},
    // The errors of three vertices are 0, 0 and 75 %.
    {"front.txt", "0\n1", "0\n1.75", "front\tthe mean relative error is 0.25"},

    {"path.json", "\"length\": 1.4142135623730951", "\"length\": 1.5",
     "path\tthe length is 1.5, but its lower bound is 1.4142135623730951"},
    {"path.json", "\"length\": 1.4142135623730951", "\"length\": 1.5",
     "path\tthe length is 1.5, but the exact distance is 1.4142135623730951"},
    {"path.json", "\"length\": 1.4142135623730951", "\"length\": 1.5",
     "path\tthe length is 1.5, but the segments have the length 1.4142135623730951"},
    {"path.json", "\"length\": 1.4142135623730951", "\"length\": 1.25",
     "path\tthe length is 1.25, but the straight distance is 1.4142135623730951"},
    {"path.txt", "1 1 0", "1 0 0", "path\tthe path does not join vertex 0 and vertex 2"},
    {"path.txt", "0.5 0.5", "0.5 inf",
     "path\tline 2 of the values has a number that is not finite"},

    {"sample.txt", "0 1 2 1 0 0", "0 1 4 1 0 0", "sample\tsample 0 is not on the surface"},
    {"sample.txt", "0.5 0 0.5", "1.5 0 -0.5", "sample\tsample 2 is not on the surface"},
    {"sample.txt", "0.5 0 0.5", "0.5 0 0.25",
     "sample\tthe barycentric coordinates of sample 2 have the sum 0.75"},
    {"sample.txt", "0 2 3 0.5 0 0.5", "0 2 3 1 0 0", "sample\ttwo samples are equal"},
    {"sample.json", "3", "4", "sample\tthe JSON has another number of samples than the values"},
    {"sample.json", "0.5", "null",
     "sample\tthe covering radius is infinite, but there are 3 samples on 1 components"},
    {"sample.json", "0.5", "-0.5", "sample\tthe covering radius is negative"},

    {"voronoi.txt", "0\n0", "0",
     "voronoi\tthe number of labels differs from the number of vertices"},
    {"voronoi.txt", "0\n0", "0\n2", "voronoi\tthe label of vertex 1 is 2"},
    {"voronoi.txt", "0\n0", "0\n-1",
     "voronoi\t1 vertices have no label, and the JSON has another number"},
    {"voronoi.txt", "0\n0", "0\n-1",
     "voronoi\t1 vertices have no label, but there are 2 seeds on 1 components"},
    {"voronoi.txt", "0\n0", "1\n0", "voronoi\tthe seed at vertex 0 has the label 1"},

    {"segment.txt", "1", "2", "segment\tthe label of a face is 2"},
    {"segment.json", "1.0", "2.5", "segment\tstep 1 increases the energy from 2 to 2.5"},

    {"remesh.off", "OFF", "", "remesh\tCGAL cannot read the mesh"},
    {"remesh.off", "1 1 0", "nan 1 0", "remesh\tCGAL cannot read the mesh"},
    {"remesh.json", "4", "5",
     "remesh\tthe mesh has 4 vertices and 2 faces, and the JSON has other numbers"},
    {"remesh.off", "3 0 1 2", "3 0 2 1", "remesh\tthe mesh is not a manifold"},
    {"remesh.off", "1 0 0", "1 1 0", "remesh\t1 faces have two corners at the same point"},
    // The two triangles cross.
    {"remesh.off", "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3",
     "6 2 0\n0 0 0\n2 0 0\n0 2 0\n0.5 0.5 -1\n0.5 0.5 1\n2 2 0\n3 0 1 2\n3 3 4 5",
     "remesh\tthe mesh intersects itself, but not according to the JSON"},
    // A single triangle and a point
    {"semiregular.off", "3 0 1 2", "3 0 2 3", "semiregular\tthe mesh is not a manifold"},
    {"semiregular.off", "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3",
     "4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2",
     "semiregular\tthe mesh has 1 components, 0 boundary cycles and genus 0, and the input 1, 1 "
     "and 0"},

    {"semiregular.json", "\"folds\": 0", "\"folds\": 1", "semiregular\t1 triangles are inverted"},

    {"flatten.off", "OFF", "", "flatten\tthe flat mesh does not have one point for each vertex"},
    {"flatten.off", "1 0 0", "0 2 0",
     "flatten\t1 faces are inverted and 0 are degenerate, but the JSON has 0 flips"},
    {"flatten.json", "0", "1",
     "flatten\t0 faces are inverted and 0 are degenerate, but the JSON has 1 flips"},

    {"atlas.obj", "1/1 2/2 3/3", "1 2 3",
     "atlas\tthe OBJ file has no triangles with texture coordinates"},
    {"atlas.obj", "vt 1 0", "vt 1.5 0",
     "atlas\tthe texture coordinates 1.5 0 are not in the unit square"},
    {"atlas.obj", "v 1 0 0", "v 2 0 0",
     "atlas\tthe faces have the area 1.5, but the surface has the area 1"},
    {"atlas.json", "1.0", "0.5",
     "atlas\tthe faces cover 1 of the texture, but the JSON has the coverage 0.5"},
    // Half of the surface covers 1/256 of the texture instead of 1/2. Charts of few vertices can
    // be 50 times as small.
    {"atlas.obj", "f 1/1/1 3/3/1 4/4/1", "vt 0 0.875\nvt 0.0625 0.875\nvt 0 1\nf 1/5 3/6 4/7",
     "atlas\tthe area of a chart exceeds its limits by the factor 2.5600000000000001"},
    {"atlas.obj", "1/1 2/2 3/3", "1/1 2/3 3/2",
     "atlas\t1 faces are not counterclockwise, and the JSON has another number"},
    {"atlas.obj", "1/1 2/2 3/3", "1/1 2/3 3/2", "atlas\t1 faces are not counterclockwise"},
    {"atlas.json", "\"overlaps\": 0", "\"overlaps\": 1", "atlas\t1 charts overlap themselves"},
    {"atlas.obj", "3/3/1 4/4/1", "3/2/1 4/4/1", "atlas\tthe faces 0 and 1 overlap in the texture"},

    {"emd.json", "1.4142", "1.4145",
     "emd\tthe value 1.4145000000000001 is not between 1.4139999999"
     "999999 and 1.4144000000000001"},
    {"emd.json", "true", "false",
     "emd\tthe method does not converge: the bounds are 1.4139999999999999 and 1.4144000000000001"},
    {"emd.json", "1.4144", "1.5",
     "emd\tthe gap between 1.4139999999999999 and 1.5 exceeds the "
     "tolerance"},
    {"emd.json", "1.414,", "1.4375,",
     "emd\tthe lower bound 1.4375 exceeds the exact distance 1.4142135623730951"},
    {"emd.json", "\"upper_continuous\": 1.5", "\"upper_continuous\": 1.25",
     "emd\tthe upper bound on the surface 1.25 is below the exact distance 1.4142135623730951"},
};

TEST_F(Check_results, each_violated_invariant_is_reported)
{
  for(const Change& change : changes)
  {
    SCOPED_TRACE(change.violation);
    Files files = good_results();
    std::string& text = files[change.file];
    const std::size_t position = text.find(change.text);
    ASSERT_NE(position, std::string::npos);
    text.replace(position, change.text.size(), change.replacement);
    const std::vector<std::string> violations = check(files);
    EXPECT_NE(std::find(violations.begin(), violations.end(), change.violation), violations.end())
        << "reported: "
        << std::accumulate(violations.begin(), violations.end(), std::string(),
                           [](std::string all, const std::string& line)
                           { return all + '\n' + line; });
  }
}

// The lower bound of a path is smaller by the heights of triangles without area. Here the longest
// edges of both triangles have the length 2.
TEST_F(Check_results, degenerate_triangles_decrease_the_lower_bound_of_a_path)
{
  const std::string line = "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0.5 0 0\n3 0 1 2\n3 0 2 3\n";
  const std::string atlas = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0.5 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 "
                            "2/2 3/3\nf 1/1 3/2 4/3\n";
  const auto path_violations = [&](const std::string& lower, const std::string& atlas_runs)
  {
    Files files = good_results();
    files["square.off"] = line;
    files["runs"] = "info\t0\t0.1\t0\t\npath\t0\t0.1\t0\t\n" + atlas_runs;
    files["info.txt"] = "0 0 0\n1 0 0\n2 0 0\n0.5 0 0\n";
    files["path.json"] = R"({"length": 2.0, "lower": )" + lower + "}";
    files["path.txt"] = "0 0 0\n2 0 0\n";
    files["atlas.obj"] = atlas;
    std::vector<std::string> violations = check(files);
    violations.erase(std::remove_if(violations.begin(), violations.end(),
                                    [](const std::string& line)
                                    { return line.rfind("path", 0) != 0; }),
                     violations.end());
    return violations;
  };
  // With and without the triangles of an atlas
  for(const std::string runs : {"atlas\t0\t0.1\t0\t\n", ""})
  {
    EXPECT_EQ(path_violations("1.9999997", runs), std::vector<std::string>());
    EXPECT_EQ(path_violations("1.9999995", runs),
              std::vector<std::string>{
                  "path\tthe length is 2, but its lower bound is 1.9999994999999999"});
  }
}

// The exact distance can differ from the length of a path by the same heights: 2e-7 for each of the
// two triangles.
TEST_F(Check_results, degenerate_triangles_change_exact_distances)
{
  const auto violations = [&](const std::string& distance)
  {
    Files files = good_results();
    files["square.off"] = "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n0.5 0 0\n3 0 1 2\n3 0 2 3\n";
    files["runs"] = "info\t0\t0.1\t0\t\nexact\t0\t0.1\t0\t\npath\t0\t0.1\t0\t\n";
    files["info.txt"] = "0 0 0\n1 0 0\n2 0 0\n0.5 0 0\n";
    files["exact.txt"] = "0\n1\n" + distance + "\n0.5\n";
    files["path.json"] = R"({"length": 2.0, "lower": 2.0})";
    files["path.txt"] = "0 0 0\n2 0 0\n";
    std::vector<std::string> result = check(files);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [](const std::string& line) {
                                  return line.find("but the exact distance") == std::string::npos;
                                }),
                 result.end());
    return result;
  };
  EXPECT_TRUE(violations("2.0000003").empty());
  EXPECT_EQ(violations("2.0000005").size(), 1u);
}

// Vertex 4 is on the edge between the vertices 0 and 2, or at a distance h of it. Its image is on
// the other side of this edge, so that a face of the height h is inverted.
TEST_F(Check_results, flips_of_faces_without_area_need_not_be_reported)
{
  const auto violations = [&](const std::string& point, const std::string& flips)
  {
    const auto mesh = [](const std::string& last)
    { return "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + last + "\n3 0 1 2\n3 0 2 4\n3 0 4 3\n"; };
    Files files = good_results();
    files["square.off"] = mesh(point);
    files["runs"] = "info\t0\t0.1\t0\t\nflatten\t0\t0.1\t0\t\n";
    files["info.txt"] = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + point + "\n";
    files["flatten.json"] = R"({"flips": )" + flips + "}";
    files["flatten.off"] = mesh("0.5 0.499 0");
    std::vector<std::string> result = check(files);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [](const std::string& line)
                                { return line.rfind("flatten", 0) != 0; }),
                 result.end());
    return result;
  };
  for(const std::string flips : {"0", "1"})
    EXPECT_EQ(violations("0.5 0.5 0", flips), std::vector<std::string>()) << flips;
  EXPECT_EQ(violations("0.5 0.5 0", "2").size(), 1u);
  // A height of 1e-6
  EXPECT_EQ(violations("0.5 0.500001 0", "0").size(), 1u);
  EXPECT_EQ(violations("0.5 0.500001 0", "1"), std::vector<std::string>());
}

// Vertex 3 is at the point of vertex 0. The edge between them has the minimum length of the
// library, 2^-36 of half of the extent, which is 1.46e-11.
TEST_F(Check_results, edges_of_length_zero_have_a_minimum_length)
{
  const auto violations = [&](const std::string& distance)
  {
    Files files = good_results();
    files["square.off"] = "OFF\n4 2 0\n0 0 0\n2 0 0\n0 2 0\n0 0 0\n3 0 1 2\n3 0 3 1\n";
    files["runs"] = "info\t0\t0.1\t0\t\nexact\t0\t0.1\t0\t\n";
    files["info.txt"] = "0 0 0\n2 0 0\n0 2 0\n0 0 0\n";
    files["exact.txt"] = "0\n2\n2\n" + distance + "\n";
    std::vector<std::string> result = check(files);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [](const std::string& line)
                                { return line.find("along edges") == std::string::npos; }),
                 result.end());
    return result;
  };
  EXPECT_TRUE(violations("1.45e-11").empty());
  EXPECT_EQ(violations("1.46e-11").size(), 1u);
}

TEST(Mesh_properties, faces_between_touching_faces_are_not_degenerate)
{
  using namespace mass_test;
  // Two triangles that share an edge only geometrically: a slit.
  const Soup slit = {
      {{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {1., 0., 0.}, {0., 0., 0.}, {1., -1., 0.}},
      {{0, 1, 2}, {3, 4, 5}}};
  EXPECT_TRUE(touches_itself_at(slit, {0.25, 0., 0.}));
  EXPECT_FALSE(touches_itself_at(slit, {0.25, 0.25, 0.}));
  EXPECT_FALSE(touches_itself_at(slit, {2., 2., 2.}));
  // The same triangles with a common edge.
  const Soup joined = {slit.points, {{0, 1, 2}, {1, 0, 5}}};
  EXPECT_FALSE(touches_itself_at(joined, {0.25, 0., 0.}));
  EXPECT_FALSE(touches_itself_at(joined, {0., 0., 0.}));
  // Two faces of a sheet without thickness, which have two common edges.
  const Soup sheet = {{{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}, {0., 1., 0.}},
                      {{0, 1, 2, 3}, {2, 1, 0, 3}}};
  EXPECT_TRUE(touches_itself_at(sheet, {0.25, 0.25, 0.}));
  EXPECT_FALSE(touches_itself_at(sheet, {0.25, 0., 0.}));

  const Soup across = {{{0.25, 0., 0.}, {0.25, 0., 0.}, {0., 1., 0.}}, {{0, 1, 2}}};
  EXPECT_EQ(number_of_degenerate_faces(across, slit), 0u);
  EXPECT_EQ(number_of_degenerate_faces(across, joined), 1u);
}

// CGAL reads no faces from a PLY file with triangle strips.
TEST_F(Check_results, triangle_strips_are_no_violation)
{
  Files files = good_results();
  files["square.ply"] = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                        "property float y\nproperty float z\nelement tristrips 1\n"
                        "property list int int vertex_indices\nend_header\n"
                        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 1 2 0 3\n";
  const std::string folder = files["file"].substr(0, files["file"].rfind('/'));
  files["file"] = folder + "/square.ply\n";
  EXPECT_EQ(check(files), std::vector<std::string>());
}

// The faces have no area. The sums of their areas are round-off errors.
TEST_F(Check_results, areas_can_differ_by_round_off_errors)
{
  Files files = good_results();
  files["runs"] = "info\t0\t0.1\t0\t\natlas\t0\t0.1\t0\t\n";
  const std::string area = "\"area\": 1.0";
  files["info.json"].replace(files["info.json"].find(area), area.size(), "\"area\": 1e-17");
  files["atlas.obj"] = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                       "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
  for(const std::string& line : check(files))
    EXPECT_EQ(line.find("but the surface has the area"), std::string::npos) << line;
}

// A large triangle contains a small one: no edge of one crosses an edge of the other.
TEST_F(Check_results, face_inside_of_another_face_is_an_overlap)
{
  Files files = good_results();
  files["atlas.obj"] = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                       "vt 0.25 0.25\nvt 0.5 0.25\nvt 0.25 0.5\nf 1/1 2/2 3/3\nf 1/4 3/5 4/6\n";
  files["atlas.json"] =
      R"({"flips": 0, "overlaps": 0, "coverage": 0.53125, "texels_per_length": 512})";
  EXPECT_EQ(check(files),
            std::vector<std::string>{"atlas\tthe faces 0 and 1 overlap in the texture"});
}

} // namespace check_results_test
