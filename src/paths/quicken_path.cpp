// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/quicken_path.h"

#include "core/unfold.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>

#include <algorithm>
#include <array>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

constexpr Index points_per_edge = 3;
// A smaller relative gain is left to the movement of the points along their edges.
constexpr double min_gain = 1e-4;
constexpr int max_searches = 50;

using Path = std::vector<Surface_location>;

double segment_time(const Surface_arrays& t, const std::vector<double>& slowness,
                    const Surface_location& begin, const Surface_location& end)
{
  double time = infinity;
  for(const Index triangle : triangles_at(t, begin))
    if(slowness[triangle] < infinity)
      if(const auto end_coordinates = barycentric_in(t, triangle, end))
        time = std::min(time,
                        slowness[triangle] *
                            distance_in_triangle(t, triangle, *barycentric_in(t, triangle, begin),
                                                 *end_coordinates));
  return time;
}

// The graph of vertices and points on edges of the triangles near a path.
class Edge_points
{
public:
  Edge_points(const Surface_arrays& t, const std::vector<double>& slowness, const Path& path)
      : m_mesh(t), m_slowness(slowness)
  {
    std::unordered_set<Index> triangles;
    for(const Surface_location& location : path)
      for(const Index triangle : triangles_at(t, location))
        for(Index k = 0; k < 3; ++k)
        {
          const Index vertex = t.corner[3 * triangle + k];
          for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
            if(slowness[t.ring[i] / 3] < infinity)
              triangles.insert(t.ring[i] / 3);
        }
    // The order of a hash table must not decide between paths of the same time.
    std::vector<Index> sorted(triangles.begin(), triangles.end());
    std::sort(sorted.begin(), sorted.end());
    for(const Index triangle : sorted)
      add_triangle(triangle);
    m_begin = add_end(path.front());
    m_end = add_end(path.back());
  }

  // Returns the fastest path between the ends; empty if there is none.
  Path fastest_path() const
  {
    std::vector<double> time(m_location.size(), infinity);
    std::vector<Index> previous(m_location.size(), none);
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    time[m_begin] = 0.;
    queue.emplace(0., m_begin);
    while(!queue.empty())
    {
      const auto [node_time, node] = queue.top();
      queue.pop();
      if(node == m_end)
        break;
      if(node_time > time[node])
        continue;
      for(const Place& place : m_places[node])
      {
        const Index triangle = m_triangles[place.tile];
        for(const auto& [neighbor, position] : m_tiles[place.tile].nodes)
        {
          const double neighbor_time =
              node_time + m_slowness[triangle] * norm(position - place.position);
          if(neighbor_time < time[neighbor])
          {
            time[neighbor] = neighbor_time;
            previous[neighbor] = node;
            queue.emplace(neighbor_time, neighbor);
          }
        }
      }
    }
    Path result;
    if(time[m_end] < infinity)
      for(Index node = m_end; node != none; node = previous[node])
        result.push_back(m_location[node]);
    std::reverse(result.begin(), result.end());
    return result;
  }

private:
  using Barycentric = std::array<double, 3>;
  struct Tile
  {
    std::array<Vec2, 3> corners;               // of the unfolded triangle
    std::vector<std::pair<Index, Vec2>> nodes; // with their positions
  };
  struct Place
  {
    Index tile; // index in m_triangles
    Vec2 position;
  };

  Index add_node(const Surface_location& location)
  {
    m_location.push_back(location);
    m_places.emplace_back();
    return Index(m_location.size() - 1);
  }
  void place(Index node, Index tile, const Barycentric& coordinates)
  {
    const Vec2 position = unfolded_point(m_tiles[tile].corners, coordinates);
    m_places[node].push_back({tile, position});
    m_tiles[tile].nodes.emplace_back(node, position);
  }

  void add_triangle(Index triangle)
  {
    const Index tile = Index(m_triangles.size());
    m_triangles.push_back(triangle);
    m_tiles.push_back({unfolded(m_mesh, triangle), {}});
    for(Index k = 0; k < 3; ++k)
    {
      const Index h = 3 * triangle + k, vertex = m_mesh.corner[h];
      const auto [corner, is_new] = m_vertex_node.try_emplace(vertex, Index(m_location.size()));
      if(is_new)
        add_node(vertex_location(m_mesh, vertex));
      Barycentric coordinates = {0., 0., 0.};
      coordinates[k] = 1.;
      place(corner->second, tile, coordinates);
      add_points(h, tile);
    }
  }

  // Adds the points on a halfedge, which its twin has in the reverse order.
  void add_points(Index h, Index tile)
  {
    const Index twin = m_mesh.twin[h];
    const bool is_reversed = twin != none && twin < h;
    const auto [first, is_new] =
        m_edge_node.try_emplace(is_reversed ? twin : h, Index(m_location.size()));
    for(Index i = 0; i < points_per_edge; ++i)
    {
      Barycentric coordinates = {0., 0., 0.};
      coordinates[(h + 1) % 3] =
          (is_reversed ? points_per_edge - i : i + 1.) / (points_per_edge + 1.);
      coordinates[h % 3] = 1. - coordinates[(h + 1) % 3];
      if(is_new)
        add_node({h / 3, none, coordinates});
      place(first->second + i, tile, coordinates);
    }
  }

