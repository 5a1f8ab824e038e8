// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/spokes.h>

#include <CGAL/Geodesic_processing/internal/planar.h>
#include <CGAL/Geodesic_processing/internal/unfold.h>

namespace CGAL::Geodesic_processing::internal {

namespace {

// What lies behind an obtuse corner.
struct Behind
{
  Index site = none;      // what splits the corner, none where no site within reach does
  double length = 0.;     // from the corner to that site
  Planar base = {0., 0.}; // from that site to the corner's two neighbours, the one that the
                          //   corner's side runs to first
};

Behind behind(const Glued_triangles& t, Index corner, int steps)
{
  const Planar angle = corner_angle(t, corner);
  // A right angle needs no split, and is common: rounding must not make it obtuse.
  if(angle[0] >= -1e-12)
    return {};
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
      return {t.corner[previous_side(side)], norm(w), {norm(a - w), norm(b - w)}};
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
  return {};
}

} // namespace

Spokes spokes(const Glued_triangles& t, int steps)
{
  Spokes result;
  const Index n = static_cast<Index>(t.number_of_sites());
  std::vector<Behind> behinds;
  std::vector<Index> behind_corner(t.corner.size(), none);
  result.first.assign(n + 1, {0, 0});
  if(!t.twin.empty())
    for(Index corner = 0; corner < t.corner.size(); ++corner)
    {
      const Behind found = behind(t, corner, steps);
      if(found.site == none)
        continue;
      behind_corner[corner] = static_cast<Index>(behinds.size());
      behinds.push_back(found);
      ++result.first[t.corner[next_side(corner)] + 1][1];
      ++result.first[t.corner[previous_side(corner)] + 1][1];
      result.first[found.site + 1][1] += 2;
    }

  result.spokes.reserve(t.star.size() + n);
  for(Index site = 0; site < n; ++site)
  {
    result.first[site][0] = static_cast<Index>(result.spokes.size());
    for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
    {
      const Index corner = t.star[i], next = next_side(corner), previous = previous_side(corner);
      Index flags = Spokes::Spoke::has_triangle;
      if(behind_corner[next] != none)
        flags |= Spokes::Spoke::is_split;
      if(behind_corner[previous] != none)
        flags |= Spokes::Spoke::next_is_split;
      result.spokes.push_back({t.corner[next], flags, t.length[corner], t.length[next]});
      const bool goes_on =
          i + 1 < t.first[site + 1] && !t.twin.empty() && turn_left(t, corner) == t.star[i + 1];
      if(!goes_on)
        result.spokes.push_back({t.corner[previous], 0, t.length[previous], 0.});
    }
  }
  result.first[n][0] = static_cast<Index>(result.spokes.size());

  for(Index site = 0; site < n; ++site)
    result.first[site + 1][1] += result.first[site][1];
  result.splits.resize(result.first[n][1]);
  std::vector<Index> end(n);
  for(Index site = 0; site < n; ++site)
    end[site] = result.first[site][1];
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    if(behind_corner[corner] == none)
      continue;
    const Behind& found = behinds[behind_corner[corner]];
    const Index previous = previous_side(corner);
    const Index sites[2] = {t.corner[next_side(corner)], t.corner[previous]};
    const double lengths[2] = {t.length[corner], t.length[previous]};
    for(const int k : {0, 1})
    {
      result.splits[end[sites[k]]++] = {corner,        found.site, sites[k],
                                        found.base[k], lengths[k], found.length};
      result.splits[end[found.site]++] = {corner,        sites[k],     sites[k],
                                          found.base[k], found.length, lengths[k]};
    }
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
