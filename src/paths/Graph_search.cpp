// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sums of the same lengths in another order differ by rounding: the bound must not cut by it.
constexpr double below = 1. - 1e-14;

// Chains of leaders go to and fro, and are longer than the way in space: with a bound of so much more
// a search visits half as many, and on spheres and tori finds chains as short.
constexpr double detour = 1.1;

// Where the way crosses so few regions, nothing is left out.
constexpr std::size_t short_way = 16;

// Where it crosses so many, a search that fills them all takes longer than the path does that is drawn
// from its chain.  It is led from each region to the leader so many farther along the way, by distances
// so much larger than those in space that it hardly looks aside: it visits a third.
constexpr std::size_t long_way = 40, look_ahead = 8;
constexpr double lead_factor = 1.1;

} // namespace

Graph_search::Graph_search(const Site_graph& graph, const std::vector<Spatial>& point,
                           const Site_regions* regions)
    : m_graph(&graph), m_point(&point), m_regions(regions), m_bound(below)
{
  if(regions == nullptr)
    return;
  m_coarse.emplace_back(regions->graph, regions->point);
  m_coarse[0].m_bound = detour;
  m_open.resize(regions->size(), 0);
  m_ahead.resize(regions->size(), 0);
}

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
  {
    if(m_is_narrow && m_open[m_regions->region[index]] != m_run)
      return;
    site = {infinity, none, m_run};
  }
  if(site.run > m_run || !(distance < site.distance))
    return;
  site.distance = distance;
  site.from = from;
  side.queue.push(index, distance + remaining(side, index));
}

Index Graph_search::spread(Side& side)
{
  const Index index = side.queue.pop().site;
  Site& site = side.sites[index];
  site.run = m_run + 1;
  ++m_visited;
  const std::vector<Spatial>& point = *m_point;
  for(Index arc = m_graph->first[index]; arc < m_graph->first[index + 1]; ++arc)
  {
    const Index other = m_graph->target[arc];
    const double length =
        m_graph->length.empty() ? norm(point[other] - point[index]) : m_graph->length[arc];
    reach(side, other, site.distance + length, index);
  }
  return index;
}

// Leads a search from the open regions along the way.
void Graph_search::lead(const std::vector<Index>& way, Index to)
{
  const Site_graph& graph = m_regions->graph;
  const std::size_t n = way.size();
  m_way.clear();
  for(const Index region : way)
    m_way.push_back(m_regions->point[region]);
  m_way.resize(n + look_ahead, (*m_point)[to]);
  m_rest.assign(n + look_ahead, 0.);
  for(std::size_t i = n; i-- > 0;)
    m_rest[i] = m_rest[i + look_ahead] + norm(m_way[i + look_ahead] - m_way[i]);
  // Neighbours of several follow the last; those on the way know their place.
  for(Index i = 0; i < n; ++i)
    for(Index arc = graph.first[way[i]]; arc < graph.first[way[i] + 1]; ++arc)
      m_ahead[graph.target[arc]] = i + look_ahead;
  for(Index i = 0; i < n; ++i)
    m_ahead[way[i]] = i + look_ahead;
}

// What a search in the direction of a goal takes for the length of the rest.
double Graph_search::remaining(const Side& side, Index site) const
{
  if(side.goal == nullptr)
    return 0.;
  const Spatial& point = (*m_point)[site];
  if(!m_is_led)
    return m_bound * norm(point - *side.goal);
  const Index place = m_ahead[m_regions->region[site]];
  return lead_factor * (norm(point - m_way[place]) + m_rest[place]);
}

// Opens the regions on the way and their neighbours.  Returns false where there is no way.
bool Graph_search::narrow(Index from, Index to)
{
  const Site_graph& graph = m_regions->graph;
  const std::vector<Index> way =
      m_coarse[0](m_regions->region[from], m_regions->region[to], Surfel_search::a_star);
  m_visited = m_coarse[0].visited();
  m_is_narrow = way.size() > short_way;
  if(m_is_narrow)
    for(const Index region : way)
    {
      m_open[region] = m_run;
      for(Index arc = graph.first[region]; arc < graph.first[region + 1]; ++arc)
        m_open[graph.target[arc]] = m_run;
    }
  m_is_led = way.size() > long_way;
  if(m_is_led)
    lead(way, to);
  return !way.empty();
}

std::vector<Index> Graph_search::operator()(Index from, Index to, Surfel_search method)
{
  m_run += 2;
  m_visited = 0;
  m_is_narrow = m_is_led = false;
  if(method != Surfel_search::coarse_to_fine)
    return find(from, to, method);
  if(m_regions != nullptr && !narrow(from, to))
    return {};
  return find(from, to, Surfel_search::a_star);
}

std::vector<Index> Graph_search::find(Index from, Index to, Surfel_search method)
{
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
