// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/write_distance_matrix.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/distances/distance_matrix.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace write_distance_matrix_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using test::Array_surface;

constexpr double scale = 3.;

struct Write_distance_matrix : testing::Test
{
  std::string path = (std::filesystem::temp_directory_path() /
                      (std::string("write_distance_matrix_") +
                       testing::UnitTest::GetInstance()->current_test_info()->name()))
                         .string();
  Array_surface surface{test::square(4)};
  std::vector<internal::Front_source> from;
  std::vector<internal::Surface_location> to;
  Matrix_regions thirds, halves; // of the vertices, with vertices without region and empty regions

  Write_distance_matrix()
  {
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      to.push_back({none, vertex, {}});
      from.push_back({{to.back()}, 0., vertex});
      thirds.region.push_back(vertex % 5 == 0 ? none : vertex % 3);
      halves.region.push_back(vertex % 7 == 0 ? none : 2 * (vertex % 2));
    }
    thirds.number_of_regions = halves.number_of_regions = 3;
  }
  ~Write_distance_matrix() override { std::filesystem::remove(path); }

  // Writes a matrix in tiles of `tile_rows` rows and reads it.
  template <typename Engine>
  Eigen::MatrixXd written(const Engine& engine, const Matrix_job& job, unsigned number_of_threads,
                          std::size_t tile_rows = 1, const Front_limits& limits = {})
  {
    const std::size_t rows = job.number_of_rows(), columns = job.number_of_columns();
    const Matrix_layout layout = {rows, columns, Number_format::float64, 0, rows};
    Matrix_file file(path, layout, tile_rows * layout.row_size(), {});
    if(!write_distance_matrix(&engine, scale, job, limits, number_of_threads, file))
    {
      file.discard();
      return {};
    }
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string content = bytes.str();
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(
        static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
    const std::size_t size = rows * columns * sizeof(double);
    std::memcpy(result.data(), content.data() + content.size() - size, size);
    return result;
  }

  // Returns the minima or means of a matrix between regions.
  static Eigen::MatrixXd joined(const Eigen::MatrixXd& distances, const Matrix_regions& rows,
                                const Matrix_regions& columns, bool do_average)
  {
    Eigen::MatrixXd result = Eigen::MatrixXd::Constant(Eigen::Index(rows.number_of_regions),
                                                       Eigen::Index(columns.number_of_regions), 0.);
    for(Eigen::Index r = 0; r < result.rows(); ++r)
      for(Eigen::Index c = 0; c < result.cols(); ++c)
      {
        double sum = 0., smallest = infinity;
        int count = 0;
        for(Eigen::Index i = 0; i < distances.rows(); ++i)
        {
          double row_sum = 0.;
          for(Eigen::Index j = 0; j < distances.cols(); ++j)
            if(rows.region[std::size_t(i)] == Index(r) &&
               columns.region[std::size_t(j)] == Index(c))
            {
              row_sum += distances(i, j);
              smallest = std::min(smallest, distances(i, j));
              ++count;
            }
          sum += row_sum;
        }
        result(r, c) = count > 0 && do_average ? sum / count : smallest;
      }
    return result;
  }

  template <typename Engine>
  void expect_rows_match(const Engine& engine)
  {
    const Matrix_job job{from, to};
    const Eigen::MatrixXd expected = distance_matrix(&engine, scale, from, to, {}, 1);
    for(const unsigned threads : {1u, 2u, 5u})
      for(const std::size_t tile_rows : {1u, 2u, 100u})
        EXPECT_EQ(written(engine, job, threads, tile_rows), expected);
  }
};

TEST_F(Write_distance_matrix, equals_matrix_in_memory)
{
  expect_rows_match(Front(surface.triangles(), Front_kind::euclidean));
  expect_rows_match(Window_propagation(surface.triangles()));
  expect_rows_match(Heat_solver(surface.triangles()));
}

TEST_F(Write_distance_matrix, has_means_between_regions)
{
  const Window_propagation engine(surface.triangles());
  const Eigen::MatrixXd distances = distance_matrix(&engine, scale, from, to, {}, 1);
  const Matrix_job job{from, to, halves, thirds, true};
  const Eigen::MatrixXd expected = joined(distances, halves, thirds, true);
  EXPECT_EQ(expected(1, 0), infinity); // an empty region
  for(const unsigned threads : {1u, 2u, 5u})
    for(const std::size_t tile_rows : {1u, 2u, 100u})
      EXPECT_EQ(written(engine, job, threads, tile_rows), expected);
}

TEST_F(Write_distance_matrix, has_minima_between_regions)
{
  const Window_propagation engine(surface.triangles());
  const Eigen::MatrixXd distances = distance_matrix(&engine, scale, from, to, {}, 1);
  const Eigen::MatrixXd expected = joined(distances, halves, thirds, false),
                        result = written(engine, {from, to, halves, thirds}, 2);
  for(Eigen::Index r = 0; r < expected.rows(); ++r)
    for(Eigen::Index c = 0; c < expected.cols(); ++c)
      if(expected(r, c) < infinity)
        EXPECT_NEAR(result(r, c), expected(r, c), 1e-14 * scale); // of several queries and of one
      else
        EXPECT_EQ(result(r, c), infinity);
}

