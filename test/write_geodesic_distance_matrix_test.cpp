// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/write_geodesic_distance_matrix.h>

#include <CGAL/Geodesic_processing/Soup_domain.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace write_geodesic_distance_matrix_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Write_geodesic_distance_matrix : testing::Test
{
  std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                 (std::string("write_matrix_") +
                                  testing::UnitTest::GetInstance()->current_test_info()->name());
  std::string path = (folder / "m.npy").string(), record = path + ".tiles",
              unfinished = path + ".unfinished";
  Triangulation plane = square(8, 0.24);
  Mesh mesh = mesh_of(plane);
  std::vector<Vertex> vertices{mesh.vertices().begin(), mesh.vertices().end()};

  Write_geodesic_distance_matrix()
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~Write_geodesic_distance_matrix() override { std::filesystem::remove_all(folder); }

  std::string bytes(const std::string& file) const
  {
    std::ostringstream result;
    result << std::ifstream(file, std::ios::binary).rdbuf();
    return result.str();
  }
  // Reads the numbers behind the header.
  template <typename Number = double>
  Eigen::MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) const
  {
    const std::string content = bytes(path);
    const std::size_t size = std::size_t(rows * columns) * sizeof(Number);
    Eigen::MatrixXd result(rows, columns);
    EXPECT_GE(content.size(), size);
    EXPECT_EQ((content.size() - size) % 64, 0u);
    for(Eigen::Index i = 0; i < rows; ++i)
      for(Eigen::Index j = 0; j < columns; ++j)
      {
        Number number;
        std::memcpy(&number,
                    content.data() + content.size() - size +
                        std::size_t(i * columns + j) * sizeof(Number),
                    sizeof(Number));
        result(i, j) = number;
      }
    return result;
  }

  template <typename Method, typename Surface, typename Vertices>
  void expect_same_as_in_memory(const Surface& surface, const Vertices& queries)
  {
    const Eigen::MatrixXd expected = GP::geodesic_distance_matrix<Method>(surface, queries);
    const auto small = GP::parameters::tile_size(1000);
    GP::write_geodesic_distance_matrix<Method>(surface, queries, path, small);
    EXPECT_EQ(matrix(expected.rows(), expected.cols()), expected);
    GP::write_geodesic_distance_matrix<Method, CGAL::Parallel_tag>(surface, queries, path,
                                                                   small.number_of_threads(3));
    EXPECT_EQ(matrix(expected.rows(), expected.cols()), expected);
    GP::write_geodesic_distance_matrix<Method, CGAL::Sequential_tag, float>(surface, queries, path);
    EXPECT_EQ(matrix<float>(expected.rows(), expected.cols()),
              expected.cast<float>().cast<double>());
    EXPECT_FALSE(std::filesystem::exists(record));
  }
};

TEST_F(Write_geodesic_distance_matrix, equals_matrix_in_memory)
{
  expect_same_as_in_memory<GP::Automatic>(mesh, vertices);
  expect_same_as_in_memory<GP::Dijkstra>(mesh, vertices);

  Numbered<CGAL::Polyhedron_3<Kernel>> polyhedron;
  fill(polyhedron, plane);
  expect_same_as_in_memory<GP::Fast_marching>(polyhedron.mesh, polyhedron.vertices);

  const Surfels surfels = sphere_surfels(2);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  expect_same_as_in_memory<GP::Automatic>(GP::make_domain(surfels, maps),
                                          std::vector<std::size_t>{4, 100, 0, 77});

  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  for(const Point& p : plane.points)
    points.emplace_back(p[0], p[1], p[2]);
  for(std::size_t i = 0; i < plane.corners.size(); i += 3)
    polygons.push_back({plane.corners[i], plane.corners[i + 1], plane.corners[i + 2]});
  expect_same_as_in_memory<GP::Euclidean_front>(GP::make_domain(points, polygons), vertices);
}

