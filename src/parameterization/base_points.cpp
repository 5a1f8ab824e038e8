// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>

#include "core/prefetch.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Of base points, in parts of the width of a patch. Corridors of a maze are turned round with 0.99, and not
// with 0.92 or less.
constexpr double widest_spacing = 0.85;

// Of each sample the distance that reaches its `nearest` nearest ones, itself among them, along chains of
// samples whose cells touch: not below the true one.
std::vector<double> reaches(const Glued_triangles& t, const Sampling& sampling, std::size_t nearest)
{
  using Link = std::pair<double, Index>; // length, sample
  const std::size_t number = sampling.samples().size();
  std::vector<std::vector<Link>> links(number);
  const auto join = [&](Index a, Index b, double length)
  {
    const Index i = sampling.labels()[a], j = sampling.labels()[b];
    if(i == j || i == none || j == none)
      return;
    length += sampling.distances()[a] + sampling.distances()[b];
    const auto shorten = [&](Index from, Index to)
    {
      const auto found = std::find_if(links[from].begin(), links[from].end(),
                                      [&](const Link& link) { return link.second == to; });
      if(found == links[from].end())
        links[from].emplace_back(length, to);
      else
        found->first = std::min(found->first, length);
    };
    shorten(i, j);
    shorten(j, i);
  };
  for(Index side = 0; side < t.corner.size(); ++side)
    join(t.corner[side], t.corner[next_side(side)], t.length[side]);
  for(Index site = 0; t.is_cloud() && site < t.number_of_sites(); ++site)
    for(Index arc = t.graph.first[site]; arc < t.graph.first[site + 1]; ++arc)
      join(site, t.graph.target[arc], t.graph.length[arc]);

  std::vector<double> result(number, infinity), length(number, infinity);
  for(Index start = 0; start < number; ++start)
  {
    std::priority_queue<Link, std::vector<Link>, std::greater<>> queue;
    std::vector<Index> touched = {start};
    std::size_t found = 0;
    length[start] = 0.;
    for(queue.emplace(0., start); !queue.empty() && found < nearest;)
    {
      const auto [so_far, sample] = queue.top();
      queue.pop();
      if(so_far > length[sample])
        continue;
      if(++found == nearest)
        result[start] = so_far;
      for(const auto& [step, next] : links[sample])
        if(so_far + step < length[next])
        {
          if(length[next] == infinity)
            touched.push_back(next);
          length[next] = so_far + step;
          queue.emplace(length[next], next);
        }
    }
    for(const Index sample : touched)
      length[sample] = infinity;
  }
  return result;
}

// The straight line between the sources of two fronts that come to a side from different triangles; longer
// than any where it does not cross the side.
double across(double side, const std::array<double, 2>& from, const std::array<double, 2>& to)
{
  const Planar p = third_corner(side, from[0], from[1]), q = third_corner(side, to[0], to[1]);
  const double height = p[1] + q[1];
  if(!(height > 0.))
    return infinity;
  const double crossing = (p[0] * q[1] + q[0] * p[1]) / height;
  return crossing >= 0. && crossing <= side ? std::hypot(p[0] - q[0], height) : infinity;
}

// Where the ways to two samples are shortest together.
struct Meeting
{
  double length = infinity;
  Index site = none;
  bool is_between = false; // their shortest path passes there
};

double distance_to(const Base_points& base, Index point, Index site)
{
  const auto begin = base.point.begin() + std::ptrdiff_t(base.nearest * site);
  const auto end = begin + std::ptrdiff_t(base.nearest);
  const auto found = std::find(begin, end, point);
  return found == end ? infinity : base.distance[std::size_t(found - base.point.begin())];
}

// The shortest line past a site where two fronts meet: straight across one of the sides around it, or through
// it.  Where one of the fronts does not go all around it the path may pass elsewhere.
void measure_between(const Glued_triangles& t, std::vector<Meeting>& meetings, Base_points& base)
{
  const std::size_t number = base.size();
  for(Index i = 0; i < number; ++i)
    for(Index j = 0; j < i; ++j)
    {
      Meeting& meeting = meetings[i * number + j];
      if(meeting.site == none)
        continue;
      double straight = infinity;
      // Through a site only where it is an end, or the path bends at a border.
      const bool is_end = meeting.site == base.sites[i] || meeting.site == base.sites[j];
      bool is_surrounded = true, is_on_border = is_end || t.is_cloud();
      if(!is_end)
        for(Index c = t.first[meeting.site]; c < t.first[meeting.site + 1]; ++c)
          for(Index side = t.star[c] - t.star[c] % 3, k = 0; k < 3; ++k, ++side)
          {
            const Index p = t.corner[side], q = t.corner[next_side(side)];
            const std::array<double, 2> from = {distance_to(base, i, p), distance_to(base, i, q)},
                                        to = {distance_to(base, j, p), distance_to(base, j, q)};
            if(from[0] < infinity && from[1] < infinity && to[0] < infinity && to[1] < infinity)
              straight = std::min(straight, across(t.length[side], from, to));
            else
              is_surrounded = false;
            is_on_border = is_on_border || t.twin[side] == none;
          }
      meeting.is_between = straight < infinity || (is_surrounded && is_on_border);
      base.between[i * number + j] = base.between[j * number + i] =
          std::min(meeting.length, straight);
    }
}

