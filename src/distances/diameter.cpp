// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/distances/diameter.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_propagation.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Upper bounds of the distances between pairs of vertices of a component, by the triangle
// inequality from known distances.
//
// Vertices have numbers 0..n-1. The nodes of a binary tree are intervals of numbers. As vertices
// are in Morton order, an interval is a compact region.
class Pair_bounds
{
public:
  struct Pair
  {
    double bound;
    std::uint32_t u, v; // numbers of vertices
  };

  explicit Pair_bounds(std::uint32_t number_of_vertices) : m_number(number_of_vertices)
  {
    const Node root{0, 0, m_number};
    m_frontier.push({infinity, 0, root, root});
  }

  // Adds the distances from a vertex: numbers of vertices to distances.
  void add(const std::vector<double>& distances)
  {
    if(m_number_of_samples % block_size == 0)
    {
      Block unknown;
      unknown.fill(infinity);
      m_max_distances.emplace_back(2 * std::size_t(m_number) - 1, unknown);
    }
    fill(distances, {0, 0, m_number});
    ++m_number_of_samples;
  }

  // Returns a pair whose bound is the largest one, if that exceeds the threshold. Otherwise,
  // returns a bound of all pairs. Thresholds must not decrease between calls.
  Pair largest(double threshold)
  {
    while(!m_frontier.empty() && m_frontier.top().bound > threshold)
    {
      Node_pair top = m_frontier.top();
      if(top.number_of_samples < m_number_of_samples)
      {
        m_frontier.pop();
        push(top, threshold);
      }
      else if(top.a.size() == 1 && top.b.size() == 1)
        return {top.bound, top.a.begin, top.b.begin};
      else
      {
        m_frontier.pop();
        split(top, threshold);
      }
    }
    double bound = m_max_dropped;
    if(!m_frontier.empty())
      bound = std::max(bound, m_frontier.top().bound);
    return {bound, 0, 0};
  }

private:
  static constexpr std::size_t block_size = 8;
  using Block = std::array<double, block_size>;

  // Vertices begin..end-1.
  struct Node
  {
    std::uint32_t index, begin, end;

    std::uint32_t size() const { return end - begin; }
    std::uint32_t middle() const { return begin + size() / 2; }
    Node first() const { return {index + 1, begin, middle()}; }
    Node second() const { return {index + 2 * (middle() - begin), middle(), end}; }
  };
  struct Node_pair
  {
    double bound; // from the first `number_of_samples` samples
    std::size_t number_of_samples;
    Node a, b;

    bool operator<(const Node_pair& other) const
    {
      // Ties are broken by the nodes, so that the result does not depend on the implementation of
      // the heap.
      return bound != other.bound       ? bound < other.bound
             : a.index != other.a.index ? a.index > other.a.index
                                        : b.index > other.b.index;
    }
  };

  // Stores the largest distance of each node.
  double fill(const std::vector<double>& distances, Node node)
  {
    double& result = m_max_distances.back()[node.index][m_number_of_samples % block_size];
    result = node.size() == 1
                 ? distances[node.begin]
                 : std::max(fill(distances, node.first()), fill(distances, node.second()));
    return result;
  }

  // Pushes a pair unless its bound is at most the threshold.
  void push(Node_pair pair, double threshold)
  {
    for(std::size_t block = pair.number_of_samples / block_size; block < m_max_distances.size();
        ++block)
    {
      const Block& a = m_max_distances[block][pair.a.index];
      const Block& b = m_max_distances[block][pair.b.index];
      for(std::size_t i = 0; i < block_size; ++i)
        pair.bound = std::min(pair.bound, a[i] + b[i]);
      if(pair.bound <= threshold)
      {
        m_max_dropped = std::max(m_max_dropped, pair.bound);
        return;
      }
    }
    pair.number_of_samples = m_number_of_samples;
    m_frontier.push(pair);
  }

  // Replaces a pair by the pairs of the children of its larger node.
  void split(const Node_pair& pair, double threshold)
  {
    const auto push_children = [&](Node a, Node b) { push({infinity, 0, a, b}, threshold); };
    if(pair.a.index == pair.b.index)
    {
      push_children(pair.a.first(), pair.a.first());
      push_children(pair.a.first(), pair.a.second());
      push_children(pair.a.second(), pair.a.second());
    }
    else if(pair.a.size() >= pair.b.size())
    {
      push_children(pair.a.first(), pair.b);
      push_children(pair.a.second(), pair.b);
    }
    else
    {
      push_children(pair.a, pair.b.first());
      push_children(pair.a, pair.b.second());
    }
  }

