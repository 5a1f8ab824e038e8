// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Path_finder.h>

#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/edges.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

Path_finder::Path_finder(std::shared_ptr<const Surface_arrays> triangles)
    : m_triangles(std::move(triangles)), m_vertices(m_triangles->number_of_vertices()),
      m_queue(m_triangles->number_of_vertices())
{
  if(!m_triangles->is_cloud())
    m_shortcuts.resize(m_triangles->corner.size());
}

// ------------------------------------------------------------------------------------ shortcuts

namespace {

// Returns whether the line from p to q has the point `right` strictly on its right and the point
// `left` strictly on its left.
bool passes_between(const Vec2& p, const Vec2& q, const Vec2& right, const Vec2& left)
{
  return cross(q - p, right - p) < 0. && cross(q - p, left - p) > 0.;
}

// Unfolds the triangle of a halfedge across its edge. Returns the position of the corner opposite
// to the halfedge.
//
// left, right  positions of the edge's endpoints, seen from the adjacent triangle
// base         length of the edge; positive
Vec2 unfolded_apex(const Surface_arrays& t, Index h, const Vec2& left, const Vec2& right,
                   double base)
{
  const Vec2 local = third_corner(base, t.length[previous_halfedge(h)], t.length[next_halfedge(h)]);
  const Vec2 direction = (1. / base) * (right - left);
  return left + local[0] * direction + local[1] * rotated_left(direction);
}

} // namespace

const Path_finder::Shortcuts& Path_finder::shortcuts(Index corner)
{
  Shortcuts& shortcuts = m_shortcuts[corner];
  if(shortcuts.across >= 0.f)
    return shortcuts;
  const Surface_arrays& t = *m_triangles;
  constexpr float unreachable = std::numeric_limits<float>::infinity();
  shortcuts = {unreachable, unreachable, unreachable};
  const Index h = next_halfedge(corner), twin = t.twin[h];
  if(twin == none)
    return shortcuts;

  // The opposite edge lies on the first axis. Its left endpoint, seen from the corner, is the
  // origin.
  const double base = t.length[h];
  const Vec2 left = {0., 0.}, right = {base, 0.};
  Vec2 start = third_corner(base, t.length[previous_halfedge(corner)], t.length[corner]);
  start[1] = -start[1];
  const double to_left = t.length[previous_halfedge(twin)],
               to_right = t.length[next_halfedge(twin)];
  const Vec2 opposite = third_corner(base, to_left, to_right);
  if(passes_between(start, opposite, right, left))
    shortcuts.across = static_cast<float>(norm(opposite - start));

  const auto length_beyond = [&](Index exit, const Vec2& exit_left, const Vec2& exit_right)
  {
    const Index twin_of_exit = t.twin[exit];
    const double length = t.length[exit];
    if(twin_of_exit == none || !(length > 0.))
      return unreachable;
    const Vec2 end = unfolded_apex(t, twin_of_exit, exit_left, exit_right, length);
    return passes_between(start, end, right, left) &&
                   passes_between(start, end, exit_right, exit_left)
               ? static_cast<float>(norm(end - start))
               : unreachable;
  };
  shortcuts.to_right = length_beyond(next_halfedge(twin), opposite, right);
  shortcuts.to_left = length_beyond(previous_halfedge(twin), left, opposite);
  return shortcuts;
}

// Calls f(target vertex, length, predecessor, type of step) for each step from a vertex.
template <typename Function>
void Path_finder::for_each_step(Index vertex, Function f)
{
  const Surface_arrays& t = *m_triangles;
  if(t.is_cloud())
  {
    for(Index edge = t.graph.begin[vertex]; edge < t.graph.begin[vertex + 1]; ++edge)
      f(t.graph.target[edge], graph_edge_length(t, vertex, edge), vertex, Step::edge);
    return;
  }
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index corner = t.ring[i], h = next_halfedge(corner), previous = previous_halfedge(corner);
    f(t.corner[h], t.length[corner], corner, Step::edge);
    if(t.twin[previous] == none)
      f(t.corner[previous], t.length[previous], corner, Step::edge);
    const Index twin = t.twin[h];
    if(twin == none)
      continue;
    const Shortcuts& shortcut = shortcuts(corner);
    if(std::isfinite(shortcut.across))
      f(t.corner[previous_halfedge(twin)], shortcut.across, corner, Step::across);
    if(std::isfinite(shortcut.to_right))
      f(t.corner[previous_halfedge(t.twin[next_halfedge(twin)])], shortcut.to_right, corner,
        Step::to_right);
    if(std::isfinite(shortcut.to_left))
      f(t.corner[previous_halfedge(t.twin[previous_halfedge(twin)])], shortcut.to_left, corner,
        Step::to_left);
  }
}

