// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "paths/shorten_geodesic.h"
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

// The way back: from any place to where the sources are.

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sums of thousands of lengths differ by less than this part of them.
constexpr double round_off_tolerance = 1e-12;
// Arrivals at a site from directions that differ by less are one; in radians.
constexpr double direction_tolerance = 1e-6;
// Paths that are nowhere farther from each other than this part of their length are one.
constexpr double path_tolerance = 1e-6;
// A line that is followed back meets its source to this part of a side, and touches sites to this angle.
constexpr double location_tolerance = 1e-6;
// It crosses a side at its end when it is nearer to it than this part of it.
constexpr double edge_end_tolerance = 1e-9;
// Where a whole circle of places is equally far from a source, there is no end of paths.
constexpr std::size_t max_paths = 64;

// The angle of a direction in the frame of a corner, around its site: counterclockwise from the side
// that leaves the first corner of the site's star.
double polar_angle(const Surface_arrays& t, Index corner, const Vec2& direction)
{
  double result = std::atan2(std::max(0., direction[1]), direction[0]);
  for(Index i = t.ring_begin[t.corner[corner]]; t.ring[i] != corner; ++i)
    result += interior_angle(t, t.ring[i]);
  return result;
}

// That of a direction in the layout of a triangle, from a clean location in it: Departure's.
double polar_angle_at(const Surface_arrays& t, const Surface_location& from, const Vec2& direction)
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

// The direction of a side in the layout of its triangle.
Vec2 edge_direction(const std::array<Vec2, 3>& corners, Index h)
{
  const Vec2 edge = corners[next_halfedge(h) % 3] - corners[h % 3];
  const double edge_length = norm(edge);
  return edge_length > 0. ? (1. / edge_length) * edge : Vec2{1., 0.};
}

// A line in the layout of a triangle.
struct Line
{
  Index triangle;
  Vec2 from, target;
};

// Whether a point lies to the left of a line, seen from its begin, by an angle of more than `touch`.
bool is_left(const Line& line, const Vec2& point, double angle_tolerance)
{
  const Vec2 direction = line.target - line.from, to_point = point - line.from;
  return cross(direction, to_point) > angle_tolerance * norm(direction) * norm(to_point);
}

// The side through which a line leaves the triangle that it begins in.
Index first_halfedge(const std::array<Vec2, 3>& corners, const Line& line, double angle_tolerance)
{
  for(const Index begin : {0, 1, 2})
  {
    const Index end = (begin + 1) % 3;
    if((corners[begin] == line.from || !is_left(line, corners[begin], angle_tolerance)) &&
       (corners[end] == line.from || is_left(line, corners[end], angle_tolerance)))
      return 3 * line.triangle + begin;
  }
  return 3 * line.triangle;
}

// Follows a line to the point where it should end: it leaves a triangle to the right of the third corner
// or to the left, by an angle of more than `touch`.  Returns it in the layout of its last triangle, or
// nothing where it misses the point.  Where it crosses sides is appended to `crossings`, unless null.
std::optional<Line> follow_line(const Surface_arrays& t, Line line, const Surface_location& end,
                                double angle_tolerance, std::vector<Surface_location>* crossings)
{
  const std::vector<Index> target_triangles = triangles_at(t, end);
  auto corners = unfolded(t, line.triangle);
  Index h = first_halfedge(corners, line, angle_tolerance);
  // A shortest path crosses no triangle twice.
  for(std::size_t i = 0; i < t.number_of_triangles(); ++i)
  {
    if(std::find(target_triangles.begin(), target_triangles.end(), line.triangle) !=
       target_triangles.end())
    {
      const Vec2 end_point = unfolded_point(corners, *barycentric_in(t, line.triangle, end));
      if(norm(end_point - line.target) < location_tolerance * t.length[h])
        return Line{line.triangle, line.from, end_point};
    }
    const Vec2 line_direction = line.target - line.from, begin = corners[h % 3],
               edge = corners[next_halfedge(h) % 3] - begin;
    const bool is_before = dot(begin - line.target, line_direction) < 0. ||
                           dot(begin + edge - line.target, line_direction) < 0.;
    if(!is_before || t.twin[h] == none)
      return std::nullopt;
    if(crossings != nullptr)
    {
      const double across = cross(line_direction, edge);
      const double fraction = across > 0. ? cross(line_direction, line.from - begin) / across : 0.;
      crossings->push_back(canonical(
          t, {line.triangle, none,
              barycentric_on_halfedge(h, fraction < edge_end_tolerance        ? 0.
                                         : fraction > 1. - edge_end_tolerance ? 1.
                                                                              : fraction)}));
    }
    // To the layout of the triangle across the side.
    const Vec2 direction = edge_direction(corners, h);
    h = t.twin[h];
    line.triangle = h / 3;
    corners = unfolded(t, line.triangle);
    const Vec2 rotation = rotated_back(-1. * edge_direction(corners, h), direction);
    line.from = corners[next_halfedge(h) % 3] + rotated(line.from - begin, rotation);
    line.target = corners[next_halfedge(h) % 3] + rotated(line.target - begin, rotation);
    h = is_left(line, corners[previous_halfedge(h) % 3], angle_tolerance) ? next_halfedge(h)
                                                                          : previous_halfedge(h);
  }
  return std::nullopt;
}

