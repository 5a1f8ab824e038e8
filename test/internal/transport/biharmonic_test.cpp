// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/transport/biharmonic.h>

#include <CGAL/Geodesic_processing/exceptions.h>

#include "Array_surface.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace biharmonic_test {

using namespace CGAL::Geodesic_processing;
using namespace CGAL::Geodesic_processing::internal;
using namespace CGAL::Geodesic_processing::test;

// Round-off errors of differences of squares, relative to distances of order one.
constexpr double round_off = 1e-10;

// Returns the unit masses at all vertices.
Masses unit_masses(Index n)
{
  Masses result(n, n);
  result.setIdentity();
  return result;
}

// Computes biharmonic distances from their definition with all eigenfunctions. The squared distance
// is the sum of squares of (difference of the function / eigenvalue). The boundary conditions are
// Neumann's.
Matrix spectral_distances(const Operators& o)
{
  const Matrix laplacian(Sparse_matrix(Laplacian(o).matrix(o).selfadjointView<Eigen::Lower>()));
  const Matrix mass = lumped_mass(o).asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix> solver(laplacian, mass);
  const Eigen::Index n = laplacian.rows();
  Matrix result = Matrix::Zero(n, n);
  for(Eigen::Index k = 1; k < n; ++k)
    for(Eigen::Index i = 0; i < n; ++i)
      for(Eigen::Index j = 0; j < n; ++j)
      {
        const double difference = solver.eigenvectors()(i, k) - solver.eigenvectors()(j, k);
        result(i, j) += std::pow(difference / solver.eigenvalues()[k], 2);
      }
  return result.cwiseSqrt();
}

TEST(Biharmonic_distances, matches_spectral_definition)
{
  for(const Triangulation& shape :
      {jittered(icosphere(2), 0.03), square(8, 0.24), cylinder(9, 5, 1., 2.), torus(12, 8)})
  {
    const Array_surface surface(shape);
    const Biharmonic_distances distances(surface.t());
    const Matrix expected = spectral_distances(operators(surface.t()));
    const Matrix pairs = distances.all_pairs(unit_masses(surface.size()));
    EXPECT_LT((pairs - expected).cwiseAbs().maxCoeff(), round_off);
    EXPECT_EQ(pairs, Matrix(pairs.transpose()));
    for(const Index from : {0u, 17u})
    {
      const Vector all = distances.one_to_all(unit_masses(surface.size()).middleCols(from, 1), 1);
      EXPECT_LT((all - expected.col(from)).cwiseAbs().maxCoeff(), round_off);
    }
  }
}

TEST(Biharmonic_distances, is_infinite_between_components)
{
  const Array_surface surface(disjoint_union(icosphere(1), torus(9, 6)));
  const Index ball = surface.vertex(0), ring = surface.vertex(50);
  const Biharmonic_distances distances(surface.t());
  const Matrix pairs = distances.all_pairs(unit_masses(surface.size()));
  EXPECT_EQ(pairs(ball, ring), infinity);
  EXPECT_LT(pairs(ball, surface.vertex(1)), 1.);
  const Vector all = distances.one_to_all(unit_masses(surface.size()).middleCols(ring, 1), 1);
  EXPECT_EQ(all[ball], infinity);
  EXPECT_EQ(all[ring], 0.);
  EXPECT_NEAR(all[surface.vertex(51)], pairs(ring, surface.vertex(51)), round_off);
}

TEST(Biharmonic_distances, is_independent_of_threads)
{
  const Array_surface surface(jittered(icosphere(3), 0.02));
  const Masses source = unit_masses(surface.size()).middleCols(5, 1);
  EXPECT_EQ(Biharmonic_distances(surface.t()).one_to_all(source, 1),
            Biharmonic_distances(surface.t()).one_to_all(source, 3));
}

TEST(Biharmonic_distances, throws_on_empty_surface)
{
  const Surface_arrays nothing;
  EXPECT_THROW(Biharmonic_distances{nothing}, Unsupported_surface_error);
}

} // namespace biharmonic_test
