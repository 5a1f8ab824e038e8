// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/base_mesh.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/curves.h>
#include <CGAL/Geodesic_processing/internal/front.h>
#include <CGAL/Geodesic_processing/internal/glue.h>
#include <CGAL/Geodesic_processing/internal/path_locations.h>
#include <CGAL/Geodesic_processing/internal/planar.h>
#include <CGAL/Geodesic_processing/internal/spatial.h>
#include <CGAL/Geodesic_processing/internal/unfold.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <queue>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Of a side: how far paths keep off its ends.  A tenth of it makes needles of a hundred to one where
// paths pass a site, and a tenfold of it kinks that can be seen.
constexpr double margin = 0.005;
// Barycentric coordinates of samples below are zero, but next to curves only what is rounding.
constexpr double snapping = 0.01, rounding = 1e-12;
// Of angles, in radians: gains beyond rounding.
constexpr double worth_a_turn = 1e-7;
// Places on each side among which paths are searched, before they are straight.
constexpr Index places = 3;
// How much longer ways are made, for the first search, off the cells of an edge's ends: across those of
// the corners opposite to it, and elsewhere.  A path around the other side of a limb can be shorter, but
// leaves no room for the edges that belong there.
struct Detours
{
  double near, far;
  bool are_samples_passed; // when paths are straightened
};
// One after the other, until there is a way for each edge: cells are coarse where sites are few.
constexpr std::array<Detours, 3> all_detours = {Detours{2., 16., false}, Detours{1., 1., true},
                                                Detours{2., 4., true}};
// Sides that are looked at to straighten a path: a tenth of a second.
constexpr std::size_t most_work = 1000000;
// Each with a half of samples more than the one before.
constexpr int most_trials = 4;
// Far below what distances tell apart.
constexpr double shortest_side = 0x1p-36;
// Places looked at, for each side of the mesh and each edge to be drawn, before it is given up: in webs of
// needles each edge drawn makes the next one longer.
constexpr std::size_t most_for_a_side = 50, most_for_an_edge = 1500;
// The label of sides on curves until their edges are known.
constexpr Index curve = none - 1;

using Barycentric = std::array<double, 3>;

// The mesh while it is divided.
class Divided_mesh
{
public:
  Divided_mesh(const Glued_triangles& coarse, const std::vector<bool>& is_curve) : m_coarse(coarse)
  {
    m_t.corner = coarse.corner;
    m_t.twin = coarse.twin;
    m_t.point = coarse.point;
    m_t.scale = coarse.scale;
    m_t.origin = coarse.origin;
    m_whole.resize(coarse.number_of_triangles());
    std::iota(m_whole.begin(), m_whole.end(), Index(0));
    m_label.assign(coarse.corner.size(), none);
    for(Index side = 0; side < m_label.size(); ++side)
      if(is_curve[side])
        m_label[side] = curve;
    for(Index site = 0; site < coarse.number_of_sites(); ++site)
      m_location.push_back(at_site(coarse, site));
    m_corner_of.assign(coarse.number_of_sites(), none);
    take_apart_pinched_sites();
  }

  const Glued_triangles& triangles() const { return m_t; }
  Glued_triangles& triangles() { return m_t; }
  std::vector<Index>& labels() { return m_label; }
  const std::vector<Index>& labels() const { return m_label; }
  std::vector<Location>& locations() { return m_location; }
  std::vector<Index>& wholes() { return m_whole; }

  Index source(Index side) const { return m_t.corner[side]; }
  Index target(Index side) const { return m_t.corner[next_side(side)]; }
  Index apex(Index side) const { return m_t.corner[previous_side(side)]; }
  // The smaller one of it and its twin.
  Index first(Index side) const { return std::min(side, m_t.twin[side]); }
  double length(Index side) const { return between(source(side), target(side)); }
  double between(Index p, Index q) const { return norm(m_t.point[p] - m_t.point[q]); }

  void set_label(Index side, Index label)
  {
    m_label[side] = label;
    if(m_t.twin[side] != none)
      m_label[m_t.twin[side]] = label;
  }

