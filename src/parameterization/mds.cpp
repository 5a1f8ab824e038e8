// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/mds.h>

#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>

#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

std::vector<Planar> scaled(const Glued_triangles& t, Front front,
                           const std::vector<Index>& base_points,
                           const std::function<bool(double)>& callback)
{
  const std::size_t number = base_points.size();
  const auto may_go_on = [&](std::size_t runs)
  { return !callback || callback(double(runs) / double(2 * number)); };
  const auto run_from = [&](Index site) { front.run({{{{none, site, {}}}, 0., 0}}); };

  const auto n = Eigen::Index(number);
  Eigen::MatrixXd squares(n, n);
  for(std::size_t i = 0; i < number; ++i)
  {
    if(!may_go_on(i))
      return {};
    run_from(base_points[i]);
    for(std::size_t j = 0; j < number; ++j)
    {
      const double distance = front.distance(base_points[j]);
      squares(Eigen::Index(i), Eigen::Index(j)) = distance * distance;
    }
  }
  const Eigen::MatrixXd images = classical_scaling(squares);

  // Base points have the mean zero, and orthogonal coordinates: a site goes to
  // -1/2 sum_j x_j (d_j^2 - mean_j) / sum_j x_j^2 along each.
  const Eigen::VectorXd mean =
      0.5 * (squares.colwise().mean().transpose() + squares.rowwise().mean());
  const Eigen::RowVector2d square = images.colwise().squaredNorm();
  std::vector<Planar> result(t.number_of_sites(), Planar{0., 0.});
  for(std::size_t j = 0; j < number; ++j)
  {
    if(!may_go_on(number + j))
      return {};
    run_from(base_points[j]);
    Planar factor;
    for(int axis = 0; axis < 2; ++axis)
      factor[axis] = square[axis] > 0. ? -0.5 * images(Eigen::Index(j), axis) / square[axis] : 0.;
    for(Index site = 0; site < result.size(); ++site)
    {
      const double distance = front.distance(site);
      result[site] = result[site] + (distance * distance - mean[Eigen::Index(j)]) * factor;
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
