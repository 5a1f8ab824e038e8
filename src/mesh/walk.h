// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_WALK_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_WALK_H

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/spatial.h>

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

// Of triangles that a walk passes: a sample moves by a cell or two.
constexpr int most_steps_of_walk = 1000;

inline bool has_area(const Spatial& a, const Spatial& b, const Spatial& c)
{
  return norm(cross(b - a, c - a)) > 0.;
}

// The place of a surface that is nearest to a point in space, found from triangle to triangle, each nearer
// than the one before.  Nowhere where that leads to a border, across a wall, or to a triangle that is not open or
// has no area.
//
// triangle: where it starts; is_open(triangle); is_wall(side): of a side that is no border
template <typename IsOpen, typename IsWall>
Location walk_to_nearest(const Glued_triangles& t, Index triangle, const Spatial& p,
                         const IsOpen& is_open, const IsWall& is_wall)
{
  // The squared distance of the nearest place.
  const auto nearest_in = [&](Index f, std::array<double, 3>& nearest)
  {
    if(f == none || !is_open(f))
      return infinity;
    const Index* const corner = &t.corner[3 * std::size_t(f)];
    const Spatial &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
    if(!has_area(a, b, c))
      return infinity;
    nearest = nearest_in_triangle(a, b, c, p);
    const Spatial way = nearest[0] * a + nearest[1] * b + nearest[2] * c - p;
    return dot(way, way);
  };

  Index last = none;
  std::array<double, 3> nearest;
  double least = nearest_in(triangle, nearest);
  for(int steps = 0; least < infinity && steps < most_steps_of_walk; ++steps)
  {
    const auto zeros = std::count(nearest.begin(), nearest.end(), 0.);
    if(zeros == 0)
      return {triangle, none, nearest};
    if(zeros > 1)
    {
      // At a corner: on through what comes nearest of all around it.
      const Location corner = {triangle, none, nearest};
      const Index site = site_of(t, corner), before = triangle;
      std::array<double, 3> there;
      for(Index i = t.first[site]; i < t.first[site + 1]; ++i)
      {
        if(t.twin[t.star[i]] != none && is_wall(t.star[i]))
          return {};
        if(const double square = nearest_in(t.star[i] / 3, there); square < least)
        {
          least = square;
          nearest = there;
          triangle = t.star[i] / 3;
        }
      }
      if(triangle == before)
        return corner;
      last = before;
      continue;
    }
    const auto behind = std::find(nearest.begin(), nearest.end(), 0.) - nearest.begin();
    const Index side = next_side(3 * triangle + Index(behind));
    if(t.twin[side] == none || is_wall(side))
      return {};
    // On an edge where the surface bulges.
    if(t.twin[side] / 3 == last)
      return {triangle, none, nearest};
    last = triangle;
    triangle = t.twin[side] / 3;
    least = nearest_in(triangle, nearest);
  }
  return {};
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_WALK_H
