// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>

#include "core/arcs.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The heap is filled anew whenever the covering radius has fallen by this factor: a scan for each
// some ten samples out of a hundred, out of a thousand and so on.  A smaller factor leaves more
// sites in the heap whose distance has fallen meanwhile.
constexpr double refill_factor = 0.8;

// Of a site along arcs, in the mean: most take one.  A bound for webs of needles.
constexpr std::size_t most_visits = 5;

bool is_sampled(const Glued_triangles& t, const std::vector<double>* slowness, Index site)
{
  if(t.is_cloud() && t.first[site] == t.first[site + 1])
    return t.graph.first[site] < t.graph.first[site + 1];
  const auto is_open = [&](Index corner)
  { return !slowness || (*slowness)[corner / 3] < infinity; };
  return std::any_of(t.star.begin() + t.first[site], t.star.begin() + t.first[site + 1], is_open);
}

} // namespace

Sampling::Sampling(std::shared_ptr<const Glued_triangles> triangles, Front front,
                   Sample_place place, std::shared_ptr<const std::vector<double>> slowness)
    : m_triangles(std::move(triangles)), m_front(std::move(front)),
      m_place(m_triangles->is_cloud() ? Sample_place::site : place),
      m_distances(m_triangles->number_of_sites(), infinity),
      m_labels(m_triangles->number_of_sites(), none)
{
  m_limits.slowness = std::move(slowness);
  if(m_place == Sample_place::triangle)
    m_is_taken.resize(m_triangles->number_of_triangles());
  for(Index site = 0; site < m_distances.size(); ++site)
    if(is_sampled(*m_triangles, m_limits.slowness.get(), site))
      m_sites.push_back(site);
}

bool Sampling::add(const std::vector<Location>& samples,
                   const std::function<bool(double)>& callback)
{
  m_limits.known = &m_distances;
  m_limits.callback = callback;
  std::vector<Source> sources;
  sources.reserve(samples.size());
  for(const Location& sample : samples)
    sources.push_back({{sample}, 0., 0});
  const bool is_finished = m_front.run(sources, m_limits);
  const Index first = Index(m_samples.size());
  for(const Location& sample : samples)
  {
    m_samples.push_back(sample);
    if(!m_is_taken.empty() && sample.triangle != none)
      m_is_taken[sample.triangle] = true;
  }
  for(const Index site : m_front.reached())
    if(const double distance = m_front.distance(site); distance < m_distances[site])
    {
      m_distances[site] = distance;
      m_labels[site] = first + m_front.source(site);
    }
  return is_finished;
}

Index Sampling::farthest_site()
{
  while(m_first_unreached < m_sites.size() && m_distances[m_sites[m_first_unreached]] < infinity)
    ++m_first_unreached;
  if(m_first_unreached < m_sites.size())
    return m_sites[m_first_unreached];
  for(;;)
  {
    if(m_heap.empty())
      refill();
    if(m_heap.empty())
      return none;
    const auto [key, site] = m_heap.front();
    const double distance = m_distances[site];
    if(distance == key)
      return site;
    std::pop_heap(m_heap.begin(), m_heap.end());
    m_heap.pop_back();
    if(distance >= m_threshold)
    {
      m_heap.push_back({distance, site});
      std::push_heap(m_heap.begin(), m_heap.end());
    }
  }
}

void Sampling::refill()
{
  // All are below the threshold, and the largest mostly not far below.
  double largest = m_threshold;
  for(int pass = 0; m_heap.empty() && pass < 2; ++pass)
  {
    m_threshold = refill_factor * largest;
    largest = 0.;
    for(const Index site : m_sites)
    {
      const double distance = m_distances[site];
      largest = std::max(largest, distance);
      if(distance >= m_threshold && distance > 0.)
        m_heap.push_back({distance, site});
    }
  }
  std::make_heap(m_heap.begin(), m_heap.end());
}

double Sampling::covering_radius()
{
  const Index site = farthest_site();
  return site == none ? 0. : m_distances[site];
}

Location Sampling::farthest(Index start)
{
  const Index site = farthest_site();
  if(site == none)
    return {};
  if(m_distances[site] == infinity)
    return {none, end_of_part(start == none ? site : start), {}};
  return m_place == Sample_place::site ? Location{none, site, {}} : beside(site);
}

// A site at an end of the part of the surface that holds a site: the farthest one along arcs, which is
// near enough to the farthest one.  What waits is not sorted: all that is nearer than the mean comes next,
// and once more where a later way is shorter (Glover and others 1985), in a third of the time of a heap.
Index Sampling::end_of_part(Index start)
{
  m_ways.resize(m_distances.size(), infinity);
  m_waits.resize(m_distances.size(), false);
  std::vector<Index> reached = {start}, near = {start}, far;
  m_ways[start] = 0.;
  double threshold = 0.;
  std::size_t visits = 0;
  const auto go_on_from = [&](Index site)
  {
    const double way = m_ways[site];
    m_waits[site] = false;
    ++visits;
    const auto reach = [&](Index target, double length)
    {
      const double last = m_ways[target];
      if(!(way + length < last))
        return;
      m_ways[target] = way + length;
      if(last == infinity)
        reached.push_back(target);
      else if(m_waits[target] || visits > most_visits * reached.size())
        return;
      m_waits[target] = true;
      (way + length <= threshold ? near : far).push_back(target);
    };
    for_each_arc(*m_triangles, m_limits.slowness.get(), site, reach);
  };
  while(!near.empty())
  {
    for(std::size_t i = 0; i < near.size(); ++i)
      go_on_from(near[i]);
    double sum = 0.;
    for(const Index site : far)
      sum += m_ways[site];
    threshold = sum / double(far.size());
    const auto is_far = [&](Index site) { return m_ways[site] > threshold; };
    const auto middle = std::partition(far.begin(), far.end(), is_far);
    near.assign(middle, far.end());
    far.erase(middle, far.end());
    // By rounding the mean of few may be below all of them.
    if(near.empty())
      near.swap(far);
  }
  Entry farthest = {0., start};
  for(const Index site : reached)
  {
    farthest = std::max(farthest, Entry{m_ways[site], site});
    m_ways[site] = infinity;
  }
  return farthest.site;
}

