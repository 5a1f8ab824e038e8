// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/normals.h"

#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/core/Queue.h>
#include <CGAL/Geodesic_processing/internal/mesh/locality.h>
#include "numerics/nearest_quadric.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Equal points have one number, in the order of their coordinates.
std::vector<Index> number_distinct(const std::vector<Spatial>& points,
                                   std::vector<Spatial>& distinct)
{
  std::vector<Index> order(points.size()), number(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return points[i] < points[j]; });
  for(const Index i : order)
  {
    if(distinct.empty() || distinct.back() != points[i])
      distinct.push_back(points[i]);
    number[i] = Index(distinct.size() - 1);
  }
  return number;
}

// Each point's nearest ones, and those of which it is one.
struct Neighborhoods
{
  explicit Neighborhoods(const std::vector<Index>& near, std::size_t size)
      : first(near.size() / size + 1, 0), around(2 * near.size())
  {
    for(std::size_t i = 0; i < near.size(); ++i)
    {
      ++first[i / size];
      ++first[near[i]];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    for(std::size_t i = 0; i < near.size(); ++i)
    {
      around[--first[i / size]] = near[i];
      around[--first[near[i]]] = Index(i / size);
    }
  }

  std::vector<std::size_t> first; // #points + 1
  std::vector<Index> around;
};

void orient(const std::vector<Spatial>& points, const Neighborhoods& neighborhoods,
            std::vector<Spatial>& normals)
{
  const std::size_t n = points.size();
  std::vector<Index> seeds(n), parent(n);
  std::iota(seeds.begin(), seeds.end(), 0);
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](Index i, Index j) { return points[i][2] > points[j][2]; });
  std::vector<double> cost(n, infinity); // of joining the tree; less than any when it is in it
  Queue queue(n);
  for(const Index seed : seeds)
  {
    if(cost[seed] != infinity)
      continue;
    if(normals[seed][2] < 0.)
      normals[seed] = -1. * normals[seed];
    parent[seed] = seed;
    queue.push(seed, 0.);
    while(!queue.empty())
    {
      const Index i = queue.pop().site;
      cost[i] = -infinity;
      if(dot(normals[i], normals[parent[i]]) < 0.)
        normals[i] = -1. * normals[i];
      for(std::size_t k = neighborhoods.first[i]; k < neighborhoods.first[i + 1]; ++k)
      {
        const Index j = neighborhoods.around[k];
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

} // namespace

std::vector<Spatial> estimate_normals(const std::vector<Spatial>& points, unsigned neighbors,
                                      bool oriented, unsigned threads)
{
  std::vector<Spatial> framed = points, point;
  to_frame(framed, unit_frame(points));
  const std::vector<Index> number = number_distinct(framed, point);
  const std::size_t n = point.size();
  std::vector<Spatial> distinct(n, {0., 0., 1.});
  if(n > 2)
  {
    std::vector<Index> order;
    const Kd_tree tree(point, order, threads);
    const std::size_t size = std::min<std::size_t>(neighbors + 1, n);
    std::vector<Spatial> normal(n);
    std::vector<Index> near(n * size);
    visit_nearest(point, tree, size - 1, threads,
                  [&](std::size_t, Index i, const std::vector<Kd_tree::Neighbor>& found)
                  {
                    std::vector<Spatial> around;
                    for(const Kd_tree::Neighbor& neighbor : found)
                    {
                      near[size * i + around.size()] = neighbor.point;
                      around.push_back(point[neighbor.point]);
                    }
                    const Quadric quadric = nearest_quadric(point[i], around);
                    normal[i] = quadric.unit > 0. ? quadric.normal() : Spatial{0., 0., 1.};
                  });
    if(oriented)
      orient(point, Neighborhoods(near, size), normal);
    for(std::size_t i = 0; i < n; ++i)
      distinct[order[i]] = normal[i];
  }
  std::vector<Spatial> result;
  for(const Index i : number)
    result.push_back(distinct[i]);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