TEST_F(Write_geodesic_distance_matrix, contains_distances_in_plane)
{
  GP::write_geodesic_distance_matrix<GP::Exact>(mesh, vertices, path,
                                                GP::parameters::maximum_distance(0.5));
  const auto n = Eigen::Index(vertices.size());
  const Eigen::MatrixXd d = matrix(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
    for(Eigen::Index j = 0; j < n; ++j)
    {
      const double truth = distance(plane.points[i], plane.points[j]);
      if(truth <= 0.5)
        EXPECT_NEAR(d(i, j), truth, 1e-12); // sums of some tens of lengths
      else
        EXPECT_EQ(d(i, j), infinity);
    }
}

TEST_F(Write_geodesic_distance_matrix, joins_columns_of_regions)
{
  // Every fifth vertex is in no region, and region 3 has no vertex.
  std::vector<int> region;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    region.push_back(i % 5 == 0 ? -1 : i % 5 == 3 ? 4 : int(i % 5));
  const auto map = GP::parameters::region_map(CGAL::make_property_map(region));
  const Eigen::MatrixXd d = GP::geodesic_distance_matrix<GP::Exact>(mesh, vertices);
  GP::write_geodesic_distance_matrix<GP::Exact>(mesh, vertices, path, map);
  const Eigen::MatrixXd minimum = matrix(d.rows(), 5);
  GP::write_geodesic_distance_matrix<GP::Exact>(mesh, vertices, path, map.do_average_regions(true));
  const Eigen::MatrixXd mean = matrix(d.rows(), 5);
  for(Eigen::Index i = 0; i < d.rows(); ++i)
    for(int r = 0; r < 5; ++r)
    {
      double smallest = infinity, sum = 0.;
      int count = 0;
      for(Eigen::Index j = 0; j < d.cols(); ++j)
        if(region[std::size_t(j)] == r)
        {
          smallest = std::min(smallest, d(i, j));
          sum += d(i, j);
          ++count;
        }
      EXPECT_EQ(minimum(i, r), smallest);
      EXPECT_EQ(mean(i, r), count == 0 ? infinity : sum / count);
    }

  // Targets that are not reached make the mean infinite, but not the minimum.
  GP::write_geodesic_distance_matrix<GP::Exact>(
      mesh, std::vector<Vertex>{vertices[1]}, path,
      map.targets(vertices).maximum_distance(0.1).do_average_regions(true));
  EXPECT_EQ(matrix(1, 5)(0, 1), infinity);
  GP::write_geodesic_distance_matrix<GP::Exact>(mesh, std::vector<Vertex>{vertices[1]}, path,
                                                map.targets(vertices).maximum_distance(0.1));
  EXPECT_EQ(matrix(1, 5)(0, 1), 0.);
}

TEST_F(Write_geodesic_distance_matrix, joins_rows_of_regions)
{
  // The regions are the columns of the square, whose distance is that of their lines.
  const double size = 8.;
  std::vector<int> column;
  for(const Point& p : square(8).points)
    column.push_back(int(std::lround(size * p[0])));
  const Mesh regular = mesh_of(square(8));
  const auto map = CGAL::make_property_map(column);
  const auto maps = GP::parameters::region_map(map).row_region_map(map);
  GP::write_geodesic_distance_matrix<GP::Exact>(regular, vertices, path, maps);
  const Eigen::MatrixXd minimum = matrix(9, 9);
  GP::write_geodesic_distance_matrix<GP::Exact>(regular, vertices, path,
                                                maps.do_average_regions(true));
  const Eigen::MatrixXd mean = matrix(9, 9);
  for(int r = 0; r < 9; ++r)
    for(int c = 0; c < 9; ++c)
    {
      EXPECT_NEAR(minimum(r, c), std::abs(r - c) / size, 1e-14); // round-off
      double sum = 0.;
      for(std::size_t i = 0; i < vertices.size(); ++i)
        for(std::size_t j = 0; j < vertices.size(); ++j)
          if(column[i] == r && column[j] == c)
            sum += distance(square(8).points[i], square(8).points[j]);
      EXPECT_NEAR(mean(r, c), sum / 81., 1e-13);
    }

  // The range of rows is one of regions.
  GP::write_geodesic_distance_matrix<GP::Exact>(
      regular, vertices, path, maps.row_range(std::pair<std::size_t, std::size_t>(2, 4)));
  EXPECT_EQ(matrix(2, 9), minimum.middleRows(2, 2));
  EXPECT_THROW(
      GP::write_geodesic_distance_matrix<GP::Exact>(
          regular, vertices, path, maps.row_range(std::pair<std::size_t, std::size_t>(2, 10))),
      GP::Invalid_argument_error);

  // From regions to vertices.
  GP::write_geodesic_distance_matrix<GP::Exact>(regular, vertices, path,
                                                GP::parameters::row_region_map(map));
  const Eigen::MatrixXd fields = matrix(9, Eigen::Index(vertices.size()));
  for(int r = 0; r < 9; ++r)
    for(std::size_t j = 0; j < vertices.size(); ++j)
      EXPECT_NEAR(fields(r, Eigen::Index(j)), std::abs(r - column[j]) / size, 1e-14);
}

// The process is killed in the middle, and the next call continues.
TEST_F(Write_geodesic_distance_matrix, continues_after_kill)
{
  const auto four_rows = GP::parameters::tile_size(4 * 8 * vertices.size());
  GP::write_geodesic_distance_matrix<GP::Fast_marching>(mesh, vertices, path + ".expected",
                                                        four_rows);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if(child == 0)
  {
    const auto kill_in_the_middle = [](double fraction)
    {
      if(fraction > 0.6)
        kill(getpid(), SIGKILL);
      return true;
    };
    GP::write_geodesic_distance_matrix<GP::Fast_marching>(
        mesh, vertices, path, four_rows.callback(std::function<bool(double)>(kill_in_the_middle)));
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
  ASSERT_TRUE(std::filesystem::exists(record));
  EXPECT_FALSE(std::filesystem::exists(path)); // because it is not complete
  EXPECT_EQ(bytes(unfinished).size(), bytes(path + ".expected").size());
  EXPECT_NE(bytes(unfinished), bytes(path + ".expected"));
  EXPECT_THROW(GP::merge_distance_matrices(std::vector<std::string>{path}, path + ".merged"),
               GP::File_error);

  // Another surface or other arguments do not continue it.
  const Mesh other_mesh = mesh_of(square(8, 0.25));
  EXPECT_THROW(
      GP::write_geodesic_distance_matrix<GP::Fast_marching>(other_mesh, vertices, path, four_rows),
      GP::File_error);
  EXPECT_THROW(GP::write_geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices, path, four_rows),
               GP::File_error);
  EXPECT_THROW((GP::write_geodesic_distance_matrix<GP::Fast_marching, CGAL::Sequential_tag, float>(
                   mesh, vertices, path, four_rows)),
               GP::File_error);
  EXPECT_THROW(
      GP::write_geodesic_distance_matrix<GP::Fast_marching>(
          mesh, vertices, path, four_rows.region_map(CGAL::Constant_property_map<Vertex, int>(0))),
      GP::File_error);

  double first_fraction = 2.;
  const std::function<bool(double)> callback = [&](double fraction)
  {
    first_fraction = std::min(first_fraction, fraction);
    return true;
  };
  GP::write_geodesic_distance_matrix<GP::Fast_marching, CGAL::Parallel_tag>(
      mesh, vertices, path, four_rows.callback(callback).number_of_threads(2));
  EXPECT_GT(first_fraction, 0.5);
  EXPECT_EQ(bytes(path), bytes(path + ".expected"));
  EXPECT_FALSE(std::filesystem::exists(record));
  EXPECT_FALSE(std::filesystem::exists(unfinished));
}

TEST_F(Write_geodesic_distance_matrix, rejects_second_writer)
{
  bool is_rejected = false;
  const std::function<bool(double)> write_again = [&](double)
  {
    EXPECT_THROW(GP::write_geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices, path),
                 GP::File_error);
    is_rejected = true;
    return true;
  };
  GP::write_geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices, path,
                                                   GP::parameters::callback(write_again));
  EXPECT_TRUE(is_rejected);
  EXPECT_EQ(matrix(Eigen::Index(vertices.size()), Eigen::Index(vertices.size())),
            GP::geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices));
}

