// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/taut_strip.h"

#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr double margin = Divided_mesh::margin;
// Of angles, in radians: gains beyond rounding.
constexpr double worth_a_turn = 1e-7;
// Sides that are looked at to straighten a path: a tenth of a second.
constexpr std::size_t most_work = 1000000;

class Strip
{
public:
  Strip(const Divided_mesh& mesh, const std::vector<bool>& is_barred, Index from, Index to,
        std::vector<Index> sides)
      : m_mesh(mesh), m_t(mesh.triangles()), m_is_barred(is_barred), m_from(from), m_to(to),
        m_sides(std::move(sides))
  {
    simplify();
    straighten();
    // Through webs of needles some strips have thousands of sides, and as many turns to take: any of
    // them is a valid one.
    std::size_t most = 20 + most_work / (m_sides.size() + 1);
    while(!m_sides.empty() && most-- > 0 && turn_around_a_site())
      ;
  }

  const std::vector<Index>& sides() const { return m_sides; }
  // Where the path crosses each.
  std::vector<double> shares() const
  {
    std::vector<double> result(m_sides.size());
    for(std::size_t k = 0; k + 1 < m_corners.size(); ++k)
    {
      const Corner &p = m_corners[k], &q = m_corners[k + 1];
      for(std::size_t i = p.side + 1; i < std::min(q.side, m_sides.size()); ++i)
      {
        const Planar across = m_left[i] - m_right[i], way = q.place - p.place;
        const double sine = cross(across, way);
        const double share = sine != 0. ? cross(p.place - m_right[i], way) / sine : 0.5;
        result[i] = std::clamp(share, margin, 1. - margin);
      }
      if(q.side < m_sides.size())
        result[q.side] = q.is_left ? 1. - margin : margin;
    }
    return result;
  }

private:
  struct Corner
  {
    Planar place;
    std::size_t side; // in the strip; the begin's number wraps to zero when one is added
    bool is_left;
  };

  // Takes loops out, and sides at the ends, which lead around them.
  void simplify()
  {
    std::map<Index, std::size_t> place;
    std::vector<Index> result;
    for(const Index side : m_sides)
    {
      const auto known = place.find(m_mesh.first(side));
      if(known != place.end())
      {
        const std::size_t keep = known->second + (result[known->second] == side ? 1 : 0);
        while(result.size() > keep)
        {
          place.erase(m_mesh.first(result.back()));
          result.pop_back();
        }
        continue;
      }
      place[m_mesh.first(side)] = result.size();
      result.push_back(side);
    }
    const auto is_at = [&](Index side, Index site)
    { return m_mesh.source(side) == site || m_mesh.target(side) == site; };
    std::size_t begin = 0;
    for(std::size_t i = 0; i < result.size(); ++i)
      if(is_at(result[i], m_from))
        begin = i + 1;
    std::size_t end = result.size();
    for(std::size_t i = result.size(); i-- > begin;)
      if(is_at(result[i], m_to))
        end = i;
    m_sides.assign(result.begin() + std::ptrdiff_t(begin), result.begin() + std::ptrdiff_t(end));
  }

  // Unfolds the strip: where the ends of its sides are, seen on the way to the left and to the right.
  void unfold()
  {
    m_left.clear();
    m_right.clear();
    if(m_sides.empty())
      return;
    const Index first = m_sides.front();
    const double base = m_mesh.between(m_from, m_mesh.source(first));
    m_right.push_back({base, 0.});
    m_left.push_back(
        third_corner(base, m_mesh.between(m_from, m_mesh.target(first)), m_mesh.length(first)));
    for(std::size_t i = 0;; ++i)
    {
      const Index entry = m_t.twin[m_sides[i]];
      const Planar back = m_right[i] - m_left[i];
      const double width = norm(back);
      const Planar along = width > 0. ? (1. / width) * back : Planar{1., 0.};
      const Planar far = m_left[i] + turned(third_corner(width, m_mesh.length(previous_side(entry)),
                                                         m_mesh.length(next_side(entry))),
                                            along);
      if(i + 1 == m_sides.size())
      {
        m_end = far;
        return;
      }
      const bool is_next = m_sides[i + 1] == next_side(entry);
      m_right.push_back(is_next ? m_right[i] : far);
      m_left.push_back(is_next ? far : m_left[i]);
    }
  }