// Returns the links of a location. A vertex is linked to itself. Any other location is linked to
// the corners of its triangles. It is also linked across each of their edges to the opposite
// vertex, if the segment stays in both triangles.
std::vector<Path_finder::Link> Path_finder::links(const Surface_location& location) const
{
  const Surface_arrays& t = *m_triangles;
  const Index vertex = vertex_of(t, location);
  if(vertex != none)
    return {{vertex, 0., {}}};
  std::vector<Link> result;
  std::array<Index, 2> triangles = {location.triangle, none};
  if(const Index h = halfedge_of(location); !t.is_cloud() && h != none && t.twin[h] != none)
    triangles[1] = t.twin[h] / 3;
  for(const Index triangle : triangles)
  {
    if(triangle == none)
      break;
    const auto barycentric = *barycentric_in(t, triangle, location);
    const auto corners = unfolded(t, triangle);
    const Vec2 x = unfolded_point(corners, barycentric);
    for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
    {
      result.push_back({t.corner[h], norm(corners[h % 3] - x), {}});
      if(t.is_cloud() || t.twin[h] == none || barycentric[previous_halfedge(h) % 3] == 0.)
        continue;
      // Seen from inside the triangle, a halfedge starts at the right end of its edge.
      const Index twin = t.twin[h];
      const Vec2 right = corners[h % 3], left = corners[next_halfedge(h) % 3];
      const double base = t.length[h];
      if(!(base > 0.))
        continue;
      const Vec2 target = unfolded_apex(t, twin, left, right, base);
      if(!passes_between(x, target, right, left))
        continue;
      const double right_area = -cross(target - x, right - x),
                   left_area = cross(target - x, left - x);
      Link link = {t.corner[previous_halfedge(twin)], norm(target - x), {}};
      link.crossing.triangle = triangle;
      link.crossing.barycentric = barycentric_on_halfedge(h, right_area / (right_area + left_area));
      link.crossing = canonical(t, link.crossing);
      result.push_back(link);
    }
  }
  return result;
}

// --------------------------------------------------------------------------------------- search

double Path_finder::heuristic(Index vertex) const
{
  if(!m_uses_heuristic)
    return 0.;
  double result = 0.;
  if(!m_triangles->point.empty())
  {
    const auto& p = m_triangles->point[vertex];
    const double x = p[0] - m_goal_point[0], y = p[1] - m_goal_point[1], z = p[2] - m_goal_point[2];
    result = std::sqrt(x * x + y * y + z * z);
  }
  for(unsigned i = 0; i < m_number_of_landmarks; ++i)
  {
    // Comparisons with NaN are false: unreachable landmarks do not change the bound.
    const double distance = m_landmarks[std::size_t(vertex) * m_number_of_landmarks + i];
    if(distance - m_goal_distance_range[i][1] > result)
      result = distance - m_goal_distance_range[i][1];
    if(m_goal_distance_range[i][0] - distance > result)
      result = m_goal_distance_range[i][0] - distance;
  }
  return result;
}

void Path_finder::relax(Index index, double distance, Index from, Step step)
{
  Vertex& vertex = m_vertices[index];
  if(vertex.stamp < m_stamp)
  {
    vertex.stamp = m_stamp;
    vertex.distance = infinity;
    vertex.heuristic = heuristic(index);
    vertex.goal_link = none;
  }
  if(vertex.stamp == m_stamp && distance < vertex.distance)
  {
    vertex.distance = distance;
    vertex.predecessor = from;
    vertex.step = step;
    m_queue.push(index, distance + vertex.heuristic);
  }
}

