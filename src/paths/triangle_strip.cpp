// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/triangle_strip.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <array>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns whether the edge of a halfedge contains a location.
//
// vertex             the vertex at which the location lies, or `none`
// location_halfedge  the halfedge inside which it lies, or `none`
bool is_incident(const Surface_arrays& t, Index h, Index vertex, Index location_halfedge)
{
  if(vertex != none)
    return t.corner[h] == vertex || t.corner[next_halfedge(h)] == vertex;
  return location_halfedge != none && (h == location_halfedge || t.twin[h] == location_halfedge);
}

// Returns the direction of an edge. An edge of length zero is treated as the limit of short ones.
//
// across   the edge, from its left to its right endpoint
// forward  the vector to the edge from the opposite corner
Vec2 edge_direction(const Vec2& across, const Vec2& forward)
{
  const double length = norm(across), forward_length = norm(forward);
  if(length > 0.)
    return (1. / length) * across;
  if(forward_length > 0.)
    return (-1. / forward_length) * rotated_left(forward);
  return {1., 0.};
}

} // namespace

void Strip::trim(const Surface_arrays& t, const Surface_location& begin,
                 const Surface_location& end)
{
  {
    const Index vertex = vertex_of(t, begin), h = halfedge_of(begin);
    std::size_t count = 0;
    while(count < halfedges.size() && is_incident(t, halfedges[count], vertex, h))
      ++count;
    if(count > 0)
    {
      triangle = t.twin[halfedges[count - 1]] / 3;
      halfedges.erase(halfedges.begin(), halfedges.begin() + count);
    }
  }
  const Index vertex = vertex_of(t, end), h = halfedge_of(end);
  while(!halfedges.empty() && is_incident(t, halfedges.back(), vertex, h))
    halfedges.pop_back();
}

void Unfolded_strip::unfold(const Surface_arrays& t, const Strip& strip,
                            const Surface_location& begin, const Surface_location& end_location)
{
  const std::size_t count = strip.halfedges.size();
  left.resize(count);
  right.resize(count);

  auto corners = unfolded(t, strip.triangle);
  const Vec2 origin = unfolded_point(corners, *barycentric_in(t, strip.triangle, begin));
  for(Vec2& corner : corners)
    corner = corner - origin;
  if(count == 0)
  {
    end = unfolded_point(corners, *barycentric_in(t, strip.triangle, end_location));
    return;
  }

  const Index h = strip.halfedges.front();
  // The left and the right end of the edge that is crossed
  std::array<Vec2, 2> ends = {corners[next_halfedge(h) % 3], corners[h % 3]};
  first_leg = ends[1] - corners[previous_halfedge(h) % 3];
  // The direction across, from left to right, is rotated from triangle to triangle by the angle at
  // the shared end: differences of positions far from the origin would lose the digits of small
  // triangles. Square roots and divisions depend on lengths only, and therefore do not wait for the
  // previous triangle.
  Vec2 direction = edge_direction(ends[1] - ends[0], first_leg);
  for(std::size_t i = 0;; ++i)
  {
    left[i] = ends[0];
    right[i] = ends[1];
    const Index entered = t.twin[strip.halfedges[i]];
    if(i + 1 == count)
    {
      const auto barycentric = *barycentric_in(t, entered / 3, end_location);
      const Vec2 across = t.length[entered] * direction;
      const Vec2 from_left =
          t.length[previous_halfedge(entered)] * rotated(direction, cosine_and_sine(t, entered));
      end = ends[0] + barycentric[next_halfedge(entered) % 3] * across +
            barycentric[previous_halfedge(entered) % 3] * from_left;
      last_leg = -1. * from_left;
      return;
    }
    // No branch, because its outcome is unpredictable.
    const Index next = strip.halfedges[i + 1];
    const bool right_is_shared = next == next_halfedge(entered);
    const double sign = right_is_shared ? -1. : 1.;
    Vec2 turn = cosine_and_sine(t, right_is_shared ? next : entered);
    turn[1] *= sign;
    direction = rotated(direction, turn);
    // One step of Newton's method for a unit vector, so that round-off errors of the length do not
    // accumulate.
    direction = (1.5 - 0.5 * dot(direction, direction)) * direction;
    ends[right_is_shared ? 0 : 1] =
        ends[right_is_shared ? 1 : 0] + (sign * t.length[next]) * direction;
  }
}

