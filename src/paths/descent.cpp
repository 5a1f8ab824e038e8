// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/descent.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Calls f with each triangle that holds a clean location.
template <typename Function>
void for_each_holder(const Glued_triangles& t, const Location& location, Function f)
{
  if(const Index site = site_of(t, location); site != none)
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      f(t.star[i] / 3);
  else
  {
    f(location.triangle);
    const Index side = side_of(location);
    if(side != none && t.twin[side] != none)
      f(t.twin[side] / 3);
  }
}

} // namespace

Descent::Descent(const Glued_triangles& t, const std::vector<Source>& sources) : m_triangles(t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error("No path can be traced on a cloud: nothing is glued.");
  for(Index s = 0; s < sources.size(); ++s)
  {
    const Source& source = sources[s];
    for(std::size_t i = 0; i < source.polyline.size(); ++i)
    {
      const Location begin = cleaned(t, source.polyline[i]);
      const Location end =
          i + 1 < source.polyline.size() ? cleaned(t, source.polyline[i + 1]) : begin;
      const auto add = [&](Index triangle)
      {
        const auto first = *seen_from(t, triangle, begin);
        m_pieces.push_back(
            {triangle, s, source.offset, first, seen_from(t, triangle, end).value_or(first)});
      };
      if(begin.triangle == none)
        m_isolated.emplace_back(begin.site, s);
      else
        for_each_holder(t, begin, add);
    }
    // The last location, seen from the triangles that do not hold the one before.
    if(source.polyline.size() > 1)
    {
      const Location end = cleaned(t, source.polyline.back());
      if(end.triangle != none)
        for_each_holder(t, end,
                        [&](Index triangle)
                        {
                          const auto b = *seen_from(t, triangle, end);
                          m_pieces.push_back({triangle, s, source.offset, b, b});
                        });
    }
  }
  std::stable_sort(m_pieces.begin(), m_pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.triangle < b.triangle; });
}

// A path under way.
struct Descent::Walk
{
  const Descent& descent;
  const Glued_triangles& t;
  const std::function<double(Index)>& distance;
  Descent_path path;
  Location at;
  double value = 0.;

  Walk(const Descent& descent, const std::function<double(Index)>& distance)
      : descent(descent), t(descent.m_triangles), distance(distance)
  {}

  double value_at(const Location& location) const
  {
    double sum = 0.;
    for(Index k = 0; k < 3; ++k)
      if(location.barycentric[k] != 0.)
        sum += location.barycentric[k] * distance(t.corner[3 * location.triangle + k]);
    return sum;
  }

  void go_to(const Location& next)
  {
    at = next;
    value = value_at(next);
    if(path.locations.empty() || !is_same_point(t, path.locations.back(), next))
      path.locations.push_back(next);
  }

  // Ends at the nearest source in a common triangle; at one that explains the value if asked to.
  bool arrive(bool must_explain)
  {
    double best = infinity;
    Location end;
    Index source = none;
    const auto try_triangle = [&](Index triangle)
    {
      auto piece = std::lower_bound(descent.m_pieces.begin(), descent.m_pieces.end(), triangle,
                                    [](const Piece& p, Index f) { return p.triangle < f; });
      if(piece == descent.m_pieces.end() || piece->triangle != triangle)
        return;
      const auto corners = unfolded(t, triangle);
      const Planar x = unfolded_point(corners, *seen_from(t, triangle, at));
      for(; piece != descent.m_pieces.end() && piece->triangle == triangle; ++piece)
      {
        const Planar p = unfolded_point(corners, piece->begin);
        const Planar pq = unfolded_point(corners, piece->end) - p;
        const double square = dot(pq, pq);
        const double share = square > 0. ? std::clamp(dot(x - p, pq) / square, 0., 1.) : 0.;
        const double total = piece->offset + norm(p + share * pq - x);
        if(total < best)
        {
          best = total;
          source = piece->source;
          end.triangle = triangle;
          for(int k = 0; k < 3; ++k)
            end.barycentric[k] = piece->begin[k] + share * (piece->end[k] - piece->begin[k]);
        }
      }
    };
    for_each_holder(t, at, try_triangle);
    // Interpolated distances are above true ones; the slack is for approximate fields.
    if(source == none || (must_explain && !(best <= value * (1. + 1e-6))))
      return false;
    end = cleaned(t, end);
    if(!is_same_point(t, path.locations.back(), end))
      path.locations.push_back(end);
    path.source = source;
    return true;
  }

  struct Step
  {
    Location to;
    double slope = 0.;
  };

  // Keeps a step if it is the steepest so far and really goes down.
  void offer(Step& best, const Location& to, double length) const
  {
    const double drop = value - value_at(to);
    if(!(drop > 0.))
      return;
    const double slope = length > 0. ? drop / length : infinity;
    if(slope > best.slope)
      best = {to, slope};
  }