  // The corners around a site, counterclockwise, from the border on where there is one.
  std::vector<Index> corners_around(Index site) const
  {
    std::vector<Index> result;
    const Index begin = m_corner_of[site];
    if(begin == none)
      return result;
    Index first = begin;
    for(Index right = turn_right(m_t, begin); right != none && right != begin;
        right = turn_right(m_t, right))
      first = right;
    if(turn_right(m_t, first) != none)
      first = begin;
    for(Index corner = first; corner != none && (result.empty() || corner != first);
        corner = turn_left(m_t, corner))
      result.push_back(corner);
    return result;
  }

  // Sides that end or begin at a site, one of each pair of twins.
  std::vector<Index> sides_around(Index site) const
  {
    std::vector<Index> result = corners_around(site);
    if(!result.empty() && m_t.twin[previous_side(result.back())] == none)
      result.push_back(previous_side(result.back()));
    return result;
  }

  double angle_at(Index corner) const
  {
    const Spatial &p = m_t.point[source(corner)], u = m_t.point[target(corner)] - p,
                  v = m_t.point[apex(corner)] - p;
    return std::atan2(norm(cross(u, v)), dot(u, v));
  }

  Barycentric barycentric(Index face, Index site) const
  {
    return *seen_from(m_coarse, m_whole[face], m_location[site]);
  }

  // A new site on a side u v of triangles u v w and v u x, which become u p w and v p x, and, with the
  // next two numbers, p v w and p u x.
  Index split_side(Index side, double share)
  {
    const Index twin = m_t.twin[side], u = source(side), v = target(side);
    const Barycentric from = barycentric(side / 3, u), to = barycentric(side / 3, v);
    Location place{m_whole[side / 3], none, {}};
    for(std::size_t k = 0; k < 3; ++k)
      place.barycentric[k] = (1. - share) * from[k] + share * to[k];
    const Index p =
        add_site((1. - share) * m_t.point[u] + share * m_t.point[v], cleaned(m_coarse, place));
    const Index part = halve(side, p);
    if(twin != none)
    {
      const Index other = halve(twin, p);
      glue(side, other);
      glue(part, twin);
    }
    else
      m_t.twin[part] = none;
    m_corner_of[p] = next_side(side);
    return p;
  }

  // The site of a sample.
  Index insert(const Location& sample)
  {
    Index best = none;
    double most = -infinity;
    Barycentric inside = {};
    const auto look_into = [&](Index f)
    {
      const Barycentric b = coordinates_in(f, sample.barycentric);
      const double least = std::min({b[0], b[1], b[2]});
      if(least > most)
      {
        most = least;
        best = f;
        inside = b;
      }
    };
    look_into(sample.triangle);
    if(const auto parts = m_parts.find(sample.triangle); parts != m_parts.end())
      for(const Index part : parts->second)
        look_into(part);

    // Those near a side or a site go there, but nowhere where they would change sides of a curve.
    for(Index k = 0; k < 3; ++k)
    {
      const Index side = 3 * best + (k + 1) % 3;
      const bool is_curve = m_label[side] != none || touches_curve(source(side)) ||
                            touches_curve(target(side)) || m_t.twin[side] == none;
      if(inside[k] < (is_curve ? rounding : snapping))
        inside[k] = 0.;
    }
    const double sum = inside[0] + inside[1] + inside[2];
    for(Index k = 0; k < 3; ++k)
      if(inside[k] == sum)
        if(const Index site = m_t.corner[3 * best + k]; !is_taken(site))
          return take(site);
    for(Index k = 0; k < 3; ++k)
      if(inside[k] == 0.)
      {
        const Index side = 3 * best + (k + 1) % 3;
        const double share = inside[(k + 2) % 3] / sum;
        return take(split_side(side, std::clamp(share, margin, 1. - margin)));
      }
    return take(split_triangle(best, {inside[0] / sum, inside[1] / sum, inside[2] / sum}));
  }

private:
  // Each fan of a site that has several gets a site of its own.
  void take_apart_pinched_sites()
  {
    std::vector<bool> is_seen(m_t.corner.size(), false);
    for(Index corner = 0; corner < m_t.corner.size(); ++corner)
    {
      if(is_seen[corner])
        continue;
      Index site = m_t.corner[corner];
      if(m_corner_of[site] != none)
      {
        const Index copy = Index(m_location.size());
        m_location.push_back({corner / 3, none, at_corner(corner)});
        m_t.point.push_back(m_t.point[site]);
        m_corner_of.push_back(none);
        site = copy;
      }
      m_corner_of[site] = corner;
      Index turned = corner;
      do
      {
        is_seen[turned] = true;
        m_t.corner[turned] = site;
        turned = turn_left(m_t, turned);
      } while(turned != none && turned != corner);
      if(turned == none)
        for(turned = turn_right(m_t, corner); turned != none; turned = turn_right(m_t, turned))
        {
          is_seen[turned] = true;
          m_t.corner[turned] = site;
        }
    }
  }

