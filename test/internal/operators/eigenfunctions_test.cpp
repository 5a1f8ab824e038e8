// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/eigenfunctions.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include "Array_surface.h"
#include "clouds.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace eigenfunctions_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// The solver accepts relative residuals of 1e-8; the other term bounds round-off errors.
constexpr double relative_tolerance = 1e-7;

Eigenfunctions eigenfunctions_of(const Triangulation& surface, std::size_t number)
{
  const Array_surface array_surface(surface);
  return eigenfunctions(array_surface.t(), operators(array_surface.t()), number);
}

Matrix dense(const Sparse_matrix& lower)
{
  return Matrix(Sparse_matrix(lower.selfadjointView<Eigen::Lower>()));
}

// Computes all eigenvalues with a dense solver on the vertices that are not on the boundary. The
// zero eigenvalue of the constants is included.
Vector all_values(const Operators& o, const std::vector<bool>& is_boundary)
{
  std::vector<Eigen::Index> free_vertices;
  for(std::size_t vertex = 0; vertex < is_boundary.size(); ++vertex)
    if(!is_boundary[vertex])
      free_vertices.push_back(Eigen::Index(vertex));
  const Matrix laplacian = dense(Laplacian(o).matrix(o))(free_vertices, free_vertices);
  const Matrix mass = Vector(lumped_mass(o)(free_vertices)).asDiagonal();
  return Eigen::GeneralizedSelfAdjointEigenSolver<Matrix>(laplacian, mass).eigenvalues();
}

void expect_eigenfunctions(const Surface_arrays& t, std::size_t number, std::size_t constants)
{
  const Operators o = operators(t);
  const Eigenfunctions found = eigenfunctions(t, o, number);
  const Eigen::Index k = found.value.size();
  const std::vector<bool> is_boundary = boundary_vertices(t);
  const Vector expected = all_values(o, is_boundary);
  ASSERT_GE(k, Eigen::Index(std::min(number, std::size_t(expected.size()) - constants)));
  ASSERT_EQ(found.function.rows(), Eigen::Index(o.number_of_vertices));
  ASSERT_EQ(found.function.cols(), k);
  for(Eigen::Index i = 0; i < k; ++i)
    EXPECT_NEAR(found.value[i], expected[i + Eigen::Index(constants)],
                relative_tolerance * found.value[i]);

  const Matrix laplacian = dense(Laplacian(o).matrix(o));
  const Vector mass = lumped_mass(o);
  const Matrix identity = Matrix::Identity(k, k);
  const Matrix gram = found.function.transpose() * mass.asDiagonal() * found.function;
  EXPECT_LT((gram - identity).cwiseAbs().maxCoeff(), relative_tolerance);
  const Vector inverse_sqrt = found.value.cwiseSqrt().cwiseInverse();
  const Matrix energy = found.function.transpose() * laplacian * found.function;
  EXPECT_LT((inverse_sqrt.asDiagonal() * energy * inverse_sqrt.asDiagonal() - identity)
                .cwiseAbs()
                .maxCoeff(),
            relative_tolerance);
  for(std::size_t vertex = 0; vertex < is_boundary.size(); ++vertex)
    EXPECT_TRUE(!is_boundary[vertex] || found.function.row(Eigen::Index(vertex)).isZero(0.));
}

TEST(Eigenfunctions, match_dense_solver)
{
  for(const auto& [surface, constants] : std::vector<std::pair<Triangulation, std::size_t>>{
          {tetrahedron(), 1},
          {jittered(icosphere(2), 0.03), 1},
          {square(12, 0.24), 0},
          {cylinder(12, 8, 1., 2.), 0},
          {torus(16, 10), 1},
          {double_torus(1), 1},
          {cone(12, 6, 8.), 0},
          {disjoint_union(jittered(icosphere(1), 0.03), disjoint_union(torus(9, 6), square(8))),
           2}})
    for(const std::size_t number : {std::size_t(1), std::size_t(7), std::size_t(40)})
      expect_eigenfunctions(Array_surface(surface).t(), number, constants);
}

