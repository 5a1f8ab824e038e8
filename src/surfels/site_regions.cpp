// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/site_regions.h>

#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr Index region_size = 32;

// The shortest chains from leaders to all sites.
struct Forest
{
  std::vector<Index> from;      // #sites: none for leaders
  std::vector<double> distance; // #sites: from the leader
};

// Lengths settle in waves from the leaders, each in about the order of the sites: unlike the pops of
// a queue, they stay in the cache.
Forest grow(const Site_graph& graph, const std::vector<Spatial>& point, std::vector<Index> wave)
{
  const std::size_t n = graph.first.size() - 1;
  Forest forest = {std::vector<Index>(n, none), std::vector<double>(n, infinity)};
  for(const Index leader : wave)
    forest.distance[leader] = 0.;
  std::vector<bool> is_next(n, false);
  for(std::vector<Index> next; !wave.empty(); next.clear())
  {
    for(const Index site : wave)
    {
      is_next[site] = false;
      for(Index arc = graph.first[site]; arc < graph.first[site + 1]; ++arc)
      {
        const Index other = graph.target[arc];
        const double distance = forest.distance[site] + norm(point[other] - point[site]);
        if(!(distance < forest.distance[other]))
          continue;
        forest.distance[other] = distance;
        forest.from[other] = site;
        if(!is_next[other])
          next.push_back(other);
        is_next[other] = true;
      }
    }
    std::swap(wave, next);
  }
  return forest;
}

// Gives each site, by the forest, the region of its leader.
void label_regions(const Forest& forest, std::vector<Index>& region)
{
  std::vector<Index> chain;
  for(Index seed = 0; seed < region.size(); ++seed)
  {
    Index site = seed;
    for(; region[site] == none; site = forest.from[site])
      chain.push_back(site);
    for(; !chain.empty(); chain.pop_back())
      region[chain.back()] = region[site];
  }
}

Site_graph join_regions(const Site_graph& graph, const std::vector<Spatial>& point,
                        const Forest& forest, const Site_regions& regions)
{
  // The sites of each region.
  std::vector<Index> first(regions.size() + 1, 0), member(regions.region.size());
  for(const Index region : regions.region)
    ++first[region + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Index> end = first;
  for(Index site = 0; site < member.size(); ++site)
    member[end[regions.region[site]]++] = site;

  Site_graph result;
  result.first.push_back(0);
  std::vector<double> least(regions.size(), infinity); // from the region to each that it touches
  for(Index region = 0; region < regions.size(); ++region)
  {
    for(Index i = first[region]; i < first[region + 1]; ++i)
      for(Index site = member[i], arc = graph.first[site]; arc < graph.first[site + 1]; ++arc)
      {
        const Index other = graph.target[arc], target = regions.region[other];
        if(target == region)
          continue;
        if(least[target] == infinity)
          result.target.push_back(target);
        const double length =
            forest.distance[site] + norm(point[other] - point[site]) + forest.distance[other];
        if(length < least[target])
          least[target] = length;
      }
    for(Index arc = result.first.back(); arc < result.target.size(); ++arc)
      result.length.push_back(std::exchange(least[result.target[arc]], infinity));
    result.first.push_back(static_cast<Index>(result.target.size()));
  }
  return result;
}

} // namespace

Site_regions make_regions(const Site_graph& graph, const std::vector<Spatial>& point,
                          const std::vector<Index>& component)
{
  const std::size_t n = point.size();
  Site_regions regions;
  regions.region.assign(n, none);
  std::vector<Index> leaders, count(n, 0); // of each component
  for(Index site = 0; site < n; ++site)
    if(count[component[site]]++ % region_size == 0)
    {
      regions.region[site] = static_cast<Index>(leaders.size());
      regions.point.push_back(point[site]);
      leaders.push_back(site);
    }
  const Forest forest = grow(graph, point, std::move(leaders));
  label_regions(forest, regions.region);
  regions.graph = join_regions(graph, point, forest, regions);
  return regions;
}

} // namespace CGAL::Geodesic_processing::internal
