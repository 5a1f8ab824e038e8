// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/sampling/sampling.h>

#include "core/edges.h"
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>
#include "core/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The heap is refilled by a scan of all vertices if the covering radius has decreased by this
// factor. This happens once or twice while the number of samples doubles. With a smaller factor the
// heap holds more outdated entries.
constexpr double refill_factor = 0.8;

// Maximum average number of visits of a vertex in the search along edges. Most vertices take one
// visit; meshes of needles could take many.
constexpr std::size_t max_visits_per_vertex = 5;

bool is_sampled(const Surface_arrays& t, const std::vector<double>* slowness, Index vertex)
{
  if(t.is_cloud() && t.ring_begin[vertex] == t.ring_begin[vertex + 1])
    return t.graph.begin[vertex] < t.graph.begin[vertex + 1];
  const auto is_passable = [&](Index corner)
  { return !slowness || (*slowness)[corner / 3] < infinity; };
  return std::any_of(t.ring.begin() + t.ring_begin[vertex],
                     t.ring.begin() + t.ring_begin[vertex + 1], is_passable);
}

} // namespace

Sampling::Sampling(std::shared_ptr<const Surface_arrays> triangles, Front front,
                   Sample_location sample_location,
                   std::shared_ptr<const std::vector<double>> slowness)
    : m_triangles(std::move(triangles)), m_front(std::move(front)),
      m_sample_location(m_triangles->is_cloud() ? Sample_location::vertex : sample_location),
      m_distances(m_triangles->number_of_vertices(), infinity),
      m_labels(m_triangles->number_of_vertices(), none)
{
  m_limits.slowness = std::move(slowness);
  if(m_sample_location == Sample_location::triangle)
    m_has_sample.resize(m_triangles->number_of_triangles());
  for(Index vertex = 0; vertex < m_distances.size(); ++vertex)
    if(is_sampled(*m_triangles, m_limits.slowness.get(), vertex))
      m_sampled_vertices.push_back(vertex);
}

bool Sampling::add(const std::vector<Surface_location>& samples,
                   const std::function<bool(double)>& callback)
{
  m_limits.known_distance = &m_distances;
  m_limits.callback = callback;
  std::vector<Front_source> sources;
  sources.reserve(samples.size());
  for(const Surface_location& sample : samples)
    sources.push_back({{sample}, 0., 0});
  const bool is_finished = m_front.run(sources, m_limits);
  const Index first_label = Index(m_samples.size());
  for(const Surface_location& sample : samples)
  {
    m_samples.push_back(sample);
    if(!m_has_sample.empty() && sample.triangle != none)
      m_has_sample[sample.triangle] = true;
  }
  for(const Index vertex : m_front.reached())
    if(const double distance = m_front.distance(vertex); distance < m_distances[vertex])
    {
      m_distances[vertex] = distance;
      m_labels[vertex] = first_label + m_front.source(vertex);
    }
  return is_finished;
}

Index Sampling::farthest_vertex()
{
  while(m_first_unreached < m_sampled_vertices.size() &&
        m_distances[m_sampled_vertices[m_first_unreached]] < infinity)
    ++m_first_unreached;
  if(m_first_unreached < m_sampled_vertices.size())
    return m_sampled_vertices[m_first_unreached];
  for(;;)
  {
    if(m_heap.empty())
      refill();
    if(m_heap.empty())
      return none;
    const auto [key, vertex] = m_heap.front();
    const double distance = m_distances[vertex];
    if(distance == key)
      return vertex;
    std::pop_heap(m_heap.begin(), m_heap.end());
    m_heap.pop_back();
    if(distance >= m_threshold)
    {
      m_heap.push_back({distance, vertex});
      std::push_heap(m_heap.begin(), m_heap.end());
    }
  }
}

void Sampling::refill()
{
  // All distances are below the threshold. The first pass uses the old threshold as an estimate of
  // the largest distance. If no distance reaches the new threshold, the second pass uses the
  // largest distance itself.
  double largest = m_threshold;
  for(int pass = 0; m_heap.empty() && pass < 2; ++pass)
  {
    m_threshold = refill_factor * largest;
    largest = 0.;
    for(const Index vertex : m_sampled_vertices)
    {
      const double distance = m_distances[vertex];
      largest = std::max(largest, distance);
      if(distance >= m_threshold && distance > 0.)
        m_heap.push_back({distance, vertex});
    }
  }
  std::make_heap(m_heap.begin(), m_heap.end());
}

