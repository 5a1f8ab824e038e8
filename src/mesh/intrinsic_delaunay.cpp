// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/intrinsic_delaunay.h"

#include <CGAL/Geodesic_processing/internal/core/planar.h>

#include <algorithm>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Whether the angles opposite to a side and its twin sum to more than pi: sin of the sum < 0.
bool is_to_be_flipped(const Glued_triangles& t, Index side)
{
  const Index twin = t.twin[side];
  if(twin == none || twin / 3 == side / 3)
    return false;
  const Planar a = corner_angle(t, previous_side(side)), b = corner_angle(t, previous_side(twin));
  return turned(a, b)[1] < -1e-12;
}

// Replaces the side ab of the triangles abc and bad by cd: they become cdb and dca.
void flip(Glued_triangles& t, Index side)
{
  const Index twin = t.twin[side];
  const Index bc = next_side(side), ca = previous_side(side), ad = next_side(twin),
              db = previous_side(twin);
  const Planar c = apex(t, side), d = apex(t, twin); // d seen from b, with a on the first axis
  const double diagonal = norm(c - (Planar{t.length[side], 0.} - d));

  struct Side
  {
    Index end, twin;
    double length;
  };
  const auto read = [&](Index s) { return Side{t.corner[s], t.twin[s], t.length[s]}; };
  const Side old_bc = read(bc), old_ca = read(ca), old_ad = read(ad), old_db = read(db);
  // side: c d, then d b, b c;  twin: d c, then c a, a d.
  const auto write = [&](Index s, const Side& value)
  {
    t.corner[s] = value.end;
    t.length[s] = value.length;
    t.twin[s] = value.twin;
    if(value.twin != none)
      t.twin[value.twin] = s;
  };
  // A side glued to another one of these four moves with it.
  const auto moved = [&](Side value)
  {
    if(value.twin == bc)
      value.twin = ca;
    else if(value.twin == ca)
      value.twin = ad;
    else if(value.twin == ad)
      value.twin = db;
    else if(value.twin == db)
      value.twin = bc;
    return value;
  };
  const Side new_db = moved(old_db), new_bc = moved(old_bc), new_ca = moved(old_ca),
             new_ad = moved(old_ad);
  write(bc, new_db);
  write(ca, new_bc);
  write(ad, new_ca);
  write(db, new_ad);
  t.corner[side] = old_ca.end; // c
  t.corner[twin] = old_db.end; // d
  t.length[side] = t.length[twin] = diagonal;
}

} // namespace

void mollify(Glued_triangles& t, double slack)
{
  double missing = 0.;
  for(Index side = 0; side < t.length.size(); ++side)
    missing = std::max(missing, slack - (t.length[side] + t.length[next_side(side)] -
                                         t.length[previous_side(side)]));
  if(missing > 0.)
    for(double& length : t.length)
      length += missing;
}

std::size_t flip_to_delaunay(Glued_triangles& t)
{
  std::vector<Index> stack;
  std::vector<bool> is_stacked(t.corner.size(), false);
  for(Index side = 0; side < t.corner.size(); ++side)
    if(t.twin[side] != none && side < t.twin[side] && is_to_be_flipped(t, side))
    {
      is_stacked[side] = true;
      stack.push_back(side);
    }
  // Each flip lowers the Dirichlet energy of the identity, so it ends; the bound is for rounding.
  const std::size_t most = 100 * t.corner.size() + 1000;
  std::size_t flips = 0;
  while(!stack.empty() && flips < most)
  {
    const Index side = stack.back();
    stack.pop_back();
    is_stacked[side] = false;
    if(!is_to_be_flipped(t, side))
      continue;
    const Index twin = t.twin[side];
    flip(t, side);
    ++flips;
    for(const Index around :
        {next_side(side), previous_side(side), next_side(twin), previous_side(twin)})
      if(t.twin[around] != none && !is_stacked[around])
      {
        is_stacked[around] = true;
        stack.push_back(around);
      }
  }
  return flips;
}

} // namespace CGAL::Geodesic_processing::internal
