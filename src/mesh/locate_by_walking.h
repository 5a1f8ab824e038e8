// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_LOCATE_BY_WALKING_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_LOCATE_BY_WALKING_H

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

// Maximum number of steps. A sample moves by one or two cells, so that walks are short.
constexpr int max_walk_steps = 1000;

// Returns whether a triangle is not degenerate.
inline bool has_area(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return norm(cross(b - a, c - a)) > 0.;
}

// Computes the barycentric coordinates of the point of a triangle that is closest to p. Returns
// its squared distance, or infinity if the triangle is `none`, degenerate or not open.
template <typename IsOpen>
double locate_in_open_triangle(const Surface_arrays& t, Index f, const Vec3& p,
                               const IsOpen& is_open, std::array<double, 3>& nearest)
{
  if(f == none || !is_open(f))
    return infinity;
  const Index* const corner = &t.corner[3 * std::size_t(f)];
  const Vec3 &a = t.point[corner[0]], &b = t.point[corner[1]], &c = t.point[corner[2]];
  if(!has_area(a, b, c))
    return infinity;
  nearest = nearest_in_triangle(a, b, c, p);
  const Vec3 offset = nearest[0] * a + nearest[1] * b + nearest[2] * c - p;
  return dot(offset, offset);
}

// Walks from triangle to triangle to a point of the surface at a local minimum of the distance to
// p, and returns it. The distance decreases in each step. Returns an empty location if the walk
// reaches the boundary, a wall, or a triangle that is degenerate or not open.
//
// triangle: the start
// is_open(f): whether the walk may enter triangle f
// is_wall(h): whether the walk must not cross halfedge h, which has a twin
template <typename IsOpen, typename IsWall>
Surface_location locate_by_walking(const Surface_arrays& t, Index triangle, const Vec3& p,
                                   const IsOpen& is_open, const IsWall& is_wall)
{
  const auto locate_in = [&](Index f, std::array<double, 3>& nearest)
  { return locate_in_open_triangle(t, f, p, is_open, nearest); };

  Index came_from = none;
  std::array<double, 3> nearest;
  double min_squared_distance = locate_in(triangle, nearest);
  for(int step = 0; min_squared_distance < infinity && step < max_walk_steps; ++step)
  {
    const auto zeros = std::count(nearest.begin(), nearest.end(), 0.);
    if(zeros == 0)
      return {triangle, none, nearest};
    if(zeros > 1)
    {
      // At a corner the walk goes on to the closest triangle of the vertex.
      const Surface_location corner = {triangle, none, nearest};
      const Index vertex = vertex_of(t, corner), previous_triangle = triangle;
      std::array<double, 3> candidate;
      for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      {
        if(t.twin[t.ring[i]] != none && is_wall(t.ring[i]))
          return {};
        if(const double squared_distance = locate_in(t.ring[i] / 3, candidate);
           squared_distance < min_squared_distance)
        {
          min_squared_distance = squared_distance;
          nearest = candidate;
          triangle = t.ring[i] / 3;
        }
      }
      if(triangle == previous_triangle)
        return corner;
      came_from = previous_triangle;
      continue;
    }
    const auto zero_corner = std::find(nearest.begin(), nearest.end(), 0.) - nearest.begin();
    const Index h = next_halfedge(3 * triangle + Index(zero_corner));
    if(t.twin[h] == none || is_wall(h))
      return {};
    // The walk came over this edge: the surface is convex there, and the closest point is on the
    // edge.
    if(t.twin[h] / 3 == came_from)
      return {triangle, none, nearest};
    came_from = triangle;
    triangle = t.twin[h] / 3;
    min_squared_distance = locate_in(triangle, nearest);
  }
  return {};
}

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_LOCATE_BY_WALKING_H