  bool touches_curve(Index site) const
  {
    const std::vector<Index> sides = sides_around(site);
    return std::any_of(sides.begin(), sides.end(), [&](Index s) { return m_label[s] != none; });
  }
  bool is_taken(Index site) const { return site < m_is_taken.size() && m_is_taken[site]; }
  Index take(Index site)
  {
    if(m_is_taken.size() <= site)
      m_is_taken.resize(std::size_t(site) + 1, false);
    m_is_taken[site] = true;
    return site;
  }

  void glue(Index side, Index twin)
  {
    m_t.twin[side] = twin;
    m_t.twin[twin] = side;
  }

  Index add_site(const Spatial& point, const Location& location)
  {
    m_t.point.push_back(point);
    m_location.push_back(location);
    m_corner_of.push_back(none);
    return Index(m_location.size() - 1);
  }

  Index add_triangle(Index whole)
  {
    const Index f = Index(m_t.number_of_triangles());
    m_t.corner.resize(m_t.corner.size() + 3);
    m_t.twin.resize(m_t.corner.size(), none);
    m_label.resize(m_t.corner.size(), none);
    m_whole.push_back(whole);
    m_parts[whole].push_back(f);
    return f;
  }

  // Moves the side of a triangle into another one, with its twin and label.
  void move(Index from, Index to)
  {
    m_label[to] = m_label[from];
    m_t.twin[to] = m_t.twin[from];
    if(m_t.twin[to] != none)
      m_t.twin[m_t.twin[to]] = to;
  }

  // Of u v w makes u p w and, new, p v w, whose side p v is returned, not yet glued.
  Index halve(Index side, Index p)
  {
    const Index next = next_side(side), u_to_v = m_label[side];
    const Index part = 3 * add_triangle(m_whole[side / 3]);
    const Index v = m_t.corner[next], w = m_t.corner[previous_side(side)];
    m_t.corner[part] = p;
    m_t.corner[part + 1] = v;
    m_t.corner[part + 2] = w;
    m_t.corner[next] = p;
    move(next, part + 1);
    m_label[part] = u_to_v;
    m_label[part + 2] = m_label[next] = none;
    glue(next, part + 2);
    if(m_corner_of[v] == next)
      m_corner_of[v] = part + 1;
    return part;
  }