void Path_finder::expand(Index index)
{
  Vertex& vertex = m_vertices[index];
  vertex.stamp = m_stamp + 1;
  ++m_number_of_visited_vertices;
  const double distance = vertex.distance;
  for_each_step(index, [&](Index target, double length, Index from, Step step)
                { relax(target, distance + length, from, step); });
}

void Path_finder::compute_all_distances(Index begin, std::vector<double>& distance)
{
  m_stamp += 2;
  m_uses_heuristic = false;
  relax(begin, 0., none, Step::start);
  while(!m_queue.empty())
    expand(m_queue.pop().vertex);
  distance.resize(m_vertices.size());
  for(std::size_t s = 0; s < m_vertices.size(); ++s)
    distance[s] = m_vertices[s].stamp > m_stamp ? m_vertices[s].distance : infinity;
}

void Path_finder::add_landmarks(unsigned number_of_landmarks)
{
  const std::size_t n = m_vertices.size();
  if(n == 0 || number_of_landmarks == 0)
    return;
  // Each landmark is the vertex farthest from all previous ones. The first is farthest from vertex
  // 0.
  std::vector<double> distance_to_nearest(n, infinity), distance;
  const std::size_t old_number = m_number_of_landmarks,
                    new_number = old_number + number_of_landmarks;
  if(old_number == 0)
    compute_all_distances(0, distance_to_nearest);
  std::vector<float> landmarks(n * new_number);
  for(std::size_t s = 0; s < n; ++s)
    for(std::size_t i = 0; i < old_number; ++i)
    {
      const double known_distance = m_landmarks[s * old_number + i];
      landmarks[s * new_number + i] = m_landmarks[s * old_number + i];
      if(known_distance < distance_to_nearest[s]) // false for NaN
        distance_to_nearest[s] = known_distance;
    }
  for(std::size_t i = old_number; i < new_number; ++i)
  {
    const auto farthest = std::max_element(distance_to_nearest.begin(), distance_to_nearest.end());
    compute_all_distances(static_cast<Index>(farthest - distance_to_nearest.begin()), distance);
    for(std::size_t s = 0; s < n; ++s)
    {
      landmarks[s * new_number + i] = std::isfinite(distance[s])
                                          ? static_cast<float>(distance[s])
                                          : std::numeric_limits<float>::quiet_NaN();
      distance_to_nearest[s] = i == 0 ? distance[s] : std::min(distance_to_nearest[s], distance[s]);
    }
  }
  m_landmarks = std::move(landmarks);
  m_number_of_landmarks = static_cast<unsigned>(new_number);
}

// --------------------------------------------------------------------------------------- queries

void Path_finder::set_goal(const Surface_location& to, const std::vector<Link>& goal_links)
{
  const Surface_arrays& t = *m_triangles;
  m_uses_heuristic = true;
  if(!t.point.empty())
  {
    m_goal_point = {0., 0., 0.};
    if(to.triangle == none)
      m_goal_point = t.point[to.vertex];
    else
      for(Index k = 0; k < 3; ++k)
        for(int axis = 0; axis < 3; ++axis)
          m_goal_point[axis] += to.barycentric[k] * t.point[t.corner[3 * to.triangle + k]][axis];
  }
  m_goal_distance_range.assign(m_number_of_landmarks, {0., infinity});
  for(unsigned i = 0; i < m_number_of_landmarks; ++i)
    for(const Link& end : goal_links)
    {
      const double distance = m_landmarks[std::size_t(end.vertex) * m_number_of_landmarks + i];
      m_goal_distance_range[i][0] = std::max(m_goal_distance_range[i][0], distance - end.length);
      m_goal_distance_range[i][1] = std::min(m_goal_distance_range[i][1], distance + end.length);
    }

  for(const Link& end : goal_links)
    relax(end.vertex, infinity, none, Step::start);
  for(Index i = 0; i < goal_links.size(); ++i)
  {
    Index& goal_link = m_vertices[goal_links[i].vertex].goal_link;
    if(goal_link == none || goal_links[i].length < goal_links[goal_link].length)
      goal_link = i;
  }
}

