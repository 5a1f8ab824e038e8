// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/geodesic_distance_derivatives.h>

#include <CGAL/Geodesic_processing/geodesic_distances.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>

#include "Mesh_of.h"
#include "rough_surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace geodesic_distance_derivatives_test {

namespace GP = CGAL::Geodesic_processing;
using namespace GP::test;
using GP::Differentiability;
using Vector = Kernel::Vector_3;

// Sums of some tens of vectors of at most unit length.
constexpr double round_off = 1e-12;

TEST(Geodesic_distance_derivatives, are_invariant_under_translation_and_rotation)
{
  for(const Triangulation& shape : {jittered(icosphere(2), 0.02), animal(2), square(8, 0.2)})
  {
    const Mesh mesh = mesh_of(shape);
    const GP::Mesh_domain<Mesh> domain(mesh);
    std::mt19937 random(1);
    for(int i = 0; i < 20; ++i)
    {
      const auto result = GP::geodesic_distance_derivatives(
          domain, random_location_of(mesh, random), random_location_of(mesh, random));
      // The identities hold for each path.
      Vector force = CGAL::NULL_VECTOR, torque = CGAL::NULL_VECTOR;
      double work = 0.;
      for(const auto& [v, gradient] : result.vertex_gradients)
      {
        const Vector position = mesh.point(v) - CGAL::ORIGIN;
        force += gradient;
        torque += CGAL::cross_product(position, gradient);
        work += position * gradient;
      }
      EXPECT_LT(std::sqrt(force.squared_length()), round_off);
      EXPECT_LT(std::sqrt(torque.squared_length()), round_off);
      EXPECT_NEAR(work, result.distance, round_off);
    }
  }
}

// Returns the gradient of each vertex.
std::vector<Vector> vertex_gradients(const Mesh& mesh,
                                     const GP::Geodesic_distance_derivatives<Mesh>& derivatives)
{
  std::vector<Vector> result(num_vertices(mesh), CGAL::NULL_VECTOR);
  for(const auto& [v, gradient] : derivatives.vertex_gradients)
    result[v] = gradient;
  return result;
}

TEST(Geodesic_distance_derivatives, do_not_depend_on_scale)
{
  const Triangulation shape = jittered(torus(20, 10), 0.02);
  std::mt19937 random(1);
  const Mesh mesh = mesh_of(shape);
  const auto source = random_location_of(mesh, random), target = random_location_of(mesh, random);
  const auto expected = GP::geodesic_distance_derivatives(mesh, source, target);
  const std::vector<Vector> expected_gradients = vertex_gradients(mesh, expected);
  for(const double factor : {1e-6, 1e6, 1e-150, 1e150})
  {
    const auto result =
        GP::geodesic_distance_derivatives(mesh_of(scaled(shape, factor)), source, target);
    EXPECT_EQ(result.differentiability, expected.differentiability);
    EXPECT_NEAR(result.distance / factor, expected.distance, round_off);
    const std::vector<Vector> gradients = vertex_gradients(mesh, result);
    for(const Vertex v : mesh.vertices())
      EXPECT_LT((gradients[v] - expected_gradients[v]).squared_length(), round_off * round_off);
  }
}

TEST(Geodesic_distance_derivatives, agree_with_central_differences_for_vertices)
{
  Mesh mesh = mesh_of(jittered(icosphere(1), 0.05));
  const Vertex source(3), target(30);
  const auto distance = [&]
  {
    auto map = vertex_map(mesh);
    GP::geodesic_distances(mesh, source, map);
    return map[target];
  };
  const auto result = GP::geodesic_distance_derivatives(mesh, source, target);
  EXPECT_TRUE(result.is_differentiable());
  EXPECT_NEAR(result.distance, distance(), round_off);
  const std::vector<Vector> gradients = vertex_gradients(mesh, result);
  // Truncation errors are about the square of the step, round-off errors 1e-16 / step.
  constexpr double step = 1e-5, tolerance = 1e-9;
  for(const Vertex v : mesh.vertices())
    for(int k = 0; k < 3; ++k)
    {
      const Kernel::Point_3 point = mesh.point(v);
      const Vector motion(k == 0 ? step : 0., k == 1 ? step : 0., k == 2 ? step : 0.);
      mesh.point(v) = point + motion;
      const double farther = distance();
      mesh.point(v) = point - motion;
      EXPECT_NEAR((farther - distance()) / (2. * step), gradients[v][k], tolerance);
      mesh.point(v) = point;
    }
}

