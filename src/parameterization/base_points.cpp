// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/base_points.h>

#include "core/edges.h"
#include "core/prefetch.h"
#include "core/unfold.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Maximum spacing of base points relative to the width of a surface with boundary. Maps of narrow
// corridors of a maze are inverted in places with 0.99, and not with 0.92 or less.
constexpr double max_spacing_ratio = 0.85;
// Above the round-off errors of distances, so that no vertex on a bound is missed.
constexpr double bound_margin = 1. + 1e-9;

// Returns for each sample an upper bound of the distance to its `number_of_nearest`-th nearest
// sample, counting itself. The bound is the distance in a graph of samples with adjacent Voronoi
// cells.
std::vector<double> neighborhood_radii(const Surface_arrays& t, const Sampling& sampling,
                                       std::size_t number_of_nearest)
{
  using Sample_edge = std::pair<double, Index>; // length, sample
  const std::size_t number_of_samples = sampling.samples().size();
  std::vector<std::vector<Sample_edge>> adjacency(number_of_samples);
  const auto connect = [&](Index a, Index b, double length)
  {
    const Index i = sampling.labels()[a], j = sampling.labels()[b];
    if(i == j || i == none || j == none)
      return;
    length += sampling.distances()[a] + sampling.distances()[b];
    const auto relax_edge = [&](Index from, Index to)
    {
      const auto found = std::find_if(adjacency[from].begin(), adjacency[from].end(),
                                      [&](const Sample_edge& edge) { return edge.second == to; });
      if(found == adjacency[from].end())
        adjacency[from].emplace_back(length, to);
      else
        found->first = std::min(found->first, length);
    };
    relax_edge(i, j);
    relax_edge(j, i);
  };
  for(Index h = 0; h < t.corner.size(); ++h)
    connect(t.corner[h], t.corner[next_halfedge(h)], t.length[h]);
  for(Index vertex = 0; t.is_cloud() && vertex < t.number_of_vertices(); ++vertex)
    for(Index edge = t.graph.begin[vertex]; edge < t.graph.begin[vertex + 1]; ++edge)
      connect(vertex, t.graph.target[edge], graph_edge_length(t, vertex, edge));

  std::vector<double> result(number_of_samples, infinity), length(number_of_samples, infinity);
  for(Index start = 0; start < number_of_samples; ++start)
  {
    std::priority_queue<Sample_edge, std::vector<Sample_edge>, std::greater<>> queue;
    std::vector<Index> visited = {start};
    std::size_t found = 0;
    length[start] = 0.;
    for(queue.emplace(0., start); !queue.empty() && found < number_of_nearest;)
    {
      const auto [distance, sample] = queue.top();
      queue.pop();
      if(distance > length[sample])
        continue;
      if(++found == number_of_nearest)
        result[start] = distance;
      for(const auto& [edge_length, next] : adjacency[sample])
        if(distance + edge_length < length[next])
        {
          if(length[next] == infinity)
            visited.push_back(next);
          length[next] = distance + edge_length;
          queue.emplace(length[next], next);
        }
    }
    for(const Index sample : visited)
      length[sample] = infinity;
  }
  return result;
}

// Returns the length of the straight line between two sources that are unfolded to both sides of an
// edge, from their distances to its ends. If it does not cross the edge, returns infinity.
double unfolded_distance(double edge_length, const std::array<double, 2>& from,
                         const std::array<double, 2>& to)
{
  const Vec2 p = third_corner(edge_length, from[0], from[1]),
             q = third_corner(edge_length, to[0], to[1]);
  const double height = p[1] + q[1];
  if(!(height > 0.))
    return infinity;
  const double crossing = (p[0] * q[1] + q[0] * p[1]) / height;
  return crossing >= 0. && crossing <= edge_length ? std::hypot(p[0] - q[0], height) : infinity;
}

// The vertex at which the sum of the distances to two samples is smallest.
struct Front_meeting
{
  double length = infinity;
  Index vertex = none;
  bool is_on_path = false; // whether the vertex is close to the shortest path between them
};

// Returns the distance of a vertex to one of its nearest base points, otherwise infinity.
double distance_to(const Base_points& base, Index neighbor, Index vertex)
{
  const auto begin = base.neighbor.begin() + std::ptrdiff_t(base.number_of_nearest * vertex);
  const auto end = begin + std::ptrdiff_t(base.number_of_nearest);
  const auto found = std::find(begin, end, neighbor);
  return found == end ? infinity : base.distance[std::size_t(found - base.neighbor.begin())];
}

