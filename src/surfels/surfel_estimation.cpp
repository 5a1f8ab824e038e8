// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_estimation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/mesh/locality.h>
#include "surfels/normals.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The places of points in the order of their mean squared distances from their neighbours.
std::vector<std::size_t> nearest_together(std::vector<Spatial> points, unsigned neighbors,
                                          unsigned threads)
{
  to_frame(points, unit_frame(points));
  std::vector<Index> order;
  const Kd_tree tree(points, order, threads);
  std::vector<std::pair<double, std::size_t>> sums(points.size());
  visit_nearest(points, tree, neighbors, threads,
                [&](std::size_t, Index i, const std::vector<Kd_tree::Neighbor>& found)
                {
                  sums[i] = {0., order[i]};
                  for(const Kd_tree::Neighbor& neighbor : found)
                    sums[i].first += neighbor.squared_distance;
                });
  std::sort(sums.begin(), sums.end());
  std::vector<std::size_t> result;
  for(const auto& [sum, place] : sums)
    result.push_back(place);
  return result;
}

} // namespace

Estimated_surfels estimate_surfels(const std::vector<Spatial>& points, unsigned neighbors,
                                   double outlier_percentage, unsigned threads)
{
  if(neighbors < 6)
    throw Invalid_argument_error("A normal needs six neighbours.");
  if(!(outlier_percentage >= 0.) || !(outlier_percentage <= 100.))
    throw Invalid_argument_error("The percentage of outliers must lie between 0 and 100.");
  const auto check_number = [&](std::size_t number)
  {
    if(number <= neighbors)
      throw Unsupported_surface_error(
          "There are fewer points than neighbours that a normal needs.");
  };
  check_number(points.size());

  Estimated_surfels result;
  std::vector<std::size_t> places(points.size());
  std::iota(places.begin(), places.end(), 0);
  if(outlier_percentage > 0.)
  {
    places = nearest_together(points, neighbors, threads);
    const auto end = places.end() - std::lround(outlier_percentage / 100. * double(places.size()));
    result.removed.assign(end, places.end());
    places.erase(end, places.end());
    check_number(places.size());
    std::sort(places.begin(), places.end());
  }
  std::vector<Spatial> kept;
  for(const std::size_t place : places)
    kept.push_back(points[place]);
  const std::vector<Spatial> normals = estimate_normals(kept, neighbors, true, threads);
  Cloud_options options;
  options.threads = threads;
  const Surfel_cloud cloud = make_cloud(std::move(kept), normals, {}, options);
  result.normals.assign(points.size(), {0., 0., 1.});
  result.radii.assign(points.size(), 0.);
  for(std::size_t i = 0; i < places.size(); ++i)
  {
    result.normals[places[i]] = normals[i];
    result.radii[places[i]] = cloud.frame.scale * cloud.radius[cloud.site_of_surfel[i]];
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