TEST(Geodesic_distance_derivatives, are_rejected_by_each_rule)
{
  const Mesh sphere = mesh_of(icosphere(1)), flat = mesh_of(square(4)),
             pair = mesh_of(disjoint_union(tetrahedron(), tetrahedron()));
  Vertex antipode(0);
  for(const Vertex v : sphere.vertices())
    if(CGAL::squared_distance(sphere.point(v), sphere.point(Vertex(0))) >
       CGAL::squared_distance(sphere.point(antipode), sphere.point(Vertex(0))))
      antipode = v;
  const auto second = GP::geodesic_distance_derivatives(sphere, Vertex(0), antipode);
  EXPECT_EQ(second.differentiability, Differentiability::second_path);
  EXPECT_FALSE(second.is_differentiable());
  EXPECT_FALSE(second.vertex_gradients.empty());

  const auto near_vertex = GP::geodesic_distance_derivatives(flat, Vertex(0), Vertex(24));
  EXPECT_EQ(near_vertex.differentiability, Differentiability::near_vertex);
  EXPECT_NEAR(near_vertex.source_gradient * Vector(1., 1., 0.), -std::sqrt(2.), round_off);

  const auto same = GP::geodesic_distance_derivatives(flat, Vertex(5), Vertex(5));
  EXPECT_EQ(same.differentiability, Differentiability::coincident);
  EXPECT_EQ(same.distance, 0.);

  const auto apart = GP::geodesic_distance_derivatives(pair, Vertex(0), Vertex(4));
  EXPECT_EQ(apart.differentiability, Differentiability::unreachable);
  EXPECT_EQ(apart.distance, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(apart.vertex_gradients.empty());
}

TEST(Geodesic_distance_derivatives, obey_tolerances)
{
  const Mesh mesh = mesh_of(jittered(icosphere(1), 0.05));
  const Vertex source(3), target(30);
  EXPECT_EQ(
      GP::geodesic_distance_derivatives(mesh, source, target, GP::parameters::vertex_tolerance(0.5))
          .differentiability,
      Differentiability::near_vertex);
  // A path on another side of the sphere.
  EXPECT_EQ(GP::geodesic_distance_derivatives(mesh, source, target,
                                              GP::parameters::second_path_tolerance(3.))
                .differentiability,
            Differentiability::second_path);
  EXPECT_THROW(GP::geodesic_distance_derivatives(mesh, source, target,
                                                 GP::parameters::second_path_tolerance(-1.)),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distance_derivatives(
                   mesh, source, target,
                   GP::parameters::vertex_tolerance(std::numeric_limits<double>::quiet_NaN())),
               GP::Invalid_argument_error);
  EXPECT_THROW(GP::geodesic_distance_derivatives(mesh, source, location_of(0, {2., -0.5, -0.5})),
               GP::Invalid_argument_error);
}

TEST(Geodesic_distance_derivatives, have_vectors_of_the_kernel_of_the_mesh)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Polyhedron = CGAL::Polyhedron_3<Epick>;
  const Triangulation shape = square(4, 0.2);
  Numbered<Polyhedron> numbered;
  fill(numbered, shape);
  const auto result = GP::geodesic_distance_derivatives(
      numbered.mesh, numbered.vertices[0], location_in(numbered, shape, 20, {0.2, 0.3, 0.5}));
  EXPECT_TRUE(result.is_differentiable());
  const Epick::Vector_3 sum = result.source_gradient + result.target_gradient;
  // Both are opposite in the plane.
  EXPECT_LT(std::sqrt(sum.squared_length()), round_off);
  EXPECT_NEAR(result.source_gradient.squared_length(), 1., round_off);
}

} // namespace geodesic_distance_derivatives_test
