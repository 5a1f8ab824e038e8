// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/paths/path_to_sources.h>
#include "paths/shorten_geodesic.h"
#include <CGAL/Geodesic_processing/internal/paths/trace_straightest.h>
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// State of a site.
constexpr Index reached_flag = 1;   // it is among the reached
constexpr Index finalized_flag = 2; // its distance has been handed on

// Sums of thousands of lengths differ by less than this part of them.
constexpr double round_off_tolerance = 1e-12;
// Gaps and sources that differ by less, in parts of the side or of the distance, are the same.
constexpr double merge_tolerance = 1e-13;
// A path that bends by this angle is longer by a part of 1e-17 only: it counts as straight.
constexpr double straight_angle_tolerance = 1e-8;
// Windows that overlap less than by this part of the smaller one are not worth to be parted.
constexpr double min_overlap_ratio = 0.6;
// Windows cross a side once or twice.  Those that have come more often than this may go in circles,
// around spikes and between faces that lie on each other.
constexpr std::uint8_t max_untracked_crossings = 8;
// Where everything lies on one line, all are as near as each other: there is no end of them.
constexpr std::size_t max_known_windows = 1000;

// Whether the place on the base lies right of the window's line to the apex (positive) or left.
template <typename Window>
double side_of_apex_line(const Window& window, double position, const Vec2& apex_point)
{
  return (position * double(window.weight) - window.source[0]) * apex_point[1] +
         window.source[1] * (apex_point[0] - position);
}

// The window seen in a mirror: its side runs the other way.
template <typename Window>
Window mirror(Window w, double length)
{
  if(w.weight == 0.f)
    w.offset -= w.source[0] * length;
  w.source[0] = length * double(w.weight) - w.source[0];
  const double begin = w.begin;
  w.begin = length - w.end;
  w.end = length - begin;
  return w;
}

// The part of a window that leaves by the left side, as its twin sees it, which runs from the origin
// along `axis` to the apex.  Its ends are so far left (negative, the first one at least) or right.
template <typename Window>
Window clip_through_left(Window w, double begin, double end, const Vec2& axis, double length)
{
  // The line through (b, 0) meets the side at the share b y / (b y + halfedge_of(b)) of its length.
  const double y = w.source[1];
  w.begin = length * (w.begin * y / (w.begin * y + begin));
  w.end = end < 0. ? length * (w.end * y / (w.end * y + end)) : length;
  w.source = {dot(w.source, axis), std::min(0., cross(axis, w.source))};
  return w;
}

// Parts two windows that overlap, the first one before the second, where they are equally far.
// False when the first one is not needed any more.
template <typename Window>
bool split_overlap(Window& a, Window& b, double min_length)
{
  double overlap_begin = std::max(a.begin, b.begin), overlap_end = std::min(a.end, b.end);
  if(overlap_end - overlap_begin < -min_length)
    return true;
  const auto is_equal = [&](double p, double q)
  { return std::abs(p - q) <= merge_tolerance * std::abs(p); };
  if(std::abs(a.source[0] - b.source[0]) <= merge_tolerance * std::abs(a.source[0]) + min_length &&
     std::abs(a.source[1] - b.source[1]) <= merge_tolerance * std::abs(a.source[1]) + min_length &&
     is_equal(a.offset, b.offset) && a.weight == b.weight)
  {
    b.begin = std::min(a.begin, b.begin);
    b.end = std::max(a.end, b.end);
    return false;
  }
  if(!(overlap_end - overlap_begin >
       min_overlap_ratio * std::min(a.end - a.begin, b.end - b.begin) + min_length))
    return true;
  double difference_at_begin = a.distance(overlap_begin) - b.distance(overlap_begin),
         difference_at_end = a.distance(overlap_end) - b.distance(overlap_end);
  if(difference_at_begin >= 0. && difference_at_end >= 0.)
  {
    if(a.end <= b.end)
    {
      if(a.begin >= b.begin)
        return false;
      a.end = overlap_begin;
    }
    return true;
  }
  if(difference_at_begin <= 0. && difference_at_end <= 0.)
  {
    if(b.begin >= a.begin)
      b.begin = overlap_end;
    return true;
  }
  if(difference_at_begin > 0.)
    return true; // they do not come in order: both stay whole
  // What is cut off is surely farther: the two ends close in on the same place.
  const double tolerance = 1e-14 * (std::abs(a.source[0]) + std::abs(a.source[1]));
  for(int step = 0; step < 4 && overlap_begin < overlap_end; ++step)
  {
    const double crossing =
        overlap_begin + (overlap_end - overlap_begin) *
                            (difference_at_begin / (difference_at_begin - difference_at_end));
    if(!(crossing > overlap_begin && crossing < overlap_end))
      break;
    const double value = a.distance(crossing) - b.distance(crossing);
    if(value <= tolerance)
    {
      overlap_begin = crossing;
      difference_at_begin = value;
    }
    if(value >= -tolerance)
    {
      overlap_end = crossing;
      difference_at_end = value;
    }
  }
  if(a.end <= b.end)
    a.end = overlap_end;
  if(b.begin >= a.begin)
    b.begin = overlap_begin;
  return true;
}