  Index split_triangle(Index f, const Barycentric& b)
  {
    Spatial point = {0., 0., 0.};
    Location place{m_whole[f], none, {0., 0., 0.}};
    for(Index k = 0; k < 3; ++k)
    {
      point = point + b[k] * m_t.point[m_t.corner[3 * f + k]];
      const Barycentric corner = barycentric(f, m_t.corner[3 * f + k]);
      for(std::size_t j = 0; j < 3; ++j)
        place.barycentric[j] += b[k] * corner[j];
    }
    const Index p = add_site(point, cleaned(m_coarse, place));
    const Index second = 3 * add_triangle(m_whole[f]), third = 3 * add_triangle(m_whole[f]);
    const Index x = m_t.corner[3 * f], y = m_t.corner[3 * f + 1], z = m_t.corner[3 * f + 2];
    const std::array<Index, 3> yzp = {y, z, p}, zxp = {z, x, p};
    std::copy(yzp.begin(), yzp.end(), m_t.corner.begin() + second);
    std::copy(zxp.begin(), zxp.end(), m_t.corner.begin() + third);
    move(3 * f + 1, second);
    move(3 * f + 2, third);
    m_t.corner[3 * f + 2] = p;
    m_label[3 * f + 1] = m_label[3 * f + 2] = none;
    glue(3 * f + 1, second + 2);
    glue(second + 1, third + 2);
    glue(third + 1, 3 * f + 2);
    m_corner_of[p] = 3 * f + 2;
    if(m_corner_of[z] == 3 * f + 2)
      m_corner_of[z] = second + 1;
    return p;
  }

  // Of a place in the mesh, in a part of its triangle.
  Barycentric coordinates_in(Index f, const Barycentric& b) const
  {
    std::array<Barycentric, 3> corner;
    for(Index k = 0; k < 3; ++k)
      corner[k] = barycentric(f, m_t.corner[3 * f + k]);
    const auto twice = [](const Barycentric& p, const Barycentric& q, const Barycentric& r)
    { return (q[1] - p[1]) * (r[2] - p[2]) - (q[2] - p[2]) * (r[1] - p[1]); };
    const double whole = twice(corner[0], corner[1], corner[2]);
    if(!(whole > 0.))
      return {-infinity, -infinity, -infinity};
    return {twice(b, corner[1], corner[2]) / whole, twice(corner[0], b, corner[2]) / whole,
            twice(corner[0], corner[1], b) / whole};
  }

  const Glued_triangles& m_coarse;
  Glued_triangles m_t;
  std::vector<Index> m_label; // #sides: the edge that it is a part of, or none
  std::vector<Index> m_whole; // #triangles
  std::vector<Location> m_location;
  std::vector<Index> m_corner_of; // #sites: one of its corners, or none
  std::vector<bool> m_is_taken;
  std::map<Index, std::vector<Index>> m_parts; // of a triangle of the mesh, without itself
};

// A strip of triangles, by the sides through which it leaves them, from a site to another.
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

class Builder
{
public:
  Builder(const Glued_triangles& coarse, const std::vector<Location>& samples,
          const std::vector<std::array<Index, 3>>& triangles, const std::vector<bool>& is_curve,
          const Detours& detours)
      : m_mesh(coarse, is_curve), m_detours(detours)
  {
    m_result.triangles = triangles;
    number_edges(samples.size());
    for(const Location& sample : samples)
    {
      m_result.site.push_back(m_mesh.insert(sample));
      m_result.samples.push_back(m_mesh.locations()[m_result.site.back()]);
    }
    m_base_vertex.assign(m_mesh.locations().size(), none);
    for(Index i = 0; i < m_result.site.size(); ++i)
      m_base_vertex[m_result.site[i]] = i;
    m_is_barred.assign(m_mesh.locations().size(), false);
    for(const Index site : m_result.site)
      m_is_barred[site] = !detours.are_samples_passed;
    find_cells(coarse, samples);
    m_visits_left =
        most_for_a_side * coarse.corner.size() + most_for_an_edge * m_result.side.size();
  }

  std::optional<Base_mesh> run()
  {
    if(!follow_curves() || !connect_all())
      return std::nullopt;
    open_shortcuts();
    if(!fill_regions())
      return std::nullopt;
    finish();
    return std::move(m_result);
  }

private:
  const Glued_triangles& t() const { return m_mesh.triangles(); }

