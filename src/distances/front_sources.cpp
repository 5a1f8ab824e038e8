// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "distances/front_relaxation.h"
#include "mesh/Intrinsic_triangulation.h"

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Relaxes a vertex that is on a source.
void initialize_vertex(Front_state& front, Index vertex, double distance, Index flags, Index source)
{
  relax(front, vertex, {distance, {1., 0.}, none, source_flag | flags, 0.}, source);
}

// Converts a unit vector in the layout of a triangle to the frame of the vertex at one of its
// corners (Front_state::directions).
Vec2 in_corner_frame(const Front_state& front, const Vec2& vector,
                     const std::array<Vec2, 3>& corners, Index corner)
{
  const Surface_arrays& t = *front.triangles;
  const Vec2 edge = corners[next_halfedge(corner) % 3] - corners[corner % 3];
  const double length = norm(edge);
  if(length == 0.)
    return {1., 0.};
  const Vec2 result = rotated_back(vector, (1. / length) * edge);
  if(!t.is_cloud())
    return result;
  const Vec3 origin = t.point[t.corner[corner]];
  const Vec3 axis_1 = unit(t.point[t.corner[next_halfedge(corner)]] - origin);
  const Vec3 third = t.point[t.corner[previous_halfedge(corner)]] - origin;
  const Vec3 axis_2 = unit(third - dot(third, axis_1) * axis_1);
  return tangent_coordinates(front, t.corner[corner], result[0] * axis_1 + result[1] * axis_2);
}

// Stores the piece of a source between two locations in a triangle, and relaxes the corners of the
// triangle with their distances to it. Does nothing if one location is not in the triangle.
void initialize_triangle(Front_state& front, Index triangle, const Surface_location& begin,
                         const Surface_location& end, double offset, Index source)
{
  const Surface_arrays& t = *front.triangles;
  const auto p = barycentric_in(t, triangle, begin), q = barycentric_in(t, triangle, end);
  if(!p || !q)
    return;
  const Surface_location local_begin = {triangle, none, *p}, local_end = {triangle, none, *q};
  const double slowness = front.slowness_in(triangle);
  const auto corners = unfolded(t, triangle);
  // The front of a segment is straight. Beyond its ends the fitted curvature makes it circular.
  const Vec2 at_begin = unfolded_point(corners, *p), at_end = unfolded_point(corners, *q);
  const Index straight = norm(at_end - at_begin) > 0. ? straight_flag : 0;
  // A source at a corner is represented by the distance of that vertex.
  if(straight || corner_of(local_begin) == none)
    front.source_pieces.push_back({triangle, {{local_begin, local_end}, offset, source}});
  for(Index k = 0; k < 3; ++k)
  {
    const Index corner = 3 * triangle + k, vertex = t.corner[corner];
    bool is_inside = false;
    const Vec2 nearest = closest_point_on_segment(corners[k], at_begin, at_end, is_inside);
    const Vec2 to_nearest = nearest - corners[k];
    const double length = norm(to_nearest);
    if(length == 0.)
      initialize_vertex(front, vertex, offset, straight, source);
    else if(slowness < infinity)
    {
      const bool stores_corner = front.has_directions() && !t.is_cloud();
      const Index nearest_vertex =
          is_inside ? none : vertex_of(t, nearest == at_begin ? local_begin : local_end);
      relax(front, vertex,
            {offset + slowness * length,
             in_corner_frame(front, (1. / length) * to_nearest, corners, corner),
             stores_corner ? corner : nearest_vertex, straight, 0.},
            source);
    }
  }
}

// Initializes the triangles that contain a segment between two locations in a common triangle.
void initialize_segment(Front_state& front, const Surface_location& begin,
                        const Surface_location& end, double offset, Index source)
{
  for(const Index triangle : triangles_at(*front.triangles, begin))
    initialize_triangle(front, triangle, begin, end, offset, source);
}

// Initializes a source, whose locations refer to the surface.
void initialize_source(Front_state& front, const Front_source& source, Index i)
{
  const std::vector<Surface_location>& polyline = source.polyline;
  const Intrinsic_triangulation* const intrinsic =
      front.triangles == front.surface ? nullptr : front.intrinsic_triangulation.get();
  if(polyline.size() == 1)
  {
    const Surface_location location = intrinsic ? intrinsic->locate(polyline[0]) : polyline[0];
    initialize_segment(front, location, location, source.offset, i);
    if(const Index vertex = vertex_of(*front.triangles, location); vertex != none)
      initialize_vertex(front, vertex, source.offset, 0, i);
  }
  for(std::size_t k = 1; k < polyline.size(); ++k)
  {
    const Surface_location &begin = polyline[k - 1], &end = polyline[k];
    if(!intrinsic)
      initialize_segment(front, begin, end, source.offset, i);
    else if(const Index triangle = common_triangle(*front.surface, begin, end); triangle != none)
      for(const auto& [from, to] :
          intrinsic->locate_segment(triangle, *barycentric_in(*front.surface, triangle, begin),
                                    *barycentric_in(*front.surface, triangle, end)))
        initialize_segment(front, from, to, source.offset, i);
  }
}

} // namespace

void initialize(Front_state& front, const std::vector<Front_source>& sources)
{
  const Surface_arrays& surface = *front.surface;
  front.source_pieces.clear();
  front.has_single_source = sources.size() == 1;
  front.point_source.reset();
  if(front.has_directions() && front.has_single_source && sources[0].polyline.size() == 1 &&
     !surface.point.empty())
    front.point_source = scaled_coordinates(surface, sources[0].polyline[0]);
  front.offsets.clear();
  for(const Front_source& source : sources)
    front.offsets.push_back(source.offset);
  front.min_offset = infinity;
  for(const Front_source& source : sources)
    front.min_offset = std::min(front.min_offset, source.offset);
  for(Index i = 0; i < sources.size(); ++i)
    initialize_source(front, sources[i], i);
  std::sort(front.source_pieces.begin(), front.source_pieces.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
}

} // namespace CGAL::Geodesic_processing::internal
