// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances/Second_path_search.h"

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"
#include "distances/directions.h"
#include "distances/window_operations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr std::size_t max_nodes = std::size_t(1) << 20;
// A line that misses a window by this fraction of its edge, or a direction by this angle, passes
// it: paths through vertices must not be lost between the windows on their two sides.
constexpr double visibility_tolerance = 1e-9;

// The directions of a fan of corners that continue a path, as intervals of polar angles.
using Direction_intervals = std::array<std::pair<double, double>, 2>;

bool contains(const Direction_intervals& intervals, double angle)
{
  return std::any_of(intervals.begin(), intervals.end(),
                     [&](const std::pair<double, double>& interval)
                     {
                       return angle >= interval.first - visibility_tolerance &&
                              angle <= interval.second + visibility_tolerance;
                     });
}

// Returns whether the line from the source of a window to a point above its edge crosses the
// window.
bool is_visible(const Window& w, const Vec2& point, double edge_length)
{
  const double height = point[1] - w.source[1];
  if(!(height > 0.))
    return false;
  const double crossing = w.source[0] - (point[0] - w.source[0]) * w.source[1] / height;
  const double tolerance = visibility_tolerance * edge_length;
  return crossing >= w.begin - tolerance && crossing <= w.end + tolerance;
}

} // namespace

Second_path_search::Second_path_search(std::shared_ptr<const Surface_arrays> triangles,
                                       std::shared_ptr<const std::vector<bool>> is_pseudo_source,
                                       const Surface_location& from, const Surface_location& to,
                                       Lower_bound lower_bound, double max_length)
    : m_triangles(std::move(triangles)), m_is_pseudo_source(std::move(is_pseudo_source)),
      m_from(from), m_to(to), m_end_vertex(vertex_of(*m_triangles, to)),
      m_lower_bound(std::move(lower_bound)), m_max_length(max_length)
{}

bool Second_path_search::has_path_other_than(const std::vector<Surface_location>& path)
{
  const Surface_arrays& t = *m_triangles;
  m_strip.clear();
  for(std::size_t i = 1; i + 1 < path.size(); ++i)
    if(const Index vertex = vertex_of(t, path[i]); vertex != none)
      m_strip.push_back(Index(t.corner.size() + vertex));
    else if(const Index h = halfedge_of(path[i]); h != none)
      m_strip.push_back(std::min(h, t.twin[h]));
  m_nodes.clear();
  m_is_found = false;
  start();
  for(std::size_t i = 0; i < m_nodes.size() && !m_is_found; ++i)
  {
    if(m_nodes.size() > max_nodes)
      return true;
    if(m_nodes[i].halfedge != none)
      cross_triangle(Index(i));
    else
      leave_vertex(Index(i), m_nodes[i].arrival.origin, Window_arrival(m_nodes[i].arrival));
  }
  return m_is_found;
}

// Returns the edge that a window crosses, or #halfedges + the vertex of an arrival.
Index Second_path_search::strip_element(const Node& node) const
{
  return node.halfedge != none ? std::min(node.halfedge, m_triangles->twin[node.halfedge])
                               : Index(m_triangles->corner.size() + node.arrival.origin);
}

// Compares a path that reaches the end with the first one.
void Second_path_search::report(Index node, double length)
{
  if(length > m_max_length)
    return;
  auto element = m_strip.rbegin();
  for(; node != none && element != m_strip.rend() && strip_element(m_nodes[node]) == *element;
      ++element)
    node = m_nodes[node].parent;
  m_is_found = m_is_found || node != none || element != m_strip.rend();
}

void Second_path_search::start()
{
  const Index vertex = vertex_of(*m_triangles, m_from);
  if(vertex != none)
    return leave_vertex(none, vertex, {0., {1., 0.}, none, vertex});
  for(const Index triangle : triangles_at(*m_triangles, m_from))
    leave_triangle(triangle);
}

// Starts at a location that is not a vertex, through one of its triangles.
void Second_path_search::leave_triangle(Index triangle)
{
  const Surface_arrays& t = *m_triangles;
  const auto barycentric = *barycentric_in(t, triangle, m_from);
  const auto corners = unfolded(t, triangle);
  const Vec2 p = unfolded_point(corners, barycentric);
  if(const auto end = barycentric_in(t, triangle, m_to); end && m_end_vertex == none)
    report(none, norm(unfolded_point(corners, *end) - p));
  for(Index k = 0; k < 3; ++k)
  {
    const Index h = 3 * triangle + k;
    const Vec2 axis = edge_direction(corners, h), to_point = p - corners[k];
    const double distance = norm(to_point);
    const Vec2 local = rotated_back(to_point, axis);
    visit_vertex(none, t.corner[h], {distance, (1. / distance) * local, h, t.corner[h]});
    if(barycentric[(k + 2) % 3] > 0.)
      emit_window(none, h, local, 0., 0., t.length[h]);
  }
}

// Enqueues the window of a point of the triangle of h, given in the coordinates of h, between two
// positions on h.
void Second_path_search::emit_window(Index parent, Index h, const Vec2& position, double offset,
                                     double begin, double end)
{
  const double length = m_triangles->length[h];
  if(m_triangles->twin[h] != none)
    push_window(parent, m_triangles->twin[h],
                {{length - position[0], std::min(0., -position[1])},
                 offset,
                 length - end,
                 length - begin,
                 none,
                 0.f});
}

void Second_path_search::push_window(Index parent, Index h, const Window& w)
{
  const Surface_arrays& t = *m_triangles;
  const double length = t.length[h];
  // The distance plus the lower bound by an end of the edge is monotonic along the edge.
  if(w.end - w.begin > merge_tolerance * length &&
     w.distance(w.end) - w.end + m_lower_bound(t.corner[h]) <= m_max_length &&
     w.distance(w.begin) - (length - w.begin) + m_lower_bound(t.corner[next_halfedge(h)]) <=
         m_max_length)
    m_nodes.push_back({parent, h, w, {}});
}

