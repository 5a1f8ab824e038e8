// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_propagator.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include "core/unfold.h"

#include <algorithm>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

// The straight line behind a vertex that has the angle pi to the source, to the left or to the right.
struct Continued_line
{
  Index corner = none;       // that the line leaves through, if the fan does not end before
  Index number_of_turns = 0; // from the corner of the source
  // The sine of the angle from the edge of the corner that is closer to the source to the line, and
  // the angle from there to the other edge.
  double sine_from_near_edge = 0.;
  Vec2 to_far_edge = {1., 0.};

  // Returns the fraction at which the line crosses the opposite edge, from the left end.
  double crossing(const Surface_arrays& t, bool is_left) const
  {
    const double sine_to_left = is_left ? to_far_edge[1] : sine_from_near_edge,
                 sine_to_right = is_left ? sine_from_near_edge : to_far_edge[1];
    const double right_weight = t.length[corner] * sine_to_right,
                 left_weight = t.length[previous_halfedge(corner)] * sine_to_left;
    return right_weight + left_weight > 0. ? left_weight / (right_weight + left_weight) : 0.5;
  }
};

namespace {

// A path that bends by this angle counts as straight: its length changes by a fraction of 1e-17
// only.
constexpr double straight_angle_tolerance = 1e-8;

// An angle as a number of half turns and a direction in the upper half-plane.
struct Long_angle
{
  int half_turns = 0;
  Vec2 direction = {1., 0.};

  // Adds an angle between 0 and pi.
  void add(const Vec2& cosine_and_sine)
  {
    Vec2 sum = rotated(direction, cosine_and_sine);
    if(sum[1] < 0.)
    {
      // A sum above pi is in the left half-plane, or was there before. Others are round-off errors.
      const bool is_half_turn = std::min(direction[0], sum[0]) < 0.;
      half_turns += is_half_turn;
      sum = is_half_turn ? -1. * sum : Vec2{sum[0], 0.};
    }
    direction = sum;
  }
};

// Returns whether an angle between 0 and pi is not zero.
bool is_wide(const Vec2& cosine_and_sine)
{
  return cosine_and_sine[0] < 0. || cosine_and_sine[1] > straight_angle_tolerance;
}

// Returns whether a shortest path may bend at a vertex; see find_pseudo_sources().
bool may_paths_bend(const Surface_arrays& t, Index vertex)
{
  const Index begin = t.ring_begin[vertex], end = t.ring_begin[vertex + 1];
  Long_angle total;
  for(Index i = begin; i < end; ++i)
  {
    // The corners of a closed fan follow each other.
    if(next_corner_ccw(t, t.ring[i]) != t.ring[i + 1 < end ? i + 1 : begin])
      return true;
    total.add(cosine_and_sine(t, t.ring[i]));
  }
  return total.half_turns > 2 || (total.half_turns == 2 && is_wide(total.direction));
}

// Returns the next corner of a vertex to the left (counterclockwise) or to the right.
Index next_corner(const Surface_arrays& t, Index corner, bool is_left)
{
  return is_left ? next_corner_ccw(t, corner) : next_corner_cw(t, corner);
}

// Returns the number of corners of a fan from one of them to the end, and whether the fan is closed.
std::pair<Index, bool> corners_until_end(const Surface_arrays& t, Index first, bool is_left)
{
  Index number = 1, corner = next_corner(t, first, is_left);
  for(; corner != none && corner != first; corner = next_corner(t, corner, is_left))
    ++number;
  return {number, corner == first};
}

Continued_line continue_line(const Surface_arrays& t, const Window_arrival& arrival, bool is_left)
{
  Vec2 angle = {arrival.direction[0], std::max(arrival.direction[1], 0.)}; // to the right edge
  if(is_left)
    angle = rotated_back(cosine_and_sine(t, arrival.corner), angle);
  Long_angle from_source = {0, {angle[0], std::max(angle[1], 0.)}};
  Continued_line result;
  for(Index corner = next_corner(t, arrival.corner, is_left);
      corner != none && corner != arrival.corner; corner = next_corner(t, corner, is_left))
  {
    ++result.number_of_turns;
    result.sine_from_near_edge = from_source.direction[1];
    from_source.add(cosine_and_sine(t, corner));
    if(from_source.half_turns > 0)
    {
      result.corner = corner;
      result.to_far_edge = from_source.direction;
      break;
    }
  }
  return result;
}

// Returns whether two corners of a vertex are in the same fan.
bool are_in_same_fan(const Surface_arrays& t, Index entry_corner, Index other)
{
  Index corner = entry_corner;
  do
  {
    if(corner == other)
      return true;
    corner = next_corner_ccw(t, corner);
  } while(corner != none && corner != entry_corner);
  for(corner = next_corner_cw(t, entry_corner); corner != none && corner != entry_corner;
      corner = next_corner_cw(t, corner))
    if(corner == other)
      return true;
  return false;
}

} // namespace

