// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/Surfel_cloud.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Builds a symmetric graph. The edges of a surfel to its neighbors with are_connected(i, j,
// length) are sorted by distance. Edges whose reverse is missing follow: surfel i is a neighbor of
// j, but j is not among the neighbors of i. This only occurs beyond the search radius of i.
template <typename Are_connected>
Proximity_graph make_graph(const std::vector<Vec3>& point, const Ragged_rows& neighbors,
                           const std::vector<double>& search_radius, unsigned number_of_threads,
                           const Are_connected& are_connected)
{
  const std::size_t n = point.size();
  Proximity_graph graph;
  graph.begin.assign(n + 1, 0);
  std::vector<std::vector<std::pair<Index, Index>>> missing_edges((n + surfel_block_size - 1) /
                                                                  surfel_block_size);
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(const Index* j = neighbors.begin(i); j != neighbors.end(i); ++j)
                     {
                       const double length = norm(point[*j] - point[i]);
                       if(!are_connected(i, *j, length))
                         continue;
                       ++graph.begin[i + 1];
                       if(length > search_radius[*j] * (1. - 1e-12) &&
                          std::find(neighbors.begin(*j), neighbors.end(*j), i) == neighbors.end(*j))
                         missing_edges[block].emplace_back(*j, i);
                     }
                 });
  // Sort the reverse edges by their first vertex (counting sort).
  std::vector<Index> reverse_begin(n + 1, 0);
  for(const auto& block_edges : missing_edges)
    for(const auto& e : block_edges)
    {
      ++graph.begin[e.first + 1];
      ++reverse_begin[e.first + 1];
    }
  std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
  std::partial_sum(reverse_begin.begin(), reverse_begin.end(), reverse_begin.begin());
  std::vector<Index> reverse_targets(reverse_begin.back()), reverse_end = reverse_begin;
  for(const auto& block_edges : missing_edges)
    for(const auto& e : block_edges)
      reverse_targets[reverse_end[e.first]++] = e.second;
  graph.target.resize(graph.begin.back());
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t, std::size_t begin, std::size_t end)
                 {
                   Index i = static_cast<Index>(begin), e = graph.begin[i];
                   for(; i < end; ++i)
                   {
                     for(const Index* j = neighbors.begin(i); j != neighbors.end(i); ++j)
                       if(are_connected(i, *j, norm(point[*j] - point[i])))
                         graph.target[e++] = *j;
                     for(Index k = reverse_begin[i]; k < reverse_begin[i + 1]; ++k)
                       graph.target[e++] = reverse_targets[k];
                   }
                 });
  return graph;
}

// Labels the connected components by union-find. Threads unite the vertices of each block in
// parallel; then the edges between blocks are processed sequentially. O(n) in practice.
void label_components(unsigned number_of_threads, Surfel_cloud& cloud)
{
  const Proximity_graph& graph = cloud.graph;
  std::vector<Index>& label = cloud.component; // the parent in the forest, at most the vertex
  const std::size_t n = cloud.number_of_vertices();
  label.resize(n);
  const auto find_root = [&](Index v)
  {
    while(label[v] != v)
      v = label[v] = label[label[v]];
    return v;
  };
  const auto unite = [&](Index a, Index b)
  {
    a = find_root(a);
    b = find_root(b);
    return label[std::max(a, b)] = std::min(a, b);
  };
  std::vector<std::vector<std::pair<Index, Index>>> cross_block_edges((n + surfel_block_size - 1) /
                                                                      surfel_block_size);
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index v = static_cast<Index>(begin); v < end; ++v)
                   {
                     Index root = label[v] = v;
                     for(Index e = graph.begin[v]; e < graph.begin[v + 1]; ++e)
                       if(const Index other = graph.target[e]; other < begin)
                         cross_block_edges[block].emplace_back(other, v);
                       else if(other < v && label[other] != root) // avoids most of the calls
                         root = unite(other, root);
                   }
                 });
  for(const auto& block_edges : cross_block_edges)
    for(const auto& [a, b] : block_edges)
      unite(a, b);
  // A root is the first vertex of its component, so components are numbered by their first
  // vertices.
  for(Index v = 0; v < n; ++v)
    label[v] = label[v] == v ? cloud.number_of_components++ : label[label[v]];
}

} // namespace

Surfel_cloud make_cloud(std::vector<Vec3> points, std::vector<Vec3> normals,
                        const std::vector<double>& radii, const Surfel_cloud_options& options,
                        const Frame* frame)
{
  check_sizes(points.size(), normals.size(), radii.size());
  if(!(options.maximum_angle > 0.) || options.maximum_angle > std::acos(-1.) || options.rank == 0 ||
     options.neighbors == 0)
    throw Invalid_argument_error(
        "The maximum angle between the normals of neighbors must be positive and at most pi, and "
        "the number of neighbors and the rank must be positive.");
  const Compatibility_test compatibility_test = {std::cos(options.maximum_angle)};
  normalize(normals);
  Surfel_cloud cloud;
  static_cast<Sorted_surfels&>(cloud) = sort_surfels(
      std::move(points), normals, compatibility_test.cosine, options.number_of_threads, frame);
  Neighbor_distances distances;
  const Ragged_rows neighbors = find_neighbors(cloud, &compatibility_test, options.neighbors,
                                               options.number_of_threads, distances);
  cloud.radius = surfel_radii(cloud, radii, neighbors, options.rank, options.number_of_threads);
  const auto graph = [&](const Ragged_rows& rows, const auto& are_connected)
  {
    cloud.graph = make_graph(cloud.point, rows, distances.search_radius, options.number_of_threads,
                             are_connected);
  };
  if(options.graph == Surfel_graph::extended_spheres)
    graph(neighbors, [&](Index i, Index j, double length)
          { return length <= options.influence_ratio * (cloud.radius[i] + cloud.radius[j]); });
  else
  {
    const Ragged_rows all_neighbors =
        find_neighbors(cloud, nullptr, options.neighbors, options.number_of_threads, distances);
    if(options.graph == Surfel_graph::nearest)
      graph(all_neighbors, [](Index, Index, double) { return true; });
    else
    {
      std::vector<double> nearest(cloud.number_of_vertices(), 0.);
      for(Index i = 0; i < nearest.size(); ++i)
        if(all_neighbors.begin(i) != all_neighbors.end(i))
          nearest[i] = norm(cloud.point[*all_neighbors.begin(i)] - cloud.point[i]);
      graph(all_neighbors,
            [&](Index i, Index j, double length) { return length <= nearest[i] + nearest[j]; });
    }
  }
  label_components(options.number_of_threads, cloud);
  cloud.spacing = std::move(distances.spacing);
  cloud.search_radius = std::move(distances.search_radius);
  return cloud;
}

} // namespace CGAL::Geodesic_processing::internal
