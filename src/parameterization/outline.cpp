// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/outline.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

CGAL::Orientation turn(const Planar& p, const Planar& q, const Planar& r)
{
  return Kernel().orientation_2_object()({p[0], p[1]}, {q[0], q[1]}, {r[0], r[1]});
}

// Of a point on the line through p and q.
bool is_between(const Planar& x, const Planar& p, const Planar& q)
{
  return std::min(p[0], q[0]) <= x[0] && x[0] <= std::max(p[0], q[0]) &&
         std::min(p[1], q[1]) <= x[1] && x[1] <= std::max(p[1], q[1]);
}

bool do_meet(const Planar& p, const Planar& q, const Planar& r, const Planar& s)
{
  const auto at_r = turn(p, q, r), at_s = turn(p, q, s), at_p = turn(r, s, p), at_q = turn(r, s, q);
  return (at_r * at_s < 0 && at_p * at_q < 0) || (at_r == CGAL::ZERO && is_between(r, p, q)) ||
         (at_s == CGAL::ZERO && is_between(s, p, q)) ||
         (at_p == CGAL::ZERO && is_between(p, r, s)) || (at_q == CGAL::ZERO && is_between(q, r, s));
}

// Whether q-r turns back over p-q.
bool turns_back(const Planar& p, const Planar& q, const Planar& r)
{
  return p == q || q == r ||
         (turn(p, q, r) == CGAL::ZERO && (is_between(r, p, q) || is_between(p, q, r)));
}

} // namespace

bool turns_left(const Planar& p, const Planar& q, const Planar& r)
{
  return turn(p, q, r) == CGAL::LEFT_TURN;
}

std::optional<std::pair<std::size_t, std::size_t>> meeting_sides(const Outline& outline)
{
  const std::size_t n = outline.size();
  const auto next = [&](std::size_t i) { return i + 1 < n ? i + 1 : 0; };
  const auto low = [&](std::size_t i, int axis)
  { return std::min(outline[i][axis], outline[next(i)][axis]); };
  const auto high = [&](std::size_t i, int axis)
  { return std::max(outline[i][axis], outline[next(i)][axis]); };
  const auto meet = [&](std::size_t i, std::size_t j)
  {
    const Planar &p = outline[i], &q = outline[next(i)], &r = outline[j], &s = outline[next(j)];
    if(next(i) == j)
      return turns_back(p, q, s);
    if(next(j) == i)
      return turns_back(r, p, q);
    return low(i, 1) <= high(j, 1) && low(j, 1) <= high(i, 1) && do_meet(p, q, r, s);
  };
  std::vector<std::size_t> order(n), active;
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j)
            { return std::make_pair(low(i, 0), i) < std::make_pair(low(j, 0), j); });
  for(const std::size_t i : order)
  {
    std::size_t kept = 0;
    for(const std::size_t j : active)
    {
      if(high(j, 0) < low(i, 0))
        continue;
      active[kept++] = j;
      if(meet(j, i))
        return std::make_pair(j, i);
    }
    active.resize(kept);
    active.push_back(i);
  }
  return std::nullopt;
}

} // namespace CGAL::Geodesic_processing::internal