// Of the other pairs the straight line across two triangles of samples, the smallest ones, when that is shorter.
void complete_between(const std::vector<Meeting>& meetings, Base_points& base)
{
  const std::size_t number = base.size();
  const auto is_known = [&](Index i, Index j)
  { return meetings[std::max(i, j) * number + std::min(i, j)].is_between; };
  std::vector<Index> common;
  for(Index i = 0; i < number; ++i)
    for(Index j = 0; j < i; ++j)
    {
      if(meetings[i * number + j].site == none || is_known(i, j))
        continue;
      common.clear();
      for(Index k = 0; k < number; ++k)
        if(k != i && k != j && is_known(i, k) && is_known(j, k))
          common.push_back(k);
      double least = infinity, straight = infinity;
      for(std::size_t a = 1; a < common.size(); ++a)
        for(std::size_t b = 0; b < a; ++b)
        {
          if(!is_known(common[a], common[b]))
            continue;
          const auto d = [&](Index p, Index q) { return base.distance_between(p, q); };
          const std::array<double, 2> from = {d(i, common[a]), d(i, common[b])},
                                      to = {d(j, common[a]), d(j, common[b])};
          const double around = from[0] + from[1] + to[0] + to[1];
          if(!(around < least))
            continue;
          if(const double length = across(d(common[a], common[b]), from, to); length < infinity)
          {
            least = around;
            straight = length;
          }
        }
      double& length = base.between[i * number + j];
      length = std::min(length, straight);
      base.between[j * number + i] = length;
    }
}

} // namespace

std::size_t base_points_across(const Glued_triangles& t)
{
  if(t.is_cloud())
    return usual_base_points;
  double area = 0., border = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const double* const l = &t.length[3 * std::size_t(f)];
    area += 0.5 * twice_area(l[0], l[1], l[2]);
    for(Index side = 3 * f; side < 3 * f + 3; ++side)
      border += t.twin[side] == none ? t.length[side] : 0.;
  }
  // Each has a hexagon for itself.
  const double spacing = widest_spacing * 2. * area / border;
  const double number = 2. / std::sqrt(3.) * area / (spacing * spacing);
  return number > double(usual_base_points)
             ? std::size_t(std::min(number, double(most_base_points)))
             : usual_base_points;
}

Base_points nearest_base_points(const Glued_triangles& t, const Sampling& sampling, Front front,
                                std::size_t nearest, const std::function<bool(double)>& callback)
{
  Base_points result;
  const std::size_t number = sampling.samples().size(), sites = t.number_of_sites();
  for(const Location& sample : sampling.samples())
    result.sites.push_back(sample.site);
  nearest = std::min(nearest, number);
  result.nearest = nearest;
  result.point.assign(nearest * sites, none);
  result.distance.assign(nearest * sites, infinity);

  // A hair more than what rounding takes away.
  constexpr double margin = 1. + 1e-9;
  const std::vector<double> reach = reaches(t, sampling, nearest);
  std::vector<double> bound(sites, infinity);
  for(const Index site : sampling.sites())
    if(const Index sample = sampling.labels()[site]; sample != none)
      bound[site] = margin * (sampling.distances()[site] + reach[sample]);

  // So many sites take longer than memory does.
  constexpr std::size_t ahead = 16, line = 64;
  const auto prefetch_known_of = [&](Index site)
  {
    const std::size_t begin = nearest * site, end = begin + nearest;
    for(std::size_t i = begin; i < end; i += line / sizeof(double))
      prefetch(&result.distance[i]);
    prefetch(&result.distance[end - 1]);
    prefetch(&result.point[begin]);
    prefetch(&result.point[end - 1]);
    prefetch(&bound[site]);
  };
  Front_limits limits;
  limits.known = &bound;
  for(Index sample = 0; sample < number; ++sample)
  {
    if(callback && !callback(double(sample) / double(number)))
      return {};
    front.run({{{sampling.samples()[sample]}, 0., 0}}, limits);
    const std::vector<Index>& reached = front.reached();
    for(std::size_t k = 0; k < reached.size(); ++k)
    {
      if(k + ahead < reached.size())
        prefetch_known_of(reached[k + ahead]);
      const Index site = reached[k];
      const double distance = front.distance(site);
      const std::size_t begin = nearest * site;
      std::size_t place = begin + nearest - 1;
      if(!(distance < result.distance[place]))
        continue;
      for(; place > begin && distance < result.distance[place - 1]; --place)
      {
        result.distance[place] = result.distance[place - 1];
        result.point[place] = result.point[place - 1];
      }
      result.distance[place] = distance;
      result.point[place] = sample;
      bound[site] = std::min(bound[site], margin * result.distance[begin + nearest - 1]);
    }
  }

  std::vector<Meeting> meetings(number * number);
  for(Index site = 0; site < sites; ++site)
  {
    const Index* points = &result.point[nearest * site];
    const double* distances = &result.distance[nearest * site];
    for(std::size_t a = 1; a < nearest && points[a] != none; ++a)
      for(std::size_t b = 0; b < a; ++b)
      {
        Meeting& meeting =
            meetings[std::max(points[a], points[b]) * number + std::min(points[a], points[b])];
        if(const double length = distances[a] + distances[b]; length < meeting.length)
          meeting = {length, site};
      }
  }
  result.between.assign(number * number, infinity);
  for(std::size_t i = 0; i < number; ++i)
    result.between[i * number + i] = 0.;
  measure_between(t, meetings, result);
  complete_between(meetings, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
