// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfels/normals.h"

#include <CGAL/Geodesic_processing/internal/spatial_search/Kd_tree.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include "numerics/fit_quadric.h"
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <thread>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the index of each point among the distinct points, which are sorted lexicographically.
std::vector<Index> index_distinct_points(const std::vector<Vec3>& points,
                                         std::vector<Vec3>& distinct)
{
  std::vector<Index> order(points.size()), index_of_point(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index i, Index j) { return points[i] < points[j]; });
  for(const Index i : order)
  {
    if(distinct.empty() || distinct.back() != points[i])
      distinct.push_back(points[i]);
    index_of_point[i] = Index(distinct.size() - 1);
  }
  return index_of_point;
}

// The symmetric graph of nearest neighbors.
struct Neighbor_graph
{
  // nearest  #points * size: the neighbors of each point
  explicit Neighbor_graph(const std::vector<Index>& nearest, std::size_t size)
      : begin(nearest.size() / size + 1, 0), neighbors(2 * nearest.size())
  {
    for(std::size_t i = 0; i < nearest.size(); ++i)
    {
      ++begin[i / size];
      ++begin[nearest[i]];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for(std::size_t i = 0; i < nearest.size(); ++i)
    {
      neighbors[--begin[i / size]] = nearest[i];
      neighbors[--begin[nearest[i]]] = Index(i / size);
    }
  }

  std::vector<std::size_t> begin; // #points + 1
  std::vector<Index> neighbors;
};

// Flips normals such that those of neighbors agree, by Prim's algorithm in each component.
void orient(const std::vector<Vec3>& points, const Neighbor_graph& graph,
            std::vector<Vec3>& normals)
{
  const std::size_t n = points.size();
  std::vector<Index> seeds(n), parent(n);
  std::iota(seeds.begin(), seeds.end(), 0);
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](Index i, Index j) { return points[i][2] > points[j][2]; });
  std::vector<double> cost(
      n, infinity); // of adding the point to the tree; -infinity if it is in the tree
  Vertex_queue queue(n);
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
      const Index i = queue.pop().vertex;
      cost[i] = -infinity;
      if(dot(normals[i], normals[parent[i]]) < 0.)
        normals[i] = -1. * normals[i];
      for(std::size_t k = graph.begin[i]; k < graph.begin[i + 1]; ++k)
      {
        const Index j = graph.neighbors[k];
        const double edge_cost = 1. - std::abs(dot(normals[i], normals[j]));
        if(edge_cost < cost[j])
        {
          cost[j] = edge_cost;
          parent[j] = i;
          queue.push(j, edge_cost);
        }
      }
    }
  }
}

} // namespace

std::vector<Vec3> estimate_normals(const std::vector<Vec3>& points, unsigned number_of_neighbors,
                                   bool is_oriented, unsigned number_of_threads,
                                   const std::function<bool(double)>& callback)
{
  constexpr Index points_per_call = 1024;
  const auto caller = std::this_thread::get_id();
  std::vector<Vec3> scaled_points = points, point;
  to_frame(scaled_points, unit_frame(points));
  const std::vector<Index> index_of_point = index_distinct_points(scaled_points, point);
  const std::size_t n = point.size();
  std::vector<Vec3> distinct_normals(n, {0., 0., 1.});
  if(n > 2)
  {
    std::vector<Index> order;
    const Kd_tree tree(point, order, number_of_threads);
    const std::size_t size = std::min<std::size_t>(number_of_neighbors + 1, n);
    std::vector<Vec3> normal(n);
    std::vector<Index> nearest(n * size);
    visit_nearest(point, tree, size - 1, number_of_threads,
                  [&](std::size_t, Index i, const std::vector<Kd_tree::Neighbor>& found)
                  {
                    if(callback && i % points_per_call == 0 && std::this_thread::get_id() == caller)
                      callback(0.);
                    std::vector<Vec3> neighborhood;
                    for(const Kd_tree::Neighbor& neighbor : found)
                    {
                      nearest[size * i + neighborhood.size()] = neighbor.point;
                      neighborhood.push_back(point[neighbor.point]);
                    }
                    const Quadric quadric = fit_quadric(point[i], neighborhood);
                    normal[i] = quadric.length_unit > 0. ? quadric.normal() : Vec3{0., 0., 1.};
                  });
    if(is_oriented)
      orient(point, Neighbor_graph(nearest, size), normal);
    for(std::size_t i = 0; i < n; ++i)
      distinct_normals[order[i]] = normal[i];
  }
  std::vector<Vec3> result;
  for(const Index i : index_of_point)
    result.push_back(distinct_normals[i]);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