// Sites where a shortest path may bend: those with more than 2 pi around them, or a border, or a
// second fan.
std::shared_ptr<const std::vector<bool>> find_pseudo_sources(const Surface_arrays& t)
{
  if(t.is_cloud())
    throw Unsupported_surface_error("Exact distances need a mesh, not a cloud.");
  auto result = std::make_shared<std::vector<bool>>(t.number_of_vertices());
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    double total_angle = 0.;
    bool is_boundary = false;
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      total_angle += interior_angle(t, t.ring[i]);
      is_boundary = is_boundary || t.twin[t.ring[i]] == none;
    }
    Index fan_size = 0, corner = t.ring_begin[vertex] < t.ring_begin[vertex + 1]
                                     ? t.ring[t.ring_begin[vertex]]
                                     : none;
    if(!is_boundary && corner != none)
      do
      {
        ++fan_size;
        corner = next_corner_ccw(t, corner);
      } while(corner != t.ring[t.ring_begin[vertex]]);
    (*result)[vertex] = is_boundary || total_angle > 2. * pi + straight_angle_tolerance ||
                        fan_size < t.ring_begin[vertex + 1] - t.ring_begin[vertex];
  }
  return result;
}

// Takes from a window the parts at its ends where another one is not farther.
template <typename Window>
void trim_dominated(Window& w, const Window& other)
{
  const double overlap_begin = std::max(w.begin, other.begin),
               overlap_end = std::min(w.end, other.end);
  const auto is_nearer = [&](double position)
  {
    return other.distance(position) <=
           w.distance(position) + merge_tolerance * std::abs(w.distance(position));
  };
  if(!(overlap_begin < overlap_end) || (overlap_begin > w.begin && overlap_end < w.end) ||
     !is_nearer(overlap_begin) || !is_nearer(overlap_end))
    return;
  // Two hyperbolas meet up to twice: in between, the difference has one extremum.
  const double slope = (w.source[0] - other.source[0]) / (w.offset - other.offset);
  const double extremum =
      w.source[0] + std::abs(w.source[1]) * slope / std::sqrt(1. - slope * slope);
  if(extremum > overlap_begin && extremum < overlap_end && !is_nearer(extremum))
    return;
  if(overlap_begin == w.begin)
    w.begin = overlap_end;
  else
    w.end = overlap_begin;
}

} // namespace

Window_propagation::Window_propagation(std::shared_ptr<const Surface_arrays> triangles)
    : Window_propagation(triangles, find_pseudo_sources(*triangles))
{}

Window_propagation::Window_propagation(std::shared_ptr<const Surface_arrays> triangles,
                                       std::shared_ptr<const std::vector<bool>> is_pseudo_source)
    : m_triangles(std::move(triangles)), m_is_pseudo_source(std::move(is_pseudo_source)),
      m_vertices(m_triangles->number_of_vertices()),
      m_queue(m_triangles->corner.size() + m_triangles->number_of_vertices()),
      m_waiting(2 * m_triangles->corner.size()), m_free_lists(33),
      m_number_of_crossings(m_triangles->corner.size())
{
  for(const double length : m_triangles->length)
    m_max_edge_length = std::max(m_max_edge_length, length);
}

