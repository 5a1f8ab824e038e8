// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include <CGAL/Geodesic_processing/internal/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/Queue.h>
#include <CGAL/Geodesic_processing/internal/parallel.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace program {

namespace {

using CGAL::Geodesic_processing::internal::for_each_block;
using CGAL::Geodesic_processing::internal::Index;
using CGAL::Geodesic_processing::internal::Kd_tree;
using CGAL::Geodesic_processing::internal::Queue;

constexpr std::size_t neighbours = 16;

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

// Each point's nearest ones, itself among them.
struct Neighbourhoods
{
  std::size_t size;        // of each
  std::vector<Index> near; // size #points

  const Index* begin(std::size_t i) const { return near.data() + size * i; }
  const Index* end(std::size_t i) const { return begin(i + 1); }
};

// The direction in which some points vary least.
Point normal_across(const std::vector<Point>& points, const Index* begin, const Index* end)
{
  // Moments about the first of them; the solver reads the lower triangle.
  const double* const origin = points[*begin].data();
  double sum[3] = {0., 0., 0.}, moment[3][3] = {};
  for(const Index* i = begin; i != end; ++i)
  {
    const double* const p = points[*i].data();
    const double d[3] = {p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]};
    for(int r = 0; r < 3; ++r)
    {
      sum[r] += d[r];
      for(int c = 0; c <= r; ++c)
        moment[r][c] += d[r] * d[c];
    }
  }
  const double count = static_cast<double>(end - begin);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(int r = 0; r < 3; ++r)
    for(int c = 0; c <= r; ++c)
      covariance(r, c) = moment[r][c] - sum[r] * sum[c] / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d normal = solver.eigenvectors().col(0);
  const Point n = unit({normal[0], normal[1], normal[2]});
  return is_zero(n) ? Point{0., 0., 1.} : n;
}

// Turns normals to one side along a minimum spanning tree of all neighbourhoods, in which those are
// near whose normals differ little (Hoppe et al. 1992).  In each part the highest one looks up.
void orient_along_tree(const std::vector<Point>& points, const Neighbourhoods& neighbourhoods,
                       std::vector<Point>& normals)
{
  const std::size_t n = points.size();
  // Neighbours, and those of which a point is one.
  std::vector<std::size_t> first(n + 1, 0);
  for(std::size_t i = 0; i < n; ++i)
  {
    first[i] += neighbourhoods.size;
    for(const Index* j = neighbourhoods.begin(i); j != neighbourhoods.end(i); ++j)
      ++first[*j];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> around(first[n]);
  for(std::size_t i = 0; i < n; ++i)
    for(const Index* j = neighbourhoods.begin(i); j != neighbourhoods.end(i); ++j)
    {
      around[--first[i]] = *j;
      around[--first[*j]] = static_cast<Index>(i);
    }

  std::vector<Index> seeds(n);
  std::iota(seeds.begin(), seeds.end(), 0);
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](Index i, Index j) { return points[i][2] > points[j][2]; });
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> cost(n, infinity); // of joining the tree; less than any when it is in it
  std::vector<Index> parent(n);
  Queue queue(n);
  const auto turn = [](Point& normal, bool turns)
  {
    for(double& x : normal)
      x = turns ? -x : x;
  };
  for(const Index seed : seeds)
  {
    if(cost[seed] != infinity)
      continue;
    turn(normals[seed], normals[seed][2] < 0.);
    parent[seed] = seed;
    queue.push(seed, 0.);
    while(!queue.empty())
    {
      const Index i = queue.pop().site;
      cost[i] = -infinity;
      turn(normals[i], dot(normals[i], normals[parent[i]]) < 0.);
      for(std::size_t k = first[i]; k < first[i + 1]; ++k)
      {
        const Index j = around[k];
        const double step = 1. - std::abs(dot(normals[i], normals[j]));
        if(step < cost[j])
        {
          cost[j] = step;
          parent[j] = i;
          queue.push(j, step);
        }
      }
    }
  }
}

// Unit normals of points that are all different, of one side where that can be told.
std::vector<Point> estimate(const std::vector<Point>& points, bool oriented, unsigned threads)
{
  const std::size_t n = points.size();
  std::vector<Point> normals(n, Point{0., 0., 1.});
  // Two points have a line at most.
  if(n < 3)
    return normals;
  std::vector<Point> sorted = points;
  std::vector<Index> order;
  const Kd_tree tree(sorted, order, threads);
  Neighbourhoods neighbourhoods = {std::min(neighbours + 1, n), {}};
  neighbourhoods.near.resize(n * neighbourhoods.size);
  std::vector<Point> found(n);
  for_each_block(n, 1024, threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   std::vector<Kd_tree::Neighbor> nearest;
                   for(std::size_t i = begin; i < end; ++i)
                   {
                     tree.nearest(sorted, sorted[i], neighbourhoods.size, nearest);
                     std::transform(nearest.begin(), nearest.end(),
                                    neighbourhoods.near.begin() +
                                        static_cast<std::ptrdiff_t>(neighbourhoods.size * i),
                                    [](const Kd_tree::Neighbor& j) { return j.point; });
                     found[i] =
                         normal_across(sorted, neighbourhoods.begin(i), neighbourhoods.end(i));
                   }
                 });
  if(oriented)
    orient_along_tree(sorted, neighbourhoods, found);
  for(std::size_t i = 0; i < n; ++i)
    normals[order[i]] = found[i];
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

  std::vector<Point> known;
  std::vector<Index> place, order;
  for(std::size_t d = 0; d < places.size(); ++d)
    if(!is_zero(sum[d]))
    {
      known.push_back(places[d]);
      place.push_back(static_cast<Index>(d));
    }
  if(known.empty())
    return;
  const Kd_tree tree(known, order);
  for(std::size_t d = 0; d < places.size(); ++d)
    if(dot(normals[d], sum[place[order[tree.nearest(known, places[d])]]]) < 0.)
      for(double& x : normals[d])
        x = -x;
}

} // namespace

bool complete_normals(Surface_file& cloud, unsigned threads)
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
  std::vector<Point> normals = estimate(distinct, missing == n, threads);
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