std::shared_ptr<const std::vector<bool>> find_pseudo_sources(const Surface_arrays& t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error("The exact method requires a mesh, not a point cloud.");
  auto result = std::make_shared<std::vector<bool>>(t.number_of_vertices());
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    (*result)[vertex] = may_paths_bend(t, vertex);
  return result;
}

// Emits windows from a vertex at which a shortest path may bend, into all directions whose angle to
// the source is at least pi to the left and to the right.
void Window_propagator::create_pseudosource_windows(Index v)
{
  const Surface_arrays& t = *m_state.triangles;
  const Window_arrival& arrival = m_state.vertices[v];
  const auto [corners_to_left, is_closed] = corners_until_end(t, arrival.corner, true);
  const Index fan_size =
      is_closed ? corners_to_left
                : corners_to_left + corners_until_end(t, arrival.corner, false).first - 1;
  const Continued_line left = continue_line(t, arrival, true),
                       right = continue_line(t, arrival, false);
  if(!is_closed)
  {
    emit_windows_behind(left, true, none);
    emit_windows_behind(right, false, none);
  }
  else if(left.corner != none && right.corner != none)
  {
    // The directions are between both lines.
    if(left.corner == right.corner)
      emit_window(left.corner, right.crossing(t, false), left.crossing(t, true));
    else if(left.number_of_turns + right.number_of_turns < fan_size)
    {
      emit_windows_behind(left, true, right.corner);
      emit_windows_behind(right, false, next_corner_cw(t, right.corner));
    }
  }
  if(fan_size < t.ring_begin[v + 1] - t.ring_begin[v])
    emit_windows_of_other_fans(v);
}

// Emits windows from the vertex of a continued line to its left or to its right, up to a corner.
void Window_propagator::emit_windows_behind(const Continued_line& line, bool is_left, Index end)
{
  const Surface_arrays& t = *m_state.triangles;
  if(line.corner == none)
    return;
  const double crossing = line.crossing(t, is_left);
  if(is_wide(line.to_far_edge))
    emit_window(line.corner, is_left ? 0. : crossing, is_left ? crossing : 1.);
  for(Index corner = next_corner(t, line.corner, is_left); corner != end && corner != none;
      corner = next_corner(t, corner, is_left))
    emit_window(corner);
}

// Emits windows into the fans of a non-manifold vertex through which the path did not arrive.
void Window_propagator::emit_windows_of_other_fans(Index v)
{
  const Surface_arrays& t = *m_state.triangles;
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    if(!are_in_same_fan(t, m_state.vertices[v].corner, t.ring[i]))
      emit_window(t.ring[i]);
}

// Enqueues a window on the whole edge opposite to a corner.
void Window_propagator::emit_window(Index corner)
{
  if(is_wide(cosine_and_sine(*m_state.triangles, corner)))
    emit_window(corner, 0., 1.);
}

// Enqueues a window on a part of the edge opposite to a corner, between two fractions of its length
// from its left end.
void Window_propagator::emit_window(Index corner, double begin, double end)
{
  const Surface_arrays& t = *m_state.triangles;
  const Index h = next_halfedge(corner);
  const double length = t.length[h];
  if(t.twin[h] == none || !(length > 0.) || !(begin < end))
    return;
  const Vec2 apex_point =
      third_corner(length, t.length[previous_halfedge(corner)], t.length[corner]);
  enqueue(t.twin[h], {{apex_point[0], -apex_point[1]},
                      m_state.vertices[t.corner[corner]].distance,
                      length * begin,
                      length * end,
                      t.corner[corner],
                      m_state.error(t.corner[corner])});
}

} // namespace CGAL::Geodesic_processing::internal