  void number_edges(std::size_t number_of_samples)
  {
    std::vector<Index> corners;
    for(const auto& f : m_result.triangles)
      corners.insert(corners.end(), f.begin(), f.end());
    m_result.twin = twins_of_soup(number_of_samples, corners);
    m_result.edge.assign(corners.size(), none);
    for(Index side = 0; side < corners.size(); ++side)
    {
      const Index twin = m_result.twin[side];
      if(twin != none && twin < side)
        continue;
      const Index edge = Index(m_result.side.size());
      m_result.edge[side] = edge;
      if(twin != none)
        m_result.edge[twin] = edge;
      m_result.side.push_back(side);
      m_edge_between[std::minmax(corners[side], corners[next_side(side)])] = edge;
    }
    m_result.path.resize(m_result.side.size());
  }

  // The cell of each site: that of the nearest sample.
  void find_cells(const Glued_triangles& coarse, const std::vector<Location>& samples)
  {
    std::vector<Source> sources;
    for(Index i = 0; i < samples.size(); ++i)
      sources.push_back({{samples[i]}, 0., i});
    Front front(std::shared_ptr<const Glued_triangles>(&coarse, [](const Glued_triangles*) {}),
                Front_kind::euclidean);
    front.run(sources);
    m_cell = m_base_vertex;
    for(Index site = 0; site < coarse.number_of_sites(); ++site)
      if(m_cell[site] == none)
        m_cell[site] = front.source(site);
  }

  Index base_corner(Index side) const { return m_result.triangles[side / 3][side % 3]; }

  void bar(Index site)
  {
    if(m_is_barred.size() <= site)
      m_is_barred.resize(t().point.size(), false);
    m_is_barred[site] = true;
  }

  // Gives curves the labels of the edges that follow them.
  bool follow_curves()
  {
    const std::vector<Index>& label = m_mesh.labels();
    for(Index vertex = 0; vertex < m_result.site.size(); ++vertex)
      for(const Index first : m_mesh.sides_around(m_result.site[vertex]))
      {
        if(label[first] != curve)
          continue;
        std::vector<Index> path = {m_result.site[vertex]}, sides = {first};
        for(;;)
        {
          const Index side = sides.back(), last = path.back();
          const Index next =
              m_mesh.source(side) == last ? m_mesh.target(side) : m_mesh.source(side);
          path.push_back(next);
          if(m_base_vertex[next] != none)
            break;
          Index on = none;
          for(const Index other : m_mesh.sides_around(next))
            if(label[other] == curve && other != side && t().twin[other] != side)
              on = other;
          if(on == none || path.size() > t().point.size())
            return false;
          sides.push_back(on);
        }
        const auto found = m_edge_between.find(std::minmax(vertex, m_base_vertex[path.back()]));
        if(found == m_edge_between.end() || !m_result.path[found->second].empty())
          return false;
        for(const Index side : sides)
          m_mesh.set_label(side, found->second);
        keep(found->second, std::move(path));
      }
    return std::none_of(label.begin(), label.end(), [](Index l) { return l == curve; });
  }

  void keep(Index edge, std::vector<Index> path)
  {
    for(const Index site : path)
      bar(site);
    if(m_base_vertex[path.front()] != base_corner(m_result.side[edge]))
      std::reverse(path.begin(), path.end());
    m_result.path[edge] = std::move(path);
  }

