// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/tags.h>

#include <CGAL/Geodesic_processing/internal/distances/Distance_engine.h>

#include <CGAL/Geodesic_processing/farthest_point_sampling.h>
#include <CGAL/Geodesic_processing/geodesic_distance_matrix.h>
#include <CGAL/Geodesic_processing/Geodesic_distance_solver.h>

#include "Array_surface.h"
#include "Mesh_of.h"

#include <gtest/gtest.h>

namespace tags_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::test;

// Returns the distance along the diagonal of a square, which distinguishes the methods.
template <typename Method>
double distance_across_square()
{
  static const Array_surface surface(square(20));
  internal::Distance_engine engine(internal::distance_method<Method>(), surface.triangles());
  engine.run({surface.source(20)});
  return surface.distances(engine)[20 * 21]; // from (1,0) to (0,1), across all face diagonals
}

TEST(Tags, select_methods_with_expected_errors)
{
  EXPECT_NEAR(distance_across_square<Dijkstra>(), 2.,
              1e-12); // the sum of two edge lengths, 41 % too long
  EXPECT_NEAR(distance_across_square<Euclidean_front>(), std::sqrt(2.), 1e-9);
  EXPECT_NEAR(distance_across_square<Exact>(), std::sqrt(2.), 1e-12); // sums of twenty lengths
  // First order: an edge length of 1/20.
  EXPECT_NEAR(distance_across_square<Fast_marching>(), std::sqrt(2.), 1.1 / 20.);
  EXPECT_GT(distance_across_square<Fast_marching>(), std::sqrt(2.) + 1e-6);
  // Depends on the time step, which is the squared edge length. Measured: 0.037.
  EXPECT_NEAR(distance_across_square<Heat>(), std::sqrt(2.), 0.06);
}

// Returns the distance of the vertex that is opposite to the first vertex of a square by a method
// that is selected at run time.
double distance_at_run_time(const Mesh& mesh, Distance_method method)
{
  Geodesic_distance_solver<Mesh, Runtime_method> solver(mesh, parameters::method(method));
  solver.compute(Vertex(20));
  return solver.distance(Vertex(20 * 21));
}

TEST(Tags, runtime_method_selects_method)
{
  const Mesh mesh = mesh_of(square(20));
  const auto expect_same = [&](auto tag, Distance_method method)
  {
    using Method = decltype(tag);
    Geodesic_distance_solver<Mesh, Method> solver(mesh);
    solver.compute(Vertex(20));
    EXPECT_EQ(distance_at_run_time(mesh, method), solver.distance(Vertex(20 * 21)));
    const auto np = parameters::method(method);
    const std::vector<Vertex> vertices = {Vertex(0), Vertex(20), Vertex(20 * 21)};
    EXPECT_EQ(geodesic_distance_matrix<Runtime_method>(mesh, vertices, np),
              geodesic_distance_matrix<Method>(mesh, vertices));
    if constexpr(internal::is_front<Method>)
    {
      std::vector<Location<Mesh>> expected, found;
      farthest_point_sampling<Method>(mesh, 9, std::back_inserter(expected));
      farthest_point_sampling<Runtime_method>(mesh, 9, std::back_inserter(found), np);
      EXPECT_EQ(found, expected);
    }
  };
  expect_same(Dijkstra(), Distance_method::dijkstra);
  expect_same(Fast_marching(), Distance_method::fast_marching);
  expect_same(Euclidean_front(), Distance_method::euclidean_front);
  expect_same(Exact(), Distance_method::exact);
  expect_same(Heat(), Distance_method::heat);
  expect_same(Automatic(), Distance_method::automatic);
  // The default of the function.
  Geodesic_distance_solver<Mesh, Runtime_method> solver(mesh);
  solver.compute(Vertex(20));
  EXPECT_EQ(solver.distance(Vertex(20 * 21)), distance_at_run_time(mesh, Distance_method::exact));
}

TEST(Tags, runtime_method_rejects_unsupported_methods)
{
  const Mesh mesh = mesh_of(square(2));
  std::vector<Location<Mesh>> samples;
  for(const Distance_method method : {Distance_method::exact, Distance_method::heat})
    EXPECT_THROW(farthest_point_sampling<Runtime_method>(mesh, 3, std::back_inserter(samples),
                                                         parameters::method(method)),
                 Invalid_argument_error);
  const Surfels surfels = sphere_surfels(1);
  const auto np = parameters::point_map(Surfel_point_map()).normal_map(Surfel_normal_map());
  EXPECT_THROW((Geodesic_distance_solver<Surfels, Runtime_method>(
                   surfels, np.method(Distance_method::exact))),
               Unsupported_surface_error);
}

} // namespace tags_test