// Appends a point to the chain `chain`; `sign` is 1 if this is the right chain, and -1 otherwise.
void Funnel::add(Chain& chain, Chain& opposite, double sign, const Vec2& point, double width,
                 Bend bend)
{
  // A hundred times the round-off error of the farthest position. Points closer to each other than
  // this are treated as one.
  const double tolerance = 2e-14 * (norm(point) + width);
  while(chain.points.size() > chain.apex + 1)
  {
    const Vec2& last = chain.points.back().position;
    std::size_t before = chain.points.size() - 2;
    while(before > chain.apex && norm(last - chain.points[before].position) <= tolerance)
      --before;
    const Vec2 leg = last - chain.points[before].position, step = point - last;
    const double turn = sign * cross(leg, step);
    const bool is_ahead = turn < -tolerance * norm(leg) || dot(leg, step) >= 0.;
    if(norm(leg) > tolerance && turn <= tolerance * norm(leg + step) && is_ahead)
      break;
    chain.points.pop_back();
  }
  if(chain.points.size() == chain.apex + 1)
    advance_apex(chain, opposite, sign, point, tolerance);
  chain.points.push_back({point, bend});
}

// Moves the apex along the chain `opposite` to the last point that blocks the view of a point, and
// records the points passed as bends.
void Funnel::advance_apex(Chain& chain, Chain& opposite, double sign, const Vec2& point,
                          double tolerance)
{
  const std::size_t apex = opposite.apex;
  while(opposite.apex + 1 < opposite.points.size())
  {
    // A point at the same position as the apex is a bend too, so that both are rerouted together.
    const Vec2 leg =
        opposite.points[opposite.apex + 1].position - opposite.points[opposite.apex].position;
    const Vec2 chord = point - opposite.points[opposite.apex].position;
    const double turn = sign * cross(leg, chord), margin = tolerance * norm(chord);
    if(turn < -margin || norm(chord) <= tolerance || (turn <= margin && dot(leg, chord - leg) < 0.))
      break;
    ++opposite.apex;
    m_bends.push_back(opposite.points[opposite.apex].bend);
  }
  if(opposite.apex != apex)
  {
    chain.points.assign(1, opposite.points[opposite.apex]);
    chain.apex = 0;
  }
}

const std::vector<Bend>& Funnel::find_bends(const Surface_arrays& t, const Strip& strip,
                                            const Unfolded_strip& u)
{
  m_bends.clear();
  // Both chains start at the apex.
  m_left.points.assign(1, {Vec2{0., 0.}, {0, true}});
  m_right.points.assign(1, {Vec2{0., 0.}, {0, false}});
  m_left.apex = m_right.apex = 0;
  const std::size_t count = strip.halfedges.size();
  for(std::size_t i = 0; i < count; ++i)
  {
    const Index strip_index = static_cast<Index>(i);
    const bool left_is_shared =
        i > 0 && strip.halfedges[i] == previous_halfedge(t.twin[strip.halfedges[i - 1]]);
    const bool right_is_shared = i > 0 && !left_is_shared;
    const double width = t.length[strip.halfedges[i]];
    if(!right_is_shared)
      add(m_right, m_left, 1., u.right[i], width, {strip_index, false});
    if(!left_is_shared)
      add(m_left, m_right, -1., u.left[i], width, {strip_index, true});
  }
  add(m_right, m_left, 1., u.end, 0., {static_cast<Index>(count), false});
  for(std::size_t i = m_right.apex + 1; i + 1 < m_right.points.size(); ++i)
    m_bends.push_back(m_right.points[i].bend);
  return m_bends;
}

} // namespace CGAL::Geodesic_processing::internal