  bool connect_all()
  {
    std::vector<Index> order, part(m_result.site.size());
    std::iota(part.begin(), part.end(), Index(0));
    const std::function<Index(Index)> root = [&](Index i)
    { return part[i] == i ? i : part[i] = root(part[i]); };
    const auto ends = [&](Index edge)
    {
      const Index side = m_result.side[edge];
      return std::pair(base_corner(side), base_corner(next_side(side)));
    };
    std::vector<double> length;
    for(Index edge = 0; edge < m_result.side.size(); ++edge)
    {
      const auto [a, b] = ends(edge);
      length.push_back(m_mesh.between(m_result.site[a], m_result.site[b]));
      if(m_result.path[edge].empty())
        order.push_back(edge);
      else
        part[root(a)] = root(b);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return length[a] < length[b]; });
    std::stable_partition(order.begin(), order.end(),
                          [&](Index edge)
                          {
                            const auto [a, b] = ends(edge);
                            const Index p = root(a), q = root(b);
                            part[p] = q;
                            return p != q;
                          });
    return std::all_of(order.begin(), order.end(), [&](Index edge) { return connect(edge); });
  }

  // The corners of a base vertex between the edges, of those already drawn, that are next to the edge of
  // a side that leaves it.
  std::vector<Index> sector(Index side) const
  {
    const std::vector<Index> corners = m_mesh.corners_around(m_result.site[base_corner(side)]);
    Index right = side;
    do
    {
      const Index twin = m_result.twin[right];
      right = twin == none ? none : next_side(twin);
    } while(right != none && right != side && m_result.path[m_result.edge[right]].empty());
    if(right == side || right == none)
      return corners;
    const std::vector<Index>& label = m_mesh.labels();
    const auto begin = std::find_if(corners.begin(), corners.end(),
                                    [&](Index c) { return label[c] == m_result.edge[right]; });
    std::vector<Index> result;
    if(begin == corners.end())
      return result;
    for(std::size_t i = std::size_t(begin - corners.begin()), n = 0; n < corners.size(); ++n)
    {
      result.push_back(corners[i]);
      if(label[previous_side(corners[i])] != none)
        break;
      i = (i + 1) % corners.size();
    }
    return result;
  }

  bool connect(Index edge)
  {
    const Index side = m_result.side[edge], twin = m_result.twin[side];
    if(twin == none)
      return false;
    const Index from = m_result.site[base_corner(side)], to = m_result.site[base_corner(twin)];
    const std::vector<Index> starts = sector(side), goals = sector(twin);
    const auto is_goal = [&](Index corner)
    { return std::find(goals.begin(), goals.end(), corner) != goals.end(); };
    for(const Index corner : starts)
      if(m_mesh.target(corner) == to && m_mesh.labels()[corner] == none &&
         is_goal(next_side(corner)))
      {
        m_mesh.set_label(corner, edge);
        keep(edge, {from, to});
        return true;
      }
    m_near = {base_corner(side), base_corner(twin), base_corner(previous_side(side)),
              base_corner(previous_side(twin))};
    const std::vector<Index> rough = search(starts, goals, to);
    if(rough.empty())
      return false;
    m_is_barred.resize(t().point.size(), false);
    const Strip strip(m_mesh, m_is_barred, from, to, rough);
    return !strip.sides().empty() && draw(edge, from, to, strip.sides(), strip.shares());
  }

  double how_far(Index site) const
  {
    const Index cell = m_cell[site];
    return cell == m_near[0] || cell == m_near[1] || cell == none ? 1.
           : cell == m_near[2] || cell == m_near[3]               ? m_detours.near
                                                                  : m_detours.far;
  }

  // The sides that a short path crosses: the shortest through some places on each (A*, Hart, Nilsson and
  // Raphael 1968).  Empty when there is none.
  std::vector<Index> search(const std::vector<Index>& starts, const std::vector<Index>& goals,
                            Index to)
  {
    ++m_run;
    m_nodes.resize(places * t().corner.size());
    const Spatial& goal = t().point[to];
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto point = [&](Index node)
    {
      const Index side = node / places;
      const double share = double(node % places + 1) / double(places + 1);
      return (1. - share) * t().point[m_mesh.source(side)] + share * t().point[m_mesh.target(side)];
    };
    const auto reach = [&](Index side, const Spatial& from, double distance, Index last)
    {
      if(m_mesh.labels()[side] != none || t().twin[side] == none)
        return;
      for(Index i = 0; i < places; ++i)
      {
        const Index number = places * m_mesh.first(side) + i;
        const Spatial place = point(number);
        const double length =
            distance + 0.5 * (how_far(m_mesh.source(side)) + how_far(m_mesh.target(side))) *
                           norm(place - from);
        Node& node = m_nodes[number];
        if(node.run == m_run && !(length < node.distance))
          continue;
        node = {length, m_run, last, side};
        queue.emplace(length + norm(goal - place), number);
      }
    };
    for(const Index corner : starts)
      reach(next_side(corner), t().point[m_mesh.source(corner)], 0., none);
    double best = infinity;
    Index end = none;
    while(!queue.empty() && queue.top().first < best)
    {
      const auto [key, number] = queue.top();
      queue.pop();
      if(m_visits_left-- == 0)
        throw Unsupported_surface_error(
            "The edges of a base mesh cross too many triangles: these are too thin.");
      const Node node = m_nodes[number];
      const Spatial place = point(number);
      if(key > node.distance + norm(goal - place))
        continue;
      const Index entry = t().twin[node.side], far = previous_side(entry);
      if(m_mesh.source(far) == to && node.distance + norm(goal - place) < best &&
         std::find(goals.begin(), goals.end(), far) != goals.end())
      {
        best = node.distance + norm(goal - place);
        end = number;
      }
      reach(next_side(entry), place, node.distance, number);
      reach(far, place, node.distance, number);
    }
    std::vector<Index> result;
    for(Index node = end; node != none; node = m_nodes[node].from)
      result.push_back(m_nodes[node].side);
    std::reverse(result.begin(), result.end());
    return result;
  }

  // Divides the triangles of a strip along a path.
  bool draw(Index edge, Index from, Index to, const std::vector<Index>& sides,
            const std::vector<double>& shares)
  {
    std::vector<bool> turns;
    for(std::size_t i = 0; i + 1 < sides.size(); ++i)
      turns.push_back(sides[i + 1] == next_side(t().twin[sides[i]]));
    std::vector<Index> path = {from};
    Index side = sides.front();
    for(std::size_t i = 0; i < sides.size(); ++i)
    {
      if(m_mesh.apex(side) != path.back())
        return false;
      const Index entry = t().twin[side];
      const Index nearer = shares[i] < 0.5 ? m_mesh.source(side) : m_mesh.target(side);
      path.push_back(m_mesh.split_side(side, shares[i]));
      m_cell.push_back(m_cell[nearer]);
      m_mesh.set_label(next_side(side), edge);
      if(i + 1 < sides.size())
        // Of v u x are left v p x and, glued to the first part, p u x.
        side = turns[i] ? next_side(t().twin[side]) : previous_side(entry);
      else
      {
        if(m_mesh.apex(entry) != to)
          return false;
        m_mesh.set_label(next_side(entry), edge);
      }
    }
    path.push_back(to);
    keep(edge, std::move(path));
    return true;
  }

  // Halves sides that join two sites of one edge, without being a part of it.
  void open_shortcuts()
  {
    std::vector<std::vector<Index>> edges(t().point.size());
    for(Index edge = 0; edge < m_result.path.size(); ++edge)
      for(const Index site : m_result.path[edge])
        edges[site].push_back(edge);
    const Index n = Index(t().corner.size());
    for(Index side = 0; side < n; ++side)
    {
      if(m_mesh.labels()[side] != none || t().twin[side] < side)
        continue;
      const Index p = m_mesh.source(side), q = m_mesh.target(side);
      if(p >= edges.size() || q >= edges.size())
        continue;
      const auto& of_q = edges[q];
      if(std::any_of(edges[p].begin(), edges[p].end(),
                     [&](Index edge)
                     { return std::find(of_q.begin(), of_q.end(), edge) != of_q.end(); }))
        m_mesh.split_side(side, 0.5);
    }
  }

  // Whether the triangles of each region form a disc between the edges of its triangle of the base.
  bool fill_regions()
  {
    const std::vector<Index>& label = m_mesh.labels();
    m_result.region.assign(t().number_of_triangles(), none);
    std::vector<Index> waiting, seen(t().point.size(), none);
    for(Index f = 0; f < m_result.triangles.size(); ++f)
    {
      for(const Index corner : m_mesh.corners_around(m_result.site[m_result.triangles[f][0]]))
        if(label[corner] == m_result.edge[3 * f])
          waiting.push_back(corner / 3);
      if(waiting.size() != 1 || m_result.region[waiting[0]] != none)
        return false;
      m_result.region[waiting[0]] = f;
      std::size_t triangles = 0, sides = 0, border = 0, sites = 0;
      while(!waiting.empty())
      {
        const Index part = waiting.back();
        waiting.pop_back();
        ++triangles;
        for(Index side = 3 * part; side < 3 * part + 3; ++side)
        {
          if(seen[m_mesh.source(side)] != f)
          {
            seen[m_mesh.source(side)] = f;
            ++sites;
          }
          ++sides;
          if(label[side] != none)
          {
            const Index* edge = &m_result.edge[3 * std::size_t(f)];
            if(std::find(edge, edge + 3, label[side]) == edge + 3)
              return false;
            ++border;
            continue;
          }
          const Index other = t().twin[side] / 3;
          if(m_result.region[other] == none)
          {
            m_result.region[other] = f;
            waiting.push_back(other);
          }
        }
      }
      std::size_t perimeter = 0;
      for(Index side = 3 * f; side < 3 * f + 3; ++side)
        perimeter += m_result.path[m_result.edge[side]].size() - 1;
      if(border != perimeter || sites + triangles != (sides + border) / 2 + 1)
        return false;
    }
    return std::find(m_result.region.begin(), m_result.region.end(), none) == m_result.region.end();
  }

  void finish()
  {
    Glued_triangles& fine = m_mesh.triangles();
    for(Index side = 0; side < fine.corner.size(); ++side)
      fine.length.push_back(std::max(m_mesh.length(side), shortest_side));
    build_stars(fine, fine.point.size());
    for(Index side = 0; side < fine.corner.size(); ++side)
      m_result.barycentric.push_back(m_mesh.barycentric(side / 3, fine.corner[side]));
    m_result.whole = std::move(m_mesh.wholes());
    m_result.edge_of_side = std::move(m_mesh.labels());
    m_result.fine = std::move(fine);
  }

  struct Node
  {
    double distance = infinity;
    Index run = 0;
    Index from = none; // the place before
    Index side = none; // seen from there
  };

  Divided_mesh m_mesh;
  Detours m_detours;
  Base_mesh m_result;
  std::map<std::pair<Index, Index>, Index> m_edge_between;
  std::vector<Index> m_base_vertex; // #sites without those of paths
  std::vector<bool> m_is_barred;    // #sites: on edges, or samples
  std::vector<Index> m_cell;        // #sites: the sample of each
  std::array<Index, 4> m_near = {}; // corners of the two triangles at the edge that is sought
  std::vector<Node> m_nodes;
  Index m_run = 0;
  std::size_t m_visits_left = 0;
};

} // namespace

