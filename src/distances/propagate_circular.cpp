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

// The two edges of a triangle at one of its corners.
struct Corner_edges
{
  Index near_vertex, far_vertex;
  double near_length, far_length;
};

// Returns the right edge at a corner as the near one and the left edge as the far one, as seen from
// the vertex of the corner; if mirrored, the other way round.
Corner_edges edges_at(const Surface_arrays& t, Index corner, bool is_mirrored)
{
  const Index next = next_halfedge(corner), previous = previous_halfedge(corner);
  if(is_mirrored)
    return {t.corner[previous], t.corner[next], t.length[previous], t.length[corner]};
  return {t.corner[next], t.corner[previous], t.length[corner], t.length[previous]};
}

// Relaxes the far vertex of a triangle by the circular front that crosses the near edge of its
// corner at `v`; see edges_at(). `opening` is the angle of the corner, and `angle` that between the
// source and the near edge, both as unit vectors.
void update_circular(Front_state& front, Index v, Index corner, bool is_mirrored,
                     const Vec2& opening, const Vec2& angle, double min_curvature)
{
  const Corner_edges edges = edges_at(*front.triangles, corner, is_mirrored);
  const Front_vertex& x = front.vertices[v];
  const Front_vertex& z = front.vertices[edges.near_vertex];
  // A tentative distance is an overestimate that would yield a far too large curvature.
  const bool is_tentative = (z.state & (tentative_flag | final_flag)) == tentative_flag;
  if(!(z.distance < infinity) || is_tentative)
    return;
  const double base = edges.near_length;
  const Vec2 y = edges.far_length * opening;
  // The curvature of a front on a polyhedron is at least that of a front from a point at this
  // distance. Therefore the gain is at least |y - r u| - r with r = 1 / min_curvature.
  const Index flags = (x.state | z.state) & straight_flag;
  double curvature = flags ? 0. : min_curvature;
  const Vec2 source = {angle[0], -angle[1]};
  const double max_gain = max_useful_gain(front, x, front.vertices[edges.far_vertex]);
  if(curvature * (edges.far_length - max_gain) * (edges.far_length + max_gain) >=
     2. * (max_gain + dot(y, source)))
    return;
  // The distances of two sources are never combined.
  bool has_closer_neighbor = false;
  if(front.have_same_source(v, edges.near_vertex))
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
  if(!(distance < front.vertices[edges.far_vertex].distance))
    return;
  Vec2 direction;
  if(!to_target_frame(backward, is_mirrored, base, y, opening, direction))
    return;
  const Index arrival_corner = is_mirrored ? next_halfedge(corner) : previous_halfedge(corner);
  const bool is_accepted = relax(
      front, edges.far_vertex, {distance, direction, arrival_corner, flags, 0.}, front.sources[v]);
  // The near vertex was reached before, around the opposite side of a vertex of positive curvature.
  // The recursion ends because each call decreases a distance.
  if(is_accepted && has_closer_neighbor && was_reached_after(front, v, edges.near_vertex))
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
  update_circular(front, vertex, corner, is_mirrored, corner_angle(front, corner),
                  {source[0], -source[1]},
                  1. / (front.vertices[vertex].distance - front.offset_at(vertex)));
}

// Relaxes from a tentative vertex: by the circle, or straight line, through its distance and that
// of an adjacent vertex (Reimers 2004).
void propagate_without_direction(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex from = front.vertices[v];
  relax_all_edges(front, v, tentative_flag | (from.state & straight_flag));
  const double curvature = 1. / (from.distance - front.offset_at(v));
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    const Index corner = t.ring[i];
    const Vec2 opening = corner_angle(front, corner);
    for(const bool is_mirrored : {false, true})
    {
      const Corner_edges edges = edges_at(t, corner, is_mirrored);
      const Front_vertex& near = front.vertices[edges.near_vertex];
      Circular_front circle{{1., 0.}, (from.state | near.state) & straight_flag ? 0. : curvature};
      if(front.sources[edges.near_vertex] == front.sources[v] &&
         fit_source_direction(edges.near_length, near.distance - from.distance, circle))
        update_circular(front, v, corner, is_mirrored, opening,
                        {circle.source[0], -circle.source[1]}, curvature);
    }
  }
}

// Relaxes through the triangles around a vertex, in both directions from the triangle through which
// the front arrived. Stops at an edge whose angle to the source exceeds pi. Returns whether this
// covered all triangles of the vertex.
bool propagate_around(Front_state& front, Index v)
{
  const Surface_arrays& t = *front.triangles;
  const Front_vertex& from = front.vertices[v];
  const Vec2 direction = front.directions[v];
  const double min_curvature = 1. / (from.distance - front.offset_at(v));
  const Index entry = from.corner, degree = t.ring_begin[v + 1] - t.ring_begin[v];
  // If no triangle reaches the end of an edge, that end gets the length of the edge and no
  // direction.
  const Index tentative_flags = tentative_flag | (from.state & straight_flag);
  relax_along_edge(front, entry, false, tentative_flags);
  relax_along_edge(front, entry, true, tentative_flags);

  // Counterclockwise; `angle` is the angle between the source and the edge to be crossed.
  Index number_of_triangles = 1, left = entry;
  Vec2 angle = rotated_back(corner_angle(front, entry), direction);
  angle[1] = std::max(angle[1], 0.);
  for(;;)
  {
    left = next_corner_ccw(t, left);
    if(left == none)
      break;
    if(left == entry)
      return number_of_triangles == degree;
    const Vec2 opening = corner_angle(front, left), next_angle = rotated(angle, opening);
    if(next_angle[1] >= shadow_tolerance)
      update_circular(front, v, left, false, opening, angle, min_curvature);
    ++number_of_triangles;
    angle = next_angle;
    if(angle[1] < 0.)
      break;
    relax_along_edge(front, left, true, tentative_flags);
  }
  // Clockwise, until it meets the triangle at which the counterclockwise pass ended.
  angle = {direction[0], std::max(direction[1], 0.)};
  for(Index right = entry;;)
  {
    right = next_corner_cw(t, right);
    if(right == none)
      break;
    const Vec2 opening = corner_angle(front, right), next_angle = rotated(angle, opening);
    if(next_angle[1] >= shadow_tolerance)
      update_circular(front, v, right, true, opening, angle, min_curvature);
    angle = next_angle;
    if(angle[1] >= 0.)
      relax_along_edge(front, right, false, tentative_flags);
    if(right == left)
      return number_of_triangles == degree;
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
  Vec2 angle =
      is_mirrored ? direction : rotated_back(corner_angle(front, vertex.corner), direction);
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
    angle = rotated(angle, corner_angle(front, rotated_corner));
    if(angle[1] < 0.)
      break;
  }
  return false;
}

} // namespace CGAL::Geodesic_processing::internal
