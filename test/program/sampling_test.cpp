// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The commands sample, voronoi, segment and matrix.
#include "Program.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace sampling_test {

using namespace program_test;

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

// Returns the numbers of a .npy file; its header must have the given shape.
std::vector<double> numpy_numbers(const std::string& bytes, const std::string& shape,
                                  bool is_single = false)
{
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
  EXPECT_NE(bytes.find("'shape': " + shape + ","), std::string::npos);
  const std::size_t begin = bytes.find('\n') + 1, size = is_single ? 4 : 8;
  std::vector<double> result;
  for(std::size_t i = begin; i + size <= bytes.size(); i += size)
  {
    float single = 0.f;
    double number = 0.;
    std::memcpy(is_single ? static_cast<void*>(&single) : &number, bytes.data() + i, size);
    result.push_back(is_single ? single : number);
  }
  return result;
}

TEST_F(Program, matrix_of_all_vertices_is_file_of_numpy)
{
  const nlohmann::json result = json("matrix square.ply --method exact -o m.npy");
  EXPECT_EQ(result["rows"], 81);
  EXPECT_EQ(result["columns"], 81);
  EXPECT_FALSE(std::filesystem::exists(m_folder / "m.npy.tiles"));
  const std::vector<double> d = numpy_numbers(read_file(m_folder / "m.npy"), "(81, 81)");
  ASSERT_EQ(d.size(), 81u * 81u);
  // Same tolerance as in distance_on_a_square_is_euclidean.
  for(int p = 0; p < 81; ++p)
    for(int q = 0; q < 81; ++q)
      EXPECT_NEAR(d[std::size_t(81 * p + q)], std::hypot(p % 9 - q % 9, p / 9 - q / 9) / 8., 1e-12);

  // Parts of the rows, in single precision, are merged.
  json("matrix square.ply --method exact --float32 --rows 0:30 -o a.npy");
  json("matrix square.ply --method exact --float32 --rows 30:81 -o b.npy");
  expect_failure("merge-matrices --part b.npy -o c.npy", 3, "c.npy: the rows 0:30 are in no part.");
  EXPECT_EQ(run("merge-matrices --part b.npy --part a.npy -o c.npy").code, 0);
  const std::vector<double> single = numpy_numbers(read_file(m_folder / "c.npy"), "(81, 81)", true);
  ASSERT_EQ(single.size(), d.size());
  for(std::size_t i = 0; i < d.size(); ++i)
    EXPECT_EQ(single[i], double(float(d[i])));
}

TEST_F(Program, matrix_joins_columns_of_regions)
{
  // The region of a vertex is its column in the square; column 8 is in none.
  std::string regions;
  for(int i = 0; i < 81; ++i)
    regions += std::to_string(i % 9 == 8 ? -1 : i % 9) + '\n';
  std::ofstream(m_folder / "regions.txt") << regions;
  EXPECT_EQ(json("matrix square.ply --method exact --sources 0,40 --regions regions.txt -o m.npy")
                ["columns"],
            8);
  const std::vector<double> nearest = numpy_numbers(read_file(m_folder / "m.npy"), "(2, 8)");
  json("matrix square.ply --method exact --sources 0,40 --regions regions.txt --average -o m.npy");
  const std::vector<double> mean = numpy_numbers(read_file(m_folder / "m.npy"), "(2, 8)");
  ASSERT_EQ(mean.size(), 16u);
  ASSERT_EQ(nearest.size(), 16u);
  for(int row = 0; row < 2; ++row)
    for(int column = 0; column < 8; ++column)
    {
      const int x = row == 0 ? 0 : 4, y = row == 0 ? 0 : 4;
      double sum = 0.;
      for(int k = 0; k < 9; ++k)
        sum += std::hypot(x - column, y - k) / 8.;
      EXPECT_NEAR(nearest[std::size_t(8 * row + column)], std::abs(x - column) / 8., 1e-12);
      EXPECT_NEAR(mean[std::size_t(8 * row + column)], sum / 9., 1e-12);
    }
}

TEST_F(Program, matrix_file_that_cannot_be_written_is_named)
{
  expect_failure("matrix square.ply -o missing/m.npy", 3, "missing/m.npy");
  std::filesystem::create_directory(m_folder / "d.npy");
  expect_failure("matrix square.ply -o d.npy", 3, "d.npy: it exists and is not a regular file.");
  std::ofstream(m_folder / "m.npy.tiles") << "notes\n";
  expect_failure("matrix square.ply -o m.npy", 3, "m.npy.tiles: it is not a record");
  std::ofstream(m_folder / "n.npy.unfinished") << "some notes\n";
  expect_failure("matrix square.ply -o n.npy", 3, "n.npy.unfinished: it exists and is not");
  // A file without a record is replaced.
  std::ofstream(m_folder / "o.npy") << "notes\n";
  EXPECT_EQ(json("matrix square.ply --sources 1,2 -o o.npy")["rows"], 2);
  EXPECT_EQ(numpy_numbers(read_file(m_folder / "o.npy"), "(2, 2)").size(), 4u);
}

TEST_F(Program, matrix_has_distances_between_regions)
{
  std::string regions;
  for(int i = 0; i < 81; ++i)
    regions += std::to_string(i % 9 == 8 ? -1 : i % 9) + '\n';
  std::ofstream(m_folder / "regions.txt") << regions;
  const std::string command =
      "matrix square.ply --method exact --regions regions.txt --between-regions -o m.npy";
  EXPECT_EQ(json(command)["rows"], 8);
  const std::vector<double> nearest = numpy_numbers(read_file(m_folder / "m.npy"), "(8, 8)");
  json(command + " --average --rows 2:4");
  const std::vector<double> mean = numpy_numbers(read_file(m_folder / "m.npy"), "(2, 8)");
  ASSERT_EQ(nearest.size(), 64u);
  ASSERT_EQ(mean.size(), 16u);
  for(int r = 0; r < 8; ++r)
    for(int c = 0; c < 8; ++c)
    {
      EXPECT_NEAR(nearest[std::size_t(8 * r + c)], std::abs(r - c) / 8., 1e-12);
      double sum = 0.;
      for(int i = 0; i < 9; ++i)
        for(int j = 0; j < 9; ++j)
          sum += std::hypot(r - c, i - j) / 8.;
      if(r == 2 || r == 3)
      {
        EXPECT_NEAR(mean[std::size_t(8 * (r - 2) + c)], sum / 81., 1e-12);
      }
    }
  expect_failure("matrix square.ply --between-regions -o n.npy", 1, "needs --regions");
  expect_failure("matrix square.ply --regions regions.txt --between-regions --number 3 -o n.npy", 1,
                 "excludes --sources and --number");
  expect_failure(command + " --rows 2:9", 1, "the matrix has only 8 rows");
}

TEST_F(Program, matrix_rejects_regions_that_are_no_indices_below_number_of_vertices)
{
  ASSERT_EQ(run("distance square.ply --source 0 -o d.ply").code, 0);
  expect_failure("matrix d.ply --regions distance -o m.npy", 2, "is not a region at a vertex");
  std::ofstream(m_folder / "regions.txt") << "81\n";
  expect_failure("matrix square.ply --regions regions.txt -o m.npy", 2,
                 "line 1: the region is not smaller than the number of vertices");
  std::ofstream(m_folder / "regions.txt") << "0\n1\n";
  expect_failure("matrix square.ply --regions regions.txt -o m.npy", 2,
                 "the number of regions is 2, but the number of vertices is 81");
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
        EXPECT_NEAR(*value++, straight, round_off);
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

} // namespace sampling_test