void Second_path_search::cross_triangle(Index node)
{
  const Surface_arrays& t = *m_triangles;
  const Index h = m_nodes[node].halfedge, left = previous_halfedge(h), right = next_halfedge(h);
  const Window w = m_nodes[node].window;
  const double base = t.length[h];
  const Vec2 apex_point = apex(t, h);
  // An end on h has been found in the triangle before.
  if(const auto end = barycentric_in(t, h / 3, m_to);
     end && m_end_vertex == none && (*end)[left % 3] > 0.)
  {
    const Vec2 point = (*end)[right % 3] * Vec2{base, 0.} + (*end)[left % 3] * apex_point;
    if(is_visible(w, point, base))
      report(node, w.offset + norm(point - w.source));
  }
  if(is_visible(w, apex_point, base))
  {
    const Vec2 to_source = w.source - apex_point;
    const double distance = norm(to_source);
    visit_vertex(node, t.corner[left],
                 {w.offset + distance,
                  rotated_back((1. / distance) * to_source, (-1. / t.length[left]) * apex_point),
                  left, t.corner[left]});
  }
  const double at_begin = side_of_apex_line(w, w.begin, apex_point),
               at_end = side_of_apex_line(w, w.end, apex_point);
  if(at_begin < 0. && t.twin[left] != none)
    push_window(
        node, t.twin[left],
        clip_through_left(w, at_begin, at_end, (1. / t.length[left]) * apex_point, t.length[left]));
  if(at_end > 0. && t.twin[right] != none)
  {
    const Vec2 axis = (1. / t.length[right]) * Vec2{base - apex_point[0], apex_point[1]};
    push_window(
        node, t.twin[right],
        mirror(clip_through_left(mirror(w, base), -at_end, -at_begin, axis, t.length[right]),
               t.length[right]));
  }
}

void Second_path_search::visit_vertex(Index parent, Index vertex, const Window_arrival& arrival)
{
  if(vertex == m_end_vertex)
    report(parent, arrival.distance);
  else if((*m_is_pseudo_source)[vertex] && arrival.distance + m_lower_bound(vertex) <= m_max_length)
    m_nodes.push_back({parent, none, {}, arrival});
}

// Leaves a vertex in all directions whose angles to the line of arrival are at least pi. If the
// arrival has no corner, the path starts here.
void Second_path_search::leave_vertex(Index node, Index vertex, const Window_arrival& arrival)
{
  const Surface_arrays& t = *m_triangles;
  const Index ring_end = t.ring_begin[vertex + 1];
  for(Index begin = t.ring_begin[vertex], end; begin < ring_end; begin = end)
  {
    // One fan of the vertex.
    double total_angle = 0., arrival_angle = -1.;
    for(end = begin;
        end == begin || (end < ring_end && t.ring[end] == next_corner_ccw(t, t.ring[end - 1]));
        ++end)
    {
      if(t.ring[end] == arrival.corner)
        arrival_angle =
            total_angle + std::atan2(std::max(0., arrival.direction[1]), arrival.direction[0]);
      total_angle += interior_angle(t, t.ring[end]);
    }
    const bool is_closed = next_corner_ccw(t, t.ring[end - 1]) == t.ring[begin];
    Direction_intervals allowed = {std::pair(-infinity, infinity), std::pair(infinity, -infinity)};
    if(arrival_angle >= 0.)
      allowed = {
          std::pair(arrival_angle + pi, is_closed ? arrival_angle - pi + total_angle : infinity),
          std::pair(is_closed ? arrival_angle + pi - total_angle : -infinity, arrival_angle - pi)};
    double angle = 0.;
    for(Index i = begin; i < end; ++i)
    {
      const Index corner = t.ring[i], opposite = next_halfedge(corner),
                  previous = previous_halfedge(corner);
      const double width = interior_angle(t, corner);
      if(contains(allowed, angle))
        visit_vertex(node, t.corner[opposite],
                     {arrival.distance + t.length[corner], corner_angle(t, opposite), opposite,
                      t.corner[opposite]});
      if(!is_closed && i + 1 == end && contains(allowed, angle + width))
        visit_vertex(
            node, t.corner[previous],
            {arrival.distance + t.length[previous], {1., 0.}, previous, t.corner[previous]});
      if(const auto barycentric = barycentric_in(t, corner / 3, m_to);
         barycentric && m_end_vertex == none)
      {
        const auto corners = unfolded(t, corner / 3);
        const Vec2 to_end =
            rotated_back(unfolded_point(corners, *barycentric) - corners[corner % 3],
                         edge_direction(corners, corner));
        if(contains(allowed, angle + std::atan2(std::max(0., to_end[1]), to_end[0])))
          report(node, arrival.distance + norm(to_end));
      }
      for(const auto& [first, last] : allowed)
      {
        const double from = std::max(first - angle, 0.), to = std::min(last - angle, width);
        if(!(from < to))
          continue;
        // Returns where a direction crosses the opposite edge.
        const auto crossing = [&](double direction)
        {
          const double near_right = t.length[corner] * std::sin(direction),
                       near_left = t.length[previous] * std::sin(width - direction);
          return t.length[opposite] * near_right / (near_right + near_left);
        };
        emit_window(node, opposite,
                    third_corner(t.length[opposite], t.length[corner], t.length[previous]),
                    arrival.distance, from > 0. ? crossing(from) : 0.,
                    to < width ? crossing(to) : t.length[opposite]);
      }
      angle += width;
    }
  }
}

} // namespace CGAL::Geodesic_processing::internal