bool Window_propagation::run(const std::vector<Front_source>& sources, const Front_limits& limits)
{
  if(limits.slowness)
    throw Unsupported_surface_error("Exact distances know no speeds.");
  clear();
  m_min_offset = infinity;
  for(const Front_source& source : sources)
    m_min_offset = std::min(m_min_offset, source.offset);
  m_max_distance = limits.maximum_distance - m_min_offset;
  start(sources);

  const Index number_of_halfedges = Index(m_triangles->corner.size());
  std::size_t next_target_check = 0; // at the targets, of the visits
  bool is_finished = true;
  for(std::size_t number_of_visits = 0; !m_queue.empty(); ++number_of_visits)
  {
    if(limits.callback && number_of_visits % 4096 == 0 &&
       !limits.callback(std::min(1., double(m_reached.size()) / double(m_vertices.size()))))
    {
      // Whatever still waits is not nearer than the queue's first by more than a side.
      m_max_distance = std::min(m_max_distance, m_queue.front().key - m_max_edge_length);
      is_finished = false;
      break;
    }
    const Index item = m_queue.pop().vertex;
    if(item < number_of_halfedges)
      cross_triangle(item);
    else
    {
      finalize_vertex(item - number_of_halfedges);
      if(!limits.targets.empty() && number_of_visits >= next_target_check)
      {
        limit_to_targets(limits.targets);
        next_target_check = number_of_visits + std::max<std::size_t>(64, limits.targets.size());
      }
    }
  }
  limit_to_targets(limits.targets);
  const auto is_too_far = [&](Index vertex)
  {
    if(m_vertices[vertex].distance <= m_max_distance)
      return false;
    m_vertices[vertex] = Vertex_data{};
    return true;
  };
  m_reached.erase(std::remove_if(m_reached.begin(), m_reached.end(), is_too_far), m_reached.end());
  return is_finished;
}

// What the last run has left, also one that was cancelled.
void Window_propagation::clear()
{
  const Index number_of_halfedges = Index(m_triangles->corner.size());
  for(const Index vertex : m_reached)
    m_vertices[vertex] = Vertex_data{};
  m_reached.clear();
  for(const Index h : m_crossed_halfedges)
    m_number_of_crossings[h] = 0;
  m_crossed_halfedges.clear();
  m_known_windows.clear();
  while(!m_queue.empty())
    if(const std::size_t h = m_queue.pop().vertex; h < number_of_halfedges)
      for(const int list_index : {0, 1})
        release(m_waiting[2 * h + list_index]);
}

// Once all targets have a distance, nothing beyond the farthest one matters.
void Window_propagation::limit_to_targets(const std::vector<Surface_location>& targets)
{
  const Surface_arrays& t = *m_triangles;
  double farthest = targets.empty() ? infinity : -infinity;
  for(const Surface_location& target : targets)
    if(target.triangle == none)
      farthest = std::max(farthest, m_vertices[target.vertex].distance);
    else
      for(Index k = 0; k < 3; ++k)
        farthest = std::max(farthest,
                            m_vertices[t.corner[3 * target.triangle + k]].distance +
                                distance_in_triangle(t, target.triangle, barycentric_at_corner(k),
                                                     target.barycentric));
  m_max_distance = std::min(m_max_distance, farthest + round_off_tolerance * std::abs(farthest));
}

void Window_propagation::start(const std::vector<Front_source>& sources)
{
  const Surface_arrays& t = *m_triangles;
  m_source_pieces.clear();
  for(Index i = 0; i < sources.size(); ++i)
  {
    const std::vector<Surface_location>& polyline = sources[i].polyline;
    const double offset = sources[i].offset - m_min_offset;
    for(const Surface_location& location : polyline)
      start_at_point(location, i, offset);
    for(std::size_t k = 1; k < polyline.size(); ++k)
      for(const Index triangle : triangles_at(t, polyline[k - 1]))
        if(const auto p = barycentric_in(t, triangle, polyline[k - 1]),
           q = barycentric_in(t, triangle, polyline[k]);
           p && q)
        {
          m_source_pieces.push_back({triangle, i, *p, *q, offset});
          start_along(m_source_pieces.back());
        }
  }
  m_pieces_by_triangle.clear();
  for(Index i = 0; i < m_source_pieces.size(); ++i)
    m_pieces_by_triangle.emplace_back(m_source_pieces[i].triangle, i);
  std::sort(m_pieces_by_triangle.begin(), m_pieces_by_triangle.end());
}

