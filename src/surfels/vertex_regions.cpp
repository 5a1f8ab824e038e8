// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/vertex_regions.h>

#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr Index region_size = 32;

// The shortest paths from the seeds to all vertices.
struct Forest
{
  std::vector<Index> parent;    // #vertices: none at seeds
  std::vector<double> distance; // #vertices: to the nearest seed
};

// Computes shortest paths by the Bellman-Ford algorithm with waves of changed vertices. A wave
// visits the vertices approximately in the order of their indices, which needs fewer cache misses
// than a priority queue.
Forest grow_forest(const Proximity_graph& graph, const std::vector<Vec3>& point,
                   std::vector<Index> wave)
{
  const std::size_t n = graph.begin.size() - 1;
  Forest forest = {std::vector<Index>(n, none), std::vector<double>(n, infinity)};
  for(const Index seed : wave)
    forest.distance[seed] = 0.;
  std::vector<bool> is_next(n, false);
  for(std::vector<Index> next; !wave.empty(); next.clear())
  {
    for(const Index v : wave)
    {
      is_next[v] = false;
      for(Index e = graph.begin[v]; e < graph.begin[v + 1]; ++e)
      {
        const Index other = graph.target[e];
        const double distance = forest.distance[v] + norm(point[other] - point[v]);
        if(!(distance < forest.distance[other]))
          continue;
        forest.distance[other] = distance;
        forest.parent[other] = v;
        if(!is_next[other])
          next.push_back(other);
        is_next[other] = true;
      }
    }
    std::swap(wave, next);
  }
  return forest;
}

// Assigns the region of its seed to each vertex.
void label_regions(const Forest& forest, std::vector<Index>& region)
{
  std::vector<Index> path;
  for(Index seed = 0; seed < region.size(); ++seed)
  {
    Index v = seed;
    for(; region[v] == none; v = forest.parent[v])
      path.push_back(v);
    for(; !path.empty(); path.pop_back())
      region[path.back()] = region[v];
  }
}

// Computes the graph of the regions.
Proximity_graph connect_regions(const Proximity_graph& graph, const std::vector<Vec3>& point,
                                const Forest& forest, const Vertex_regions& regions)
{
  // Sort the vertices by region (counting sort).
  std::vector<Index> region_begin(regions.size() + 1, 0), region_vertices(regions.region.size());
  for(const Index region : regions.region)
    ++region_begin[region + 1];
  std::partial_sum(region_begin.begin(), region_begin.end(), region_begin.begin());
  std::vector<Index> region_end = region_begin;
  for(Index v = 0; v < region_vertices.size(); ++v)
    region_vertices[region_end[regions.region[v]]++] = v;

  Proximity_graph result;
  result.begin.push_back(0);
  std::vector<double> min_length(regions.size(),
                                 infinity); // from the region to the adjacent ones
  for(Index region = 0; region < regions.size(); ++region)
  {
    for(Index i = region_begin[region]; i < region_begin[region + 1]; ++i)
      for(Index v = region_vertices[i], e = graph.begin[v]; e < graph.begin[v + 1]; ++e)
      {
        const Index other = graph.target[e], target = regions.region[other];
        if(target == region)
          continue;
        if(min_length[target] == infinity)
          result.target.push_back(target);
        const double length =
            forest.distance[v] + norm(point[other] - point[v]) + forest.distance[other];
        if(length < min_length[target])
          min_length[target] = length;
      }
    for(Index e = result.begin.back(); e < result.target.size(); ++e)
      result.length.push_back(std::exchange(min_length[result.target[e]], infinity));
    result.begin.push_back(static_cast<Index>(result.target.size()));
  }
  return result;
}

} // namespace

Vertex_regions make_regions(const Proximity_graph& graph, const std::vector<Vec3>& point,
                            const std::vector<Index>& component)
{
  const std::size_t n = point.size();
  Vertex_regions regions;
  regions.region.assign(n, none);
  std::vector<Index> seeds, count(n, 0); // of each component
  for(Index v = 0; v < n; ++v)
    if(count[component[v]]++ % region_size == 0)
    {
      regions.region[v] = static_cast<Index>(seeds.size());
      regions.point.push_back(point[v]);
      seeds.push_back(v);
    }
  const Forest forest = grow_forest(graph, point, std::move(seeds));
  label_regions(forest, regions.region);
  regions.graph = connect_regions(graph, point, forest, regions);
  return regions;
}

} // namespace CGAL::Geodesic_processing::internal
