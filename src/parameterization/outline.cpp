// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>

#include "core/exact_predicates.h"

#include <algorithm>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns whether a point on the line through p and q is between p and q.
bool is_between(const Vec2& x, const Vec2& p, const Vec2& q)
{
  return std::min(p[0], q[0]) <= x[0] && x[0] <= std::max(p[0], q[0]) &&
         std::min(p[1], q[1]) <= x[1] && x[1] <= std::max(p[1], q[1]);
}

bool do_intersect_segments(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s)
{
  const auto at_r = orientation(p, q, r), at_s = orientation(p, q, s), at_p = orientation(r, s, p),
             at_q = orientation(r, s, q);
  return (at_r * at_s < 0 && at_p * at_q < 0) || (at_r == 0 && is_between(r, p, q)) ||
         (at_s == 0 && is_between(s, p, q)) || (at_p == 0 && is_between(p, r, s)) ||
         (at_q == 0 && is_between(q, r, s));
}

// Returns whether the edges pq and qr overlap, or one of them has length zero.
bool is_folding_back(const Vec2& p, const Vec2& q, const Vec2& r)
{
  return p == q || q == r ||
         (orientation(p, q, r) == 0 && (is_between(r, p, q) || is_between(p, q, r)));
}

} // namespace

bool is_left_turn(const Vec2& p, const Vec2& q, const Vec2& r) { return orientation(p, q, r) > 0; }

std::optional<std::pair<std::size_t, std::size_t>> find_self_intersection(const Outline& outline)
{
  const std::size_t n = outline.size();
  const auto next = [&](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  const auto low = [&](std::size_t i, int axis)
  { return std::min(outline[i][axis], outline[next(i)][axis]); };
  const auto high = [&](std::size_t i, int axis)
  { return std::max(outline[i][axis], outline[next(i)][axis]); };
  const auto do_edges_intersect = [&](std::size_t i, std::size_t j)
  {
    const Vec2 &p = outline[i], &q = outline[next(i)], &r = outline[j], &s = outline[next(j)];
    if(next(i) == j)
      return is_folding_back(p, q, s);
    if(next(j) == i)
      return is_folding_back(r, p, q);
    return low(i, 1) <= high(j, 1) && low(j, 1) <= high(i, 1) && do_intersect_segments(p, q, r, s);
  };
  std::vector<std::size_t> order(n), active;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j)
            { return std::make_pair(low(i, 0), i) < std::make_pair(low(j, 0), j); });
  for(const std::size_t i : order)
  {
    std::size_t number_kept = 0;
    for(const std::size_t j : active)
    {
      if(high(j, 0) < low(i, 0))
        continue;
      active[number_kept++] = j;
      if(do_edges_intersect(j, i))
        return std::make_pair(j, i);
    }
    active.resize(number_kept);
    active.push_back(i);
  }
  return std::nullopt;
}

} // namespace CGAL::Geodesic_processing::internal
