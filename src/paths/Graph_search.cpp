// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/paths/Graph_search.h>

#include <algorithm>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sums of the same lengths in another order differ by round-off errors. This factor keeps the
// heuristic a lower bound.
constexpr double round_off_factor = 1. - 1e-14;

// Coarse paths zigzag between leaders and are longer than the Euclidean distance. With a heuristic
// 1.1 times as large, a search visits half as many regions, and on spheres and tori the paths are
// equally short.
constexpr double coarse_heuristic_factor = 1.1;

// If the coarse path has at most this number of regions, the search is not restricted.
constexpr std::size_t min_corridor_length = 16;

// If the coarse path has more than `min_guided_length` regions, visiting the whole corridor takes
// longer than shortening the resulting path. The search is then guided from each region to the
// leader that is `look_ahead` regions ahead on the coarse path. With distances scaled by
// `guidance_factor`, it visits a third of the vertices.
constexpr std::size_t min_guided_length = 40, look_ahead = 8;
constexpr double guidance_factor = 1.1;

} // namespace

Graph_search::Graph_search(const Proximity_graph& graph, const std::vector<Vec3>& point,
                           const Vertex_regions* regions)
    : m_graph(&graph), m_point(&point), m_regions(regions), m_heuristic_factor(round_off_factor)
{
  if(regions == nullptr)
    return;
  m_coarse_search.emplace_back(regions->graph, regions->point);
  m_coarse_search[0].m_heuristic_factor = coarse_heuristic_factor;
  m_corridor_stamp.resize(regions->size(), 0);
  m_waypoint_ahead.resize(regions->size(), 0);
}

void Graph_search::initialize(Frontier& frontier, Index vertex, const Vec3* goal)
{
  if(frontier.vertices.empty())
  {
    frontier.vertices.resize(m_point->size());
    frontier.queue = Vertex_queue(m_point->size());
  }
  frontier.queue.clear();
  frontier.goal = goal;
  relax(frontier, vertex, 0., none);
}

void Graph_search::relax(Frontier& frontier, Index index, double distance, Index from)
{
  Vertex& vertex = frontier.vertices[index];
  if(vertex.stamp < m_stamp)
  {
    if(m_is_restricted && m_corridor_stamp[m_regions->region[index]] != m_stamp)
      return;
    vertex = {infinity, none, m_stamp};
  }
  if(vertex.stamp > m_stamp || !(distance < vertex.distance))
    return;
  vertex.distance = distance;
  vertex.predecessor = from;
  frontier.queue.push(index, distance + heuristic(frontier, index));
}

Index Graph_search::expand(Frontier& frontier)
{
  const Index index = frontier.queue.pop().vertex;
  Vertex& vertex = frontier.vertices[index];
  vertex.stamp = m_stamp + 1;
  ++m_number_of_visited_vertices;
  const std::vector<Vec3>& point = *m_point;
  for(Index e = m_graph->begin[index]; e < m_graph->begin[index + 1]; ++e)
  {
    const Index neighbor = m_graph->target[e];
    const double length =
        m_graph->length.empty() ? norm(point[neighbor] - point[index]) : m_graph->length[e];
    relax(frontier, neighbor, vertex.distance + length, index);
  }
  return index;
}

// Computes the waypoints of a search that is guided along a coarse path.
void Graph_search::set_waypoints(const std::vector<Index>& coarse_path, Index to)
{
  const Proximity_graph& graph = m_regions->graph;
  const std::size_t n = coarse_path.size();
  m_waypoints.clear();
  for(const Index region : coarse_path)
    m_waypoints.push_back(m_regions->point[region]);
  m_waypoints.resize(n + look_ahead, (*m_point)[to]);
  m_remaining_length.assign(n + look_ahead, 0.);
  for(std::size_t i = n; i-- > 0;)
    m_remaining_length[i] =
        m_remaining_length[i + look_ahead] + norm(m_waypoints[i + look_ahead] - m_waypoints[i]);
  // A region next to several regions of the path is guided by the last of them. Regions on the
  // path override this.
  for(Index i = 0; i < n; ++i)
    for(Index e = graph.begin[coarse_path[i]]; e < graph.begin[coarse_path[i] + 1]; ++e)
      m_waypoint_ahead[graph.target[e]] = i + look_ahead;
  for(Index i = 0; i < n; ++i)
    m_waypoint_ahead[coarse_path[i]] = i + look_ahead;
}

