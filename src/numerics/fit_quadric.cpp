// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/fit_quadric.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

namespace {

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
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> rhs = Eigen::Matrix<double, 6, 1>::Zero(), monomials;
  for(const Vec3& p : points)
  {
    const Vec3 offset = (1. / result.length_unit) * (p - origin);
    const double u = dot(offset, result.x), v = dot(offset, result.y);
    monomials << 1., u, v, 0.5 * u * u, u * v, 0.5 * v * v;
    normal_matrix += monomials * monomials.transpose();
    rhs += dot(offset, result.plane_normal) * monomials;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 6, 6>> decomposition;
  decomposition.setThreshold(1e-12); // if the points are on a conic, the system is singular
  const Eigen::Matrix<double, 6, 1> c = decomposition.compute(normal_matrix).solve(rhs);
  std::copy(c.data(), c.data() + 6, result.coefficients.begin());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