// A line may touch a saddle site on either side.
std::optional<Line> follow_line(const Surface_arrays& t, const Line& line,
                                const Surface_location& end,
                                std::vector<Surface_location>* crossings = nullptr)
{
  for(const double angle_tolerance : {0., location_tolerance, -location_tolerance})
  {
    if(crossings != nullptr)
      crossings->clear();
    if(const auto line_found = follow_line(t, line, end, angle_tolerance, crossings))
      return line_found;
  }
  return std::nullopt;
}

// Whether rounding has led a path astray.
bool is_disconnected(const Surface_arrays& t, const std::vector<Surface_location>& path)
{
  return std::adjacent_find(path.begin(), path.end(),
                            [&](const Surface_location& p, const Surface_location& q)
                            { return common_triangle(t, p, q) == none; }) != path.end();
}

// Whether every point of a path lies beside the other path.
bool is_along(const Surface_arrays& t, const std::vector<Surface_location>& path,
              const std::vector<Surface_location>& other, double width)
{
  const auto is_close = [&](const Surface_location& location)
  {
    for(const Index triangle : triangles_at(t, location))
    {
      const auto corners = unfolded(t, triangle);
      const Vec2 p = unfolded_point(corners, *barycentric_in(t, triangle, location));
      bool has_previous = false, is_inside = false;
      Vec2 previous = {0., 0.};
      for(const Surface_location& other_location : other)
      {
        const auto barycentric = barycentric_in(t, triangle, other_location);
        if(barycentric)
        {
          const Vec2 q = unfolded_point(corners, *barycentric);
          if(norm(p - closest_point_on_segment(p, has_previous ? previous : q, q, is_inside)) <=
             width)
            return true;
          previous = q;
        }
        has_previous = barycentric.has_value();
      }
    }
    return false;
  };
  return std::all_of(path.begin(), path.end(), is_close);
}

} // namespace

double Window_propagation::distance(const Surface_location& location) const
{
  if(const Index vertex = vertex_of(*m_triangles, location); vertex != none)
    return distance(vertex);
  const std::lock_guard lock(m_reverse_search.mutex);
  const double distance = reverse_propagation().find_shortest(*this, location).distance;
  return distance <= m_max_distance ? distance + m_min_offset : infinity;
}

Window_propagation& Window_propagation::reverse_propagation() const
{
  if(!m_reverse_search.windows)
    m_reverse_search.windows.reset(new Window_propagation(m_triangles, m_is_pseudo_source));
  return *m_reverse_search.windows;
}

// As a goal's site is not nearer to its sources than the distance there, a window that is too far from
// it is late: only those that may be on a shortest path go on.
const Window_propagation::Meeting&
Window_propagation::find_shortest(const Window_propagation& forward, const Surface_location& from)
{
  m_collects_all = false;
  m_meeting = Meeting{};
  propagate_back(forward, from);
  return m_meeting;
}

// Keeps all ways of at most this length by which the goal's sources are reached.
void Window_propagation::find_all(const Window_propagation& forward, const Surface_location& from,
                                  double max_length)
{
  m_collects_all = true;
  m_meeting = Meeting{};
  m_meeting.distance = max_length;
  m_meetings.clear();
  m_arrivals.clear();
  propagate_back(forward, from);
}

void Window_propagation::propagate_back(const Window_propagation& forward,
                                        const Surface_location& from)
{
  const Surface_arrays& t = *m_triangles;
  clear();
  m_forward = &forward;
  m_max_distance = infinity;
  const Index vertex = vertex_of(t, from);
  const Index origin = vertex != none ? vertex : Index(m_vertices.size()); // or its first piece
  for(const Index triangle : triangles_at(t, from))
    meet_sources(triangle,
                 unfolded_point(unfolded(t, triangle), *barycentric_in(t, triangle, from)), origin);
  m_min_offset = 0.;
  start({{{from}, 0., 0}});
  while(!m_queue.empty())
  {
    m_max_distance = m_meeting.distance * (1. + round_off_tolerance);
    const Index item = m_queue.pop().vertex, number_of_halfedges = Index(t.corner.size());
    if(item < number_of_halfedges)
      cross_triangle(item);
    else
      finalize_vertex(item - number_of_halfedges);
  }
}

