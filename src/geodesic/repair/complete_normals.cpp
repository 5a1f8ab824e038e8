// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/complete_normals.h"

#include "readers/vectors.h"

// Not public: estimate_surfels() rejects clouds with at most as many points as neighbors, orients
// all normals, and also computes radii.
#include "surfels/normals.h"
// Not public: The search trees of CGAL return any of several points at the same distance, and
// overflow if coordinates are large. The orientation of normals must be deterministic.
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace program {

namespace {

// Not public: The includes above have the reasons.
using CGAL::Geodesic_processing::internal::estimate_normals;
using CGAL::Geodesic_processing::internal::Kd_tree;
using CGAL::Geodesic_processing::internal::to_frame;
using CGAL::Geodesic_processing::internal::unit_frame;

constexpr unsigned number_of_neighbors = 16;

// Returns the unit vector, or zero if v is zero or not finite. Avoids overflow and underflow. A unit
// vector, up to round-off errors of its normalization, is returned as it is: the results of a cloud
// do not change if it is written with its normals and read again.
Point unit(Point v)
{
  if(std::abs(dot(v, v) - 1.) <= 4. * std::numeric_limits<double>::epsilon())
    return v;
  double size = 0.;
  for(const double x : v)
  {
    if(!std::isfinite(x))
      return {0., 0., 0.};
    size = std::max(size, std::abs(x));
  }
  if(size == 0.)
    return {0., 0., 0.};
  for(double& x : v)
    x /= size;
  const double length = norm(v);
  for(double& x : v)
    x /= length;
  return v;
}

bool is_zero(const Point& v) { return v[0] == 0. && v[1] == 0. && v[2] == 0.; }

// Replaces missing normals by estimated ones, oriented like the normal of the nearest point that
// has one.
void fill_missing_normals(std::vector<Point> points, const std::vector<Point>& estimated,
                          std::vector<Point>& normals)
{
  to_frame(points, unit_frame(points));
  std::vector<Point> known_points, known_normals;
  for(std::size_t i = 0; i < points.size(); ++i)
    if(!is_zero(normals[i]))
    {
      known_points.push_back(points[i]);
      known_normals.push_back(normals[i]);
    }
  std::vector<std::uint32_t> order;
  const Kd_tree tree(known_points, order);
  for(std::size_t i = 0; i < points.size(); ++i)
    if(is_zero(normals[i]))
    {
      const bool agrees =
          dot(estimated[i], known_normals[order[tree.nearest(known_points, points[i])]]) >= 0.;
      normals[i] = (agrees ? 1. : -1.) * estimated[i];
    }
}

} // namespace

bool complete_normals(Surface_file& cloud, unsigned threads)
{
  const std::size_t n = cloud.points.size();
  const bool had_normals = !cloud.normals.empty();
  cloud.normals.resize(n, Point{0., 0., 0.});
  for(Point& normal : cloud.normals)
    normal = unit(normal);
  const auto number_of_missing =
      static_cast<std::size_t>(std::count_if(cloud.normals.begin(), cloud.normals.end(), is_zero));
  if(number_of_missing == 0)
    return false;

  std::vector<Point> estimated =
      estimate_normals(cloud.points, number_of_neighbors, number_of_missing == n, threads);
  if(number_of_missing == n)
    cloud.normals = std::move(estimated);
  else
    fill_missing_normals(cloud.points, estimated, cloud.normals);
  return had_normals;
}

} // namespace program
