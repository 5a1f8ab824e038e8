// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/flips.h>

#include <CGAL/Geodesic_processing/internal/glue.h>
#include <CGAL/Geodesic_processing/internal/spatial.h>

#include <algorithm>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr double least_cosine = 0.9;  // between normals of neighbours
constexpr double worth_a_flip = 1e-9; // of a cosine: beyond rounding

class Flips
{
public:
  Flips(const std::vector<Spatial>& points, const std::vector<bool>& is_kept,
        const std::vector<std::array<Index, 3>>& triangles)
      : m_points(points), m_is_kept(is_kept)
  {
    for(const auto& f : triangles)
      m_corner.insert(m_corner.end(), f.begin(), f.end());
    m_twin = twins_of_soup(points.size(), m_corner);
  }

  void run()
  {
    std::vector<Index> sides(m_corner.size());
    std::iota(sides.rbegin(), sides.rend(), Index(0));
    while(!sides.empty())
    {
      const Index side = sides.back();
      sides.pop_back();
      if(!is_better_flipped(side))
        continue;
      flip(side);
      for(const Index f : {side / 3, m_twin[3 * (side / 3) + 1] / 3})
        sides.insert(sides.end(), {3 * f, 3 * f + 1, 3 * f + 2});
    }
  }

  Index corner(Index i) const { return m_corner[i]; }

private:
  Spatial normal(Index a, Index b, Index c) const
  {
    return unit(cross(m_points[b] - m_points[a], m_points[c] - m_points[a]));
  }
  // Of the least angle.
  double largest_cosine(Index a, Index b, Index c) const
  {
    const Spatial u = unit(m_points[b] - m_points[a]), v = unit(m_points[c] - m_points[b]),
                  w = unit(m_points[a] - m_points[c]);
    return std::max({-dot(u, v), -dot(v, w), -dot(w, u)});
  }

  // Whether an edge joins the end of a side to another point.
  bool is_joined(Index side, Index point) const
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

  bool is_better_flipped(Index side) const
  {
    const Index twin = m_twin[side];
    if(twin == none)
      return false;
    const Index x = m_corner[side], y = m_corner[twin], z = m_corner[previous_side(side)],
                w = m_corner[previous_side(twin)];
    if((m_is_kept[x] && m_is_kept[y]) || z == w)
      return false;
    const double now = std::max(largest_cosine(x, y, z), largest_cosine(y, x, w)),
                 then = std::max(largest_cosine(x, w, z), largest_cosine(w, y, z));
    if(!(then < now - worth_a_flip))
      return false;
    const Spatial a = normal(x, y, z), b = normal(y, x, w), c = normal(x, w, z),
                  d = normal(w, y, z);
    const bool is_flat = dot(a, b) > least_cosine && dot(c, d) > least_cosine &&
                         dot(a + b, c) > least_cosine * norm(a + b) &&
                         dot(a + b, d) > least_cosine * norm(a + b);
    return is_flat && !is_joined(previous_side(side), w);
  }

  void join(Index side, Index twin)
  {
    m_twin[side] = twin;
    if(twin != none)
      m_twin[twin] = side;
  }
  // Of x y z and y x w makes x w z and w y z.
  void flip(Index side)
  {
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

  const std::vector<Spatial>& m_points;
  const std::vector<bool>& m_is_kept;
  std::vector<Index> m_corner, m_twin;
};

} // namespace

void flip_to_larger_angles(const std::vector<std::array<double, 3>>& points,
                           const std::vector<bool>& is_kept,
                           std::vector<std::array<Index, 3>>& triangles)
{
  Flips flips(points, is_kept, triangles);
  flips.run();
  for(Index f = 0; f < triangles.size(); ++f)
    for(Index k = 0; k < 3; ++k)
      triangles[f][k] = flips.corner(3 * f + k);
}

} // namespace CGAL::Geodesic_processing::internal
