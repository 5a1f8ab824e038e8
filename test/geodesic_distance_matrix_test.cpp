// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_distance_matrix.h>

#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

namespace geodesic_distance_matrix_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using Mesh_source = GP::Source<Mesh>;

// Sums of some tens of lengths.
constexpr double rounding = 1e-12;

std::vector<Vertex> some_vertices(const Mesh& mesh, std::size_t step)
{
  std::vector<Vertex> result;
  for(std::size_t i = 0; i < num_vertices(mesh); i += step)
    result.push_back(Vertex(Mesh::size_type(i)));
  return result;
}

TEST(Geodesic_distance_matrix, contains_all_pair_distances)
{
  const Triangulation plane = square(12, 0.24);
  const Mesh mesh = mesh_of(plane);
  const auto queries = some_vertices(mesh, 13);
  const Eigen::MatrixXd d = GP::geodesic_distance_matrix<GP::Exact>(mesh, queries);
  ASSERT_EQ(d.rows(), Eigen::Index(queries.size()));
  ASSERT_EQ(d.cols(), d.rows());
  for(Eigen::Index i = 0; i < d.rows(); ++i)
    for(Eigen::Index j = 0; j < d.cols(); ++j)
      EXPECT_NEAR(d(i, j), distance(plane.points[queries[i]], plane.points[queries[j]]), rounding);
}

TEST(Geodesic_distance_matrix, accepts_relative_tolerance)
{
  const Mesh mesh = mesh_of(jittered(icosphere(4), 0.1));
  const auto queries = some_vertices(mesh, 400);
  constexpr double tolerance = 0.01;
  const Eigen::MatrixXd exact = GP::geodesic_distance_matrix(mesh, queries),
                        d = GP::geodesic_distance_matrix<GP::Automatic, CGAL::Parallel_tag>(
                            mesh, queries,
                            GP::parameters::relative_tolerance(tolerance).number_of_threads(2));
  EXPECT_NE(d, exact);
  // An entry is the mean of two bounds whose relative difference is at most the tolerance.
  for(Eigen::Index i = 0; i < d.rows(); ++i)
    for(Eigen::Index j = 0; j < d.cols(); ++j)
      EXPECT_NEAR(d(i, j), exact(i, j), 0.51 * tolerance * exact(i, j));
  EXPECT_THROW(GP::geodesic_distance_matrix<GP::Dijkstra>(
                   mesh, queries, GP::parameters::relative_tolerance(tolerance)),
               GP::Unsupported_surface_error);
}

TEST(Geodesic_distance_matrix, has_one_column_per_target)
{
  const Triangulation plane = square(12, 0.24);
  const Mesh mesh = mesh_of(plane);
  std::mt19937 random(1);
  std::vector<GP::Location<Mesh>> locations;
  for(int i = 0; i < 9; ++i)
    locations.push_back(random_location_of(mesh, random));
  // From locations to vertices with a limit, and from one source of another kind to all vertices.
  const auto from = some_vertices(mesh, 40);
  const Eigen::MatrixXd d = GP::geodesic_distance_matrix<GP::Exact>(
      mesh, from, GP::parameters::targets(locations).maximum_distance(0.6));
  ASSERT_EQ(d.rows(), Eigen::Index(from.size()));
  ASSERT_EQ(d.cols(), 9);
  for(Eigen::Index i = 0; i < d.rows(); ++i)
    for(Eigen::Index j = 0; j < d.cols(); ++j)
    {
      const double truth = distance(plane.points[from[i]], point_of(mesh, locations[j]));
      if(truth <= 0.6)
        EXPECT_NEAR(d(i, j), truth, rounding);
      else
        EXPECT_EQ(d(i, j), std::numeric_limits<double>::infinity());
    }
  const Eigen::MatrixXd row = GP::geodesic_distance_matrix<GP::Exact>(
      mesh, Mesh_source(Vertex(5), 0.25), GP::parameters::targets(mesh.vertices()));
  ASSERT_EQ(row.rows(), 1);
  ASSERT_EQ(row.cols(), Eigen::Index(plane.points.size()));
  for(Eigen::Index j = 0; j < row.cols(); ++j)
    EXPECT_NEAR(row(0, j), 0.25 + distance(plane.points[j], plane.points[5]), rounding);
}

