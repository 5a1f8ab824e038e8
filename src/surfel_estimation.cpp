// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfel_estimation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/Surfel_cloud.h>
#include <CGAL/Geodesic_processing/internal/locality.h>
#include <CGAL/Geodesic_processing/internal/nearest_quadric.h>
#include <CGAL/Geodesic_processing/internal/surfel_neighbors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/mst_orient_normals.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = Simple_cartesian<double>;
using Entry = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;
using Point_map = Nth_of_tuple_property_map<0, Entry>;
using Normal_map = Nth_of_tuple_property_map<1, Entry>;

// Points with a tree, and the place of each among the caller's.
struct Planted
{
  Planted(const std::vector<Spatial>& points, std::vector<std::size_t> kept, unsigned threads)
  {
    for(const std::size_t i : kept)
      point.push_back(points[i]);
    std::vector<Index> order;
    tree = Kd_tree(point, order, threads);
    for(const Index i : order)
      place.push_back(kept[i]);
  }

  std::vector<Spatial> point;
  Kd_tree tree;
  std::vector<std::size_t> place; // #points
};

// The places of points in the order of their mean squared distances from their neighbours.
std::vector<std::size_t> nearest_together(const Planted& planted, unsigned neighbors,
                                          unsigned threads)
{
  std::vector<std::pair<double, std::size_t>> sums(planted.point.size());
  visit_nearest(planted.point, planted.tree, neighbors, threads,
                [&](std::size_t, Index i, const std::vector<Kd_tree::Neighbor>& found)
                {
                  sums[i] = {0., planted.place[i]};
                  for(const Kd_tree::Neighbor& neighbor : found)
                    sums[i].first += neighbor.squared_distance;
                });
  std::sort(sums.begin(), sums.end());
  std::vector<std::size_t> result;
  for(const auto& [sum, place] : sums)
    result.push_back(place);
  return result;
}

std::vector<Spatial> estimated_normals(const Planted& planted, unsigned neighbors, unsigned threads)
{
  std::vector<Spatial> result(planted.point.size());
  visit_nearest(planted.point, planted.tree, neighbors, threads,
                [&](std::size_t, Index i, const std::vector<Kd_tree::Neighbor>& found)
                {
                  std::vector<Spatial> around;
                  for(const Kd_tree::Neighbor& neighbor : found)
                    around.push_back(planted.point[neighbor.point]);
                  const Quadric quadric = nearest_quadric(planted.point[i], around);
                  result[i] = quadric.unit > 0. ? quadric.normal() : Spatial{0., 0., 1.};
                });
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
  std::vector<Spatial> framed = points;
  to_frame(framed, unit_frame(points));

  Estimated_surfels result;
  std::vector<std::size_t> places(points.size());
  std::iota(places.begin(), places.end(), 0);
  if(outlier_percentage > 0.)
  {
    places = nearest_together(Planted(framed, places, threads), neighbors, threads);
    const auto end = places.end() - std::lround(outlier_percentage / 100. * double(places.size()));
    result.removed.assign(end, places.end());
    places.erase(end, places.end());
    check_number(places.size());
    std::sort(places.begin(), places.end());
  }
  const Planted planted(framed, places, threads);
  const std::vector<Spatial> estimated = estimated_normals(planted, neighbors, threads);
  std::vector<Entry> entries;
  for(std::size_t i = 0; i < planted.point.size(); ++i)
  {
    const Spatial &p = planted.point[i], &n = estimated[i];
    entries.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]),
                         planted.place[i]);
  }
  mst_orient_normals(entries, neighbors,
                     CGAL::parameters::point_map(Point_map()).normal_map(Normal_map()));

  result.normals.assign(points.size(), {0., 0., 1.});
  result.radii.assign(points.size(), 0.);
  std::vector<Spatial> kept, normals;
  for(const auto& [point, normal, place] : entries)
  {
    kept.push_back(points[place]);
    normals.push_back({normal.x(), normal.y(), normal.z()});
    result.normals[place] = normals.back();
  }
  Cloud_options options;
  options.threads = threads;
  const Surfel_cloud cloud = make_cloud(std::move(kept), std::move(normals), {}, options);
  for(std::size_t i = 0; i < entries.size(); ++i)
    result.radii[std::get<2>(entries[i])] =
        cloud.frame.scale * cloud.radius[cloud.site_of_surfel[i]];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