// Peyré and Cohen 2003, section 3.1: between the farthest site, its farthest neighbour, and the
// farther of the two behind the side that joins them, where the fronts meet that came to them.
Location Sampling::beside(Index site) const
{
  const Glued_triangles& t = *m_triangles;
  const Location at_site = {none, site, {}};
  Entry neighbour = {-1., none}, third = {-1., none};
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    for(const Index corner : {next_side(t.star[i]), previous_side(t.star[i])})
      neighbour = std::max(neighbour, Entry{m_distances[t.corner[corner]], t.corner[corner]});
  Index triangle = none;
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    const Index next = t.corner[next_side(t.star[i])],
                previous = t.corner[previous_side(t.star[i])];
    if(next != neighbour.site && previous != neighbour.site)
      continue;
    const Index opposite = next == neighbour.site ? previous : next;
    if(third < Entry{m_distances[opposite], opposite})
    {
      third = {m_distances[opposite], opposite};
      triangle = t.star[i] / 3;
    }
  }
  // One sample inside a triangle is enough: more of them would not be told apart by its corners.
  if(triangle == none || m_is_taken[triangle] || !(neighbour.key < infinity) ||
     !(third.key < infinity) || !(slowness(triangle) < infinity))
    return at_site;

  // At a border fronts meet along it.
  std::vector<Index> sides;
  for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
  {
    const std::array<Index, 2> ends = {t.corner[side], t.corner[next_side(side)]};
    const bool joins = (ends[0] == site && ends[1] == neighbour.site) ||
                       (ends[1] == site && ends[0] == neighbour.site);
    if(joins && t.twin[side] == none)
      sides = {side};
  }
  if(sides.empty())
    sides = {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};

  Location result = {triangle, none, {0., 0., 0.}};
  for(const Index side : sides)
  {
    const double width = slowness(triangle) * t.length[side];
    const double rise = m_distances[t.corner[next_side(side)]] - m_distances[t.corner[side]];
    const double share = width > 0. ? std::clamp(0.5 + 0.5 * rise / width, 0., 1.) : 0.5;
    const auto meeting = on_side(side, share);
    for(int j = 0; j < 3; ++j)
      result.barycentric[j] += meeting[j] / double(sides.size());
  }
  result = cleaned(t, result);
  // Where one front came to all three of them, at a border or around a tip, they do not meet.
  return distance_in(triangle, result.barycentric) > m_distances[site] ? result : at_site;
}

// The distance of a place in a triangle, where fronts enter it as straight lines.
double Sampling::distance_in(Index triangle, const std::array<double, 3>& barycentric) const
{
  const Glued_triangles& t = *m_triangles;
  const auto corners = unfolded(t, triangle);
  const Planar p = unfolded_point(corners, barycentric);
  double result = infinity;
  for(Index k = 0; k < 3; ++k)
  {
    const Index side = 3 * triangle + k, x = t.corner[side], z = t.corner[next_side(side)];
    const Planar way = p - corners[k], base = corners[(k + 1) % 3] - corners[k];
    result = std::min(result, m_distances[x] + slowness(triangle) * norm(way));
    const double length = norm(base);
    const double rise = (m_distances[z] - m_distances[x]) / (slowness(triangle) * length);
    if(m_labels[x] != m_labels[z] || !(std::abs(rise) < 1.))
      continue;
    const Straight_front front(length, rise, turned_back(way, (1. / length) * base));
    result = std::min(result, m_distances[x] + slowness(triangle) * front.gain);
  }
  return result;
}

bool sample_farthest(Sampling& sampling, const Sampling_goal& goal,
                     const std::function<void(double)>& out)
{
  std::size_t added = 0;
  std::function<bool(double)> callback;
  if(goal.callback)
    callback = [&](double) { return goal.callback(double(added) / double(goal.number)); };
  const std::vector<Index>& sites = sampling.sites();
  Index start = none;
  if(sampling.samples().empty() && !sites.empty())
    start = sites[std::mt19937(goal.seed)() % sites.size()];
  for(double radius = sampling.covering_radius();
      added < goal.number && radius > goal.covering_radius; start = none)
  {
    if(callback && !callback(0.))
      return false;
    const bool is_finished = sampling.add(sampling.farthest(start), callback);
    ++added;
    radius = sampling.covering_radius();
    out(radius);
    if(!is_finished)
      return false;
  }
  return true;
}

} // namespace CGAL::Geodesic_processing::internal
