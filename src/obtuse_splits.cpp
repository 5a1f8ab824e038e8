// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/obtuse_splits.h>

#include <CGAL/Geodesic_processing/internal/planar.h>

#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The split of one obtuse corner, or site == none.
Obtuse_splits::Split split_of(const Glued_triangles& t, Index corner, int steps)
{
  const Planar angle = corner_angle(t, corner);
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

} // namespace

Obtuse_splits obtuse_splits(const Glued_triangles& t, int steps)
{
  Obtuse_splits result;
  result.split_of_corner.assign(t.corner.size(), none);
  result.first.assign(t.number_of_sites() + 1, 0);
  if(t.twin.empty())
    return result;
  for(Index corner = 0; corner < t.corner.size(); ++corner)
  {
    // A right angle needs no split, and is common: rounding must not make it obtuse.
    if(corner_angle(t, corner)[0] >= -1e-12)
      continue;
    const Obtuse_splits::Split split = split_of(t, corner, steps);
    if(split.site == none)
      continue;
    result.split_of_corner[corner] = static_cast<Index>(result.splits.size());
    result.splits.push_back(split);
    ++result.first[split.site + 1];
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.behind.resize(result.splits.size());
  std::vector<Index> end(result.first.begin(), result.first.end() - 1);
  for(Index i = 0; i < result.splits.size(); ++i)
    result.behind[end[result.splits[i].site]++] = i;
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
