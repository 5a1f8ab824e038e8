// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/voronoi.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Voronoi::Voronoi(std::shared_ptr<const Glued_triangles> triangles, Front front,
                 const std::vector<Source>& sources, Index number_of_cells,
                 const Front_limits& limits)
    : m_triangles(std::move(triangles)), m_slowness(limits.slowness),
      m_distances(m_triangles->number_of_sites(), infinity),
      m_labels(m_triangles->number_of_sites(), none)
{
  std::vector<std::vector<Source>> cells(number_of_cells);
  for(const Source& source : sources)
  {
    cells[source.label].push_back(source);
    m_is_circular = m_is_circular && source.offset == 0.;
  }
  m_is_circular = m_is_circular && !m_slowness;

  std::size_t done = 0;
  Front_limits bounded = limits;
  bounded.targets.clear();
  if(limits.callback)
    bounded.callback = [&](double)
    { return limits.callback(double(done) / double(number_of_cells + 1)); };
  m_is_finished = front.run(sources, bounded);
  for(const Index site : front.reached())
  {
    m_distances[site] = front.distance(site);
    m_labels[site] = sources[front.source(site)].label;
  }

  // Where the fronts of two cells met, a circle may have been fitted to what came from both: each cell's
  // own front knows better.  It goes on beyond the cell as far as the sites that share triangles with it,
  // by the ways that are shortest: these may be late, and so may what lies on them, by two sides.
  std::vector<double> known = m_distances;
  for(Index site = 0; site < known.size(); ++site)
    known[site] += 2. * longest_around(site);
  bounded.known = &known;
  std::vector<bool> is_own(known.size(), false);
  for(Index label = 0; label < number_of_cells && m_is_finished; ++label)
  {
    ++done;
    m_is_finished = front.run(cells[label], bounded);
    for(const Index site : front.reached())
    {
      const double distance = front.distance(site);
      if(is_own[site] && distance >= m_distances[site])
      {
        m_others.push_back({site, label, distance});
        continue;
      }
      if(is_own[site])
        m_others.push_back({site, m_labels[site], m_distances[site]});
      m_distances[site] = distance;
      m_labels[site] = label;
      is_own[site] = true;
    }
  }
  std::sort(m_others.begin(), m_others.end());
}

// The longest time that a front takes along a side of the triangles around a site.
double Voronoi::longest_around(Index site) const
{
  const Glued_triangles& t = *m_triangles;
  double result = 0.;
  for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
  {
    const Index f = t.star[i] / 3;
    const double slowness = m_slowness ? (*m_slowness)[f] : 1.;
    if(slowness < infinity)
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        result = std::max(result, slowness * t.length[side]);
  }
  return result;
}

double Voronoi::distance(Index site, Index label) const
{
  if(m_labels[site] == label)
    return m_distances[site];
  const auto found =
      std::lower_bound(m_others.begin(), m_others.end(), Other{site, label, -infinity});
  const bool is_there = found != m_others.end() && found->site == site && found->label == label;
  return is_there ? found->distance : infinity;
}

// What decides between cells inside a triangle, where it changes linearly but for what all cells have in
// common: |p - a|^2 - |p - b|^2 is linear in p, and so is the difference of straight fronts.
double Voronoi::height(Index site, Index label) const
{
  const double result = distance(site, label);
  return m_is_circular ? result * result : result;
}

bool Voronoi::is_crossed(Index side) const
{
  return m_labels[m_triangles->corner[side]] != m_labels[m_triangles->corner[next_side(side)]];
}

// How many cells meet in a triangle; 0 where it is not reached.
int Voronoi::number_of_labels(Index triangle) const
{
  const Index* const c = &m_triangles->corner[3 * std::size_t(triangle)];
  const Index a = m_labels[c[0]], b = m_labels[c[1]], d = m_labels[c[2]];
  if(a == none || b == none || d == none)
    return 0;
  return a == b ? (b == d ? 1 : 2) : (b == d || a == d ? 2 : 3);
}