// Computes the distances of base points whose fronts meet: the length of a straight line across an
// edge of the triangles at the meeting vertex, or through this vertex. If one of the fronts does
// not cover all of these triangles, the shortest path can be elsewhere.
void compute_pair_distances(const Surface_arrays& t, std::vector<Front_meeting>& meetings,
                            Base_points& base)
{
  const std::size_t number_of_points = base.size();
  for(Index i = 0; i < number_of_points; ++i)
    for(Index j = 0; j < i; ++j)
    {
      Front_meeting& meeting = meetings[i * number_of_points + j];
      if(meeting.vertex == none)
        continue;
      double straight_distance = infinity;
      // A path through the vertex itself is shortest only if the vertex is one of the ends, or if
      // the path bends at the boundary.
      const bool is_end = meeting.vertex == base.vertices[i] || meeting.vertex == base.vertices[j];
      bool is_surrounded = true, is_on_boundary = is_end || t.is_cloud();
      if(!is_end)
        for(Index c = t.ring_begin[meeting.vertex]; c < t.ring_begin[meeting.vertex + 1]; ++c)
          for(Index h = t.ring[c] - t.ring[c] % 3, k = 0; k < 3; ++k, ++h)
          {
            const Index p = t.corner[h], q = t.corner[next_halfedge(h)];
            const std::array<double, 2> from = {distance_to(base, i, p), distance_to(base, i, q)},
                                        to = {distance_to(base, j, p), distance_to(base, j, q)};
            if(from[0] < infinity && from[1] < infinity && to[0] < infinity && to[1] < infinity)
              straight_distance =
                  std::min(straight_distance, unfolded_distance(t.length[h], from, to));
            else
              is_surrounded = false;
            is_on_boundary = is_on_boundary || t.twin[h] == none;
          }
      meeting.is_on_path = straight_distance < infinity || (is_surrounded && is_on_boundary);
      base.pair_distance[i * number_of_points + j] = base.pair_distance[j * number_of_points + i] =
          std::min(meeting.length, straight_distance);
    }
}

// For all other pairs, computes the straight line across the common edge of two triangles of base
// points, for the two triangles of smallest perimeter. It replaces the distance if it is shorter.
void complete_pair_distances(const std::vector<Front_meeting>& meetings, Base_points& base)
{
  const std::size_t number_of_points = base.size();
  const auto is_known = [&](Index i, Index j)
  { return meetings[std::max(i, j) * number_of_points + std::min(i, j)].is_on_path; };
  std::vector<Index> common;
  for(Index i = 0; i < number_of_points; ++i)
    for(Index j = 0; j < i; ++j)
    {
      if(meetings[i * number_of_points + j].vertex == none || is_known(i, j))
        continue;
      common.clear();
      for(Index k = 0; k < number_of_points; ++k)
        if(k != i && k != j && is_known(i, k) && is_known(j, k))
          common.push_back(k);
      double min_perimeter = infinity, straight_distance = infinity;
      for(std::size_t a = 1; a < common.size(); ++a)
        for(std::size_t b = 0; b < a; ++b)
        {
          if(!is_known(common[a], common[b]))
            continue;
          const auto d = [&](Index p, Index q) { return base.distance_between(p, q); };
          const std::array<double, 2> from = {d(i, common[a]), d(i, common[b])},
                                      to = {d(j, common[a]), d(j, common[b])};
          const double perimeter = from[0] + from[1] + to[0] + to[1];
          if(!(perimeter < min_perimeter))
            continue;
          if(const double length = unfolded_distance(d(common[a], common[b]), from, to);
             length < infinity)
          {
            min_perimeter = perimeter;
            straight_distance = length;
          }
        }
      double& length = base.pair_distance[i * number_of_points + j];
      length = std::min(length, straight_distance);
      base.pair_distance[j * number_of_points + i] = length;
    }
}

} // namespace

std::size_t suitable_number_of_base_points(const Surface_arrays& t)
{
  if(t.is_cloud())
    return default_number_of_base_points;
  double area = 0., boundary_length = 0.;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const double* const l = &t.length[3 * std::size_t(f)];
    area += 0.5 * twice_area(l[0], l[1], l[2]);
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      boundary_length += t.twin[h] == none ? t.length[h] : 0.;
  }
  // In a regular hexagonal arrangement each base point has this area.
  const double spacing = max_spacing_ratio * 2. * area / boundary_length;
  const double number = 2. / std::sqrt(3.) * area / (spacing * spacing);
  return number > double(default_number_of_base_points)
             ? std::size_t(std::min(number, double(max_number_of_base_points)))
             : default_number_of_base_points;
}