// Arrivals from the same direction are one path.
void Window_propagation::keep_arrival(Index vertex, const Arrival& arrival)
{
  if(!(arrival.distance + m_forward->m_vertices[vertex].distance <= m_meeting.distance))
    return;
  const Surface_arrays& t = *m_triangles;
  std::vector<Arrival>& arrivals = m_arrivals[vertex];
  if(arrival.corner != none)
  {
    double total_angle = 0.;
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
      total_angle += interior_angle(t, t.ring[i]);
    const double angle = polar_angle(t, arrival.corner, arrival.direction);
    for(const Arrival& other : arrivals)
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

// Looks for sources of the goal next to where windows are sent back from.
void Window_propagation::meet_sources(Index triangle, const Vec2& position, Index origin)
{
  const auto& pieces = m_forward->m_pieces_by_triangle;
  for(auto i = std::lower_bound(pieces.begin(), pieces.end(), std::pair(triangle, Index(0)));
      i != pieces.end() && i->first == triangle; ++i)
  {
    const Source_piece& piece = m_forward->m_source_pieces[i->second];
    const auto corners = unfolded(*m_triangles, triangle);
    bool is_inside = false;
    meet(piece,
         closest_point_on_segment(position, unfolded_point(corners, piece.begin),
                                  unfolded_point(corners, piece.end), is_inside),
         position, 0., origin);
  }
}

// Looks for sources of the goal in a triangle that windows cross.
void Window_propagation::meet_sources_behind(Index h)
{
  const Surface_arrays& t = *m_triangles;
  const auto& pieces = m_forward->m_pieces_by_triangle;
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
    const Source_piece& piece = m_forward->m_source_pieces[i->second];
    const Vec2 p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
    for(std::size_t k = 1; k < m_windows.size(); ++k)
    {
      const Window& window = m_windows[k];
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
        meet(piece, closest_point_on_segment(end, p, q, is_inside), end, window.distance(position),
             origin);
      }
    }
  }
}

void Window_propagation::meet(const Source_piece& piece, const Vec2& position, const Vec2& from,
                              double distance, Index origin)
{
  const double total = piece.offset + norm(from - position) + distance;
  if(m_collects_all ? !(total <= m_meeting.distance) : !(total < m_meeting.distance))
    return;
  const auto corners = unfolded(*m_triangles, piece.triangle);
  const Vec2 begin = unfolded_point(corners, piece.begin);
  const double size = norm(unfolded_point(corners, piece.end) - begin);
  const double fraction = size > 0. ? norm(position - begin) / size : 0.;
  Meeting meeting = {
      total, none, {piece.triangle, none, {}}, from - position, norm(from - position), origin};
  for(int k = 0; k < 3; ++k)
    meeting.location.barycentric[k] = (1. - fraction) * piece.begin[k] + fraction * piece.end[k];
  if(m_collects_all)
    m_meetings.push_back(meeting);
  else
    m_meeting = meeting;
}

std::vector<Surface_location> Window_propagation::path(const Surface_location& from) const
{
  const Surface_arrays& t = *m_triangles;
  std::vector<Surface_location> path;
  double length = 0.;
  Index vertex = vertex_of(t, from);
  if(vertex == none)
  {
    const std::lock_guard lock(m_reverse_search.mutex);
    Window_propagation& reverse_windows = reverse_propagation();
    const Meeting& meeting = reverse_windows.find_shortest(*this, from);
    if(meeting.distance == infinity || meeting.distance > m_max_distance)
      return {};
    vertex = meeting.vertex;
    if(vertex == none)
    {
      path.push_back(canonical(t, meeting.location));
      length += reverse_windows.append_line(meeting.location, meeting.direction, meeting.length,
                                            meeting.origin, path);
    }
    else
      path.push_back(vertex_location(t, vertex));
    if(const Index origin = vertex == none ? meeting.origin : vertex; origin < m_vertices.size())
      length += reverse_windows.append_chain(origin, path);
    std::reverse(path.begin(), path.end());
  }
  else if(m_vertices[vertex].distance < infinity)
    path.push_back(vertex_location(t, vertex));
  else
    return {};
  if(vertex != none)
    length += append_chain(vertex, path);
  if(is_disconnected(t, path))
    return {};
  const Locally_shortest_path result = shorten_geodesic(t, path);
  return result.length <= length + 1e-9 * (length + m_max_edge_length * round_off_tolerance)
             ? result.locations
             : std::vector<Surface_location>();
}