// How far along a side the cells of its ends meet; seen from both of its triangles alike.
double Voronoi::share(Index side) const
{
  const Glued_triangles& t = *m_triangles;
  if(t.twin[side] < side)
    return 1. - share(t.twin[side]);
  const Index x = t.corner[side], z = t.corner[next_side(side)];
  const Index a = m_labels[x], b = m_labels[z];
  const double at_x = height(x, b) - height(x, a), at_z = height(z, a) - height(z, b);
  if(at_x + at_z > 0. && at_x + at_z < infinity)
    return std::clamp(at_x / (at_x + at_z), 0., 1.);
  // Next to an obstacle one front may not have come around it: both go along the side then.
  const double width = (m_slowness ? (*m_slowness)[side / 3] : 1.) * t.length[side];
  return width > 0. && width < infinity
             ? std::clamp(0.5 + 0.5 * (m_distances[z] - m_distances[x]) / width, 0., 1.)
             : 0.5;
}

Location Voronoi::crossing(Index side) const
{
  return {side / 3, none, on_side(side, share(side))};
}

Location Voronoi::triple_point(Index triangle) const
{
  const Index* const c = &m_triangles->corner[3 * std::size_t(triangle)];
  const Index a = m_labels[c[0]], b = m_labels[c[1]], d = m_labels[c[2]];
  // Where three linear functions are equal, if they are inside.
  std::array<double, 3> u, v, p;
  for(int k = 0; k < 3; ++k)
  {
    u[k] = height(c[k], a) - height(c[k], b);
    v[k] = height(c[k], b) - height(c[k], d);
  }
  double sum = 0.;
  for(int k = 0; k < 3; ++k)
  {
    p[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    sum += p[k];
  }
  bool is_inside = true;
  for(double& b_k : p)
  {
    b_k /= sum;
    is_inside = is_inside && b_k >= 0.;
  }
  if(is_inside)
    return {triangle, none, p};
  // A cell that has a corner only, cut off by the other two.
  Location result = {triangle, none, {0., 0., 0.}};
  for(Index k = 0; k < 3; ++k)
  {
    const Location on = crossing(3 * triangle + k);
    for(int j = 0; j < 3; ++j)
      result.barycentric[j] += on.barycentric[j] / 3.;
  }
  return result;
}

Index Voronoi::label_of_triangle(Index triangle) const
{
  if(number_of_labels(triangle) == 0)
    return none;
  const Index* const c = &m_triangles->corner[3 * std::size_t(triangle)];
  Index result = none;
  double least = infinity, nearest = infinity;
  for(int k = 0; k < 3; ++k)
  {
    const Index label = m_labels[c[k]];
    const double at_centre = height(c[0], label) + height(c[1], label) + height(c[2], label);
    // Where one of them is not known at all corners, the nearest corner decides.
    if(at_centre < least || (least == infinity && m_distances[c[k]] < nearest))
      result = label;
    least = std::min(least, at_centre);
    nearest = std::min(nearest, m_distances[c[k]]);
  }
  return result;
}

// Follows a line between cells from triangle to triangle.
struct Voronoi::Trace
{
  const Voronoi& voronoi;
  std::vector<bool> is_done = std::vector<bool>(voronoi.m_triangles->corner.size(), false);

  Index across(Index side) const
  {
    const Index twin = voronoi.m_triangles->twin[side];
    return twin != none && voronoi.number_of_labels(twin / 3) > 0 ? twin : none;
  }
  void mark(Index side)
  {
    is_done[side] = true;
    if(const Index twin = voronoi.m_triangles->twin[side]; twin != none)
      is_done[twin] = true;
  }
  // Goes on through the triangle behind a side on which the line is.
  void follow(Index side, std::vector<Location>& line)
  {
    while(side != none)
    {
      if(voronoi.number_of_labels(side / 3) == 3)
        return line.push_back(voronoi.triple_point(side / 3));
      const Index other =
          voronoi.is_crossed(next_side(side)) ? next_side(side) : previous_side(side);
      line.push_back(voronoi.crossing(other));
      if(is_done[other]) // around
        return;
      mark(other);
      side = across(other);
    }
  }
};

std::vector<Voronoi::Bisector> Voronoi::bisectors() const
{
  const Glued_triangles& t = *m_triangles;
  std::vector<Bisector> result;
  Trace trace{*this};
  // Inwards across a side the cell of its first end is on the left.
  const auto begin_inwards = [&](Index side)
  {
    trace.mark(side);
    result.push_back(
        {m_labels[t.corner[side]], m_labels[t.corner[next_side(side)]], {crossing(side)}});
    trace.follow(side, result.back().line);
  };
  for(Index f = 0; f < t.number_of_triangles(); ++f)
    if(number_of_labels(f) == 3)
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        if(!trace.is_done[side])
        {
          trace.mark(side);
          result.push_back({m_labels[t.corner[next_side(side)]],
                            m_labels[t.corner[side]],
                            {triple_point(f), crossing(side)}});
          trace.follow(trace.across(side), result.back().line);
        }
  for(const bool is_loop : {false, true})
    for(Index side = 0; side < t.corner.size(); ++side)
      if(!trace.is_done[side] && number_of_labels(side / 3) > 0 && is_crossed(side) &&
         (is_loop || trace.across(side) == none))
      {
        begin_inwards(side);
        result.back().is_closed = is_loop;
      }
  return result;
}

Voronoi::Cut Voronoi::cut() const
{
  const Glued_triangles& t = *m_triangles;
  Cut result;
  for(Index site = 0; site < m_labels.size(); ++site)
    result.vertices.push_back({none, site, {}});
  const auto add = [&](const Location& place)
  {
    result.vertices.push_back(place);
    return Index(result.vertices.size() - 1);
  };
  std::vector<Index> middle(t.corner.size(), none); // of each side that is crossed
  for(Index side = 0; side < t.corner.size(); ++side)
    if(t.twin[side] < side)
      middle[side] = middle[t.twin[side]];
    else if(m_labels[t.corner[side]] != none && m_labels[t.corner[next_side(side)]] != none &&
            is_crossed(side))
      middle[side] = add(crossing(side));

  const auto add_triangle = [&](Index a, Index b, Index c, Index label)
  {
    result.corners.insert(result.corners.end(), {a, b, c});
    result.labels.push_back(label);
  };
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const int count = number_of_labels(f);
    const Index centre = count == 3 ? add(triple_point(f)) : none;
    bool is_whole = true;
    for(Index right = 3 * f; right < 3 * f + 3; ++right)
    {
      // Counterclockwise from a corner, with the middles of its sides.
      const Index left = previous_side(right);
      const Index a = t.corner[right], b = t.corner[next_side(right)], c = t.corner[left];
      const Index label = count > 0 ? m_labels[a] : none;
      if(middle[right] == none)
        continue;
      is_whole = false;
      if(count == 3)
      {
        add_triangle(a, middle[right], centre, label);
        add_triangle(a, centre, middle[left], label);
      }
      else if(count == 0)
      {
        add_triangle(a, middle[right], c, none);
        add_triangle(middle[right], b, c, none);
      }
      else if(middle[left] != none)
      {
        add_triangle(a, middle[right], middle[left], label);
        add_triangle(middle[right], b, c, m_labels[b]);
        add_triangle(middle[right], c, middle[left], m_labels[b]);
      }
    }
    if(is_whole)
      add_triangle(t.corner[3 * f], t.corner[3 * f + 1], t.corner[3 * f + 2],
                   count > 0 ? m_labels[t.corner[3 * f]] : none);
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