void Window_propagation::start_at_point(const Surface_location& location, Index source,
                                        double offset)
{
  const Surface_arrays& t = *m_triangles;
  if(const Index vertex = vertex_of(t, location); vertex != none)
  {
    relax(vertex, {offset, {1., 0.}, none, vertex}, source);
    return;
  }
  for(const Index triangle : triangles_at(t, location))
  {
    const auto barycentric = *barycentric_in(t, triangle, location);
    const Index origin = Index(m_vertices.size() + m_source_pieces.size());
    m_source_pieces.push_back({triangle, source, barycentric, barycentric, offset});
    const auto corners = unfolded(t, triangle);
    const Vec2 p = unfolded_point(corners, barycentric);
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * triangle + k;
      const double length = t.length[h];
      if(!(length > 0.))
        continue;
      const Vec2 axis = (1. / length) * (corners[(k + 1) % 3] - corners[k]);
      const Vec2 to_point = p - corners[k];
      const double gain = norm(to_point);
      relax(t.corner[h],
            {offset + gain, gain > 0. ? rotated_back((1. / gain) * to_point, axis) : Vec2{1., 0.},
             h, origin},
            source);
      // Seen by the twin, which runs the other way.
      const Vec2 local_point = rotated_back(to_point, axis);
      if(barycentric[(k + 2) % 3] > 0.)
        enqueue(t.twin[h], {{length - local_point[0], std::min(0., -local_point[1])},
                            offset,
                            0.,
                            length,
                            origin,
                            1.f});
    }
  }
}

// A segment sends straight fronts to both of its sides.
void Window_propagation::start_along(const Source_piece& piece)
{
  const Surface_arrays& t = *m_triangles;
  const Index origin = Index(m_vertices.size() + m_source_pieces.size() - 1);
  const auto corners = unfolded(t, piece.triangle);
  const Vec2 p = unfolded_point(corners, piece.begin), q = unfolded_point(corners, piece.end);
  const double size = norm(q - p);
  if(!(size > 0.))
    return;
  const Vec2 along = (1. / size) * (q - p);
  for(Index k = 0; k < 3; ++k)
  {
    const Index h = 3 * piece.triangle + k;
    const double length = t.length[h];
    if(!(length > 0.))
      continue;
    const Vec2 axis = (1. / length) * (corners[(k + 1) % 3] - corners[k]);
    // Coordinates of the corner and of the side's direction, along the segment and across it.
    const Vec2 corner = rotated_back(corners[k] - p, along),
               edge_direction = rotated_back(axis, along);
    if(corner[0] >= 0. && corner[0] <= size)
    {
      const Vec2 direction = {0., corner[1] > 0. ? -1. : 1.};
      relax(t.corner[h],
            {piece.offset + std::abs(corner[1]), rotated_back(rotated(direction, along), axis), h,
             origin},
            piece.source);
    }
    if(t.twin[h] == none || (piece.begin[(k + 2) % 3] == 0. && piece.end[(k + 2) % 3] == 0.))
      continue;
    for(const double sign : {1., -1.})
    {
      // The part of the side where 0 <= x <= size and up y >= 0.
      double begin = 0., end = length;
      const auto clip = [&](double value, double slope_of_value) // value + rise place >= 0
      {
        if(slope_of_value > 0.)
          begin = std::max(begin, -value / slope_of_value);
        else if(slope_of_value < 0.)
          end = std::min(end, -value / slope_of_value);
        else if(value < 0.)
          end = -1.;
      };
      clip(corner[0], edge_direction[0]);
      clip(size - corner[0], -edge_direction[0]);
      clip(sign * corner[1], sign * edge_direction[1]);
      const Vec2 backward = rotated_back(rotated({0., -sign}, along), axis);
      if(begin < end && backward[1] > 0.) // it leaves the triangle
        enqueue(t.twin[h], {{-backward[0], -backward[1]},
                            piece.offset + sign * (corner[1] + length * edge_direction[1]),
                            length - end,
                            length - begin,
                            origin,
                            0.f});
    }
  }
}

