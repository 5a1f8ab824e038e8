// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include "surfels/normals.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the indices of the points, sorted by the mean squared distance to their neighbors.
std::vector<std::size_t> sort_by_neighbor_distance(std::vector<Vec3> points,
                                                   unsigned number_of_neighbors,
                                                   unsigned number_of_threads)
{
  to_frame(points, unit_frame(points));
  std::vector<Index> order;
  const Kd_tree tree(points, order, number_of_threads);
  std::vector<std::pair<double, std::size_t>> sums(points.size());
  visit_nearest(points, tree, number_of_neighbors, number_of_threads,
                [&](std::size_t, Index i, const std::vector<Kd_tree::Neighbor>& found)
                {
                  sums[i] = {0., order[i]};
                  for(const Kd_tree::Neighbor& neighbor : found)
                    sums[i].first += neighbor.squared_distance;
                });
  std::sort(sums.begin(), sums.end());
  std::vector<std::size_t> result;
  for(const auto& [sum, index] : sums)
    result.push_back(index);
  return result;
}

} // namespace

Estimated_surfels estimate_surfels(const std::vector<Vec3>& points, unsigned number_of_neighbors,
                                   double outlier_percentage, unsigned number_of_threads,
                                   const std::function<bool(double)>& callback)
{
  const auto begin_step = [&]
  {
    if(callback)
      callback(0.);
  };
  if(number_of_neighbors < 6)
    throw Invalid_argument_error("Normals must be estimated from at least 6 neighbors.");
  if(!(outlier_percentage >= 0.) || !(outlier_percentage <= 100.))
    throw Invalid_argument_error("The percentage of outliers must lie between 0 and 100.");
  const auto check_number_of_points = [&](std::size_t number_of_points)
  {
    if(number_of_points <= number_of_neighbors)
      throw Unsupported_surface_error("The number of points must exceed the number of neighbors.");
  };
  check_number_of_points(points.size());

  Estimated_surfels result;
  std::vector<std::size_t> indices(points.size());
  std::iota(indices.begin(), indices.end(), 0);
  if(outlier_percentage > 0.)
  {
    indices = sort_by_neighbor_distance(points, number_of_neighbors, number_of_threads);
    const auto end =
        indices.end() - std::lround(outlier_percentage / 100. * double(indices.size()));
    result.removed.assign(end, indices.end());
    indices.erase(end, indices.end());
    check_number_of_points(indices.size());
    std::sort(indices.begin(), indices.end());
  }
  begin_step();
  std::vector<Vec3> kept_points;
  for(const std::size_t index : indices)
    kept_points.push_back(points[index]);
  const std::vector<Vec3> normals =
      estimate_normals(kept_points, number_of_neighbors, true, number_of_threads, callback);
  begin_step();
  Surfel_cloud_options options;
  options.number_of_threads = number_of_threads;
  const Surfel_cloud cloud = make_cloud(std::move(kept_points), normals, {}, options);
  begin_step();
  result.normals.assign(points.size(), {0., 0., 1.});
  result.radii.assign(points.size(), 0.);
  for(std::size_t i = 0; i < indices.size(); ++i)
  {
    result.normals[indices[i]] = normals[i];
    result.radii[indices[i]] = cloud.frame.scale * cloud.radius[cloud.internal_vertex[i]];
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