// The distances from regions to vertices, and from vertices to regions.
TEST_F(Write_distance_matrix, joins_rows_or_columns)
{
  const Window_propagation engine(surface.triangles());
  const Eigen::MatrixXd distances = distance_matrix(&engine, scale, from, to, {}, 1);
  Matrix_regions each;
  for(Index i = 0; i < from.size(); ++i)
    each.region.push_back(i);
  each.number_of_regions = from.size();
  EXPECT_EQ(written(engine, {from, to, halves, {}, true}, 2),
            joined(distances, halves, each, true));
  EXPECT_EQ(written(engine, {from, to, {}, thirds, true}, 2),
            joined(distances, each, thirds, true));
  EXPECT_EQ(written(engine, {from, to, {}, thirds}, 2), joined(distances, each, thirds, false));
}

TEST_F(Write_distance_matrix, stops_if_cancelled)
{
  const Front engine(surface.triangles(), Front_kind::planar);
  double last = -1.;
  Front_limits limits;
  limits.callback = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    EXPECT_LT(fraction, 1.);
    last = fraction;
    return true;
  };
  for(const bool do_average : {false, true})
  {
    last = -1.;
    EXPECT_GT(written(engine, {from, to, halves, thirds, do_average}, 1, 1, limits).size(), 0);
    EXPECT_GT(last, 0.5);
  }
  limits.callback = [](double fraction) { return fraction < 0.5; };
  for(const bool do_average : {false, true})
    EXPECT_EQ(written(engine, {from, to, halves, thirds, do_average}, 2, 1, limits).size(), 0);
}

TEST_F(Write_distance_matrix, exceptions_of_callbacks_keep_finished_tiles)
{
  const Front engine(surface.triangles(), Front_kind::planar);
  const Matrix_job job{from, to};
  Matrix_layout layout = {from.size(), to.size(), Number_format::float32, 0, from.size()};
  Front_limits limits;
  limits.callback = [](double fraction)
  {
    if(fraction > 0.5)
      throw Invalid_argument_error("callback");
    return true;
  };
  {
    Matrix_file file(path, layout, layout.row_size(), {});
    EXPECT_THROW(write_distance_matrix(&engine, scale, job, limits, 1, file),
                 Invalid_argument_error);
  }
  Matrix_file file(path, layout, layout.row_size(), {});
  EXPECT_TRUE(file.is_finished(0));
  // Distances that are too large for the format remove the file.
  EXPECT_THROW(write_distance_matrix(&engine, 1e39, job, {}, 1, file), Invalid_argument_error);
  EXPECT_FALSE(std::filesystem::exists(path + ".unfinished"));
  EXPECT_FALSE(std::filesystem::exists(path + ".tiles"));
}

TEST_F(Write_distance_matrix, key_depends_on_surface_and_arguments)
{
  const auto key_of = [&](const Array_surface& s, const Matrix_job& job,
                          const Front_limits& limits = {},
                          Distance_method method = Distance_method::exact)
  { return matrix_key(s.t(), method, {}, job, limits); };
  const Matrix_job job{from, to};
  const Matrix_key key = key_of(surface, job);
  const Matrix_key other = key_of(Array_surface(test::square(4, 0.1)), job);
  EXPECT_NE(other.surface, key.surface);
  EXPECT_EQ(other.arguments, key.arguments);

  std::vector<internal::Front_source> other_from = from;
  other_from.back().offset = 1.;
  std::vector<internal::Surface_location> other_to = to;
  std::swap(other_to[0], other_to[1]);
  Front_limits bounded, tolerant, slow;
  bounded.maximum_distance = 1.;
  tolerant.relative_tolerance = 0.1;
  slow.slowness = std::make_shared<std::vector<double>>(surface.t().number_of_triangles(), 2.);
  std::set<std::uint64_t> keys = {key.arguments};
  for(const Matrix_key& k :
      {key_of(surface, {other_from, to}), key_of(surface, {from, other_to}),
       key_of(surface, {from, to, thirds}), key_of(surface, {from, to, {}, thirds}),
       key_of(surface, {from, to, halves}), key_of(surface, {from, to, thirds, {}, true}),
       key_of(surface, job, bounded), key_of(surface, job, tolerant), key_of(surface, job, slow),
       key_of(surface, job, {}, Distance_method::dijkstra),
       matrix_key(surface.t(), Distance_method::exact, 1., job, {})})
  {
    EXPECT_EQ(k.surface, key.surface);
    EXPECT_TRUE(keys.insert(k.arguments).second);
  }
}

} // namespace write_distance_matrix_test
