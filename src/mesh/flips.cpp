// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/flips.h"

#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// minimum cosine between normals of adjacent triangles, 26 degrees
constexpr double min_cosine = 0.9;
// maximum height of a needle relative to its longest edge
constexpr double needle_height_ratio = 0.1;
constexpr double cosine_tolerance = 1e-9; // minimum decrease of a cosine, above round-off errors

} // namespace

Flippable_triangles::Flippable_triangles(std::size_t number_of_points,
                                         const std::vector<std::array<Index, 3>>& triangles)
{
  for(const auto& f : triangles)
    m_corner.insert(m_corner.end(), f.begin(), f.end());
  m_twin = twins_of_soup(number_of_points, m_corner);
}

bool Flippable_triangles::is_adjacent(Index h, Index point) const
{
  for(const bool is_ccw : {true, false})
    for(Index corner = h; corner != none;)
    {
      if(m_corner[next_halfedge(corner)] == point || m_corner[previous_halfedge(corner)] == point)
        return true;
      const Index twin = m_twin[is_ccw ? previous_halfedge(corner) : corner];
      corner = is_ccw || twin == none ? twin : next_halfedge(twin);
      if(corner == h)
        return false;
    }
  return false;
}

bool Flippable_triangles::is_flat(const std::vector<Vec3>& points, Index h) const
{
  const Index twin = m_twin[h];
  const Vec3 &x = points[m_corner[h]], &y = points[m_corner[twin]],
             &z = points[m_corner[previous_halfedge(h)]],
             &w = points[m_corner[previous_halfedge(twin)]];
  const Vec3 a = cross(y - x, z - x), b = cross(x - y, w - y), c = unit(cross(w - x, z - x)),
             d = unit(cross(y - w, z - w));
  const auto agrees_with_flipped = [&](const Vec3& n)
  { return dot(n, c) > min_cosine * norm(n) && dot(n, d) > min_cosine * norm(n); };
  if(!(dot(c, d) > min_cosine))
    return false;
  if(dot(a, b) > min_cosine * norm(a) * norm(b) && agrees_with_flipped(unit(a) + unit(b)))
    return true;
  // Otherwise one must be a needle along the other, as at creases: the distance between the lines
  // of the two diagonals is small.
  const Vec3 common_normal = cross(y - x, w - z);
  return std::abs(dot(z - x, common_normal)) <
             needle_height_ratio * norm(y - x) * norm(common_normal) &&
         agrees_with_flipped(dot(a, a) > dot(b, b) ? a : b);
}

void Flippable_triangles::flip(Index h)
{
  const auto set_twins = [&](Index first_halfedge, Index second_halfedge)
  {
    m_twin[first_halfedge] = second_halfedge;
    if(second_halfedge != none)
      m_twin[second_halfedge] = first_halfedge;
  };
  const Index twin = m_twin[h], f = 3 * (h / 3), g = 3 * (twin / 3);
  const Index x = m_corner[h], y = m_corner[twin], z = m_corner[previous_halfedge(h)],
              w = m_corner[previous_halfedge(twin)];
  const Index yz = m_twin[next_halfedge(h)], zx = m_twin[previous_halfedge(h)],
              xw = m_twin[next_halfedge(twin)], wy = m_twin[previous_halfedge(twin)];
  const std::array<Index, 3> first = {x, w, z}, second = {w, y, z};
  std::copy(first.begin(), first.end(), m_corner.begin() + f);
  std::copy(second.begin(), second.end(), m_corner.begin() + g);
  set_twins(f, xw);
  set_twins(f + 1, g + 2);
  set_twins(f + 2, zx);
  set_twins(g, wy);
  set_twins(g + 1, yz);
}

void flip_to_larger_angles(const std::vector<Vec3>& points,
                           const std::vector<std::array<Index, 2>>& kept_edges,
                           std::vector<std::array<Index, 3>>& triangles)
{
  Flippable_triangles t(points.size(), triangles);
  const auto is_kept = [&](Index x, Index y)
  {
    return std::binary_search(kept_edges.begin(), kept_edges.end(),
                              std::array<Index, 2>{std::min(x, y), std::max(x, y)});
  };
  const auto improves_by_flip = [&](Index h)
  {
    const Index twin = t.twin()[h];
    if(twin == none)
      return false;
    const Index x = t.corner()[h], y = t.corner()[twin], z = t.corner()[previous_halfedge(h)],
                w = t.corner()[previous_halfedge(twin)];
    if(z == w || is_kept(x, y))
      return false;
    const Vec3 &a = points[x], &b = points[y], &c = points[z], &d = points[w];
    const double cosine_before = std::max(largest_cosine(a, b, c), largest_cosine(b, a, d)),
                 cosine_after = std::max(largest_cosine(a, d, c), largest_cosine(d, b, c));
    return cosine_after < cosine_before - cosine_tolerance && t.is_flat(points, h) &&
           !t.is_adjacent(previous_halfedge(h), w);
  };
  std::vector<Index> halfedges(t.corner().size());
  std::iota(halfedges.rbegin(), halfedges.rend(), Index(0));
  while(!halfedges.empty())
  {
    const Index h = halfedges.back();
    halfedges.pop_back();
    if(!improves_by_flip(h))
      continue;
    t.flip(h);
    for(const Index f : {h / 3, t.twin()[3 * (h / 3) + 1] / 3})
      halfedges.insert(halfedges.end(), {3 * f, 3 * f + 1, 3 * f + 2});
  }
  for(Index f = 0; f < triangles.size(); ++f)
    std::copy_n(t.corner().begin() + 3 * std::ptrdiff_t(f), 3, triangles[f].begin());
}

} // namespace CGAL::Geodesic_processing::internal