std::vector<std::vector<Surface_location>> Window_propagation::paths(const Surface_location& from,
                                                                     double tolerance) const
{
  const Surface_arrays& t = *m_triangles;
  const std::lock_guard lock(m_reverse_search.mutex);
  Window_propagation& reverse_windows = reverse_propagation();
  const Index start_vertex = vertex_of(t, from);
  const double shortest = start_vertex == none ? reverse_windows.find_shortest(*this, from).distance
                                               : m_vertices[start_vertex].distance;
  if(shortest == infinity || shortest > m_max_distance)
    return {};
  const double max_length = shortest * (1. + std::max(tolerance, round_off_tolerance));
  reverse_windows.find_all(*this, from, max_length);

  std::vector<std::vector<Surface_location>> candidates;
  for(const Index vertex : reverse_windows.m_reached)
    if(m_vertices[vertex].distance < infinity && m_vertices[vertex].corner == none &&
       reverse_windows.m_vertices[vertex].distance + m_vertices[vertex].distance <= max_length)
      reverse_windows.collect_paths(vertex, {vertex_location(t, vertex)}, candidates);
  for(const Meeting& meeting : reverse_windows.m_meetings)
  {
    std::vector<Surface_location> path = {canonical(t, meeting.location)};
    reverse_windows.append_line(meeting.location, meeting.direction, meeting.length, meeting.origin,
                                path);
    reverse_windows.collect_paths(meeting.origin, path, candidates);
  }

  std::vector<std::vector<Surface_location>> result;
  for(std::vector<Surface_location>& path : candidates)
  {
    std::reverse(path.begin(), path.end());
    if(is_disconnected(t, path))
      continue;
    path = shorten_geodesic(t, path).locations;
    const double width = path_tolerance * path_length(t, path);
    if(std::none_of(result.begin(), result.end(),
                    [&](const std::vector<Surface_location>& other)
                    { return is_along(t, path, other, width) && is_along(t, other, path, width); }))
      result.push_back(std::move(path));
  }
  return result;
}

Departure Window_propagation::departure(const Surface_location& to) const
{
  const Surface_arrays& t = *m_triangles;
  const std::vector<Surface_location> path = this->path(to);
  Departure result;
  if(path.empty())
    return result;
  result.from = result.next = path.back();
  result.length = path_length(t, path);
  if(path.size() == 1)
    return result;
  result.next = path[path.size() - 2];
  const Index triangle = common_triangle(t, path.back(), result.next);
  const auto corners = unfolded(t, triangle);
  const auto barycentric = *barycentric_in(t, triangle, path.back());
  const Vec2 direction = unfolded_point(corners, *barycentric_in(t, triangle, result.next)) -
                         unfolded_point(corners, barycentric);
  result.from = {triangle, none, barycentric};
  result.angle = std::atan2(direction[1], direction[0]);
  result.polar_angle = polar_angle_at(t, result.from, direction);
  return result;
}

double Window_propagation::polar_angle_of_departure(Index vertex) const
{
  const auto comes_from_vertex = [&]
  { return m_vertices[vertex].origin < m_vertices.size() && m_vertices[vertex].corner != none; };
  while(comes_from_vertex() && m_vertices[m_vertices[vertex].origin].corner != none)
    vertex = m_vertices[vertex].origin;
  if(m_vertices[vertex].corner == none)
    return 0.;
  const Arrival& arrival = m_vertices[vertex];
  const auto corners = unfolded(*m_triangles, arrival.corner / 3);
  const Vec2 from = corners[arrival.corner % 3];
  const Line line = {arrival.corner / 3, from,
                     from +
                         line_length(arrival) *
                             rotated(arrival.direction, edge_direction(corners, arrival.corner))};
  if(const auto end = source_point(arrival.origin))
    if(const auto found = follow_line(*m_triangles, line, *end))
      return polar_angle_at(
          *m_triangles,
          {found->triangle, none, *barycentric_in(*m_triangles, found->triangle, *end)},
          found->from - found->target);
  return departure(vertex_location(*m_triangles, vertex)).polar_angle;
}

// The point that windows come from, if it is one.
std::optional<Surface_location> Window_propagation::source_point(Index origin) const
{
  if(origin < m_vertices.size())
    return vertex_location(*m_triangles, origin);
  const Source_piece& piece = m_source_pieces[origin - m_vertices.size()];
  if(piece.begin != piece.end)
    return std::nullopt;
  return canonical(*m_triangles, {piece.triangle, none, piece.begin});
}

