// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flips.h"

#include <CGAL/Geodesic_processing/internal/mesh/glue.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr double least_cosine = 0.9;  // between normals of neighbours
constexpr double least_height = 0.1;  // of a needle, in parts of its longest side
constexpr double worth_a_flip = 1e-9; // of a cosine: beyond rounding

} // namespace

Flippable_triangles::Flippable_triangles(std::size_t number_of_points,
                                         const std::vector<std::array<Index, 3>>& triangles)
{
  for(const auto& f : triangles)
    m_corner.insert(m_corner.end(), f.begin(), f.end());
  m_twin = twins_of_soup(number_of_points, m_corner);
}

bool Flippable_triangles::is_joined(Index side, Index point) const
{
  for(const bool leftwards : {true, false})
    for(Index corner = side; corner != none;)
    {
      if(m_corner[next_side(corner)] == point || m_corner[previous_side(corner)] == point)
        return true;
      const Index twin = m_twin[leftwards ? previous_side(corner) : corner];
      corner = leftwards || twin == none ? twin : next_side(twin);
      if(corner == side)
        return false;
    }
  return false;
}

bool Flippable_triangles::is_flat(const std::vector<Spatial>& points, Index side) const
{
  const Index twin = m_twin[side];
  const Spatial &x = points[m_corner[side]], &y = points[m_corner[twin]],
                &z = points[m_corner[previous_side(side)]],
                &w = points[m_corner[previous_side(twin)]];
  const Spatial a = cross(y - x, z - x), b = cross(x - y, w - y), c = unit(cross(w - x, z - x)),
                d = unit(cross(y - w, z - w));
  const auto is_along = [&](const Spatial& n)
  { return dot(n, c) > least_cosine * norm(n) && dot(n, d) > least_cosine * norm(n); };
  if(!(dot(c, d) > least_cosine))
    return false;
  if(dot(a, b) > least_cosine * norm(a) * norm(b) && is_along(unit(a) + unit(b)))
    return true;
  // Or one is a needle along the other, as come at creases: how far the one edge passes the other.
  const Spatial across = cross(y - x, w - z);
  return std::abs(dot(z - x, across)) < least_height * norm(y - x) * norm(across) &&
         is_along(dot(a, a) > dot(b, b) ? a : b);
}

void Flippable_triangles::flip(Index side)
{
  const auto join = [&](Index one, Index other)
  {
    m_twin[one] = other;
    if(other != none)
      m_twin[other] = one;
  };
  const Index twin = m_twin[side], f = 3 * (side / 3), g = 3 * (twin / 3);
  const Index x = m_corner[side], y = m_corner[twin], z = m_corner[previous_side(side)],
              w = m_corner[previous_side(twin)];
  const Index yz = m_twin[next_side(side)], zx = m_twin[previous_side(side)],
              xw = m_twin[next_side(twin)], wy = m_twin[previous_side(twin)];
  const std::array<Index, 3> first = {x, w, z}, second = {w, y, z};
  std::copy(first.begin(), first.end(), m_corner.begin() + f);
  std::copy(second.begin(), second.end(), m_corner.begin() + g);
  join(f, xw);
  join(f + 1, g + 2);
  join(f + 2, zx);
  join(g, wy);
  join(g + 1, yz);
}

void flip_to_larger_angles(const std::vector<Spatial>& points, const std::vector<bool>& is_kept,
                           std::vector<std::array<Index, 3>>& triangles)
{
  Flippable_triangles t(points.size(), triangles);
  const auto is_better_flipped = [&](Index side)
  {
    const Index twin = t.twin()[side];
    if(twin == none)
      return false;
    const Index x = t.corner()[side], y = t.corner()[twin], z = t.corner()[previous_side(side)],
                w = t.corner()[previous_side(twin)];
    if((is_kept[x] && is_kept[y]) || z == w)
      return false;
    const Spatial &a = points[x], &b = points[y], &c = points[z], &d = points[w];
    const double now = std::max(largest_cosine(a, b, c), largest_cosine(b, a, d)),
                 then = std::max(largest_cosine(a, d, c), largest_cosine(d, b, c));
    return then < now - worth_a_flip && t.is_flat(points, side) &&
           !t.is_joined(previous_side(side), w);
  };
  std::vector<Index> sides(t.corner().size());
  std::iota(sides.rbegin(), sides.rend(), Index(0));
  while(!sides.empty())
  {
    const Index side = sides.back();
    sides.pop_back();
    if(!is_better_flipped(side))
      continue;
    t.flip(side);
    for(const Index f : {side / 3, t.twin()[3 * (side / 3) + 1] / 3})
      sides.insert(sides.end(), {3 * f, 3 * f + 1, 3 * f + 2});
  }
  for(Index f = 0; f < triangles.size(); ++f)
    std::copy_n(t.corner().begin() + 3 * std::ptrdiff_t(f), 3, triangles[f].begin());
}

} // namespace CGAL::Geodesic_processing::internal
