// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Path_finder::Path_finder(std::shared_ptr<const Glued_triangles> triangles)
    : m_triangles(std::move(triangles)), m_sites(m_triangles->number_of_sites()),
      m_queue(m_triangles->number_of_sites())
{
  if(!m_triangles->is_cloud())
    m_hops.resize(m_triangles->corner.size());
}

// ----------------------------------------------------------------------------------------- hops

namespace {

// Whether the line between two points passes between two others, one on each side of it.
bool passes(const Planar& p, const Planar& q, const Planar& right, const Planar& left)
{
  return cross(q - p, right - p) < 0. && cross(q - p, left - p) > 0.;
}

} // namespace

const Path_finder::Hops& Path_finder::hops(Index corner)
{
  Hops& hops = m_hops[corner];
  if(hops.across >= 0.f)
    return hops;
  const Glued_triangles& t = *m_triangles;
  constexpr float never = std::numeric_limits<float>::infinity();
  hops = {never, never, never};
  const Index side = next_side(corner), entered = t.twin[side];
  if(entered == none)
    return hops;

  // The side lies on the first axis, its left end (seen from the corner) at the origin.
  const double base = t.length[side];
  const Planar left = {0., 0.}, right = {base, 0.};
  Planar begin = third_corner(base, t.length[previous_side(corner)], t.length[corner]);
  begin[1] = -begin[1];
  const double to_left = t.length[previous_side(entered)], to_right = t.length[next_side(entered)];
  const Planar top = third_corner(base, to_left, to_right);
  if(passes(begin, top, right, left))
    hops.across = static_cast<float>(norm(top - begin));

  const auto beyond = [&](Index out, const Planar& out_left, const Planar& out_right)
  {
    const Index behind = t.twin[out];
    const double length = t.length[out];
    if(behind == none || !(length > 0.))
      return never;
    const Planar local =
        third_corner(length, t.length[previous_side(behind)], t.length[next_side(behind)]);
    const Planar along = (1. / length) * (out_right - out_left);
    const Planar end = out_left + local[0] * along + local[1] * turned_left(along);
    return passes(begin, end, right, left) && passes(begin, end, out_right, out_left)
               ? static_cast<float>(norm(end - begin))
               : never;
  };
  hops.to_right = beyond(next_side(entered), top, right);
  hops.to_left = beyond(previous_side(entered), left, top);
  return hops;
}

// Calls f with each site that one step leads to, the step's length, where it comes from, and how.
template <typename Function>
void Path_finder::for_each_way(Index site, Function f)
{
  const Glued_triangles& t = *m_triangles;
  if(t.is_cloud())
  {
    for(Index arc = t.graph.first[site]; arc < t.graph.first[site + 1]; ++arc)
      f(t.graph.target[arc], t.graph.length[arc], site, Way::arc);
    return;
  }
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    const Index corner = t.star[i], side = next_side(corner), before = previous_side(corner);
    f(t.corner[side], t.length[corner], corner, Way::arc);
    if(t.twin[before] == none)
      f(t.corner[before], t.length[before], corner, Way::arc);
    const Index entered = t.twin[side];
    if(entered == none)
      continue;
    const Hops& hop = hops(corner);
    if(std::isfinite(hop.across))
      f(t.corner[previous_side(entered)], hop.across, corner, Way::across);
    if(std::isfinite(hop.to_right))
      f(t.corner[previous_side(t.twin[next_side(entered)])], hop.to_right, corner, Way::to_right);
    if(std::isfinite(hop.to_left))
      f(t.corner[previous_side(t.twin[previous_side(entered)])], hop.to_left, corner, Way::to_left);
  }
}