template <typename Method, typename Domain, typename Queries>
void expect_independent_of_threads(const Domain& domain, const Queries& queries)
{
  const auto three = GP::parameters::number_of_threads(3);
  const Eigen::MatrixXd alone = GP::geodesic_distance_matrix<Method>(domain, queries);
  EXPECT_EQ(alone,
            (GP::geodesic_distance_matrix<Method, CGAL::Parallel_tag>(domain, queries, three)));

  // Compares with separate queries that do not know the matrix.
  GP::Geodesic_distance_solver<typename Domain::Surface, Method> solver(domain);
  Eigen::Index row = 0;
  for(const auto& from : queries)
  {
    Eigen::Index column = 0;
    solver.compute(from);
    for(const auto& to : queries)
      // A front that stops at its targets does not process later updates. These may shorten a
      // distance by round-off errors.
      EXPECT_NEAR(alone(row, column++), solver.distance(to), rounding);
    ++row;
  }

  const double radius = 0.4 * alone.maxCoeff();
  const auto sparse = GP::sparse_geodesic_distance_matrix<Method>(domain, queries, radius);
  const auto same = GP::sparse_geodesic_distance_matrix<Method, CGAL::Parallel_tag>(domain, queries,
                                                                                    radius, three);
  ASSERT_EQ(sparse.nonZeros(), same.nonZeros());
  EXPECT_TRUE(sparse.isCompressed());
  EXPECT_TRUE(
      std::equal(sparse.valuePtr(), sparse.valuePtr() + sparse.nonZeros(), same.valuePtr()));
  EXPECT_TRUE(std::equal(sparse.innerIndexPtr(), sparse.innerIndexPtr() + sparse.nonZeros(),
                         same.innerIndexPtr()));
  Eigen::Index within = 0;
  for(Eigen::Index i = 0; i < alone.rows(); ++i)
    for(Eigen::Index j = 0; j < alone.cols(); ++j)
      if(alone(i, j) <= radius)
      {
        ++within;
        EXPECT_NEAR(sparse.coeff(i, j), alone(i, j), rounding);
      }
  EXPECT_EQ(sparse.nonZeros(), within);
}

TEST(Geodesic_distance_matrix, is_independent_of_threads)
{
  const Mesh mesh = mesh_of(jittered(icosphere(3), 0.02));
  const auto queries = some_vertices(mesh, 37);
  const auto domain = GP::make_domain(mesh);
  expect_independent_of_threads<GP::Exact>(domain, queries);
  expect_independent_of_threads<GP::Euclidean_front>(domain, queries);
  expect_independent_of_threads<GP::Dijkstra>(domain, queries);
  expect_independent_of_threads<GP::Fast_marching>(domain, queries);
  expect_independent_of_threads<GP::Heat>(domain, queries);

  Numbered<CGAL::Polyhedron_3<Kernel>> polyhedron;
  fill(polyhedron, icosphere(2));
  expect_independent_of_threads<GP::Exact>(
      GP::make_domain(polyhedron.mesh),
      std::vector{polyhedron.vertices[3], polyhedron.vertices[0], polyhedron.vertices[77]});
  const Surfels surfels = sphere_surfels(3);
  const auto maps = GP::parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  expect_independent_of_threads<GP::Euclidean_front>(GP::make_domain(surfels, maps),
                                                     std::vector<std::size_t>{4, 300, 0, 77});
}