  std::uint32_t m_number;
  std::size_t m_number_of_samples = 0;
  // #samples / block_size, rounded up, x #nodes
  std::vector<std::vector<Block>> m_max_distances;
  std::priority_queue<Node_pair> m_frontier;
  double m_max_dropped = 0.;
};

// Exact distances from single vertices, one query each.
class Vertex_queries
{
public:
  Vertex_queries(const std::shared_ptr<const Surface_arrays>& triangles,
                 const Diameter_options& options)
      : m_triangles(*triangles), m_windows(triangles), m_options(options)
  {}

  std::size_t number() const { return m_number; }
  void begin_component() { m_number_in_component = 0; }
  // Returns whether the component has had its maximum number of queries.
  bool is_exhausted() const { return m_number_in_component >= m_options.max_number_of_queries; }
  void run(Index vertex)
  {
    m_windows.run({{{vertex_location(m_triangles, vertex)}, 0., 0}});
    ++m_number;
    ++m_number_in_component;
  }
  double lower(Index vertex) const { return m_windows.lower(vertex); }
  double upper(Index vertex) const { return m_windows.upper(vertex); }
  // Returns the vertex next to the midpoint of the shortest path to a vertex.
  Index midpoint(Index to) const;
  // Reports the fraction that has been done, if the ratio of the bounds has a final value of one.
  void report(double lower, double upper) const
  {
    if(m_options.callback)
      m_options.callback(upper > 0. ? std::min(1., lower / upper) : 1.);
  }

private:
  const Surface_arrays& m_triangles;
  Window_propagation m_windows;
  const Diameter_options& m_options;
  std::size_t m_number = 0, m_number_in_component = 0;
};

Index Vertex_queries::midpoint(Index to) const
{
  const std::vector<Surface_location> path =
      m_windows.path(vertex_location(m_triangles, to)).locations;
  const double half = 0.5 * m_windows.distance(to);
  Index result = to;
  double smallest = infinity;
  for(const Surface_location& location : path)
    for(const Index corner : {0, 1, 2})
      if(location.triangle != none && location.barycentric[corner] > 0.)
      {
        const Index v = m_triangles.corner[3 * location.triangle + corner];
        const double difference = std::abs(m_windows.distance(v) - half);
        if(difference < smallest)
        {
          smallest = difference;
          result = v;
        }
      }
  return result;
}

// The vertices of the components that have triangles, larger components first.
std::vector<std::vector<Index>> vertices_of_components(const Surface_arrays& triangles)
{
  const auto [component, number] = components(triangles);
  std::vector<std::vector<Index>> result(number);
  for(Index v = 0; v < triangles.number_of_vertices(); ++v)
    if(triangles.ring_begin[v] < triangles.ring_begin[v + 1])
      result[component[v]].push_back(v);
  result.erase(std::remove_if(result.begin(), result.end(),
                              [](const auto& vertices) { return vertices.empty(); }),
               result.end());
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  if(result.empty())
    throw Unsupported_surface_error("The mesh has no faces.");
  return result;
}