bool Window_propagation::relax(Index v, const Arrival& arrival, Index source)
{
  if(m_collects_all)
    keep_arrival(v, arrival);
  Vertex_data& vertex = m_vertices[v];
  const double distance = arrival.distance;
  if(!(distance < vertex.distance) || distance > m_max_distance)
    return false;
  if(m_forward)
  {
    const double total_length = distance + m_forward->m_vertices[v].distance;
    if(!(total_length <= m_meeting.distance * (1. + round_off_tolerance)))
      return false;
    if(!m_collects_all && total_length < m_meeting.distance)
      m_meeting = {total_length, v, {}, {}, 0., none};
  }
  if(!(vertex.state & reached_flag))
    m_reached.push_back(v);
  // Who has left does not go back for rounding.
  const bool is_unchanged =
      (vertex.state & finalized_flag) && distance >= vertex.distance * (1. - merge_tolerance);
  vertex = {arrival, source, vertex.state | reached_flag};
  if(!is_unchanged)
    m_queue.push(Index(m_triangles->corner.size() + v), distance);
  return true;
}

// A site tells its neighbours along the sides, and those whom no straight line reaches.
void Window_propagation::finalize_vertex(Index v)
{
  const Surface_arrays& t = *m_triangles;
  m_vertices[v].state |= finalized_flag;
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
  {
    relax_along_edge(t.ring[i], false);
    relax_along_edge(t.ring[i], true);
    if(m_vertices[v].corner == none)
      emit_window(t.ring[i], 0., pi);
  }
  if(m_vertices[v].corner != none && (*m_is_pseudo_source)[v])
    create_pseudosource_windows(v);
}

void Window_propagation::relax_along_edge(Index corner, bool is_incoming)
{
  const Surface_arrays& t = *m_triangles;
  const Index v = t.corner[corner], h = is_incoming ? previous_halfedge(corner) : corner;
  const Index far_corner = is_incoming ? h : next_halfedge(corner);
  const double distance = m_vertices[v].distance + t.length[h];
  if(!m_collects_all && !(distance < m_vertices[t.corner[far_corner]].distance))
    return;
  const bool is_on_axis = is_incoming || t.twin[corner] != none;
  relax(t.corner[far_corner],
        {distance, is_on_axis ? Vec2{1., 0.} : corner_angle(t, far_corner),
         is_incoming || !is_on_axis ? far_corner : t.twin[corner], v},
        m_vertices[v].source);
}

// Sends windows to where the shortest path bends at a site: more than pi from the way back, both
// ways round.
void Window_propagation::create_pseudosource_windows(Index v)
{
  const Surface_arrays& t = *m_triangles;
  const Index entry_corner = m_vertices[v].corner;
  const Vec2 direction = m_vertices[v].direction;
  const double right_angle = std::atan2(std::max(direction[1], 0.), direction[0]);
  const double left_angle = interior_angle(t, entry_corner) - right_angle;
  double total_angle = right_angle + left_angle;
  Index fan_size = 1, corner = next_corner_ccw(t, entry_corner);
  for(; corner != none && corner != entry_corner; corner = next_corner_ccw(t, corner), ++fan_size)
    total_angle += interior_angle(t, corner);
  const bool is_closed = corner == entry_corner;
  if(!is_closed)
    total_angle = infinity;
  double angle = left_angle; // from the way back to the corner, counterclockwise
  for(corner = next_corner_ccw(t, entry_corner);
      corner != none && corner != entry_corner && angle < total_angle - pi;
      corner = next_corner_ccw(t, corner))
  {
    emit_window(corner, pi - angle, total_angle - pi - angle);
    angle += interior_angle(t, corner);
  }
  if(!is_closed)
  {
    angle = right_angle;
    for(corner = next_corner_cw(t, entry_corner); corner != none;
        corner = next_corner_cw(t, corner), ++fan_size)
    {
      angle += interior_angle(t, corner);
      emit_window(corner, 0., angle - pi);
    }
  }
  if(fan_size == t.ring_begin[v + 1] - t.ring_begin[v])
    return;
  const auto is_in_fan = [&](Index other)
  {
    Index rotated_corner = entry_corner;
    do
    {
      if(rotated_corner == other)
        return true;
      rotated_corner = next_corner_ccw(t, rotated_corner);
    } while(rotated_corner != none && rotated_corner != entry_corner);
    for(rotated_corner = next_corner_cw(t, entry_corner);
        rotated_corner != none && rotated_corner != entry_corner;
        rotated_corner = next_corner_cw(t, rotated_corner))
      if(rotated_corner == other)
        return true;
    return false;
  };
  for(Index i = t.ring_begin[v]; i < t.ring_begin[v + 1]; ++i)
    if(!is_in_fan(t.ring[i]))
      emit_window(t.ring[i], 0., pi);
}