  // Steps to the corners of a triangle and, unless only these are wanted, down its gradient.
  void offer_steps(Step& best, Index triangle, bool sites_only) const
  {
    const auto b = *seen_from(t, triangle, at);
    const auto corners = unfolded(t, triangle);
    const Planar x = unfolded_point(corners, b);
    std::array<double, 3> u;
    for(Index k = 0; k < 3; ++k)
    {
      u[k] = distance(t.corner[3 * triangle + k]);
      Location corner;
      corner.triangle = triangle;
      corner.barycentric = at_corner(3 * triangle + k);
      if(b[k] != 1.)
        offer(best, corner, norm(corners[k] - x));
    }
    if(sites_only || !std::isfinite(u[0] + u[1] + u[2]) || !(corners[2][1] > 0.))
      return;
    const double gx = (u[1] - u[0]) / corners[1][0];
    const double gy = (u[2] - u[0] - gx * corners[2][0]) / corners[2][1];
    const Planar down = {-gx, -gy};
    for(Index k = 0; k < 3; ++k)
    {
      if(b[(k + 2) % 3] == 0.)
      {
        // On this side: the way down must lead inside.
        if(!(cross(corners[(k + 1) % 3] - corners[k], down) > 0.))
          return;
      }
    }
    for(Index k = 0; k < 3; ++k)
    {
      if(b[(k + 2) % 3] == 0.)
        continue;
      const Planar side = corners[(k + 1) % 3] - corners[k], way = corners[k] - x;
      const double turn = cross(down, side);
      if(!(turn > 0.))
        continue;
      const double share = -cross(down, way) / turn;
      if(!(share >= 0. && share <= 1.))
        continue;
      Location to;
      to.triangle = triangle;
      // Near a corner that is lower, rather the corner itself: it saves a fan of small steps.
      const double near = 1e-4;
      if(share < near && u[k] < value)
        to.barycentric = at_corner(3 * triangle + k);
      else if(share > 1. - near && u[(k + 1) % 3] < value)
        to.barycentric = at_corner(3 * triangle + (k + 1) % 3);
      else
        to.barycentric = on_side(3 * triangle + k, share);
      offer(best, cleaned(t, to), norm(way + share * side));
    }
  }

  // Along the shortest chain of arcs to a site that is lower, or that has a source in its star.
  bool climb_out()
  {
    struct Reached
    {
      double length;
      Index from;
      bool is_final = false;
    };
    std::unordered_map<Index, Reached> reached;
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto reach = [&](Index site, double length, Index from)
    {
      const auto [place, is_new] = reached.try_emplace(site, Reached{length, from});
      if(is_new || length < place->second.length)
      {
        place->second = {length, from};
        queue.emplace(length, site);
      }
    };
    const Index start = site_of(t, at);
    if(start != none)
      reach(start, 0., none);
    else
      for_each_holder(t, at,
                      [&](Index triangle)
                      {
                        const auto b = *seen_from(t, triangle, at);
                        for(Index c = 3 * triangle; c < 3 * triangle + 3; ++c)
                          reach(t.corner[c], distance_in_triangle(t, triangle, b, at_corner(c)),
                                none);
                      });
    while(!queue.empty())
    {
      const auto [length, site] = queue.top();
      queue.pop();
      Reached& here = reached.find(site)->second;
      if(here.is_final)
        continue;
      here.is_final = true;
      bool is_goal = distance(site) < value;
      for(Index i = t.first[site]; i < t.first[site + 1] && !is_goal; ++i)
      {
        const Index triangle = t.star[i] / 3;
        const auto piece =
            std::lower_bound(descent.m_pieces.begin(), descent.m_pieces.end(), triangle,
                             [](const Piece& p, Index f) { return p.triangle < f; });
        is_goal = piece != descent.m_pieces.end() && piece->triangle == triangle;
      }
      if(is_goal)
      {
        std::vector<Index> chain;
        for(Index s = site; s != none; s = reached.find(s)->second.from)
          chain.push_back(s);
        for(auto s = chain.rbegin(); s != chain.rend(); ++s)
          go_to(at_site(t, *s));
        return true;
      }
      for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      {
        const Index corner = t.star[i], before = previous_side(corner);
        reach(t.corner[next_side(corner)], length + t.length[corner], site);
        reach(t.corner[before], length + t.length[before], site);
      }
    }
    return false;
  }

  bool run(const Location& from)
  {
    go_to(from);
    if(!std::isfinite(value))
    {
      double best = infinity;
      Index begin = none;
      for_each_holder(t, from,
                      [&](Index triangle)
                      {
                        const auto b = *seen_from(t, triangle, from);
                        for(Index c = 3 * triangle; c < 3 * triangle + 3; ++c)
                        {
                          const double total = distance(t.corner[c]) +
                                               distance_in_triangle(t, triangle, b, at_corner(c));
                          if(total < best)
                          {
                            best = total;
                            begin = t.corner[c];
                          }
                        }
                      });
      if(begin == none)
        return arrive(false);
      go_to(at_site(t, begin));
    }
    // A step across a triangle lowers the value by an amount that has no lower bound: after more of
    // them than the mesh has sides only steps to sites are made, of which there are finitely many.
    for(std::size_t steps = 0;; ++steps)
    {
      if(arrive(true))
        return true;
      Step best;
      for_each_holder(
          t, at, [&](Index triangle) { offer_steps(best, triangle, steps > t.corner.size()); });
      if(best.slope > 0.)
        go_to(best.to);
      else if(arrive(false))
        return true;
      else
      {
        const double before = value;
        if(!climb_out())
          return false;
        if(!(value < before))
          return arrive(false);
      }
    }
  }
};

Descent_path Descent::operator()(const Location& from,
                                 const std::function<double(Index)>& distance) const
{
  const Location begin = cleaned(m_triangles, from);
  if(begin.triangle == none)
  {
    // A site without triangles is reached from itself alone.
    for(const auto& [site, source] : m_isolated)
      if(site == begin.site)
        return {{begin}, source};
    return {};
  }
  Walk walk(*this, distance);
  if(!walk.run(begin))
    return {};
  return std::move(walk.path);
}

} // namespace CGAL::Geodesic_processing::internal
