// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/Graph_search.h>

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

Graph_search::Graph_search(const Site_graph& graph, const std::vector<Spatial>& point)
    : m_graph(&graph), m_point(&point)
{}

void Graph_search::begin(Side& side, Index site, const Spatial* goal)
{
  if(side.sites.empty())
  {
    side.sites.resize(m_point->size());
    side.queue = Queue(m_point->size());
  }
  side.queue.clear();
  side.goal = goal;
  reach(side, site, 0., none);
}

void Graph_search::reach(Side& side, Index index, double distance, Index from)
{
  Site& site = side.sites[index];
  if(site.run < m_run)
    site = {infinity, none, m_run};
  if(site.run > m_run || !(distance < site.distance))
    return;
  site.distance = distance;
  site.from = from;
  // Sums of the same lengths in another order differ by rounding: the bound must not cut by it.
  constexpr double below = 1. - 1e-14;
  const double bound = side.goal == nullptr ? 0. : below * norm((*m_point)[index] - *side.goal);
  side.queue.push(index, distance + bound);
}

Index Graph_search::spread(Side& side)
{
  const Index index = side.queue.pop().site;
  Site& site = side.sites[index];
  site.run = m_run + 1;
  ++m_visited;
  for(Index arc = m_graph->first[index]; arc < m_graph->first[index + 1]; ++arc)
    reach(side, m_graph->target[arc], site.distance + m_graph->length[arc], index);
  return index;
}

std::vector<Index> Graph_search::operator()(Index from, Index to, Surfel_search method)
{
  m_run += 2;
  m_visited = 0;
  Side &forward = m_sides[0], &backward = m_sides[1];
  const bool is_two_sided = method == Surfel_search::bidirectional;
  begin(forward, from, method == Surfel_search::a_star ? &(*m_point)[to] : nullptr);
  if(is_two_sided)
    begin(backward, to, nullptr);

  Index middle = none;
  double best = infinity;
  const auto is_open = [&]
  {
    if(!is_two_sided)
      return middle == none && !forward.queue.empty();
    return !forward.queue.empty() && !backward.queue.empty() &&
           forward.queue.front().key + backward.queue.front().key < best;
  };
  while(is_open())
  {
    if(!is_two_sided)
    {
      if(spread(forward) == to)
        middle = to;
      continue;
    }
    const bool is_forward = forward.queue.front().key <= backward.queue.front().key;
    Side &near = is_forward ? forward : backward, &far = is_forward ? backward : forward;
    const Index site = spread(near);
    const auto meet = [&](Index other)
    {
      if(!is_reached(near, other) || !is_reached(far, other))
        return;
      const double length = near.sites[other].distance + far.sites[other].distance;
      if(length < best)
      {
        best = length;
        middle = other;
      }
    };
    meet(site);
    for(Index arc = m_graph->first[site]; arc < m_graph->first[site + 1]; ++arc)
      meet(m_graph->target[arc]);
  }
  std::vector<Index> chain;
  for(Index site = middle; site != none; site = forward.sites[site].from)
    chain.push_back(site);
  std::reverse(chain.begin(), chain.end());
  if(is_two_sided && middle != none)
    for(Index site = backward.sites[middle].from; site != none; site = backward.sites[site].from)
      chain.push_back(site);
  return chain;
}

} // namespace CGAL::Geodesic_processing::internal