// Bounds the diameter of one component with sorted vertices, and returns the upper bound. The lower
// bound of the result is that of all components until now, and can only increase.
double bound_component_diameter(const std::vector<Index>& vertices, const Diameter_options& options,
                                Vertex_queries& queries, Diameter_bounds& result)
{
  Pair_bounds pairs(std::uint32_t(vertices.size()));
  std::vector<bool> is_queried(vertices.size(), false);
  std::vector<double> distances(vertices.size());
  // Returns the farthest vertex.
  const auto query = [&](std::size_t number)
  {
    queries.run(vertices[number]);
    is_queried[number] = true;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      distances[i] = queries.upper(vertices[i]);
    pairs.add(distances);
    const Index farthest = vertices[std::size_t(
        std::max_element(distances.begin(), distances.end()) - distances.begin())];
    if(result.from == none || queries.lower(farthest) > result.lower)
    {
      result.lower = queries.lower(farthest);
      result.from = vertices[number];
      result.to = farthest;
    }
    return farthest;
  };

  queries.begin_component();
  query(0);
  for(;;)
  {
    const double threshold = (1. + options.relative_tolerance) * result.lower;
    Pair_bounds::Pair pair = pairs.largest(threshold);
    queries.report(threshold, pair.bound);
    if(is_queried[pair.u])
      std::swap(pair.u, pair.v);
    // The bound of a pair with a known distance cannot decrease. It can exceed the threshold only
    // by the errors of thin triangles.
    if(pair.bound <= threshold || queries.is_exhausted() || is_queried[pair.u])
      return pair.bound;
    const Index farthest = query(pair.u);
    const Index to =
        queries.lower(vertices[pair.v]) > 0.5 * result.lower ? vertices[pair.v] : farthest;
    const auto middle =
        std::size_t(std::lower_bound(vertices.begin(), vertices.end(), queries.midpoint(to)) -
                    vertices.begin());
    if(!is_queried[middle] && !queries.is_exhausted())
      query(middle);
  }
}

// Bounds the radius of one component, whose center is the vertex of the upper bound. `known_lower`
// is the largest lower bound of the components until now.
Radius_bounds bound_component_radius(const std::vector<Index>& vertices,
                                     const Diameter_options& options, double known_lower,
                                     Vertex_queries& queries)
{
  Radius_bounds result;
  result.upper = infinity;
  std::vector<double> lower(vertices.size(), 0.);
  std::vector<bool> is_queried(vertices.size(), false);
  // Returns the number of the farthest vertex.
  const auto query = [&](std::size_t number)
  {
    queries.run(vertices[number]);
    is_queried[number] = true;
    std::size_t farthest = 0;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(queries.upper(vertices[i]) > queries.upper(vertices[farthest]))
        farthest = i;
    const double eccentricity = queries.upper(vertices[farthest]);
    for(std::size_t i = 0; i < vertices.size(); ++i)
      lower[i] = std::max({lower[i], queries.lower(vertices[i]),
                           queries.lower(vertices[farthest]) - queries.upper(vertices[i])});
    if(eccentricity < result.upper)
    {
      result.upper = eccentricity;
      result.center = vertices[number];
      result.farthest = vertices[farthest];
    }
    return farthest;
  };

  queries.begin_component();
  std::size_t next = 0;
  while(!queries.is_exhausted())
  {
    const std::size_t farthest = query(next);
    if(!is_queried[farthest] && !queries.is_exhausted())
      query(farthest);
    next = std::size_t(std::min_element(lower.begin(), lower.end()) - lower.begin());
    result.lower = lower[next];
    const double final_lower = std::max(known_lower, result.lower);
    queries.report((1. + options.relative_tolerance) * final_lower, result.upper);
    // The eccentricity of a queried vertex is known.
    result.is_converged =
        result.upper <= (1. + options.relative_tolerance) * final_lower || is_queried[next];
    if(result.is_converged)
      break;
  }
  return result;
}

} // namespace

Diameter_bounds bound_diameter(const std::shared_ptr<const Surface_arrays>& triangles,
                               const Diameter_options& options)
{
  Vertex_queries queries(triangles, options);
  Diameter_bounds result;
  for(const std::vector<Index>& vertices : vertices_of_components(*triangles))
    result.upper =
        std::max(result.upper, bound_component_diameter(vertices, options, queries, result));
  result.upper = std::max(result.upper, result.lower);
  result.is_converged = result.upper <= (1. + options.relative_tolerance) * result.lower;
  result.number_of_queries = queries.number();
  return result;
}

Radius_bounds bound_radius(const std::shared_ptr<const Surface_arrays>& triangles,
                           const Diameter_options& options)
{
  Vertex_queries queries(triangles, options);
  Radius_bounds result;
  result.is_converged = true;
  for(const std::vector<Index>& vertices : vertices_of_components(*triangles))
  {
    const Radius_bounds bounds = bound_component_radius(vertices, options, result.lower, queries);
    result.lower = std::max(result.lower, bounds.lower);
    result.is_converged = result.is_converged && bounds.is_converged;
    if(result.center == none || bounds.upper > result.upper)
    {
      result.upper = bounds.upper;
      result.center = bounds.center;
      result.farthest = bounds.farthest;
    }
  }
  result.number_of_queries = queries.number();
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
