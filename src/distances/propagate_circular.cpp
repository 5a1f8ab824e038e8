// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/front_updates.h"

#include "core/unfold.h"
#include "distances/circular_front.h"
#include "distances/front_relaxation.h"

#include <algorithm>
#include <cmath>

namespace CGAL::Geodesic_processing::internal {

namespace {

// If the distance of an adjacent final vertex z is smaller than that of the circle of this vertex,
// by more than this fraction of their edge, the front of z enters their triangle a second time. On
// one face of a cube projected to a sphere, the errors were up to 2.8 % (mean 0.04 %) without this;
// 0.20 % (0.007 %) with 1e-3; 0.44 % (0.013 %) with 1e-2; and 0.20 % (0.0066 %) with 0.
constexpr double reentry_ratio = 1e-3;
// An edge is in the shadow of its vertex if its angle to the source exceeds pi by more than this
// sine. The front arrives behind it along another path.
constexpr double shadow_tolerance = -1e-12;

void update_from(Front_state& front, Index corner, bool is_mirrored);

// Returns whether the front arrived at a vertex from a vertex that became final after `neighbor`.
bool was_reached_after(const Front_state& front, Index vertex, Index neighbor)
{
  const Surface_arrays& t = *front.triangles;
  const Index corner = front.vertices[vertex].corner;
  const auto is_later = [&](Index other)
  { return front.vertices[t.corner[other]].distance > front.vertices[neighbor].distance; };
  return is_later(next_halfedge(corner)) || is_later(previous_halfedge(corner));
}

// Returns the largest gain from x that improves the distance of the target.
double max_useful_gain(const Front_state& front, const Front_vertex& x, const Front_vertex& target)
{
  double max_gain = target.distance - x.distance;
  if(!(target.state & tentative_flag) && target.distance < infinity)
    max_gain -= (target.state & final_flag ? correction_tolerance : relaxation_tolerance) *
                (target.distance - front.min_offset);
  return max_gain;
}

// Rotates a direction at the far vertex y into the frame of the corner at y. The first axis of the
// given coordinates is the crossed edge, from (0, 0) to (base, 0). Returns false if that triangle
// has an edge of length 0.
bool to_target_frame(const Vec2& backward, bool is_mirrored, double base, const Vec2& y,
                     const Vec2& opening, Vec2& direction)
{
  if(!is_mirrored)
  {
    direction = rotated_back(backward, {-opening[0], -opening[1]});
    return true;
  }
  const Vec2 edge = Vec2{base, 0.} - y;
  const double size = norm(edge);
  if(size == 0.)
    return false;
  direction = rotated_back(backward, (1. / size) * edge);
  direction[1] = -direction[1];
  return true;
}

// Relaxes the far vertex of the triangle after a fan edge by the circular front that crosses an
// edge at `v`. This is the right edge or, if mirrored, the left edge, as seen from `v`. `angle`
// is the unit vector of the angle between the source and that edge.
void update_circular(Front_state& front, Index v, const Fan_position& position, bool is_mirrored,
                     const Vec2& angle, double min_curvature)
{
  const Vertex_fans::Fan_edge* const right = &front.fans->edges[position.edge];
  const Vec2& opening = right->opening;
  const Vertex_fans::Fan_edge &near = right[is_mirrored ? 1 : 0], &far = right[is_mirrored ? 0 : 1];
  const Front_vertex& x = front.vertices[v];
  const Front_vertex& z = front.vertices[near.vertex];
  // A tentative distance is an overestimate that would yield a far too large curvature.
  const bool is_tentative = (z.state & (tentative_flag | final_flag)) == tentative_flag;
  if(!(z.distance < infinity) || is_tentative)
    return;
  const double base = near.length;
  const Vec2 y = far.length * opening;
  // The curvature of a front on a polyhedron is at least that of a front from a point at this
  // distance. Therefore the gain is at least |y - r u| - r with r = 1 / min_curvature.
  const Index flags = (x.state | z.state) & straight_flag;
  double curvature = flags ? 0. : min_curvature;
  const Vec2 source = {angle[0], -angle[1]};
  const double max_gain = max_useful_gain(front, x, front.vertices[far.vertex]);
  if(curvature * (far.length - max_gain) * (far.length + max_gain) >=
     2. * (max_gain + dot(y, source)))
    return;
  // The distances of two sources are never combined.
  bool has_closer_neighbor = false;
  if(front.have_same_source(v, near.vertex))
  {
    const double difference = z.distance - x.distance;
    has_closer_neighbor =
        circle_residual(curvature, base, difference, angle[0]) < -reentry_ratio * base &&
        (z.state & (final_flag | source_flag | tentative_flag)) == final_flag;
    curvature =
        fitted_curvature(curvature, base, difference, angle[0], x.distance - front.offset_at(v));
  }
  double gain;
  Vec2 backward;
  if(!cross_edge({source, curvature}, base, y, gain, backward))
    return;
  const double distance = x.distance + gain;
  if(!(distance < front.vertices[far.vertex].distance))
    return;
  Vec2 direction;
  if(!to_target_frame(backward, is_mirrored, base, y, opening, direction))
    return;
  const Index corner = front.triangles->ring[position.ring];
  const Index arrival_corner = is_mirrored ? next_halfedge(corner) : previous_halfedge(corner);
  const bool is_accepted =
      relax(front, far.vertex, {distance, direction, arrival_corner, flags, 0.}, front.sources[v]);
  // The near vertex was reached before, around the opposite side of a vertex of positive curvature.
  // The recursion ends because each call decreases a distance.
  if(is_accepted && has_closer_neighbor && was_reached_after(front, v, near.vertex))
    update_from(front, is_mirrored ? previous_halfedge(corner) : next_halfedge(corner),
                !is_mirrored);
}

// Relaxes through the triangle of a corner, from the vertex of that corner.
void update_from(Front_state& front, Index corner, bool is_mirrored)
{
  const Surface_arrays& t = *front.triangles;
  const Index vertex = t.corner[corner];
  Vec2 source;
  if(!source_direction(front, corner, is_mirrored, source))
    return;
  const Fan_position position = fan_position(t, *front.fans, vertex, corner);
  update_circular(front, vertex, position, is_mirrored, {source[0], -source[1]},
                  1. / (front.vertices[vertex].distance - front.offset_at(vertex)));
}

// Relaxes from a tentative vertex: by the circle, or straight line, through its distance and that
// of an adjacent vertex (Reimers 2004).
void propagate_without_direction(Front_state& front, Index v)
{
  const Vertex_fans& s = *front.fans;
  const Front_vertex from = front.vertices[v];
  relax_all_edges(front, v, tentative_flag | (from.state & straight_flag));
  const double curvature = 1. / (from.distance - front.offset_at(v));
  Fan_position position = {s.begin[v].edge, s.begin[v].ring};
  for(; position.edge < s.begin[v + 1].edge; ++position.edge)
  {
    const Vertex_fans::Fan_edge& right = s.edges[position.edge];
    if(!(right.flags & Vertex_fans::Fan_edge::has_triangle))
      continue;
    const Vertex_fans::Fan_edge& left = (&right)[1];
    for(const bool is_mirrored : {false, true})
    {
      const Vertex_fans::Fan_edge& near = is_mirrored ? left : right;
      Circular_front circle{
          {1., 0.},
          (from.state | front.vertices[near.vertex].state) & straight_flag ? 0. : curvature};
      if(front.sources[near.vertex] == front.sources[v] &&
         fit_source_direction(near.length, front.vertices[near.vertex].distance - from.distance,
                              circle))
        update_circular(front, v, position, is_mirrored, {circle.source[0], -circle.source[1]},
                        curvature);
    }
    ++position.ring;
  }
}

// The fan of a vertex that contains a triangle; a triangle is identified by the fan edge before it.
struct Fan
{
  Index begin, end; // its triangles are begin .. end - 1
  bool is_closed;   // no boundary
  bool is_only_fan; // of its vertex
};

Fan fan_of(const Vertex_fans& s, Index v, Index triangle)
{
  Index begin = triangle, end = triangle + 1;
  while(begin > s.begin[v].edge && (s.edges[begin - 1].flags & Vertex_fans::Fan_edge::has_triangle))
    --begin;
  while(s.edges[end].flags & Vertex_fans::Fan_edge::has_triangle)
    ++end;
  const bool is_closed = (s.edges[end].flags & Vertex_fans::Fan_edge::is_repeated) != 0;
  const bool is_only_fan = end - begin == s.begin[v + 1].ring - s.begin[v].ring;
  return {begin, end, is_closed, is_only_fan};
}

// Relaxes through the triangles around a vertex, in both directions from the triangle through which
// the front arrived. Stops at an edge whose angle to the source exceeds pi. Returns whether this
// covered all triangles of the vertex.
bool propagate_around(Front_state& front, Index v)
{
  const Vertex_fans& s = *front.fans;
  const Front_vertex& from = front.vertices[v];
  const Index straight = from.state & straight_flag;
  const Vec2 direction = front.directions[v];
  const double min_curvature = 1. / (from.distance - front.offset_at(v));
  const Fan_position entry = fan_position(*front.triangles, s, v, from.corner);
  const auto [begin, end, is_closed, is_only_fan] = fan_of(s, v, entry.edge);
  const auto position_of = [&](Index edge) {
    return Fan_position{edge, entry.ring + edge - entry.edge};
  };
  const auto opening = [&](Index triangle) -> const Vec2& { return s.edges[triangle].opening; };
  // If no triangle reaches the end of an edge, that end gets the length of the edge and no
  // direction.
  const Index tentative_flags = tentative_flag | straight;
  relax_along_edge(front, v, position_of(entry.edge), tentative_flags);
  relax_along_edge(front, v, position_of(entry.edge + 1), tentative_flags);

  // Counterclockwise; `angle` is the angle between the source and the edge to be crossed.
  Index number_of_triangles = 1, left = entry.edge;
  Vec2 angle = rotated_back(opening(left), direction);
  angle[1] = std::max(angle[1], 0.);
  for(;;)
  {
    if(++left == end)
    {
      if(!is_closed)
        break;
      left = begin;
    }
    if(left == entry.edge)
      return is_only_fan;
    const Vec2 next_angle = rotated(angle, opening(left));
    if(next_angle[1] >= shadow_tolerance)
      update_circular(front, v, position_of(left), false, angle, min_curvature);
    ++number_of_triangles;
    angle = next_angle;
    if(angle[1] < 0.)
      break;
    relax_along_edge(front, v, position_of(left + 1), tentative_flags);
  }

  // Clockwise, until it meets the triangle at which the counterclockwise pass ended.
  angle = {direction[0], std::max(direction[1], 0.)};
  for(Index right = entry.edge;;)
  {
    if(right == begin)
    {
      if(!is_closed)
        break;
      right = end;
    }
    --right;
    const Vec2 next_angle = rotated(angle, opening(right));
    if(next_angle[1] >= shadow_tolerance)
      update_circular(front, v, position_of(right), true, angle, min_curvature);
    angle = next_angle;
    if(angle[1] >= 0.)
      relax_along_edge(front, v, position_of(right), tentative_flags);
    if(right == left)
      return is_only_fan && number_of_triangles == end - begin;
    ++number_of_triangles;
    if(angle[1] < 0.)
      break;
  }

  return false;
}

} // namespace

void propagate_circular(Front_state& front, Index v)
{
  const Index state = front.vertices[v].state;
  if(state & source_flag)
    return relax_all_edges(front, v, state & straight_flag);
  if(state & tentative_flag)
    return propagate_without_direction(front, v);
  // A saddle or boundary vertex is a pseudo-source for its shadow, a non-manifold vertex for its
  // other fans.
  if(!propagate_around(front, v))
    relax_all_edges(front, v, state & straight_flag);
}

bool source_direction(const Front_state& front, Index corner, bool is_mirrored, Vec2& source)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex& vertex = front.vertices[t.corner[corner]];
  const Vec2 direction = front.directions[t.corner[corner]];
  if(t.is_cloud() || vertex.corner == none || vertex.corner == corner)
    return false;
  Vec2 angle = is_mirrored ? direction : rotated_back(corner_angle(t, vertex.corner), direction);
  angle[1] = std::max(angle[1], 0.);
  for(Index rotated_corner = is_mirrored ? next_corner_cw(t, vertex.corner)
                                         : next_corner_ccw(t, vertex.corner);
      rotated_corner != none && rotated_corner != vertex.corner;
      rotated_corner = is_mirrored ? next_corner_cw(t, rotated_corner)
                                   : next_corner_ccw(t, rotated_corner))
  {
    if(rotated_corner == corner)
    {
      source = {angle[0], -angle[1]};
      return true;
    }
    angle = rotated(angle, corner_angle(t, rotated_corner));
    if(angle[1] < 0.)
      break;
  }
  return false;
}

} // namespace CGAL::Geodesic_processing::internal
