// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fit_quadric.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Decomposition = Eigen::CompleteOrthogonalDecomposition<Matrix6>;

// Returns the direction of smallest variance.
Vec3 best_fit_plane_normal(const std::vector<Vec3>& points)
{
  Vec3 centroid = {0., 0., 0.};
  for(const Vec3& p : points)
    centroid = centroid + (1. / double(points.size())) * p;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(const Vec3& p : points)
  {
    const Vec3 offset = p - centroid;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        covariance(i, j) += offset[i] * offset[j];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigensolver;
  eigensolver.computeDirect(covariance);
  const auto normal = eigensolver.eigenvectors().col(0);
  return {normal[0], normal[1], normal[2]};
}

// Returns the solution of minimum norm. Equivalent to decomposition.solve(), which also instantiates
// reflections of blocks and takes nine seconds to compile.
Vector6 solve(const Decomposition& decomposition, Vector6 c)
{
  const Matrix6& factors = decomposition.matrixQTZ();
  const Eigen::Index rank = decomposition.rank(), defect = 6 - rank;
  double workspace;
  for(Eigen::Index k = 0; k < rank; ++k)
    c.tail(6 - k).applyHouseholderOnTheLeft(factors.col(k).tail(5 - k), decomposition.hCoeffs()[k],
                                            &workspace);
  for(Eigen::Index k = rank - 1; k >= 0; --k)
    if(c[k] != 0.)
    {
      c[k] /= factors(k, k);
      for(Eigen::Index i = 0; i < k; ++i)
        c[i] -= c[k] * factors(i, k);
    }
  c.tail(defect).setZero();
  for(Eigen::Index k = 0; k < rank && defect > 0; ++k)
  {
    std::swap(c[k], c[rank - 1]);
    c.tail(defect + 1)
        .applyHouseholderOnTheLeft(factors.row(k).tail(defect).transpose(),
                                   decomposition.zCoeffs()[k], &workspace);
    std::swap(c[k], c[rank - 1]);
  }
  return decomposition.colsPermutation() * c;
}

} // namespace

Quadric fit_quadric(const Vec3& origin, const std::vector<Vec3>& points)
{
  Quadric result;
  for(const Vec3& p : points)
    result.length_unit = std::max(result.length_unit, norm(p - origin));
  if(!(result.length_unit > 0.))
    return result;
  result.plane_normal = best_fit_plane_normal(points);
  std::tie(result.x, result.y) = tangent_frame(result.plane_normal);

  // In this unit, the sums of all monomials have the same order of magnitude.
  Matrix6 normal_matrix = Matrix6::Zero();
  Vector6 rhs = Vector6::Zero();
  for(const Vec3& p : points)
  {
    const Vec3 offset = (1. / result.length_unit) * (p - origin);
    const double u = dot(offset, result.x), v = dot(offset, result.y);
    const std::array<double, 6> monomials = {1., u, v, 0.5 * u * u, u * v, 0.5 * v * v};
    const double height = dot(offset, result.plane_normal);
    for(int i = 0; i < 6; ++i)
    {
      for(int j = 0; j < 6; ++j)
        normal_matrix(i, j) += monomials[i] * monomials[j];
      rhs[i] += height * monomials[i];
    }
  }
  Decomposition decomposition;
  decomposition.setThreshold(1e-12); // if the points are on a conic, the system is singular
  decomposition.compute(normal_matrix);
  const Vector6 c = solve(decomposition, rhs);
  std::copy(c.data(), c.data() + 6, result.coefficients.begin());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