// The largest number of 32 bits is about 3.4e38.
TEST_F(Write_geodesic_distance_matrix, rejects_distances_too_large_for_float)
{
  for(Point& p : plane.points)
    for(double& x : p)
      x *= 1e39;
  const Mesh large = mesh_of(plane);
  const std::vector<Vertex> one = {vertices[0]};
  EXPECT_THROW((GP::write_geodesic_distance_matrix<GP::Exact, CGAL::Sequential_tag, float>(
                   large, vertices, path)),
               GP::Invalid_argument_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  GP::write_geodesic_distance_matrix<GP::Exact>(large, vertices, path);
  EXPECT_GT(matrix(Eigen::Index(vertices.size()), Eigen::Index(vertices.size())).maxCoeff(), 1e39);
  // Infinity has its own number.
  GP::write_geodesic_distance_matrix<GP::Exact, CGAL::Sequential_tag, float>(
      large, one, path, GP::parameters::maximum_distance(0.).targets(vertices));
  EXPECT_EQ(matrix<float>(1, Eigen::Index(vertices.size())).maxCoeff(), infinity);
}

template <typename Number>
using Row_major = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

TEST_F(Write_geodesic_distance_matrix, writes_to_memory)
{
  std::vector<int> region;
  for(std::size_t i = 0; i < vertices.size(); ++i)
    region.push_back(int(i % 5) - 1);
  const auto map = CGAL::make_property_map(region);
  const auto n = Eigen::Index(vertices.size());
  const auto expect_same = [&](Eigen::Index rows, Eigen::Index columns, const auto& np)
  {
    GP::write_geodesic_distance_matrix(mesh, vertices, path, np);
    const Eigen::MatrixXd expected = matrix(rows, columns);
    Row_major<double> doubles(rows, columns);
    GP::write_geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(mesh, vertices, doubles,
                                                                      np.number_of_threads(2));
    EXPECT_EQ(doubles, expected);
    // The rows of a map can have gaps, which remain.
    std::vector<float> memory(std::size_t(rows * (columns + 1)), -1.f);
    Eigen::Map<Row_major<float>, 0, Eigen::OuterStride<>> floats(memory.data(), rows, columns,
                                                                 Eigen::OuterStride<>(columns + 1));
    GP::write_geodesic_distance_matrix(mesh, vertices, floats, np);
    EXPECT_EQ(Row_major<float>(floats), Row_major<float>(expected.cast<float>()));
    for(Eigen::Index i = 0; i < rows; ++i)
      EXPECT_EQ(memory[std::size_t((i + 1) * (columns + 1) - 1)], -1.f);
  };
  const auto all = GP::parameters::maximum_distance(2.);
  expect_same(n, n, all);
  expect_same(n, n, all.maximum_distance(0.3));
  expect_same(2, n, all.row_range(std::pair<std::size_t, std::size_t>(3, 5)));
  expect_same(n, 4, all.region_map(map));
  expect_same(4, n, all.row_region_map(map));
  expect_same(4, 4, all.region_map(map).row_region_map(map));
  expect_same(4, 4, all.region_map(map).row_region_map(map).do_average_regions(true));
  using Map = std::decay_t<decltype(map)>;
  expect_same(n, 4, all.region_map(std::optional<Map>(map)).row_region_map(std::optional<Map>()));
}

TEST_F(Write_geodesic_distance_matrix, rejects_matrix_of_wrong_size)
{
  const auto n = Eigen::Index(vertices.size());
  for(const auto& [rows, columns] : {std::pair(n, n - 1), std::pair(n + 1, n)})
  {
    Row_major<double> wrong(rows, columns);
    EXPECT_THROW(GP::write_geodesic_distance_matrix(mesh, vertices, wrong),
                 GP::Invalid_argument_error);
  }
  Row_major<double> result(n, n);
  const std::function<bool(double)> cancel = [](double fraction) { return fraction < 0.5; };
  EXPECT_THROW(
      GP::write_geodesic_distance_matrix(mesh, vertices, result, GP::parameters::callback(cancel)),
      GP::Cancelled);
}

TEST_F(Write_geodesic_distance_matrix, continues_after_cancellation)
{
  const auto small = GP::parameters::tile_size(1);
  GP::write_geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices, path + ".expected", small);
  const std::function<bool(double)> cancel = [](double fraction) { return fraction < 0.5; };
  EXPECT_THROW(GP::write_geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices, path,
                                                                small.callback(cancel)),
               GP::Cancelled);
  EXPECT_TRUE(std::filesystem::exists(record));
  GP::write_geodesic_distance_matrix<GP::Dijkstra>(mesh, vertices, path, small);
  EXPECT_EQ(bytes(path), bytes(path + ".expected"));
}