TEST(Eigenfunctions, cloud_has_no_boundary_condition)
{
  const Cloud cloud = octahedron_sphere(3);
  const Surfel_arrays sphere = build_surfel_arrays(cloud.points, cloud.normals);
  expect_eigenfunctions(sphere.arrays, 20, 1);
}

TEST(Eigenfunctions, returns_complete_spectrum)
{
  const Triangulation small = square(5);
  EXPECT_EQ(eigenfunctions_of(small, 0).value.size(), 0);
  EXPECT_EQ(eigenfunctions_of(small, 1000).value.size(), 16);
  EXPECT_EQ(eigenfunctions_of(tetrahedron(), 1000).value.size(), 3);
  EXPECT_EQ(eigenfunctions_of(one_triangle(), 1000).value.size(), 0);
  expect_eigenfunctions(Array_surface(small).t(), 1000, 0);
  expect_eigenfunctions(Array_surface(tetrahedron()).t(), 1000, 1);
}

// On the unit sphere, the eigenvalue l (l + 1) has the multiplicity 2 l + 1. This triangulation
// splits it by 0.5 %.
TEST(Eigenfunctions, eigenspaces_are_complete_on_sphere)
{
  const Array_surface sphere(icosphere(4));
  const Operators o = operators(sphere.t());
  for(const std::size_t number : {1u, 3u, 4u, 10u, 15u, 16u, 37u, 49u, 70u, 99u, 100u})
  {
    const Eigenfunctions found = eigenfunctions(sphere.t(), o, number);
    std::size_t group = 1;
    while(group * (group + 2) < number)
      ++group;
    ASSERT_EQ(found.value.size(), Eigen::Index(group * (group + 2)));
    // The relative error is of second order in the phase of the wave along an edge. The maximum
    // edge length is 0.08.
    const double value = double(group * (group + 1));
    EXPECT_NEAR(found.value[found.value.size() - 1] / (sphere.scale() * sphere.scale()), value,
                0.08 * 0.08 * value * value);
  }
}

// The eigenvalues of the unit square are pi^2 (i^2 + j^2) with i, j >= 1.
TEST(Eigenfunctions, eigenspaces_are_complete_on_square)
{
  const Triangulation plane = square(40);
  const std::vector<std::pair<std::size_t, Eigen::Index>> groups = {
      {1, 1}, {2, 3}, {3, 3}, {4, 4}, {5, 6}, {7, 8}, {9, 10}, {11, 11}, {12, 13}};
  for(const auto& [number, group] : groups)
    EXPECT_EQ(eigenfunctions_of(plane, number).value.size(), group);
}

// The multiplicity exceeds the number of columns in a block.
TEST(Eigenfunctions, finds_high_multiplicity)
{
  Triangulation many = icosphere(1);
  for(int i = 1; i < 12; ++i)
    many = disjoint_union(many, icosphere(1));
  EXPECT_EQ(eigenfunctions_of(many, 1).value.size(), 36);
  EXPECT_EQ(eigenfunctions_of(many, 37).value.size(), 96);
}

TEST(Eigenfunctions, is_deterministic)
{
  const Triangulation surface = jittered(icosphere(3), 0.03);
  EXPECT_EQ(eigenfunctions_of(surface, 20).function, eigenfunctions_of(surface, 20).function);
}

// Returns equal tetrahedra.
Triangulation equal_components(std::size_t number)
{
  Triangulation result = tetrahedron();
  while(result.points.size() < number * tetrahedron().points.size())
    result = disjoint_union(result, tetrahedron());
  return result;
}

TEST(Eigenfunctions, throw_if_no_gap_follows)
{
  // Each tetrahedron has three eigenfunctions, so that each eigenvalue has the multiplicity 250 or
  // more. The basis has at most 520 columns.
  EXPECT_NO_THROW(eigenfunctions_of(equal_components(20), 1));
  EXPECT_THROW(eigenfunctions_of(equal_components(250), 1), Unsupported_surface_error);
}

TEST(Eigenfunctions, throw_if_there_are_too_many_closed_components)
{
  EXPECT_THROW(eigenfunctions_of(equal_components(513), 1), Unsupported_surface_error);
}

} // namespace eigenfunctions_test