namespace {

// Upper bounds, one per vertex, of the distance to its `number_of_nearest`-th nearest base point.
std::vector<double> initial_distance_bounds(const Surface_arrays& t, const Sampling& sampling,
                                            std::size_t number_of_nearest)
{
  const std::vector<double> radii = neighborhood_radii(t, sampling, number_of_nearest);
  std::vector<double> bounds(t.number_of_vertices(), infinity);
  for(const Index vertex : sampling.sampled_vertices())
    if(const Index sample = sampling.labels()[vertex]; sample != none)
      bounds[vertex] = bound_margin * (sampling.distances()[vertex] + radii[sample]);
  return bounds;
}

// Prefetches the nearest base points of a vertex: with many vertices, these accesses dominate.
void prefetch_neighbors(const Base_points& base, Index vertex)
{
  constexpr std::size_t cache_line = 64;
  const std::size_t begin = base.number_of_nearest * vertex, end = begin + base.number_of_nearest;
  for(std::size_t i = begin; i < end; i += cache_line / sizeof(double))
    prefetch(&base.distance[i]);
  prefetch(&base.distance[end - 1]);
  prefetch(&base.neighbor[begin]);
  prefetch(&base.neighbor[end - 1]);
}

// Inserts a base point into the sorted list of the nearest ones of a vertex. Returns whether it is
// among them.
bool insert_neighbor(Base_points& base, Index vertex, Index sample, double distance)
{
  const std::size_t begin = base.number_of_nearest * vertex;
  std::size_t slot = begin + base.number_of_nearest - 1;
  if(!(distance < base.distance[slot]))
    return false;
  for(; slot > begin && distance < base.distance[slot - 1]; --slot)
  {
    base.distance[slot] = base.distance[slot - 1];
    base.neighbor[slot] = base.neighbor[slot - 1];
  }
  base.distance[slot] = distance;
  base.neighbor[slot] = sample;
  return true;
}

// Returns for each pair (i > j) of base points, at i * number_of_samples + j, the vertex with both
// among its nearest base points at which the sum of the two distances is smallest.
std::vector<Front_meeting> find_meetings(const Base_points& base, std::size_t number_of_vertices)
{
  const std::size_t number_of_samples = base.vertices.size();
  std::vector<Front_meeting> meetings(number_of_samples * number_of_samples);
  for(Index vertex = 0; vertex < number_of_vertices; ++vertex)
  {
    const Index* points = &base.neighbor[base.number_of_nearest * vertex];
    const double* distances = &base.distance[base.number_of_nearest * vertex];
    for(std::size_t a = 1; a < base.number_of_nearest && points[a] != none; ++a)
      for(std::size_t b = 0; b < a; ++b)
      {
        Front_meeting& meeting = meetings[std::max(points[a], points[b]) * number_of_samples +
                                          std::min(points[a], points[b])];
        if(const double length = distances[a] + distances[b]; length < meeting.length)
          meeting = {length, vertex};
      }
  }
  return meetings;
}

} // namespace

Base_points nearest_base_points(const Surface_arrays& t, const Sampling& sampling, Front front,
                                std::size_t number_of_nearest,
                                const std::function<bool(double)>& callback)
{
  Base_points result;
  const std::size_t number_of_samples = sampling.samples().size(),
                    number_of_vertices = t.number_of_vertices();
  for(const Surface_location& sample : sampling.samples())
    result.vertices.push_back(sample.vertex);
  number_of_nearest = std::min(number_of_nearest, number_of_samples);
  result.number_of_nearest = number_of_nearest;
  result.neighbor.assign(number_of_nearest * number_of_vertices, none);
  result.distance.assign(number_of_nearest * number_of_vertices, infinity);

  std::vector<double> distance_bound = initial_distance_bounds(t, sampling, number_of_nearest);
  Front_limits limits;
  limits.known_distance = &distance_bound;
  constexpr std::size_t prefetch_distance = 16;
  for(Index sample = 0; sample < number_of_samples; ++sample)
  {
    if(callback && !callback(double(sample) / double(number_of_samples)))
      return {};
    front.run({{{sampling.samples()[sample]}, 0., 0}}, limits);
    const std::vector<Index>& reached = front.reached();
    for(std::size_t k = 0; k < reached.size(); ++k)
    {
      if(k + prefetch_distance < reached.size())
      {
        prefetch_neighbors(result, reached[k + prefetch_distance]);
        prefetch(&distance_bound[reached[k + prefetch_distance]]);
      }
      const Index vertex = reached[k];
      if(insert_neighbor(result, vertex, sample, front.distance(vertex)))
        distance_bound[vertex] =
            std::min(distance_bound[vertex],
                     bound_margin * result.distance[number_of_nearest * (vertex + 1) - 1]);
    }
  }

  std::vector<Front_meeting> meetings = find_meetings(result, number_of_vertices);
  result.pair_distance.assign(number_of_samples * number_of_samples, infinity);
  for(std::size_t i = 0; i < number_of_samples; ++i)
    result.pair_distance[i * number_of_samples + i] = 0.;
  compute_pair_distances(t, meetings, result);
  complete_pair_distances(meetings, result);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
