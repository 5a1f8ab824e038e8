// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/nearest_quadric.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <tuple>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The direction in which points vary least.
Spatial normal_across(const std::vector<Spatial>& points)
{
  Spatial centre = {0., 0., 0.};
  for(const Spatial& p : points)
    centre = centre + (1. / double(points.size())) * p;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for(const Spatial& p : points)
  {
    const Spatial way = p - centre;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        spread(i, j) += way[i] * way[j];
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> plane;
  plane.computeDirect(spread);
  const auto normal = plane.eigenvectors().col(0);
  return {normal[0], normal[1], normal[2]};
}

} // namespace

Quadric nearest_quadric(const Spatial& origin, const std::vector<Spatial>& points)
{
  Quadric result;
  for(const Spatial& p : points)
    result.unit = std::max(result.unit, norm(p - origin));
  if(!(result.unit > 0.))
    return result;
  result.up = normal_across(points);
  std::tie(result.x, result.y) = tangent_frame(result.up);

  // In this unit the sums are of one size.
  Eigen::Matrix<double, 6, 6> sums = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> heights = Eigen::Matrix<double, 6, 1>::Zero(), powers;
  for(const Spatial& p : points)
  {
    const Spatial way = (1. / result.unit) * (p - origin);
    const double u = dot(way, result.x), v = dot(way, result.y);
    powers << 1., u, v, 0.5 * u * u, u * v, 0.5 * v * v;
    sums += powers * powers.transpose();
    heights += dot(way, result.up) * powers;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, 6, 6>> decomposition;
  decomposition.setThreshold(1e-12); // points on a conic leave some coefficients open
  const Eigen::Matrix<double, 6, 1> c = decomposition.compute(sums).solve(heights);
  std::copy(c.data(), c.data() + 6, result.coefficients.begin());
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