// Returns the estimated distance from a vertex to the goal, or zero if there is no goal.
double Graph_search::heuristic(const Frontier& frontier, Index vertex) const
{
  if(frontier.goal == nullptr)
    return 0.;
  const Vec3& point = (*m_point)[vertex];
  if(!m_is_guided)
    return m_heuristic_factor * norm(point - *frontier.goal);
  const Index waypoint = m_waypoint_ahead[m_regions->region[vertex]];
  return guidance_factor * (norm(point - m_waypoints[waypoint]) + m_remaining_length[waypoint]);
}

// Restricts the search to the regions of a coarse path and their neighbors, if that path is long
// enough. Returns false if there is no coarse path.
bool Graph_search::restrict_to_corridor(Index from, Index to)
{
  const Proximity_graph& graph = m_regions->graph;
  const std::vector<Index> coarse_path =
      m_coarse_search[0](m_regions->region[from], m_regions->region[to], Surfel_search::a_star);
  m_number_of_visited_vertices = m_coarse_search[0].number_of_visited_vertices();
  m_is_restricted = coarse_path.size() > min_corridor_length;
  if(m_is_restricted)
    for(const Index region : coarse_path)
    {
      m_corridor_stamp[region] = m_stamp;
      for(Index e = graph.begin[region]; e < graph.begin[region + 1]; ++e)
        m_corridor_stamp[graph.target[e]] = m_stamp;
    }
  m_is_guided = coarse_path.size() > min_guided_length;
  if(m_is_guided)
    set_waypoints(coarse_path, to);
  return !coarse_path.empty();
}

std::vector<Index> Graph_search::operator()(Index from, Index to, Surfel_search method)
{
  m_stamp += 2;
  m_number_of_visited_vertices = 0;
  m_is_restricted = m_is_guided = false;
  if(method != Surfel_search::coarse_to_fine)
    return find(from, to, method);
  if(m_regions != nullptr && !restrict_to_corridor(from, to))
    return {};
  return find(from, to, Surfel_search::a_star);
}

std::vector<Index> Graph_search::find(Index from, Index to, Surfel_search method)
{
  if(method == Surfel_search::bidirectional)
    return find_bidirectional(from, to);
  Frontier& frontier = m_frontiers[0];
  initialize(frontier, from, method == Surfel_search::a_star ? &(*m_point)[to] : nullptr);
  Index last = none;
  while(last == none && !frontier.queue.empty())
    if(expand(frontier) == to)
      last = to;
  return path_to(frontier, last);
}

std::vector<Index> Graph_search::find_bidirectional(Index from, Index to)
{
  Frontier &forward = m_frontiers[0], &backward = m_frontiers[1];
  initialize(forward, from, nullptr);
  initialize(backward, to, nullptr);

  Index meeting_vertex = none;
  double best_length = infinity;
  while(!forward.queue.empty() && !backward.queue.empty() &&
        forward.queue.front().key + backward.queue.front().key < best_length)
  {
    const bool is_forward = forward.queue.front().key <= backward.queue.front().key;
    Frontier &current = is_forward ? forward : backward,
             &opposite = is_forward ? backward : forward;
    const Index vertex = expand(current);
    const auto update_meeting = [&](Index candidate)
    {
      if(!is_reached(current, candidate) || !is_reached(opposite, candidate))
        return;
      const double length =
          current.vertices[candidate].distance + opposite.vertices[candidate].distance;
      if(length < best_length)
      {
        best_length = length;
        meeting_vertex = candidate;
      }
    };
    update_meeting(vertex);
    for(Index e = m_graph->begin[vertex]; e < m_graph->begin[vertex + 1]; ++e)
      update_meeting(m_graph->target[e]);
  }
  std::vector<Index> path = path_to(forward, meeting_vertex);
  if(meeting_vertex != none)
    for(Index vertex = backward.vertices[meeting_vertex].predecessor; vertex != none;
        vertex = backward.vertices[vertex].predecessor)
      path.push_back(vertex);
  return path;
}

// Returns the path from the start of a search to a vertex, which may be `none`.
std::vector<Index> Graph_search::path_to(const Frontier& frontier, Index vertex) const
{
  std::vector<Index> path;
  for(; vertex != none; vertex = frontier.vertices[vertex].predecessor)
    path.push_back(vertex);
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace CGAL::Geodesic_processing::internal