// The sites that a location sees in its triangles and behind their sides.
std::vector<Path_finder::Link> Path_finder::links(const Location& location) const
{
  const Glued_triangles& t = *m_triangles;
  const Index site = site_of(t, location);
  if(site != none)
    return {{site, 0., {}}};
  std::vector<Link> result;
  std::array<Index, 2> holders = {location.triangle, none};
  if(const Index side = side_of(location); !t.is_cloud() && side != none && t.twin[side] != none)
    holders[1] = t.twin[side] / 3;
  for(const Index triangle : holders)
  {
    if(triangle == none)
      break;
    const auto b = *seen_from(t, triangle, location);
    const auto corners = unfolded(t, triangle);
    const Planar x = unfolded_point(corners, b);
    for(Index side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      result.push_back({t.corner[side], norm(corners[side % 3] - x), {}});
      if(t.is_cloud() || t.twin[side] == none || b[previous_side(side) % 3] == 0.)
        continue;
      // Behind the side: its right end, seen from inside, is where it begins.
      const Index entered = t.twin[side];
      const Planar right = corners[side % 3], left = corners[next_side(side) % 3];
      const double base = t.length[side];
      if(!(base > 0.))
        continue;
      const Planar local =
          third_corner(base, t.length[previous_side(entered)], t.length[next_side(entered)]);
      const Planar along = (1. / base) * (right - left);
      const Planar end = left + local[0] * along + local[1] * turned_left(along);
      if(!passes(x, end, right, left))
        continue;
      const double from_right = -cross(end - x, right - x), from_left = cross(end - x, left - x);
      Link link = {t.corner[previous_side(entered)], norm(end - x), {}};
      link.crossing.triangle = triangle;
      link.crossing.barycentric = on_side(side, from_right / (from_right + from_left));
      link.crossing = cleaned(t, link.crossing);
      result.push_back(link);
    }
  }
  return result;
}

// --------------------------------------------------------------------------------------- search

double Path_finder::bound(Index site) const
{
  if(!m_has_goal)
    return 0.;
  double result = 0.;
  if(!m_triangles->point.empty())
  {
    const auto& p = m_triangles->point[site];
    const double x = p[0] - m_goal_point[0], y = p[1] - m_goal_point[1], z = p[2] - m_goal_point[2];
    result = std::sqrt(x * x + y * y + z * z);
  }
  for(unsigned i = 0; i < m_number_of_landmarks; ++i)
  {
    // Comparisons with NaN are false.
    const double distance = m_landmarks[std::size_t(site) * m_number_of_landmarks + i];
    if(distance - m_goal_range[i][1] > result)
      result = distance - m_goal_range[i][1];
    if(m_goal_range[i][0] - distance > result)
      result = m_goal_range[i][0] - distance;
  }
  return result;
}

void Path_finder::reach(Index index, double distance, Index from, Way way)
{
  Site& site = m_sites[index];
  if(site.run < m_run)
  {
    site.run = m_run;
    site.distance = infinity;
    site.bound = bound(index);
    site.goal = none;
  }
  if(site.run == m_run && distance < site.distance)
  {
    site.distance = distance;
    site.from = from;
    site.way = way;
    m_queue.push(index, distance + site.bound);
  }
}

void Path_finder::spread(Index index)
{
  Site& site = m_sites[index];
  site.run = m_run + 1;
  ++m_visited;
  const double distance = site.distance;
  for_each_way(index, [&](Index target, double length, Index from, Way way)
               { reach(target, distance + length, from, way); });
}

void Path_finder::run_everywhere(Index begin, std::vector<double>& distance)
{
  m_run += 2;
  m_has_goal = false;
  reach(begin, 0., none, Way::start);
  while(!m_queue.empty())
    spread(m_queue.pop().site);
  distance.resize(m_sites.size());
  for(std::size_t s = 0; s < m_sites.size(); ++s)
    distance[s] = m_sites[s].run > m_run ? m_sites[s].distance : infinity;
}

void Path_finder::add_landmarks(unsigned number)
{
  const std::size_t n = m_sites.size();
  if(n == 0 || number == 0)
    return;
  // Each is the site farthest from those before, the first from site 0.
  std::vector<double> nearest(n, infinity), distance;
  const std::size_t before = m_number_of_landmarks, after = before + number;
  if(before == 0)
    run_everywhere(0, nearest);
  std::vector<float> landmarks(n * after);
  for(std::size_t s = 0; s < n; ++s)
    for(std::size_t i = 0; i < before; ++i)
    {
      const double known = m_landmarks[s * before + i];
      landmarks[s * after + i] = m_landmarks[s * before + i];
      if(known < nearest[s]) // false for NaN
        nearest[s] = known;
    }
  for(std::size_t i = before; i < after; ++i)
  {
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    run_everywhere(static_cast<Index>(farthest - nearest.begin()), distance);
    for(std::size_t s = 0; s < n; ++s)
    {
      landmarks[s * after + i] = std::isfinite(distance[s])
                                     ? static_cast<float>(distance[s])
                                     : std::numeric_limits<float>::quiet_NaN();
      nearest[s] = i == 0 ? distance[s] : std::min(nearest[s], distance[s]);
    }
  }
  m_landmarks = std::move(landmarks);
  m_number_of_landmarks = static_cast<unsigned>(after);
}