double Sampling::covering_radius()
{
  const Index vertex = farthest_vertex();
  return vertex == none ? 0. : m_distances[vertex];
}

Surface_location Sampling::farthest_location(Index start)
{
  const Index vertex = farthest_vertex();
  if(vertex == none)
    return {};
  if(m_distances[vertex] == infinity)
    return {none, farthest_in_component(start == none ? vertex : start), {}};
  return m_sample_location == Sample_location::vertex ? Surface_location{none, vertex, {}}
                                                      : front_meeting_point(vertex);
}

// Returns the vertex of the connected component of `start` that is farthest along edges, an
// approximation of the farthest vertex. The threshold algorithm (Glover et al. 1985) expands all
// vertices with a path length below the mean. A vertex is expanded again if a later path is
// shorter. This takes a third of the time of a heap.
Index Sampling::farthest_in_component(Index start)
{
  m_path_lengths.resize(m_distances.size(), infinity);
  m_is_queued.resize(m_distances.size(), false);
  std::vector<Index> reached = {start}, near = {start}, far;
  m_path_lengths[start] = 0.;
  double threshold = 0.;
  std::size_t visits = 0;
  const auto expand = [&](Index vertex)
  {
    const double distance = m_path_lengths[vertex];
    m_is_queued[vertex] = false;
    ++visits;
    const auto relax = [&](Index target, double length)
    {
      const double old_distance = m_path_lengths[target];
      if(!(distance + length < old_distance))
        return;
      m_path_lengths[target] = distance + length;
      if(old_distance == infinity)
        reached.push_back(target);
      else if(m_is_queued[target] || visits > max_visits_per_vertex * reached.size())
        return;
      m_is_queued[target] = true;
      (distance + length <= threshold ? near : far).push_back(target);
    };
    for_each_edge(*m_triangles, m_limits.slowness.get(), vertex, relax);
  };
  while(!near.empty())
  {
    for(std::size_t i = 0; i < near.size(); ++i)
      expand(near[i]);
    double sum = 0.;
    for(const Index vertex : far)
      sum += m_path_lengths[vertex];
    threshold = sum / double(far.size());
    const auto is_far = [&](Index vertex) { return m_path_lengths[vertex] > threshold; };
    const auto near_begin = std::partition(far.begin(), far.end(), is_far);
    near.assign(near_begin, far.end());
    far.erase(near_begin, far.end());
    // By round-off errors the mean of a few equal values may be smaller than all of them.
    if(near.empty())
      near.swap(far);
  }
  Entry farthest = {0., start};
  for(const Index vertex : reached)
  {
    farthest = std::max(farthest, Entry{m_path_lengths[vertex], vertex});
    m_path_lengths[vertex] = infinity;
  }
  return farthest.vertex;
}

