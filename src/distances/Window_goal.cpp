// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Window_goal.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"
#include "distances/directions.h"
#include "distances/Window_propagator.h"
#include "distances/window_operations.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Arrivals whose directions differ by less than this angle, in radians, are the same path.
constexpr double direction_tolerance = 1e-6;

} // namespace

Window_goal::Window_goal(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(std::move(triangles))
{}

void Window_goal::find_shortest(const Window_state& forward)
{
  m_mode = Mode::shortest;
  m_forward = &forward;
  m_meeting = Meeting{};
}

void Window_goal::find_all(const Window_state& forward, double max_length)
{
  m_mode = Mode::all;
  m_forward = &forward;
  m_meeting = Meeting{};
  m_meeting.distance = max_length;
  m_meetings.clear();
  m_arrivals.clear();
}

void Window_goal::find_between(const Window_state& initialized, const Surface_location& source,
                               double max_length)
{
  m_mode = Mode::between;
  m_forward = &initialized;
  m_source_point = scaled_coordinates(*m_triangles, source);
  m_meeting = Meeting{};
  m_meeting.distance = max_length;
}

void Window_goal::find_each(const std::vector<Source_piece>& pieces)
{
  m_mode = Mode::each;
  m_pieces = pieces;
  m_pieces_by_triangle.clear();
  for(Index i = 0; i < pieces.size(); ++i)
    m_pieces_by_triangle.emplace_back(pieces[i].triangle, i);
  std::sort(m_pieces_by_triangle.begin(), m_pieces_by_triangle.end());
  m_meetings.assign(pieces.size(), Meeting{});
}

const std::vector<Window_arrival>& Window_goal::arrivals(Index vertex) const
{
  static const std::vector<Window_arrival> no_arrivals;
  const auto found = m_arrivals.find(vertex);
  return found == m_arrivals.end() ? no_arrivals : found->second;
}

void Window_goal::keep_arrival(Index vertex, const Window_arrival& arrival)
{
  if(m_mode != Mode::all ||
     !(arrival.distance + m_forward->vertices[vertex].distance <= m_meeting.distance))
    return;
  const Surface_arrays& t = *m_triangles;
  std::vector<Window_arrival>& arrivals = m_arrivals[vertex];
  if(arrival.corner != none)
  {
    double total_angle = 0.;
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      total_angle += interior_angle(t, t.ring[i]);
    const double angle = polar_angle(t, arrival.corner, arrival.direction);
    for(const Window_arrival& other : arrivals)
    {
      const double angle_difference =
          other.corner == none ? total_angle / 2.
                               : std::abs(polar_angle(t, other.corner, other.direction) - angle);
      if(std::min(angle_difference, total_angle - angle_difference) < direction_tolerance)
        return;
    }
  }
  arrivals.push_back(arrival);
}

bool Window_goal::reach(Index vertex, double distance)
{
  if(m_mode == Mode::each)
    return true;
  if(!(distance + lower_bound(vertex) <= m_meeting.distance * (1. + round_off_tolerance)))
    return false;
  const double total_length = distance + m_forward->vertices[vertex].distance;
  if(m_mode != Mode::all && total_length < m_meeting.distance)
    m_meeting = {total_length, vertex, {}, {}, 0., none};
  return true;
}

double Window_goal::max_useful_distance(Index vertex) const
{
  return m_mode == Mode::each
             ? infinity
             : m_meeting.distance * (1. + round_off_tolerance) - lower_bound(vertex);
}

// Returns a lower bound of the distance from a vertex to the sources of the forward query.
double Window_goal::lower_bound(Index vertex) const
{
  if(m_mode == Mode::between)
    return m_triangles->point.empty() ? 0. : norm(m_triangles->point[vertex] - m_source_point);
  // A vertex that was not reached is farther than the maximum distance.
  return std::min(m_forward->vertices[vertex].distance, m_forward->max_distance);
}

void Window_goal::meet_sources(Index triangle, const Vec2& position, double distance, Index origin)
{
  const auto& pieces = pieces_by_triangle();
  for(auto i = std::lower_bound(pieces.begin(), pieces.end(), std::pair(triangle, Index(0)));
      i != pieces.end() && i->first == triangle; ++i)
  {
    const Source_piece& piece = this->pieces()[i->second];
    const auto corners = unfolded(*m_triangles, triangle);
    bool is_inside = false;
    meet(piece,
         closest_point_on_segment(position, unfolded_point(corners, piece.begin),
                                  unfolded_point(corners, piece.end), is_inside),
         position, distance, origin);
  }
}

void Window_goal::meet_sources_behind(Index h, const std::vector<Window>& windows)
{
  const Surface_arrays& t = *m_triangles;
  const auto& pieces = pieces_by_triangle();
  const Index triangle = h / 3;
  auto i = std::lower_bound(pieces.begin(), pieces.end(), std::pair(triangle, Index(0)));
  if(i == pieces.end() || i->first != triangle)
    return;
  const auto corners = unfolded(t, triangle);
  const Vec2 begin = corners[h % 3];
  const Vec2 axis = (1. / t.length[h]) * (corners[next_halfedge(h) % 3] - begin);
  bool is_inside = false;
  for(; i != pieces.end() && i->first == triangle; ++i)
  {
    const Source_piece& piece = this->pieces()[i->second];
    const Vec2 p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
    for(std::size_t k = 1; k < windows.size(); ++k)
    {
      const Window& window = windows[k];
      if(window.is_straight())
      {
        meet_straight(piece, rotated_back(p - begin, axis), p, window);
        continue;
      }
      const Vec2 source = begin + rotated(window.source, axis),
                 nearest = closest_point_on_segment(source, p, q, is_inside);
      const Vec2 local_point = rotated_back(nearest - begin, axis);
      const auto is_right_of = [&](double position) {
        return internal::cross(Vec2{position, 0.} - window.source, local_point - window.source) >=
               0.;
      };
      if(!is_right_of(window.begin) && is_right_of(window.end))
      {
        meet(piece, nearest, source, window.offset, window.origin);
        continue;
      }
      for(const double position : {window.begin, window.end})
      {
        const Vec2 end = begin + position * axis;
        const Index origin = position <= 0.            ? t.corner[h]
                             : position >= t.length[h] ? t.corner[next_halfedge(h)]
                                                       : window.origin;
        // A point next to a window is in a gap at round-off errors. The line of the window's source
        // is its line.
        if(m_mode == Mode::each)
          meet_each(piece, window.distance(position) + norm(end - p),
                    (origin == window.origin ? source : end) - p, origin);
        else
          meet(piece, closest_point_on_segment(end, p, q, is_inside), end,
               window.distance(position), origin);
      }
    }
  }
}

// Tests the path from a straight window, which occurs in forward propagations only, to a point
// piece; the point is given in the coordinates of the halfedge and of the triangle.
void Window_goal::meet_straight(const Source_piece& piece, const Vec2& local_point,
                                const Vec2& point, const Window& window)
{
  const double at_begin = side_of_apex_line(window, window.begin, local_point),
               at_end = side_of_apex_line(window, window.end, local_point);
  if(at_begin <= 0. && at_end >= 0.)
    return meet(piece, point, point, window.offset - dot(window.source, local_point),
                window.origin);
  const double position = at_begin > 0. ? window.begin : window.end;
  const double gain = norm(local_point - Vec2{position, 0.});
  meet(piece, point, point, window.distance(position) + gain, window.origin);
}

void Window_goal::meet(const Source_piece& piece, const Vec2& position, const Vec2& from,
                       double distance, Index origin)
{
  const double total = piece.offset + norm(from - position) + distance;
  if(m_mode == Mode::each)
    return meet_each(piece, total, from - position, origin);
  if(m_mode == Mode::all ? !(total <= m_meeting.distance) : !(total < m_meeting.distance))
    return;
  const auto corners = unfolded(*m_triangles, piece.triangle);
  const Vec2 begin = unfolded_point(corners, piece.begin);
  const double size = norm(unfolded_point(corners, piece.end) - begin);
  const double fraction = size > 0. ? norm(position - begin) / size : 0.;
  Meeting meeting = {
      total, none, {piece.triangle, none, {}}, from - position, norm(from - position), origin};
  for(int k = 0; k < 3; ++k)
    meeting.location.barycentric[k] = (1. - fraction) * piece.begin[k] + fraction * piece.end[k];
  if(m_mode == Mode::all)
    m_meetings.push_back(meeting);
  else
    m_meeting = meeting;
}

// Keeps the line from a point piece to an origin if the total distance is the shortest one so far.
void Window_goal::meet_each(const Source_piece& piece, double distance, const Vec2& line,
                            Index origin)
{
  Meeting& shortest = m_meetings[std::size_t(&piece - m_pieces.data())];
  if(distance < shortest.distance)
    shortest = {distance, none, {}, line, norm(line), origin};
}

} // namespace CGAL::Geodesic_processing::internal