std::optional<Base_mesh> base_mesh(const Glued_triangles& coarse,
                                   const std::vector<Location>& samples,
                                   const std::vector<std::array<Index, 3>>& triangles,
                                   const std::vector<bool>& is_curve)
{
  for(const Detours& detours : all_detours)
    if(auto result = Builder(coarse, samples, triangles, is_curve, detours).run())
      return result;
  return std::nullopt;
}

Base_mesh base_mesh(const std::shared_ptr<const Glued_triangles>& triangles, Remeshing_goal goal)
{
  const std::vector<bool> is_curve =
      goal.is_curve.empty() ? border_and_sharp_sides(*triangles) : goal.is_curve;
  for(int trial = 0; trial < most_trials; ++trial)
  {
    const Remeshing found = remeshing(triangles, goal);
    if(!found.is_finished)
    {
      Base_mesh nothing;
      nothing.is_finished = false;
      return nothing;
    }
    if(auto result = base_mesh(*triangles, found.samples, found.triangles, is_curve))
      return std::move(*result);
    goal.number = found.samples.size() + found.samples.size() / 2 + 1;
  }
  throw Unsupported_surface_error(
      "The edges of no base mesh can be drawn on the surface: it is too thin or too coarse.");
}

} // namespace CGAL::Geodesic_processing::internal