Index Path_finder::search(const std::vector<Link>& start_links, const std::vector<Link>& goal_links)
{
  for(Index i = 0; i < start_links.size(); ++i)
    relax(start_links[i].vertex, start_links[i].length, i, Step::start);

  double best_length = infinity;
  Index last_vertex = none;
  while(!m_queue.empty() && m_queue.front().key < best_length)
  {
    const Index vertex = m_queue.pop().vertex;
    expand(vertex);
    const Index goal_link = m_vertices[vertex].goal_link;
    if(goal_link != none &&
       m_vertices[vertex].distance + goal_links[goal_link].length < best_length)
    {
      best_length = m_vertices[vertex].distance + goal_links[goal_link].length;
      last_vertex = vertex;
    }
  }
  m_queue.clear();
  return last_vertex;
}

void Path_finder::append_location(std::vector<Surface_location>& path,
                                  const Surface_location& location) const
{
  const Surface_arrays& t = *m_triangles;
  if(path.empty() || t.is_cloud() || !is_same_point(t, path.back(), location))
    path.push_back(location);
}

Index Path_finder::append_predecessors(std::vector<Surface_location>& path, Index vertex) const
{
  const Surface_arrays& t = *m_triangles;
  while(m_vertices[vertex].step != Step::start)
  {
    const Vertex& current = m_vertices[vertex];
    const Index corner = current.predecessor;
    const auto add_edge_midpoint = [&](Index h)
    {
      Surface_location location;
      location.triangle = h / 3;
      location.barycentric = barycentric_on_halfedge(h, 0.5);
      append_location(path, location);
    };
    // Midpoints suffice: only the crossed edges matter, because shorten_geodesic() moves the
    // points.
    if(current.step == Step::to_right)
      add_edge_midpoint(next_halfedge(t.twin[next_halfedge(corner)]));
    if(current.step == Step::to_left)
      add_edge_midpoint(previous_halfedge(t.twin[next_halfedge(corner)]));
    if(current.step != Step::edge)
      add_edge_midpoint(next_halfedge(corner));
    vertex = t.is_cloud() ? current.predecessor : t.corner[corner];
    append_location(path, vertex_location(t, vertex));
  }
  return vertex;
}

std::vector<Surface_location> Path_finder::operator()(const Surface_location& input_from,
                                                      const Surface_location& input_to)
{
  const Surface_arrays& t = *m_triangles;
  const Surface_location from = canonical(t, input_from), to = canonical(t, input_to);
  m_number_of_visited_vertices = 0;
  const Index from_vertex = vertex_of(t, from), to_vertex = vertex_of(t, to);
  const bool is_same =
      t.is_cloud() ? from_vertex == to_vertex &&
                         (from_vertex != none ||
                          (from.triangle == to.triangle && from.barycentric == to.barycentric))
                   : is_same_point(t, from, to);
  if(is_same)
    return {from};
  if(from.triangle != none && to.triangle != none &&
     (t.is_cloud() ? from.triangle == to.triangle : common_triangle(t, from, to) != none))
    return {from, to};

  m_stamp += 2;
  m_queue.clear();
  const std::vector<Link> start_links = links(from), goal_links = links(to);
  set_goal(to, goal_links);
  const Index last_vertex = search(start_links, goal_links);
  if(last_vertex == none)
    return {};

  // The path is collected from the goal back to the start.
  std::vector<Surface_location> path = {to};
  const Link& end = goal_links[m_vertices[last_vertex].goal_link];
  if(end.crossing.triangle != none)
    append_location(path, end.crossing);
  if(to_vertex == none)
    append_location(path, vertex_location(t, last_vertex));
  const Index first_vertex = append_predecessors(path, last_vertex);
  const Link& begin = start_links[m_vertices[first_vertex].predecessor];
  if(begin.crossing.triangle != none)
    append_location(path, begin.crossing);
  if(from_vertex == none)
    append_location(path, from);
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace CGAL::Geodesic_processing::internal
