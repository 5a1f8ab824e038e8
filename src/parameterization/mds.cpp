// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/mds.h>

#include <CGAL/Geodesic_processing/internal/parameterization/lle.h>

#include <cstddef>

namespace CGAL::Geodesic_processing::internal {

std::vector<Vec2> landmark_mds(const Surface_arrays& t, Front front,
                               const std::vector<Index>& base_points,
                               const std::function<bool(double)>& callback)
{
  const std::size_t number_of_points = base_points.size();
  const auto report_progress = [&](std::size_t number_of_runs)
  { return !callback || callback(double(number_of_runs) / double(2 * number_of_points)); };
  const auto run_from = [&](Index vertex) { front.run({{{{none, vertex, {}}}, 0., 0}}); };

  const auto n = Eigen::Index(number_of_points);
  Eigen::MatrixXd squares(n, n);
  for(std::size_t i = 0; i < number_of_points; ++i)
  {
    if(!report_progress(i))
      return {};
    run_from(base_points[i]);
    for(std::size_t j = 0; j < number_of_points; ++j)
    {
      const double distance = front.distance(base_points[j]);
      squares(Eigen::Index(i), Eigen::Index(j)) = distance * distance;
    }
  }
  const Eigen::MatrixXd images = classical_scaling(squares);

  // The base points are centered and their coordinates x are orthogonal: along each axis the
  // coordinate of a vertex at distances d_j is -1/2 sum_j x_j (d_j^2 - mean_j) / sum_j x_j^2.
  const Eigen::VectorXd mean =
      0.5 * (squares.colwise().mean().transpose() + squares.rowwise().mean());
  const Eigen::RowVector2d squared_norm = images.colwise().squaredNorm();
  std::vector<Vec2> result(t.number_of_vertices(), Vec2{0., 0.});
  for(std::size_t j = 0; j < number_of_points; ++j)
  {
    if(!report_progress(number_of_points + j))
      return {};
    run_from(base_points[j]);
    Vec2 factor;
    for(int axis = 0; axis < 2; ++axis)
      factor[axis] =
          squared_norm[axis] > 0. ? -0.5 * images(Eigen::Index(j), axis) / squared_norm[axis] : 0.;
    for(Index vertex = 0; vertex < result.size(); ++vertex)
    {
      const double distance = front.distance(vertex);
      result[vertex] = result[vertex] + (distance * distance - mean[Eigen::Index(j)]) * factor;
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
