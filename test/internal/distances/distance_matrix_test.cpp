// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/distance_matrix.h>

#include "Array_surface.h"

#include <gtest/gtest.h>

#include <vector>

namespace distance_matrix_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using test::Array_surface;

struct Distance_matrix : testing::Test
{
  Array_surface surface{test::square(4)};
  std::vector<internal::Front_source> from;
  std::vector<internal::Surface_location> to;
  std::vector<Index> column;

  Distance_matrix()
  {
    for(Index vertex = 0; vertex < surface.size(); ++vertex)
    {
      to.push_back({none, vertex, {}});
      from.push_back({{to.back()}, 0., vertex});
      column.push_back(vertex);
    }
  }

  // Checks that each entry equals the result of a single query, also with a maximum distance.
  template <typename Engine>
  void expect_rows_match(Engine engine)
  {
    const double scale = 3.;
    const Eigen::MatrixXd dense = distance_matrix(&engine, scale, from, to, {}, 2);
    Front_limits limits;
    limits.maximum_distance = 2.5 * surface.t().length[0];
    const auto sparse = sparse_distance_matrix(&engine, scale, from, column, limits, 2);
    Eigen::Index number_of_entries = 0;
    ASSERT_EQ(dense.rows(), Eigen::Index(from.size()));
    for(Eigen::Index i = 0; i < dense.rows(); ++i)
    {
      engine.run({from[i]});
      for(Eigen::Index j = 0; j < dense.cols(); ++j)
        EXPECT_EQ(dense(i, j), scale * engine.distance(Index(j)));
      engine.run({from[i]}, limits);
      number_of_entries += Eigen::Index(engine.reached().size());
      for(const Index j : engine.reached())
        EXPECT_EQ(sparse.coeff(i, Eigen::Index(j)), scale * engine.distance(j));
    }
    EXPECT_EQ(sparse.nonZeros(), number_of_entries);
    EXPECT_LT(number_of_entries, dense.size());
  }
};

TEST_F(Distance_matrix, rows_match_single_queries)
{
  expect_rows_match(Front(surface.triangles(), Front_kind::euclidean));
  expect_rows_match(Window_propagation(surface.triangles()));
}

TEST_F(Distance_matrix, heat_matrix_is_complete)
{
  Heat_solver engine(surface.triangles());
  const Eigen::MatrixXd dense = distance_matrix(&engine, 1., from, to, {}, 2);
  engine.run({from[3]});
  for(Eigen::Index j = 0; j < dense.cols(); ++j)
    EXPECT_EQ(dense(3, j), engine.distance(Index(j)));
}

TEST_F(Distance_matrix, is_empty_if_cancelled)
{
  const Front engine(surface.triangles(), Front_kind::planar);
  Front_limits limits;
  limits.callback = [](double done) { return done < 0.5; };
  EXPECT_EQ(distance_matrix(&engine, 1., from, to, limits, 1).size(), 0);
  EXPECT_EQ(sparse_distance_matrix(&engine, 1., from, column, limits, 1).size(), 0);
}

} // namespace distance_matrix_test