  // The funnel (Lee and Preparata 1984) between sides that are shorter by a margin at both ends.
  void straighten()
  {
    unfold();
    const std::size_t n = m_sides.size(), before = std::size_t(-1);
    m_corners = {{{0., 0.}, before, false}};
    if(n == 0)
      return;
    const auto right = [&](std::size_t i)
    { return i == n ? m_end : (1. - margin) * m_right[i] + margin * m_left[i]; };
    const auto left = [&](std::size_t i)
    { return i == n ? m_end : (1. - margin) * m_left[i] + margin * m_right[i]; };
    Corner apex = m_corners.front(), l = apex, r = apex;
    for(std::size_t i = 0; i <= n; ++i)
    {
      const Planar to_right = right(i) - apex.place, to_left = left(i) - apex.place;
      if(cross(r.place - apex.place, to_right) >= 0.)
      {
        if(r.side == apex.side || cross(l.place - apex.place, to_right) <= 0.)
          r = {right(i), i, false};
        else
        {
          apex = r = l;
          m_corners.push_back(apex);
          i = apex.side;
          continue;
        }
      }
      if(cross(l.place - apex.place, to_left) <= 0.)
      {
        if(l.side == apex.side || cross(r.place - apex.place, to_left) >= 0.)
          l = {left(i), i, true};
        else
        {
          apex = l = r;
          m_corners.push_back(apex);
          i = apex.side;
          continue;
        }
      }
    }
    if(m_corners.back().side != n)
      m_corners.push_back({m_end, n, true});
  }

  double length() const
  {
    double result = 0.;
    for(std::size_t k = 0; k + 1 < m_corners.size(); ++k)
      result += norm(m_corners[k + 1].place - m_corners[k].place);
    return result;
  }

  // Leads the strip around the other side of a site, if the path is shorter there (Xin and Wang 2007);
  // margins may make it longer.
  bool turn_around_a_site()
  {
    for(std::size_t k = 1; k + 1 < m_corners.size(); ++k)
    {
      const Corner& corner = m_corners[k];
      const Index side = m_sides[corner.side];
      const Index site = corner.is_left ? m_mesh.target(side) : m_mesh.source(side);
      if(m_is_barred[site] || site == m_from || site == m_to ||
         std::find(m_tried.begin(), m_tried.end(), site) != m_tried.end())
        continue;
      const Planar u = m_corners[k - 1].place - corner.place,
                   v = m_corners[k + 1].place - corner.place;
      double behind = std::abs(std::atan2(cross(u, v), dot(u, v))) - 2. * pi;
      for(const Index around : m_mesh.corners_around(site))
        behind += m_mesh.angle_at(around);
      if(!(behind < pi - worth_a_turn))
        continue;
      const std::vector<Index> sides = m_sides;
      const double before = length();
      if(turn(corner.side, corner.is_left, site))
      {
        straighten();
        if(!m_sides.empty() && length() < before)
          return true;
      }
      m_tried.push_back(site);
      m_sides = sides;
      straighten();
      return true;
    }
    return false;
  }

  bool turn(std::size_t place, bool is_left, Index site)
  {
    const auto is_around = [&](std::size_t i)
    { return (is_left ? m_mesh.target(m_sides[i]) : m_mesh.source(m_sides[i])) == site; };
    std::size_t begin = place, end = place + 1;
    while(begin > 0 && is_around(begin - 1))
      --begin;
    while(end < m_sides.size() && is_around(end))
      ++end;
    const Index goal = m_t.twin[m_sides[end - 1]] / 3;
    std::vector<Index> around;
    Index side = m_sides[begin];
    for(;;)
    {
      side = is_left ? next_side(side) : previous_side(side);
      if(m_t.twin[side] == none || around.size() > m_t.number_of_triangles())
        return false;
      around.push_back(side);
      side = m_t.twin[side];
      if(side / 3 == goal)
        break;
    }
    m_sides.erase(m_sides.begin() + std::ptrdiff_t(begin), m_sides.begin() + std::ptrdiff_t(end));
    m_sides.insert(m_sides.begin() + std::ptrdiff_t(begin), around.begin(), around.end());
    simplify();
    return true;
  }

  const Divided_mesh& m_mesh;
  const Glued_triangles& m_t;
  const std::vector<bool>& m_is_barred;
  Index m_from, m_to;
  std::vector<Index> m_sides;
  std::vector<Index> m_tried; // sites behind which the path is longer
  std::vector<Planar> m_left, m_right;
  Planar m_end = {};
  std::vector<Corner> m_corners;
};

} // namespace

Taut_strip taut_strip(const Divided_mesh& mesh, const std::vector<bool>& is_barred, Index from,
                      Index to, std::vector<Index> sides)
{
  const Strip strip(mesh, is_barred, from, to, std::move(sides));
  return {strip.sides(), strip.shares()};
}

} // namespace CGAL::Geodesic_processing::internal