TEST(Geodesic_distance_matrix, bounded_matrix_is_sparse)
{
  const Triangulation plane = square(12, 0.24);
  const Mesh mesh = mesh_of(plane);
  for(const double bound : {0., 0.17, 10.})
  {
    const auto d = GP::sparse_geodesic_distance_matrix<GP::Exact>(mesh, mesh.vertices(), bound);
    ASSERT_EQ(d.rows(), Eigen::Index(plane.points.size()));
    ASSERT_EQ(d.cols(), d.rows());
    Eigen::Index expected = 0;
    for(Index i = 0; i < plane.points.size(); ++i)
      for(Index j = 0; j < plane.points.size(); ++j)
        expected += distance(plane.points[i], plane.points[j]) <= bound;
    EXPECT_EQ(d.nonZeros(), expected);
    for(int i = 0; i < d.outerSize(); ++i)
    {
      int last = -1;
      for(decltype(d)::InnerIterator entry(d, i); entry; ++entry)
      {
        EXPECT_LT(last, entry.col());
        last = int(entry.col());
        EXPECT_NEAR(entry.value(), distance(plane.points[i], plane.points[last]), rounding);
      }
    }
  }
}

TEST(Geodesic_distance_matrix, is_infinite_between_components)
{
  const Mesh mesh = mesh_of(disjoint_union(tetrahedron(), square(2)));
  const Eigen::MatrixXd d = GP::geodesic_distance_matrix(mesh, std::vector{Vertex(0), Vertex(8)});
  EXPECT_EQ(d(0, 0), 0.);
  EXPECT_EQ(d(0, 1), std::numeric_limits<double>::infinity());
  EXPECT_EQ(d(1, 0), std::numeric_limits<double>::infinity());
}

TEST(Geodesic_distance_matrix, callback_cancels)
{
  const Mesh mesh = mesh_of(icosphere(2));
  for(const unsigned number_of_threads : {1u, 3u})
  {
    std::atomic<int> calls{0};
    const auto np = GP::parameters::number_of_threads(number_of_threads)
                        .callback(std::function<bool(double)>([&](double) { return ++calls < 5; }));
    EXPECT_THROW(
        (GP::geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(mesh, mesh.vertices(), np)),
        GP::Cancelled);
    calls = 0;
    EXPECT_THROW((GP::sparse_geodesic_distance_matrix<GP::Exact, CGAL::Parallel_tag>(
                     mesh, mesh.vertices(), 0.5, np)),
                 GP::Cancelled);
  }
}

// A row calls it every 4,096 vertices.
TEST(Geodesic_distance_matrix, callback_is_called_during_rows)
{
  const Mesh mesh = mesh_of(icosphere(5)); // 10,242 vertices
  const std::vector<Vertex> sources = {Vertex(0), Vertex(1)};
  for(const int last_call : {100, 2})
  {
    int calls = 0;
    double last_fraction = 0.;
    const std::function<bool(double)> callback = [&](double fraction)
    {
      EXPECT_GE(fraction, last_fraction);
      last_fraction = fraction;
      return ++calls < last_call;
    };
    const auto np = GP::parameters::callback(callback);
    if(last_call == 2)
      EXPECT_THROW(
          GP::geodesic_distance_matrix<GP::Dijkstra>(mesh, sources, np.targets(mesh.vertices())),
          GP::Cancelled);
    else
      GP::geodesic_distance_matrix<GP::Dijkstra>(mesh, sources, np.targets(mesh.vertices()));
    EXPECT_GE(calls, last_call == 2 ? 2 : 6);
    EXPECT_EQ(last_fraction, last_call == 2 ? 0. : 0.5);
  }
}

TEST(Geodesic_distance_matrix, throws_on_invalid_input)
{
  const Mesh mesh = mesh_of(tetrahedron());
  EXPECT_THROW(GP::geodesic_distance_matrix(mesh, std::vector<Vertex>()),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distance_matrix(mesh, Vertex(7)), GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distance_matrix(mesh, Vertex(0), GP::parameters::maximum_distance(-1.)),
               GP::Invalid_argument_error);
  for(const double bound : {-1., std::nan("")})
    EXPECT_THROW(GP::sparse_geodesic_distance_matrix(mesh, mesh.vertices(), bound),
                 GP::Invalid_argument_error);
  EXPECT_THROW(GP::sparse_geodesic_distance_matrix(mesh, std::vector{Vertex(1), Vertex(1)}, 1.),
               GP::Invalid_argument_error);
  EXPECT_EQ(GP::sparse_geodesic_distance_matrix(mesh, std::vector<Vertex>(), 1.).size(), 0);
}

} // namespace geodesic_distance_matrix_test