std::vector<Location> Path_finder::operator()(const Location& given_from, const Location& given_to)
{
  const Glued_triangles& t = *m_triangles;
  const Location from = cleaned(t, given_from), to = cleaned(t, given_to);
  m_visited = 0;
  const Index site_from = site_of(t, from), site_to = site_of(t, to);
  const bool is_same =
      t.is_cloud() ? site_from == site_to &&
                         (site_from != none ||
                          (from.triangle == to.triangle && from.barycentric == to.barycentric))
                   : is_same_point(t, from, to);
  if(is_same)
    return {from};
  if(from.triangle != none && to.triangle != none &&
     (t.is_cloud() ? from.triangle == to.triangle : common_triangle(t, from, to) != none))
    return {from, to};

  m_run += 2;
  m_queue.clear();
  const std::vector<Link> begins = links(from), ends = links(to);

  // The lower bound at the goal
  m_has_goal = true;
  if(!t.point.empty())
  {
    m_goal_point = {0., 0., 0.};
    if(to.triangle == none)
      m_goal_point = t.point[to.site];
    else
      for(Index k = 0; k < 3; ++k)
        for(int axis = 0; axis < 3; ++axis)
          m_goal_point[axis] += to.barycentric[k] * t.point[t.corner[3 * to.triangle + k]][axis];
  }
  m_goal_range.assign(m_number_of_landmarks, {0., infinity});
  for(unsigned i = 0; i < m_number_of_landmarks; ++i)
    for(const Link& end : ends)
    {
      const double distance = m_landmarks[std::size_t(end.site) * m_number_of_landmarks + i];
      m_goal_range[i][0] = std::max(m_goal_range[i][0], distance - end.length);
      m_goal_range[i][1] = std::min(m_goal_range[i][1], distance + end.length);
    }

  for(const Link& end : ends)
    reach(end.site, infinity, none, Way::start);
  for(Index i = 0; i < ends.size(); ++i)
  {
    Index& goal = m_sites[ends[i].site].goal;
    if(goal == none || ends[i].length < ends[goal].length)
      goal = i;
  }
  for(Index i = 0; i < begins.size(); ++i)
    reach(begins[i].site, begins[i].length, i, Way::start);

  double best = infinity;
  Index last = none;
  while(!m_queue.empty() && m_queue.front().key < best)
  {
    const Index site = m_queue.pop().site;
    spread(site);
    const Index goal = m_sites[site].goal;
    if(goal != none && m_sites[site].distance + ends[goal].length < best)
    {
      best = m_sites[site].distance + ends[goal].length;
      last = site;
    }
  }
  m_queue.clear();
  if(last == none)
    return {};

  std::vector<Location> path;
  const auto add = [&](const Location& location)
  {
    if(path.empty() || t.is_cloud() || !is_same_point(t, path.back(), location))
      path.push_back(location);
  };
  add(to);
  const Link& end = ends[m_sites[last].goal];
  if(end.crossing.triangle != none)
    add(end.crossing);
  if(site_to == none)
    add(at_site(t, last));
  Index site = last;
  while(m_sites[site].way != Way::start)
  {
    const Site& here = m_sites[site];
    const Index corner = here.from;
    const auto add_side = [&](Index side)
    {
      Location location;
      location.triangle = side / 3;
      location.barycentric = on_side(side, 0.5);
      add(location);
    };
    // The point on a side that a hop crosses matters to no one: straighten() moves it.
    if(here.way == Way::to_right)
      add_side(next_side(t.twin[next_side(corner)]));
    if(here.way == Way::to_left)
      add_side(previous_side(t.twin[next_side(corner)]));
    if(here.way != Way::arc)
      add_side(next_side(corner));
    site = t.is_cloud() ? here.from : t.corner[corner];
    add(at_site(t, site));
  }
  const Link& begin = begins[m_sites[site].from];
  if(begin.crossing.triangle != none)
    add(begin.crossing);
  if(site_from == none)
    add(from);
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace CGAL::Geodesic_processing::internal
