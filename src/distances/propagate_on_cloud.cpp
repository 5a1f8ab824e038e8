// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "distances/circular_front.h"
#include "distances/front_relaxation.h"

#include <CGAL/Geodesic_processing/internal/core/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

// The triangles of a cloud have no twins. Directions are stored in the tangent planes of the
// surfels and rotated into the plane of each triangle.

namespace {

// Applies to a vector perpendicular to the unit vector `from` the smallest rotation that takes
// `from` to the line of the unit vector `to`. This unfolds across a sharp edge, where a projection
// would turn the vector towards the edge.
Vec3 rotated_between(const Vec3& v, const Vec3& from, const Vec3& to)
{
  const double cosine = dot(from, to);
  const Vec3 axis = cosine < 0. ? -1. * to : to;
  return v - (dot(v, axis) / (1. + std::abs(cosine))) * (from + axis);
}

// The plane of the triangle (from, along, target): `from` is the origin and `along` is on the first
// axis.
struct Triangle_frame
{
  double base; // length of the edge from `from` to `along`
  Vec2 target;
  Vec3 axis_1, axis_2, normal;
  Vec2 source; // projection of the direction to the source, after unfolding

  bool is_degenerate() const { return !(base > 0. && target[1] > 0.); }
};

// Computes the frame of a triangle from the vectors of the edges to `along` and to `target`, the
// normal at `from` and the direction in space to the source. There are no branches, so that the
// processor computes several frames at the same time. This takes half of the time.
Triangle_frame triangle_frame(const Vec3& base_edge, const Vec3& to_target, const Vec3& normal,
                              const Vec3& source)
{
  Triangle_frame frame;
  frame.base = norm(base_edge);
  frame.axis_1 = (1. / frame.base) * base_edge;
  const double y_0 = dot(to_target, frame.axis_1);
  const Vec3 perpendicular = to_target - y_0 * frame.axis_1;
  const double y_1 = norm(perpendicular);
  frame.axis_2 = (1. / y_1) * perpendicular;
  frame.normal = cross(frame.axis_1, frame.axis_2);
  frame.target = {y_0, y_1};
  const Vec3 unfolded_source = rotated_between(source, normal, frame.normal);
  frame.source = {dot(unfolded_source, frame.axis_1), dot(unfolded_source, frame.axis_2)};
  return frame;
}

// Computes the circular front at `from` in the plane of a triangle. If `from` is tentative, the
// direction to the source is fitted to the distances of both ends of the edge. Returns false if
// there is no such front.
bool front_in_triangle(const Front_state& front, Index from, Index along,
                       const Triangle_frame& frame, Circular_front& circle)
{
  const Front_vertex& x = front.vertices[from];
  const Front_vertex& z = front.vertices[along];
  const bool is_same = front.have_same_source(from, along);
  const double difference = z.distance - x.distance;
  circle.curvature =
      (x.state | z.state) & straight_flag ? 0. : 1. / (x.distance - front.offset_at(from));
  if(x.state & tentative_flag)
    return is_same && fit_source_direction(frame.base, difference, circle);
  const double size = norm(frame.source);
  if(size == 0. || frame.source[1] > 0.)
    return false;
  circle.source = (1. / size) * frame.source;
  if(is_same)
    circle.curvature = fitted_curvature(circle.curvature, frame.base, difference, circle.source[0],
                                        x.distance - front.offset_at(from));
  return true;
}

// Relaxes `target` by the circular front that passes `from` and crosses the edge from `from` to
// `along`.
void update_on_cloud(Front_state& front, Index from, Index along, Index target,
                     const Triangle_frame& frame)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex& x = front.vertices[from];
  const Front_vertex& z = front.vertices[along];
  const bool is_tentative = (z.state & (tentative_flag | final_flag)) == tentative_flag;
  if(!(z.distance < infinity) || is_tentative)
    return;
  Circular_front circle;
  if(frame.is_degenerate() || !front_in_triangle(front, from, along, frame, circle))
    return;
  double gain;
  Vec2 backward;
  if(!cross_edge(circle, frame.base, frame.target, gain, backward))
    return;
  const double distance = x.distance + gain;
  // A predecessor is closer to the source than the target. Otherwise two vertices could be the
  // predecessors of each other.
  const bool is_from_closer = x.distance < distance;
  const bool is_along_closer = front.have_same_source(from, along) && z.distance < distance;
  if(!(distance < front.vertices[target].distance) || !(is_from_closer || is_along_closer))
    return;
  const double y_0 = frame.target[0];
  const bool is_along_predecessor =
      is_along_closer && (!is_from_closer || std::abs(y_0) >= std::abs(frame.base - y_0));
  const Vec3 direction = rotated_between(backward[0] * frame.axis_1 + backward[1] * frame.axis_2,
                                         frame.normal, t.normal[target]);
  relax(front, target,
        {distance, tangent_coordinates(front, target, direction),
         is_along_predecessor ? along : from, (x.state | z.state) & straight_flag, 0.},
        front.sources[from]);
}

