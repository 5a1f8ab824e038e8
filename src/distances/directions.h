// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DIRECTIONS_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DIRECTIONS_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// Returns the unit direction of a halfedge in the layout of its triangle, or (1, 0) if its length
// is 0.
inline Vec2 edge_direction(const std::array<Vec2, 3>& corners, Index h)
{
  const Vec2 edge = corners[next_halfedge(h) % 3] - corners[h % 3];
  const double edge_length = norm(edge);
  return edge_length > 0. ? (1. / edge_length) * edge : Vec2{1., 0.};
}

// Returns the polar angle of a direction at a vertex, counterclockwise from the halfedge that
// leaves the first corner of its one-ring. The direction is given in the frame of a corner of the
// vertex.
inline double polar_angle(const Surface_arrays& t, Index corner, const Vec2& direction)
{
  double result = std::atan2(std::max(0., direction[1]), direction[0]);
  for(Index i = t.ring_begin[t.corner[corner]]; t.ring[i] != corner; ++i)
    result += interior_angle(t, t.ring[i]);
  return result;
}

// Returns the polar angle (Departure::polar_angle) of a direction in the layout of a triangle, at a
// canonical location in this triangle.
inline double polar_angle_at(const Surface_arrays& t, const Surface_location& from,
                             const Vec2& direction)
{
  const auto corners = unfolded(t, from.triangle);
  if(const Index corner = corner_of(from); corner != none)
    return polar_angle(
        t, corner,
        rotated_back(direction, corners[next_halfedge(corner) % 3] - corners[corner % 3]));
  const Index h = halfedge_of(from);
  if(h == none)
    return std::atan2(direction[1], direction[0]);
  const Vec2 local_direction =
      rotated_back(direction, corners[next_halfedge(h) % 3] - corners[h % 3]);
  return std::atan2(std::max(0., local_direction[1]), local_direction[0]) +
         (t.twin[h] < h ? pi : 0.);
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_DIRECTIONS_H