// Sends a window through the side opposite a corner, between two angles from the corner's side.
void Window_propagation::emit_window(Index corner, double from, double to)
{
  const Surface_arrays& t = *m_triangles;
  const Index h = next_halfedge(corner);
  const double length = t.length[h], right = t.length[corner],
               left = t.length[previous_halfedge(corner)], opening = interior_angle(t, corner);
  from = std::max(from, 0.);
  if(t.twin[h] == none || !(length > 0.) ||
     !(std::min(to, opening) - from > straight_angle_tolerance))
    return;
  const auto position_at = [&](double angle) // from the left end
  {
    const double right_weight = right * std::sin(angle),
                 left_weight = left * std::sin(opening - angle);
    return right_weight + left_weight > 0. ? length * (left_weight / (right_weight + left_weight))
                                           : 0.5 * length;
  };
  const Vec2 apex_point = third_corner(length, left, right);
  enqueue(t.twin[h], {{apex_point[0], -apex_point[1]},
                      m_vertices[t.corner[corner]].distance,
                      to < opening ? position_at(to) : 0.,
                      from > 0. ? position_at(from) : length,
                      t.corner[corner],
                      1.f});
}

// Takes the windows that wait at a side and may be on a shortest path, in order along it.
void Window_propagation::collect_windows(Index h)
{
  const Surface_arrays& t = *m_triangles;
  const double length = t.length[h], min_length = merge_tolerance * length;
  const double max_by_begin = max_useful_distance(t.corner[h]),
               max_by_end = max_useful_distance(t.corner[next_halfedge(h)]) + length;
  Window_list* const lists = &m_waiting[2 * std::size_t(h)];
  m_windows.resize(lists[0].size + lists[1].size + 1);
  Window* stack_top = m_windows.data(); // the first one is none
  for(const int k : {0, 1})
  {
    const Window* const begin = m_pool.data() + lists[k].position;
    for(const Window* w = begin; w != begin + lists[k].size; ++w)
    {
      if(!(w->end - w->begin > min_length) ||
         is_too_long(*w, max_by_begin + w->end - w->offset, max_by_end - w->begin - w->offset))
        continue;
      stack_top[1] = *w;
      for(; stack_top != m_windows.data() && !split_overlap(stack_top[0], stack_top[1], min_length);
          --stack_top)
        stack_top[0] = stack_top[1];
      if(stack_top[1].end - stack_top[1].begin > min_length)
        ++stack_top;
    }
    release(lists[k]);
  }
  m_windows.resize(std::size_t(stack_top - m_windows.data()) + 1);
  if(m_number_of_crossings[h] == 0)
    m_crossed_halfedges.push_back(h);
  if(m_number_of_crossings[h] < max_untracked_crossings)
    ++m_number_of_crossings[h];
  else
    drop_dominated(h);
}

// A side that is crossed often remembers by what: windows that are nowhere nearer end here.
void Window_propagation::drop_dominated(Index h)
{
  std::vector<Window>& known_windows = m_known_windows[h];
  if(known_windows.size() > max_known_windows)
    return m_windows.resize(1);
  const double min_length = merge_tolerance * m_triangles->length[h];
  std::size_t number_kept = 1;
  for(std::size_t i = 1; i < m_windows.size(); ++i)
  {
    Window w = m_windows[i];
    for(double width = infinity; w.end - w.begin > min_length && w.end - w.begin < width;)
    {
      width = w.end - w.begin;
      for(const Window& other : known_windows)
        trim_dominated(w, other);
    }
    if(w.end - w.begin > min_length)
      m_windows[number_kept++] = w;
  }
  m_windows.resize(number_kept);
  known_windows.insert(known_windows.end(), m_windows.begin() + 1, m_windows.end());
}

// The distance at a site beyond which no window counts.
double Window_propagation::max_useful_distance(Index vertex) const
{
  const double max_here = m_vertices[vertex].distance * (1. + round_off_tolerance);
  if(!m_forward)
    return max_here;
  return std::min(max_here, m_meeting.distance * (1. + round_off_tolerance) -
                                m_forward->m_vertices[vertex].distance);
}