  // Adds an endpoint of the path.
  Index add_end(const Surface_location& location)
  {
    const Index node = add_node(location);
    for(const Index triangle : triangles_at(m_mesh, location))
    {
      const auto position = std::lower_bound(m_triangles.begin(), m_triangles.end(), triangle);
      if(position != m_triangles.end() && *position == triangle)
        place(node, Index(position - m_triangles.begin()),
              *barycentric_in(m_mesh, triangle, location));
    }
    return node;
  }

  const Surface_arrays& m_mesh;
  const std::vector<double>& m_slowness;
  std::vector<Index> m_triangles;           // sorted
  std::vector<Tile> m_tiles;                // of these triangles
  Path m_location;                          // of each node
  std::vector<std::vector<Place>> m_places; // of each node
  // The node of a vertex, and the first node of an edge.
  std::unordered_map<Index, Index> m_vertex_node, m_edge_node;
  Index m_begin = none, m_end = none;
};

// Removes locations without which the path is not slower.
Path without_superfluous(const Surface_arrays& t, const std::vector<double>& slowness,
                         const Path& path)
{
  // Above the round-off errors of the sum of two segments, far below the error of a path.
  constexpr double tolerance = 1e-12;
  Path result;
  for(const Surface_location& location : path)
  {
    if(!result.empty() && is_same_point(t, result.back(), location))
      continue;
    while(result.size() >= 2 &&
          segment_time(t, slowness, result[result.size() - 2], location) <=
              (1. + tolerance) *
                  (segment_time(t, slowness, result[result.size() - 2], result.back()) +
                   segment_time(t, slowness, result.back(), location)))
      result.pop_back();
    result.push_back(location);
  }
  return result;
}

// Returns the location moved along its edge by a fraction of the edge, almost to the edge's ends;
// the location itself if it is not on an edge. At an end it could not move any more.
Surface_location moved(const Surface_location& location, double step)
{
  constexpr double min_fraction = 1e-9;
  const Index h = halfedge_of(location);
  if(h == none)
    return location;
  Surface_location result = location;
  double& fraction = result.barycentric[(h + 1) % 3];
  fraction = std::clamp(fraction + step, min_fraction, 1. - min_fraction);
  result.barycentric[h % 3] = 1. - fraction;
  return result;
}

// Moves the inner locations along their edges to positions at which the path is faster.
//
// The time is a convex function of the positions. Therefore steps that become smaller lead to its
// minimum.
Path with_moved_crossings(const Surface_arrays& t, const std::vector<double>& slowness, Path path)
{
  constexpr double first_step = 0.5 / (points_per_edge + 1.);
  // The time is quadratic near its minimum, so that such a step changes it by round-off errors.
  constexpr double last_step = 1e-7;
  for(double step = first_step; step > last_step; step *= 0.7)
  {
    using Candidates = std::array<Surface_location, 3>;
    std::vector<Candidates> candidates;
    for(const Surface_location& location : path)
      candidates.push_back({location, moved(location, -step), moved(location, step)});
    candidates.front().fill(path.front());
    candidates.back().fill(path.back());
    std::vector<std::array<double, 3>> time(path.size(), {infinity, infinity, infinity});
    std::vector<std::array<int, 3>> previous(path.size(), {0, 0, 0});
    time[0][0] = 0.;
    for(std::size_t i = 1; i < path.size(); ++i)
      for(int from = 0; from < 3; ++from)
        if(time[i - 1][from] < infinity)
          for(int to = 0; to < 3; ++to)
          {
            const double sum =
                time[i - 1][from] +
                segment_time(t, slowness, candidates[i - 1][from], candidates[i][to]);
            if(sum < time[i][to])
            {
              time[i][to] = sum;
              previous[i][to] = from;
            }
          }
    int choice = 0;
    for(std::size_t i = path.size(); i-- > 1; choice = previous[i][choice])
      path[i] = candidates[i][choice];
  }
  return path;
}

} // namespace

double travel_time(const Surface_arrays& t, const std::vector<double>& slowness,
                   const std::vector<Surface_location>& path)
{
  double time = 0.;
  for(std::size_t i = 0; i + 1 < path.size(); ++i)
    time += segment_time(t, slowness, path[i], path[i + 1]);
  return time;
}

std::vector<Surface_location> quicken_path(const Surface_arrays& t,
                                           const std::vector<double>& slowness,
                                           std::vector<Surface_location> path)
{
  if(path.size() < 2)
    return path;
  double time = travel_time(t, slowness, path);
  const auto replace = [&](const Path& candidate)
  {
    const double candidate_time = travel_time(t, slowness, candidate);
    if(candidate.empty() || !(candidate_time < time))
      return false;
    const bool is_worthwhile = !(candidate_time > (1. - min_gain) * time);
    path = candidate;
    time = candidate_time;
    return is_worthwhile;
  };
  for(int i = 0; i < max_searches && replace(Edge_points(t, slowness, path).fastest_path()); ++i)
    ;
  replace(with_moved_crossings(t, slowness, without_superfluous(t, slowness, path)));
  return without_superfluous(t, slowness, path);
}

} // namespace CGAL::Geodesic_processing::internal