// Returns the point at which the fronts meet in a triangle at the farthest vertex (Peyré and Cohen
// 2003, section 3.1). The triangle contains the neighbor with the largest distance and, of the two
// opposite vertices, the one with the larger distance.
Surface_location Sampling::front_meeting_point(Index vertex) const
{
  const Surface_arrays& t = *m_triangles;
  const Surface_location at_vertex = {none, vertex, {}};
  Entry neighbor = {-1., none}, third = {-1., none};
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    for(const Index corner : {next_halfedge(t.ring[i]), previous_halfedge(t.ring[i])})
      neighbor = std::max(neighbor, Entry{m_distances[t.corner[corner]], t.corner[corner]});
  Index triangle = none;
  for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
  {
    const Index next = t.corner[next_halfedge(t.ring[i])],
                previous = t.corner[previous_halfedge(t.ring[i])];
    if(next != neighbor.vertex && previous != neighbor.vertex)
      continue;
    const Index opposite = next == neighbor.vertex ? previous : next;
    if(third < Entry{m_distances[opposite], opposite})
    {
      third = {m_distances[opposite], opposite};
      triangle = t.ring[i] / 3;
    }
  }
  // At most one sample per triangle: the labels of its corners could not represent more.
  if(triangle == none || m_has_sample[triangle] || !(neighbor.key < infinity) ||
     !(third.key < infinity) || !(slowness(triangle) < infinity))
    return at_vertex;

  // On a boundary edge, fronts meet on the edge.
  std::vector<Index> halfedges;
  for(Index h = 3 * triangle; h < 3 * triangle + 3; ++h)
  {
    const std::array<Index, 2> ends = {t.corner[h], t.corner[next_halfedge(h)]};
    const bool is_joining_edge = (ends[0] == vertex && ends[1] == neighbor.vertex) ||
                                 (ends[1] == vertex && ends[0] == neighbor.vertex);
    if(is_joining_edge && t.twin[h] == none)
      halfedges = {h};
  }
  if(halfedges.empty())
    halfedges = {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};

  Surface_location result = {triangle, none, {0., 0., 0.}};
  for(const Index h : halfedges)
  {
    const double travel_time = slowness(triangle) * t.length[h];
    const double difference = m_distances[t.corner[next_halfedge(h)]] - m_distances[t.corner[h]];
    const double fraction =
        travel_time > 0. ? std::clamp(0.5 + 0.5 * difference / travel_time, 0., 1.) : 0.5;
    const auto meeting_point = barycentric_on_halfedge(h, fraction);
    for(int j = 0; j < 3; ++j)
      result.barycentric[j] += meeting_point[j] / double(halfedges.size());
  }
  result = canonical(t, result);
  // If one front reached all three corners (at the boundary or around a tip), the point is not
  // farther than the vertex.
  return distance_in_triangle(triangle, result.barycentric) > m_distances[vertex] ? result
                                                                                  : at_vertex;
}

// Returns the distance of a point in a triangle if fronts enter it through its edges as straight
// lines.
double Sampling::distance_in_triangle(Index triangle,
                                      const std::array<double, 3>& barycentric) const
{
  const Surface_arrays& t = *m_triangles;
  const auto corners = unfolded(t, triangle);
  const Vec2 p = unfolded_point(corners, barycentric);
  double result = infinity;
  for(Index k = 0; k < 3; ++k)
  {
    const Index h = 3 * triangle + k, x = t.corner[h], z = t.corner[next_halfedge(h)];
    const Vec2 offset = p - corners[k], edge = corners[(k + 1) % 3] - corners[k];
    result = std::min(result, m_distances[x] + slowness(triangle) * norm(offset));
    const double length = norm(edge);
    const double slope = (m_distances[z] - m_distances[x]) / (slowness(triangle) * length);
    if(m_labels[x] != m_labels[z] || !(std::abs(slope) < 1.))
      continue;
    const Straight_front front(length, slope, rotated_back(offset, (1. / length) * edge));
    result = std::min(result, m_distances[x] + slowness(triangle) * front.delay);
  }
  return result;
}

bool sample_farthest_points(Sampling& sampling, const Sampling_options& options,
                            const std::function<void(double)>& report_radius)
{
  std::size_t number_added = 0;
  double radius = sampling.covering_radius();
  std::function<bool(double)> callback;
  if(options.callback)
    callback = [&](double)
    {
      // The number of samples grows as the inverse square of the covering radius.
      const double ratio = options.covering_radius / radius;
      return options.callback((std::max)(double(number_added) / double(options.number_of_samples),
                                         (std::min)(1., ratio * ratio)));
    };
  const std::vector<Index>& vertices = sampling.sampled_vertices();
  Index start = none;
  if(sampling.samples().empty() && !vertices.empty())
    start = vertices[std::mt19937(options.seed)() % vertices.size()];
  for(; number_added < options.number_of_samples && radius > options.covering_radius; start = none)
  {
    if(callback && !callback(0.))
      return false;
    const bool is_finished = sampling.add(sampling.farthest_location(start), callback);
    ++number_added;
    radius = sampling.covering_radius();
    report_radius(radius);
    if(!is_finished)
      return false;
  }
  return true;
}

} // namespace CGAL::Geodesic_processing::internal
