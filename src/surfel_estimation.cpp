// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef GEODESIC_PROCESSING_HAS_TBB
#  define CGAL_LINKED_WITH_TBB
#endif
#include <CGAL/Geodesic_processing/internal/surfel_estimation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/Surfel_cloud.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/remove_outliers.h>
#include <CGAL/tags.h>

#ifdef GEODESIC_PROCESSING_HAS_TBB
#  include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = Simple_cartesian<double>;
using Entry = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;
using Point_map = Nth_of_tuple_property_map<0, Entry>;
using Normal_map = Nth_of_tuple_property_map<1, Entry>;

// Moves outliers behind the others, whose end it returns, and gives these their normals.
template <typename Concurrency_tag>
std::vector<Entry>::iterator estimate(std::vector<Entry>& entries, unsigned neighbors,
                                      double outlier_percentage)
{
  const auto points = CGAL::parameters::point_map(Point_map());
  const auto end = outlier_percentage > 0.
                       ? remove_outliers<Concurrency_tag>(
                             entries, neighbors, points.threshold_percent(outlier_percentage))
                       : entries.end();
  auto kept = make_range(entries.begin(), end);
  jet_estimate_normals<Concurrency_tag>(kept, neighbors, points.normal_map(Normal_map()));
  return end;
}

} // namespace

Estimated_surfels estimate_surfels(const std::vector<Spatial>& points, unsigned neighbors,
                                   double outlier_percentage, unsigned threads)
{
  if(neighbors < 6)
    throw Invalid_argument_error("A normal needs six neighbours.");
  if(!(outlier_percentage >= 0.) || !(outlier_percentage <= 100.))
    throw Invalid_argument_error("The percentage of outliers must lie between 0 and 100.");
  if(points.size() <= neighbors)
    throw Unsupported_surface_error("There are fewer points than neighbours that a normal needs.");
  unit_frame(points); // which throws where they are not finite

  std::vector<Entry> entries;
  for(std::size_t i = 0; i < points.size(); ++i)
    entries.emplace_back(Kernel::Point_3(points[i][0], points[i][1], points[i][2]),
                         Kernel::Vector_3(0., 0., 0.), i);
  auto end = entries.end();
#ifdef GEODESIC_PROCESSING_HAS_TBB
  if(threads > 1)
    tbb::task_arena(std::min(int(threads), tbb::info::default_concurrency()))
        .execute([&] { end = estimate<Parallel_tag>(entries, neighbors, outlier_percentage); });
  else
#endif
    end = estimate<Sequential_tag>(entries, neighbors, outlier_percentage);
  Estimated_surfels result;
  for(auto entry = end; entry != entries.end(); ++entry)
    result.removed.push_back(std::get<2>(*entry));
  entries.erase(end, entries.end());
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