// How long the line is by which windows came.
double Window_propagation::line_length(const Arrival& arrival) const
{
  return arrival.distance - (arrival.origin < m_vertices.size()
                                 ? m_vertices[arrival.origin].distance
                                 : m_source_pieces[arrival.origin - m_vertices.size()].offset);
}

// Appends the way from a site to the source that its windows came from, without the site itself, and
// returns its length.
double Window_propagation::append_chain(Index vertex, std::vector<Surface_location>& path) const
{
  double length = 0.;
  for(; vertex < m_vertices.size() && m_vertices[vertex].corner != none;
      vertex = m_vertices[vertex].origin)
    length += append_arrival(m_vertices[vertex], path);
  return length;
}

// Goes on from a site by every way that was kept, and adds the paths to their beginning.
void Window_propagation::collect_paths(Index vertex, const std::vector<Surface_location>& path,
                                       std::vector<std::vector<Surface_location>>& paths) const
{
  if(paths.size() == max_paths)
    return;
  if(vertex >= m_vertices.size() || m_vertices[vertex].corner == none)
    return paths.push_back(path);
  const auto arrivals = m_arrivals.find(vertex);
  if(arrivals == m_arrivals.end())
    return;
  for(const Arrival& arrival : arrivals->second)
  {
    std::vector<Surface_location> extended_path = path;
    append_arrival(arrival, extended_path);
    collect_paths(arrival.origin, extended_path, paths);
  }
}

// Appends the straight line from a site to where an arrival there came from.
double Window_propagation::append_arrival(const Arrival& arrival,
                                          std::vector<Surface_location>& path) const
{
  const Surface_arrays& t = *m_triangles;
  const auto corners = unfolded(t, arrival.corner / 3);
  return append_line({arrival.corner / 3, none, barycentric_at_corner(arrival.corner)},
                     rotated(arrival.direction, edge_direction(corners, arrival.corner)),
                     line_length(arrival), arrival.origin, path);
}

// Appends the straight line to the site or the piece of a source that is seen in a direction of the
// layout of a triangle.
double Window_propagation::append_line(const Surface_location& from, const Vec2& direction,
                                       double length, Index origin,
                                       std::vector<Surface_location>& path) const
{
  const Surface_arrays& t = *m_triangles;
  const Surface_location line_start = path.back();
  if(const auto end = source_point(origin))
  {
    const Vec2 line_begin = unfolded_point(unfolded(t, from.triangle), from.barycentric);
    const double size = norm(direction);
    const Vec2 line_end = line_begin + (size > 0. ? std::max(length, 0.) / size : 0.) * direction;
    std::vector<Surface_location> crossings;
    if(follow_line(t, {from.triangle, line_begin, line_end}, *end, &crossings))
    {
      crossings.push_back(*end);
      for(const Surface_location& location : crossings)
        if(!is_same_point(t, path.back(), location))
          path.push_back(location);
      return length;
    }
  }
  const double angle = std::atan2(direction[1], direction[0]);
  for(const Surface_location& traced_location :
      trace_straightest(t, from, angle, std::max(length, 0.)).locations)
    if(const Surface_location location = canonical(t, traced_location);
       !is_same_point(t, path.back(), location))
      path.push_back(location);
  Surface_location end;
  if(origin < m_vertices.size())
    end = vertex_location(t, origin);
  else
  {
    const Source_piece& piece = m_source_pieces[origin - m_vertices.size()];
    end = {piece.triangle, none, piece.begin};
    if(const auto barycentric_of_last = barycentric_in(t, piece.triangle, path.back());
       barycentric_of_last && piece.begin != piece.end)
    {
      const auto corners = unfolded(t, piece.triangle);
      const Vec2 p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
      bool is_inside = false;
      const double fraction =
          norm(closest_point_on_segment(unfolded_point(corners, *barycentric_of_last), p, q,
                                        is_inside) -
               p) /
          norm(q - p);
      for(int k = 0; k < 3; ++k)
        end.barycentric[k] = (1. - fraction) * piece.begin[k] + fraction * piece.end[k];
    }
    end = canonical(t, end);
  }
  // Rounding may have led it past the end by a triangle or two.
  while(path.size() > 1 && common_triangle(t, path.back(), end) == none &&
        !is_same_point(t, path.back(), line_start))
    path.pop_back();
  if(!is_same_point(t, path.back(), end))
    path.push_back(end);
  return length;
}

} // namespace CGAL::Geodesic_processing::internal