// Whether the far end of a window is farther from its source than by the near end of the side, for
// both ends, or all of it is beyond the maximum.
bool Window_propagation::is_too_long(const Window& w, double max_by_begin, double max_by_end) const
{
  const double max_length = m_max_distance - w.offset;
  if(w.weight == 0.f)
    return -w.end * w.source[0] > max_by_begin || -w.begin * w.source[0] > max_by_end ||
           std::min(-w.begin * w.source[0], -w.end * w.source[0]) > max_length;
  const double to_begin = w.begin - w.source[0], to_end = w.end - w.source[0],
               square = w.source[1] * w.source[1];
  if(std::min({max_by_begin, max_by_end, max_length}) < 0. ||
     to_end * to_end + square > max_by_begin * max_by_begin ||
     to_begin * to_begin + square > max_by_end * max_by_end)
    return true;
  const double offset_from_window = std::max({to_begin, -to_end, 0.});
  return offset_from_window * offset_from_window + square > max_length * max_length;
}

void Window_propagation::cross_triangle(Index h)
{
  const Surface_arrays& t = *m_triangles;
  collect_windows(h);
  const Window* const windows = m_windows.data() + 1;
  const std::size_t n = m_windows.size() - 1;
  if(n == 0)
    return;
  const Index next = next_halfedge(h), previous = previous_halfedge(h);
  const double base = t.length[h], left_length = t.length[previous], right_length = t.length[next];
  const Vec2 apex_point = apex(t, h);

  // Those that may reach the apex, and the one beside them on either side.
  std::size_t first = 0, last = n;
  while(first < n && side_of_apex_line(windows[first], windows[first].end, apex_point) < 0.)
    ++first;
  while(last > first &&
        side_of_apex_line(windows[last - 1], windows[last - 1].begin, apex_point) > 0.)
    --last;
  // The one that is nearest to the apex, also by a bend at one of its ends.
  double best_distance = infinity, nearest_position = 0.;
  std::size_t nearest_window = n;
  Vec2 nearest_direction = {1., 0.};
  const auto offer_to_apex =
      [&](const Window& w, double distance, double position, const Vec2& to_source)
  {
    const double size = norm(to_source);
    const Vec2 direction =
        size > 0. ? rotated_back((1. / size) * to_source, (-1. / left_length) * apex_point)
                  : Vec2{1., 0.};
    // A bend at an end of the side is one at the site there.
    Index origin = w.origin;
    if(to_source[1] == -apex_point[1] && position <= merge_tolerance * base)
      origin = t.corner[h];
    else if(to_source[1] == -apex_point[1] && position >= base * (1. - merge_tolerance))
      origin = t.corner[next];
    relax(t.corner[previous], {distance, direction, previous, origin},
          origin < m_vertices.size() ? m_vertices[origin].source
                                     : m_source_pieces[origin - m_vertices.size()].source);
  };
  for(std::size_t i = first - (first > 0); i < last + (last < n); ++i)
  {
    const Window& w = windows[i];
    const double at_begin = side_of_apex_line(w, w.begin, apex_point),
                 at_end = side_of_apex_line(w, w.end, apex_point);
    double distance, position;
    Vec2 to_source;
    if(at_begin <= 0. && at_end >= 0.)
    {
      to_source = w.weight == 0.f ? w.source : w.source - apex_point;
      distance = w.offset + (w.weight == 0.f ? -dot(to_source, apex_point) : norm(to_source));
      position = at_end > at_begin ? w.begin + (w.end - w.begin) * (-at_begin / (at_end - at_begin))
                                   : w.begin;
    }
    else
    {
      position = at_begin > 0. ? w.begin : w.end;
      to_source = Vec2{position, 0.} - apex_point;
      distance = w.distance(position) + norm(to_source);
    }
    if(m_collects_all && left_length > 0.)
      offer_to_apex(w, distance, position, to_source);
    if(distance < best_distance)
    {
      best_distance = distance;
      nearest_window = i;
      nearest_position = position;
      nearest_direction = to_source;
    }
  }
  if(nearest_window == n)
    return;
  if(best_distance < m_vertices[t.corner[previous]].distance && left_length > 0.)
    offer_to_apex(windows[nearest_window], best_distance, nearest_position, nearest_direction);

  if(m_forward)
    meet_sources_behind(h);

  // Lines that cross the nearest one's to the apex are not shortest behind it.
  if(t.twin[previous] != none && left_length > 0. && last > 0)
  {
    Window_list list = allocate(last);
    Window* next_window = m_pool.data() + list.position;
    const Vec2 axis = (1. / left_length) * apex_point;
    for(std::size_t i = 0; i < last; ++i)
    {
      const Window& w = windows[i];
      const double at_begin = side_of_apex_line(w, w.begin, apex_point),
                   at_end = side_of_apex_line(w, w.end, apex_point);
      if(at_begin < 0. && !(i > nearest_window && w.begin >= nearest_position))
        *next_window++ = clip_through_left(w, at_begin, at_end, axis, left_length);
    }
    list.size = Index(next_window - (m_pool.data() + list.position));
    enqueue(t.twin[previous], 0, list);
  }
  if(t.twin[next] != none && right_length > 0. && first < n)
  {
    Window_list list = allocate(n - first);
    Window* next_window = m_pool.data() + list.position;
    const Vec2 axis = (1. / right_length) * Vec2{base - apex_point[0], apex_point[1]};
    for(std::size_t i = first; i < n; ++i)
    {
      const Window& w = windows[i];
      const double at_begin = side_of_apex_line(w, w.begin, apex_point),
                   at_end = side_of_apex_line(w, w.end, apex_point);
      if(at_end > 0. && !(i < nearest_window && w.end <= nearest_position))
        *next_window++ =
            mirror(clip_through_left(mirror(w, base), -at_end, -at_begin, axis, right_length),
                   right_length);
    }
    list.size = Index(next_window - (m_pool.data() + list.position));
    enqueue(t.twin[next], 1, list);
  }
}

