// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/spokes.h>

#include <CGAL/Geodesic_processing/internal/core/planar.h>
#include "core/unfold.h"

#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// An obtuse corner and the site behind the opposite side that splits it.
struct Behind
{
  Index corner;
  Index site;    // none where no site within reach splits the corner
  double length; // from the corner to that site
  Planar base;   // from that site to the corner's two neighbours, the one that the corner's side
                 //   runs to first
};

Behind behind(const Glued_triangles& t, Index corner, const Planar& angle)
{
  constexpr int steps = 20;
  const Planar a = {t.length[corner], 0.}, b = t.length[previous_side(corner)] * angle;
  // The side to look behind, from `left` to `right` as seen from the corner.
  Index side = next_side(corner);
  Planar begin = a, end = b;
  for(int step = 0; step < steps; ++step)
  {
    side = t.twin[side]; // runs from end to begin
    if(side == none)
      break;
    const double length = t.length[side];
    if(length <= 0.)
      break;
    const Planar along = (1. / length) * (begin - end);
    const Planar w = end + turned(apex(t, side), along);
    const bool acute_to_a = dot(a, w) > 0., acute_to_b = dot(b, w) > 0.;
    if(acute_to_a && acute_to_b && cross(a, w) > 0. && cross(w, b) > 0.)
      return {corner, t.corner[previous_side(side)], norm(w), {norm(a - w), norm(b - w)}};
    if(acute_to_a)
    {
      // Too close to a: the cone passes between w and end.
      begin = w;
      side = previous_side(side);
      // previous_side runs from w to end
    }
    else
    {
      end = w;
      side = next_side(side);
    }
  }
  return {corner, none, 0., {0., 0.}};
}

// Angles around a site add up to 2 pi within this: coordinates of single precision leave less.
constexpr double flat = 1e-6;

void add_spokes(const Glued_triangles& t, Spokes& s)
{
  const Index n = static_cast<Index>(t.number_of_sites());
  s.first.resize(n + 1);
  s.spokes.reserve(t.star.size() + n);
  for(Index site = 0; site < n; ++site)
  {
    s.first[site] = {static_cast<Index>(s.spokes.size()), 0, t.first[site]};
    std::size_t fan = s.spokes.size(); // where it begins
    Planar turn = {1., 0.};            // of its triangles so far
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index corner = t.star[i], next = next_side(corner), previous = previous_side(corner);
      s.spokes.push_back(
          {t.corner[next], Spokes::Spoke::has_triangle, t.length[corner], corner_angle(t, corner)});
      turn = turned(turn, s.spokes.back().opening);
      const Index left = t.twin.empty() ? none : turn_left(t, corner);
      if(left != none && i + 1 < t.first[site + 1] && left == t.star[i + 1])
        continue;
      s.spokes.push_back({t.corner[previous], 0, t.length[previous], {1., 0.}});
      if(left != none)
      {
        s.spokes[fan].flags |= Spokes::Spoke::is_repeated;
        s.spokes.back().flags |= Spokes::Spoke::is_repeated;
        if(std::abs(turn[0] - 1.) + std::abs(turn[1]) > flat)
          s.spokes[s.first[site].spoke].flags |= Spokes::Spoke::is_curved;
      }
      turn = {1., 0.};
      fan = s.spokes.size();
    }
  }
  s.first[n] = {static_cast<Index>(s.spokes.size()), 0, t.first[n]};
}

void add_splits(const Glued_triangles& t, Spokes& s)
{
  std::vector<Behind> behinds;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    const double a = t.length[corner], b = t.length[previous_side(corner)],
                 opposite = t.length[next_side(corner)];
    // A right angle needs no split, and is common: rounding must not make it obtuse.
    if(!(opposite * opposite > a * a + b * b))
      continue;
    const Planar angle = angle_between(a, b, opposite);
    if(angle[0] >= -1e-12)
      continue;
    const Behind found = behind(t, corner, angle);
    if(found.site != none)
      behinds.push_back(found);
  }

  // Each is seen from both ends of the bases of its two halves.
  const auto for_each_view = [&](const auto& use)
  {
    for(const Behind& found : behinds)
    {
      const Index corners[2] = {next_side(found.corner), previous_side(found.corner)};
      const double lengths[2] = {t.length[found.corner], t.length[corners[1]]};
      for(const int k : {0, 1})
      {
        const Index neighbour = t.corner[corners[k]];
        use(found, neighbour, found.site, neighbour, found.base[k], lengths[k], found.length);
        use(found, found.site, neighbour, neighbour, found.base[k], found.length, lengths[k]);
      }
      s.spokes[place_of(t, s, t.corner[corners[0]], corners[0]).spoke].flags |=
          Spokes::Spoke::next_is_split;
      s.spokes[place_of(t, s, t.corner[corners[1]], corners[1]).spoke].flags |=
          Spokes::Spoke::is_split;
    }
  };
  for_each_view([&](const Behind&, Index site, Index, Index, double, double, double)
                { ++s.first[site + 1].split; });
  for(std::size_t site = 1; site < s.first.size(); ++site)
    s.first[site].split += s.first[site - 1].split;
  s.splits.resize(s.first.back().split);
  std::vector<Index> end;
  end.reserve(s.first.size());
  for(const Spokes::First& first : s.first)
    end.push_back(first.split);
  for_each_view(
      [&](const Behind& found, Index site, Index along, Index neighbour, double base,
          double to_site, double to_along)
      {
        s.splits[end[site]++] = {found.corner, t.corner[found.corner],
                                 along,        neighbour,
                                 base,         third_corner(base, to_site, to_along)};
      });
}

} // namespace

Spokes spokes(const Glued_triangles& t, bool with_splits)
{
  Spokes result;
  add_spokes(t, result);
  if(with_splits && !t.is_cloud())
    add_splits(t, result);
  return result;
}

std::shared_ptr<const Spokes> shared_spokes(const Glued_triangles& t, bool with_splits)
{
  const std::lock_guard<std::mutex> lock(t.spokes.mutex);
  std::weak_ptr<const Spokes>& made = t.spokes.made[with_splits ? 1 : 0];
  std::shared_ptr<const Spokes> result = made.lock();
  if(!result)
    made = result = std::make_shared<const Spokes>(spokes(t, with_splits));
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