TEST_F(Write_geodesic_distance_matrix, parts_are_merged)
{
  GP::write_geodesic_distance_matrix(mesh, vertices, path + ".expected");
  std::vector<std::string> parts;
  const std::size_t n = vertices.size();
  const auto merge = [&] { GP::merge_distance_matrices(parts, path); };
  for(const std::pair<std::size_t, std::size_t>& rows :
      {std::pair(std::size_t(0), n / 3), std::pair(n / 3, n - 1), std::pair(n - 1, n)})
  {
    parts.push_back(path + std::to_string(parts.size()));
    GP::write_geodesic_distance_matrix(mesh, vertices, parts.back(),
                                       GP::parameters::row_range(rows));
  }
  std::reverse(parts.begin(), parts.end());
  merge();
  EXPECT_EQ(bytes(path), bytes(path + ".expected"));
  GP::write_geodesic_distance_matrix(mesh_of(square(8, 0.25)), vertices, parts[0],
                                     GP::parameters::row_range(std::pair(n - 1, n)));
  EXPECT_THROW(merge(), GP::File_error); // because it is of another surface
  parts.erase(parts.begin());
  EXPECT_THROW(merge(), GP::File_error); // because the last row is missing
  EXPECT_THROW(GP::write_geodesic_distance_matrix(
                   mesh, vertices, path,
                   GP::parameters::row_range(std::pair<std::size_t, std::size_t>(2, n + 1))),
               GP::Invalid_argument_error);
}

} // namespace write_geodesic_distance_matrix_test