Window_propagation::Window_list Window_propagation::allocate(std::size_t size)
{
  Window_list result;
  while((std::size_t(1) << result.capacity_log2) < size)
    ++result.capacity_log2;
  std::vector<Index>& free_list = m_free_lists[result.capacity_log2];
  if(free_list.empty())
  {
    result.position = Index(m_pool.size());
    m_pool.resize(m_pool.size() + (std::size_t(1) << result.capacity_log2));
  }
  else
  {
    result.position = free_list.back();
    free_list.pop_back();
  }
  // Whether it is in use is seen from its size.
  result.size = 1;
  return result;
}

void Window_propagation::release(Window_list& list)
{
  if(list.size > 0)
    m_free_lists[list.capacity_log2].push_back(list.position);
  list = Window_list{};
}

// Lets windows wait at a side.
void Window_propagation::enqueue(Index h, int list_index, Window_list list)
{
  const Surface_arrays& t = *m_triangles;
  if(list.size == 0)
  {
    list.size = 1;
    return release(list);
  }
  Window_list& waiting = m_waiting[2 * std::size_t(h) + list_index];
  if(waiting.size > 0)
  {
    Window_list merged = allocate(waiting.size + list.size);
    const auto begin = m_pool.begin();
    std::merge(begin + waiting.position, begin + waiting.position + waiting.size,
               begin + list.position, begin + list.position + list.size, begin + merged.position,
               [](const Window& a, const Window& b) { return a.begin + a.end < b.begin + b.end; });
    merged.size = waiting.size + list.size;
    release(waiting);
    release(list);
    list = merged;
  }
  waiting = list;
  m_queue.push(h, std::min(m_vertices[t.corner[h]].distance,
                           m_vertices[t.corner[next_halfedge(h)]].distance));
}

void Window_propagation::enqueue(Index h, const Window& window)
{
  if(h == none)
    return;
  const Window_list list = allocate(1);
  m_pool[list.position] = window;
  enqueue(h, 0, list);
}

Index Window_propagation::predecessor(Index v) const
{
  const Surface_arrays& t = *m_triangles;
  const Vertex_data& vertex = m_vertices[v];
  if(vertex.corner == none)
    return none;
  const Index next = t.corner[next_halfedge(vertex.corner)],
              previous = t.corner[previous_halfedge(vertex.corner)];
  // The side nearer to the source's direction, if its far end is nearer at all.
  const Vec2 direction_from_next = rotated_back(corner_angle(t, vertex.corner), vertex.direction);
  const bool is_next = vertex.direction[0] >= direction_from_next[0];
  for(const Index candidate : {is_next ? next : previous, is_next ? previous : next})
    if(m_vertices[candidate].distance < vertex.distance &&
       m_vertices[candidate].source == vertex.source)
      return candidate;
  return none;
}

} // namespace CGAL::Geodesic_processing::internal
