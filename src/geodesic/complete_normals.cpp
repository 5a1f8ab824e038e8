// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace program {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr unsigned neighbours = 16;

// Of unit length, or zero where there is none.  Neither overflows nor underflows.
Point unit(Point v)
{
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
  const double length = std::hypot(v[0], v[1], v[2]);
  for(double& x : v)
    x /= length;
  return v;
}

bool is_zero(const Point& v) { return v[0] == 0. && v[1] == 0. && v[2] == 0.; }

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The points moved and scaled into a box of size about one: squares of their distances are then
// ordinary numbers.
std::vector<Point> to_unit_box(const std::vector<Point>& points)
{
  Point low = points[0], high = points[0];
  for(const Point& p : points)
    for(std::size_t c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  double size = 0.;
  for(std::size_t c = 0; c < 3; ++c)
    size = std::max(size, high[c] / 2. - low[c] / 2.);
  std::vector<Point> scaled = points;
  for(Point& p : scaled)
    for(std::size_t c = 0; c < 3; ++c)
      p[c] = size == 0. ? 0. : (p[c] / 2. - low[c] / 2.) / size;
  return scaled;
}

// Equal points have one number, in the order of their coordinates.
std::vector<std::size_t> number_distinct(const std::vector<Point>& points,
                                         std::vector<Point>& distinct)
{
  std::vector<std::size_t> order(points.size()), number(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
  for(const std::size_t i : order)
  {
    if(distinct.empty() || distinct.back() != points[i])
      distinct.push_back(points[i]);
    number[i] = distinct.size() - 1;
  }
  return number;
}

// Point, normal, and place in the input: orientation reorders them.
using Surfel = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;

// Unit normals of points that are all different, of one side where that can be told.
std::vector<Point> estimate(const std::vector<Point>& points, bool oriented)
{
  std::vector<Point> normals(points.size(), Point{0., 0., 1.});
  // Two points have a line at most.
  if(points.size() < 3)
    return normals;
  std::vector<Surfel> surfels(points.size());
  for(std::size_t i = 0; i < points.size(); ++i)
    surfels[i] = {{points[i][0], points[i][1], points[i][2]}, {0., 0., 0.}, i};
  const unsigned k = static_cast<unsigned>(std::min<std::size_t>(neighbours, points.size() - 1));
  const auto maps = CGAL::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Surfel>())
                        .normal_map(CGAL::Nth_of_tuple_property_map<1, Surfel>());
  CGAL::pca_estimate_normals<CGAL::Sequential_tag>(surfels, k, maps);
  // What has no normal (all neighbours in one place, to rounding) must not enter the tree.
  for(auto& [point, normal, i] : surfels)
  {
    const Point n = unit({normal.x(), normal.y(), normal.z()});
    normal = is_zero(n) ? Kernel::Vector_3(0., 0., 1.) : Kernel::Vector_3(n[0], n[1], n[2]);
  }
  if(oriented)
    CGAL::mst_orient_normals(surfels, k, maps);
  for(const auto& [point, normal, i] : surfels)
    normals[i] = {normal.x(), normal.y(), normal.z()};
  return normals;
}

// Turns each normal to the side of the nearest one given: the sum of those at its place, or at the
// nearest place that has some.
void turn_like_given(const std::vector<Point>& given, const std::vector<std::size_t>& number,
                     const std::vector<Point>& places, std::vector<Point>& normals)
{
  std::vector<Point> sum(places.size(), Point{0., 0., 0.});
  for(std::size_t i = 0; i < given.size(); ++i)
    for(std::size_t c = 0; c < 3; ++c)
      sum[number[i]][c] += given[i][c];

  using Numbered = std::tuple<Kernel::Point_3, std::size_t>;
  using Traits = CGAL::Search_traits_adapter<Numbered, CGAL::Nth_of_tuple_property_map<0, Numbered>,
                                             CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  Search::Tree tree;
  for(std::size_t d = 0; d < places.size(); ++d)
    if(!is_zero(sum[d]))
      tree.insert({{places[d][0], places[d][1], places[d][2]}, d});
  if(tree.empty())
    return;
  for(std::size_t d = 0; d < places.size(); ++d)
  {
    const Search search(tree, {places[d][0], places[d][1], places[d][2]}, 1);
    if(dot(normals[d], sum[std::get<1>(search.begin()->first)]) < 0.)
      for(double& x : normals[d])
        x = -x;
  }
}

} // namespace

bool complete_normals(Surface_file& cloud)
{
  const std::size_t n = cloud.points.size();
  const bool given = !cloud.normals.empty();
  cloud.normals.resize(n, Point{0., 0., 0.});
  for(Point& normal : cloud.normals)
    normal = unit(normal);
  const auto missing =
      static_cast<std::size_t>(std::count_if(cloud.normals.begin(), cloud.normals.end(), is_zero));
  if(missing == 0)
    return false;

  std::vector<Point> distinct;
  const std::vector<std::size_t> number = number_distinct(to_unit_box(cloud.points), distinct);
  std::vector<Point> normals = estimate(distinct, missing == n);
  if(missing == n)
    for(std::size_t i = 0; i < n; ++i)
      cloud.normals[i] = normals[number[i]];
  else
  {
    turn_like_given(cloud.normals, number, distinct, normals);
    for(std::size_t i = 0; i < n; ++i)
      if(is_zero(cloud.normals[i]))
        cloud.normals[i] = normals[number[i]];
  }
  return given;
}

} // namespace program