// Relaxes a surfel with the length of the edge from `v`.
void relax_cloud_edge(Front_state& front, Index v, const Front_vertex& from, Index target,
                      double length)
{
  const Surface_arrays& t = *front.triangles;
  const double distance = from.distance + length;
  const Front_vertex& to = front.vertices[target];
  // The same distance replaces a tentative one only. Each edge of two triangles is relaxed twice.
  if(!(distance < to.distance || (distance == to.distance && to.state & tentative_flag)))
    return;
  const Vec3 backward = t.point[v] - t.point[target];
  // The length of an edge alone determines no direction: the target is tentative.
  const Index straight = from.state & straight_flag;
  Index flags = from.state & source_flag && !straight ? 0 : tentative_flag | straight;
  // A copy of the surfel has the same position.
  if(length == 0.)
    flags = from.state & arrival_flags;
  relax(front, target,
        {distance, tangent_coordinates(front, target, backward), v, flags,
         flags & tentative_flag ? length : 0.},
        front.sources[v]);
}

} // namespace

Vec2 tangent_coordinates(const Front_state& front, Index vertex, const Vec3& direction)
{
  const auto [axis_1, axis_2] = tangent_frame(front.triangles->normal[vertex]);
  const Vec2 result = {dot(direction, axis_1), dot(direction, axis_2)};
  const double size = norm(result);
  return size > 0. ? (1. / size) * result : Vec2{1., 0.};
}

void propagate_on_cloud(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex from = front.vertices[v];
  const auto [axis_1, axis_2] = tangent_frame(t.normal[v]);
  const Vec3 source = front.directions[v][0] * axis_1 + front.directions[v][1] * axis_2;
  // Edges of the proximity graph connect different components of triangles only. Inside a
  // component, these longer edges would arrive before the front through the triangles.
  const Proximity_graph& edges = *front.component_edges;
  if(!edges.begin.empty())
    for(Index i = edges.begin[v]; i < edges.begin[v + 1]; ++i)
      relax_cloud_edge(front, v, from, edges.target[i],
                       norm(t.point[v] - t.point[edges.target[i]]));
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    const Index corner = t.ring[i], previous_corner = previous_halfedge(corner);
    relax_cloud_edge(front, v, from, t.corner[next_halfedge(corner)], t.length[corner]);
    relax_cloud_edge(front, v, from, t.corner[previous_corner], t.length[previous_corner]);
  }
  if(from.state & source_flag)
    return;
  constexpr Index chunk_size = 8; // most surfels have at most 8 triangles
  std::array<std::array<Triangle_frame, 2>, chunk_size> frames;
  for(Index chunk = t.ring_begin[v]; chunk < t.ring_begin[v + 1]; chunk += chunk_size)
  {
    const Index size = std::min(chunk_size, t.ring_begin[v + 1] - chunk);
    for(Index i = 0; i < size; ++i)
    {
      const Index corner = t.ring[chunk + i];
      const Vec3 a = t.point[t.corner[next_halfedge(corner)]] - t.point[v],
                 b = t.point[t.corner[previous_halfedge(corner)]] - t.point[v];
      frames[i] = {triangle_frame(a, b, t.normal[v], source),
                   triangle_frame(b, a, t.normal[v], source)};
    }
    for(Index i = 0; i < size; ++i)
    {
      const Index corner = t.ring[chunk + i], a = t.corner[next_halfedge(corner)],
                  b = t.corner[previous_halfedge(corner)];
      update_on_cloud(front, v, a, b, frames[i][0]);
      update_on_cloud(front, v, b, a, frames[i][1]);
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal
