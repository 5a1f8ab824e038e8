// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRIANGLE_STRIP_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRIANGLE_STRIP_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <cstddef>
#include <vector>

// Strips of triangles on a mesh, their unfolding to the plane, and the shortest path in them by the
// funnel algorithm (Lee and Preparata 1984).

namespace CGAL::Geodesic_processing::internal {

// The triangles that a path passes, given by the edges that it crosses.
struct Strip
{
  Index triangle = none;        // the first triangle
  std::vector<Index> halfedges; // crossed one after the other, each in the triangle that is left

  Index last_triangle(const Surface_arrays& t) const
  {
    return halfedges.empty() ? triangle : t.twin[halfedges.back()] / 3;
  }
  // Crosses one more edge. If it is the edge crossed last, that crossing is removed instead.
  void append(const Surface_arrays& t, Index h)
  {
    if(!halfedges.empty() && t.twin[halfedges.back()] == h)
      halfedges.pop_back();
    else
      halfedges.push_back(h);
  }
  // Removes the edges at both ends of the strip that contain the first or the last location of the
  // path.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void trim(const Surface_arrays& t, const Surface_location& begin, const Surface_location& end);
};

// A strip in the plane; the first location of the path is at the origin.
struct Unfolded_strip
{
  std::vector<Vec2> left, right; // #halfedges: the endpoints of the edges that are crossed
  Vec2 end;                      // the last location of the path
  // The vector from the corner opposite to the first edge to that edge's right end, and the vector
  // from the corner opposite to the last edge to that edge's left end.
  Vec2 first_leg, last_leg;

  // Unfolds a strip from a location in its first triangle to a location in its last one. Linear in
  // the number of triangles.
  CGAL_GEODESIC_PROCESSING_EXPORT
  void unfold(const Surface_arrays& t, const Strip& strip, const Surface_location& begin,
              const Surface_location& end);
};

// A vertex at which the shortest path in a strip bends.
struct Bend
{
  Index strip_index; // index of the strip's first halfedge that is incident to the vertex
  bool is_left;      // whether the vertex is on the left of the path
};

// The funnel algorithm (Lee and Preparata 1984).
class Funnel
{
public:
  // Returns the vertices, in order, at which the shortest path in an unfolded strip bends.
  // Vertices that touch the path up to round-off errors are included. By their angles, the caller
  // decides on which side of them the path is shorter. The result is valid until the next call.
  // Linear in the length of the strip.
  CGAL_GEODESIC_PROCESSING_EXPORT
  const std::vector<Bend>& find_bends(const Surface_arrays& t, const Strip& strip,
                                      const Unfolded_strip& unfolded);

private:
  struct Point
  {
    Vec2 position;
    Bend bend;
  };
  // One side of the funnel. Points before the apex are obsolete.
  struct Chain
  {
    std::vector<Point> points;
    std::size_t apex = 0;
  };

  void add(Chain& chain, Chain& opposite, double sign, const Vec2& point, double width, Bend bend);
  void advance_apex(Chain& chain, Chain& opposite, double sign, const Vec2& point,
                    double tolerance);

  Chain m_left, m_right;
  std::vector<Bend> m_bends;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_TRIANGLE_STRIP_H
