// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/surfels/surfel_arrays.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include <CGAL/Geodesic_processing/internal/surfels/surfel_neighbors.h>
#include "core/edges.h"
#include "surfels/delaunay_rings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

double distance(const Vec3& a, const Vec3& b) { return norm(a - b); }

// Returns true if the ring of a vertex contains the triangle (vertex, a, b).
bool ring_has_edge(const Ragged_rows& rings, Index vertex, Index a, Index b)
{
  const Index *begin = rings.begin(vertex), *end = rings.end(vertex);
  const Index* it = std::find(begin, end, a);
  if(it == end)
    return false;
  // An entry can occur twice: in the last triangle of one fan and the first one of another fan.
  for(; it != end; it = std::find(it + 1, end, a))
    if((it + 1 == end ? *begin : it[1]) == b)
      return true;
  return false;
}

std::size_t number_of_blocks(std::size_t size)
{
  return (size + surfel_block_size - 1) / surfel_block_size;
}

// Concatenates the entries of all blocks, and frees the blocks.
template <typename T>
std::vector<T> concatenated(std::vector<std::vector<T>> blocks)
{
  std::size_t size = 0;
  for(const std::vector<T>& block : blocks)
    size += block.size();
  std::vector<T> result;
  result.reserve(size);
  for(std::vector<T>& block : blocks)
  {
    result.insert(result.end(), block.begin(), block.end());
    std::vector<T>().swap(block);
  }
  return result;
}

// Collects the triangles of all rings. A triangle that several corners found is appended once, by
// the corner with the smallest index. Its weight is one third of the number of these corners.
void collect_triangles(const Ragged_rows& rings, unsigned number_of_threads, Surface_arrays& t)
{
  const std::size_t n = rings.row_begin.size() - 1;
  std::vector<std::vector<Index>> corners(number_of_blocks(n));
  std::vector<std::vector<float>> weights(number_of_blocks(n));
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(const Index* it = rings.begin(i); it != rings.end(i); ++it)
                     {
                       const Index a = *it, b = it + 1 == rings.end(i) ? *rings.begin(i) : it[1];
                       if(a == none || b == none)
                         continue;
                       const bool is_in_ring_of_a = ring_has_edge(rings, a, b, i),
                                  is_in_ring_of_b = ring_has_edge(rings, b, i, a);
                       if((is_in_ring_of_a && a < i) || (is_in_ring_of_b && b < i))
                         continue;
                       corners[block].insert(corners[block].end(), {i, a, b});
                       weights[block].push_back(is_in_ring_of_a && is_in_ring_of_b
                                                    ? 1.f
                                                    : (1 + is_in_ring_of_a + is_in_ring_of_b) /
                                                          3.f);
                     }
                 });
  t.corner = concatenated(std::move(corners));
  t.weight = concatenated(std::move(weights));
}

// Computes `ring` and `ring_begin`: the corners at each vertex, sorted by index.
void build_rings(Surface_arrays& t)
{
  t.ring_begin.assign(t.point.size() + 1, 0);
  for(const Index v : t.corner)
    ++t.ring_begin[v + 1];
  std::partial_sum(t.ring_begin.begin(), t.ring_begin.end(), t.ring_begin.begin());
  std::vector<Index> end(t.ring_begin.begin(), t.ring_begin.end() - 1);
  t.ring.resize(t.corner.size());
  for(Index corner = 0; corner < t.corner.size(); ++corner)
    t.ring[end[t.corner[corner]]++] = corner;
}

using Graph_edge = std::pair<Index, Index>;

// Returns the graph of the vertices 0..n-1 with these edges, sorted by their first vertex
// (counting sort).
Proximity_graph graph_of(std::size_t n, const std::vector<Graph_edge>& edges)
{
  Proximity_graph result;
  result.begin.assign(n + 1, 0);
  for(const Graph_edge& edge : edges)
    ++result.begin[edge.first + 1];
  std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
  result.target.resize(edges.size());
  std::vector<Index> end(result.begin.begin(), result.begin.end() - 1);
  for(const Graph_edge& edge : edges)
    result.target[end[edge.first]++] = edge.second;
  return result;
}

// Removes the neighbors without an edge: edges connect gentle neighbors with intersecting spheres.
void remove_unconnected(const Distinct_surfels& surfels, const std::vector<double>& radius,
                        Ragged_rows& neighbors)
{
  for_each_block(
      surfels.size(), surfel_block_size, surfels.number_of_threads,
      [&](std::size_t block, std::size_t, std::size_t)
      {
        neighbors.replace_rows(
            block,
            [&](std::size_t row, const Index* begin, const Index* end, std::vector<Index>& result)
            {
              const Index i = static_cast<Index>(row);
              std::copy_if(begin, end, std::back_inserter(result),
                           [&](Index j)
                           {
                             return distance(surfels.point[i], surfels.point[j]) <=
                                        radius[i] + radius[j] &&
                                    surfels.compatibility(i, j) == Compatibility::gentle;
                           });
            });
      });
}

// Returns the edge (j, i) for each edge (i, j) whose surfel i is not among the neighbors of j. This
// only occurs beyond the search radius of j.
std::vector<Graph_edge> missing_reverse_edges(const Distinct_surfels& surfels,
                                              const Ragged_rows& neighbors,
                                              const std::vector<double>& search_radius)
{
  std::vector<std::vector<Graph_edge>> edges(number_of_blocks(surfels.size()));
  for_each_block(surfels.size(), surfel_block_size, surfels.number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(const Index* j = neighbors.begin(i); j != neighbors.end(i); ++j)
                       if(distance(surfels.point[i], surfels.point[*j]) >
                              search_radius[*j] * (1. - 1e-12) && // round-off errors
                          std::find(neighbors.begin(*j), neighbors.end(*j), i) == neighbors.end(*j))
                         edges[block].emplace_back(*j, i);
                 });
  return concatenated(std::move(edges));
}

// Builds the graph: edges between gentle neighbors with intersecting spheres, the edges of all
// triangles, and an edge from each copy to its original. The rows of neighbors become those of the
// graph, so that the memory is used twice.
//
// original  #copies: the vertices of the surfels whose copies follow the vertices of the tree
void build_graph(const Distinct_surfels& surfels, Ragged_rows neighbors,
                 const std::vector<double>& search_radius, const std::vector<double>& radius,
                 const std::vector<Index>& original, Surface_arrays& t)
{
  const std::size_t n = surfels.size();
  remove_unconnected(surfels, radius, neighbors);
  std::vector<Graph_edge> edges = missing_reverse_edges(surfels, neighbors, search_radius);
  for(std::size_t copy = 0; copy < original.size(); ++copy)
    edges.emplace_back(original[copy], static_cast<Index>(n + copy));
  const Proximity_graph more_edges = graph_of(n, edges);
  std::vector<Graph_edge>().swap(edges);
  for_each_block(
      n, surfel_block_size, surfels.number_of_threads,
      [&](std::size_t block, std::size_t, std::size_t)
      {
        neighbors.replace_rows(
            block,
            [&](std::size_t i, const Index* begin, const Index* end, std::vector<Index>& result)
            {
              const std::ptrdiff_t row = std::ptrdiff_t(result.size());
              result.insert(result.end(), begin, end);
              result.insert(result.end(), more_edges.target.begin() + more_edges.begin[i],
                            more_edges.target.begin() + more_edges.begin[i + 1]);
              for(Index k = t.ring_begin[i]; k < t.ring_begin[i + 1]; ++k)
                for(const Index h : {next_halfedge(t.ring[k]), previous_halfedge(t.ring[k])})
                  if(std::find(result.begin() + row, result.end(), t.corner[h]) == result.end())
                    result.push_back(t.corner[h]);
              std::sort(result.begin() + row, result.end());
            });
      });
  neighbors.join();
  t.graph.begin = std::move(neighbors.row_begin);
  t.graph.target = std::move(neighbors.entries);
  t.graph.begin.reserve(n + original.size() + 1);
  t.graph.target.reserve(t.graph.target.size() + original.size());
  for(const Index vertex : original)
  {
    t.graph.target.push_back(vertex);
    t.graph.begin.push_back(static_cast<Index>(t.graph.target.size()));
  }
}

// Computes the lengths of the edges of triangles. Scales all lengths and coordinates by a power of two, such
// that the longest edge lies in [1, 2).
void compute_lengths(Surfel_arrays& surfels, unsigned number_of_threads)
{
  Surface_arrays& t = surfels.arrays;
  const std::size_t n = t.point.size();
  std::vector<double> longest_in_block(number_of_blocks(n), 0.);
  for_each_block(n, surfel_block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   for(Index i = static_cast<Index>(begin); i < end; ++i)
                     for(Index e = t.graph.begin[i]; e < t.graph.begin[i + 1]; ++e)
                       longest_in_block[block] =
                           std::max(longest_in_block[block], graph_edge_length(t, i, e));
                 });
  // The edges of triangles are edges of the graph, so this is the longest of both.
  double longest = 0.;
  for(const double length : longest_in_block)
    longest = std::max(longest, length);
  const int exponent = longest > 0. ? std::ilogb(longest) : 0;
  const double factor = std::ldexp(1., -exponent);
  for(double& radius : surfels.radius)
    radius *= factor;
  surfels.tree.scale(factor);
  for(Vec3& point : t.point)
    for(double& x : point)
      x *= factor;
  t.scale = std::ldexp(t.scale, exponent);
  t.length.resize(t.corner.size());
  for(Index h = 0; h < t.corner.size(); ++h)
    t.length[h] = distance(t.point[t.corner[h]], t.point[t.corner[next_halfedge(h)]]);
}

// Appends a vertex for each copy of a surfel.
//
// copies    #copies: the surfels
// original  #copies: the vertex that each one is a copy of
// normals   #copies
void append_copies(const std::vector<Index>& copies, const std::vector<Index>& original,
                   const std::vector<Vec3>& normals, Surfel_arrays& surfels)
{
  Surface_arrays& t = surfels.arrays;
  const std::size_t size = t.point.size() + copies.size();
  t.point.reserve(size);
  t.normal.reserve(size);
  surfels.radius.reserve(size);
  surfels.caller_vertex.reserve(size);
  t.normal.insert(t.normal.end(), normals.begin(), normals.end());
  for(std::size_t i = 0; i < copies.size(); ++i)
  {
    surfels.internal_vertex[copies[i]] = static_cast<Index>(t.point.size());
    t.point.push_back(t.point[original[i]]);
    surfels.radius.push_back(surfels.radius[original[i]]);
    surfels.caller_vertex.push_back(copies[i]);
  }
}

} // namespace

Surfel_arrays build_surfel_arrays(std::vector<std::array<double, 3>> points,
                                  std::vector<std::array<double, 3>> normals,
                                  const std::vector<double>& radii, const Surfel_options& options)
{
  const std::size_t n = points.size();
  check_sizes(n, normals.size(), radii.size());
  if(!(options.maximum_angle > 0.) || options.maximum_angle > std::acos(-1.) || options.rank == 0)
    throw Invalid_argument_error(
        "The maximum angle between the normals of neighbors must be positive and at most pi, and "
        "the rank of the neighbor that determines the radius must be positive.");
  const auto begin_step = [&]
  {
    if(options.callback)
      options.callback(0.);
  };
  Surfel_arrays result;
  Surface_arrays& t = result.arrays;
  const Compatibility_test compatibility_test = {std::cos(options.maximum_angle)};
  Frame centered; // of points that are relative to the origin
  if(options.frame)
    centered.scale = options.frame->scale;
  else
    normalize(normals);
  begin_step();
  Sorted_surfels sorted =
      sort_surfels(std::move(points), normals, compatibility_test.cosine, options.number_of_threads,
                   options.frame ? &centered : nullptr);
  t.origin = options.frame ? options.frame->origin : sorted.frame.origin;
  t.scale = result.frame_scale = sorted.frame.scale;
  std::vector<Index> copies, original; // the surfels of the copies, and their vertices
  std::vector<Vec3> copy_normals;
  for(Index i = 0; i < n; ++i)
    if(const Index vertex = sorted.internal_vertex[i]; sorted.caller_vertex[vertex] != i)
    {
      copies.push_back(i);
      original.push_back(vertex);
      copy_normals.push_back(normals[i]);
    }
  std::vector<Vec3>().swap(normals);
  begin_step();
  Neighbor_distances distances;
  Ragged_rows neighbors = find_neighbors(sorted, &compatibility_test, number_of_ring_neighbors,
                                         options.number_of_threads, distances);
  std::vector<double>().swap(distances.spacing);
  begin_step();
  result.radius = surfel_radii(sorted, radii, neighbors, options.rank, options.number_of_threads);

  result.tree = std::move(sorted.tree);
  t.point = std::move(sorted.point);
  t.normal = std::move(sorted.normal);
  result.internal_vertex = std::move(sorted.internal_vertex);
  result.caller_vertex = std::move(sorted.caller_vertex);
  append_copies(copies, original, copy_normals, result);

  const Distinct_surfels surfels = {t.point, t.normal, result.tree, compatibility_test,
                                    options.number_of_threads};
  begin_step();
  const Ragged_rows rings =
      find_delaunay_rings(surfels, neighbors, distances.search_radius, result.radius);
  begin_step();
  collect_triangles(rings, options.number_of_threads, t);
  build_rings(t);
  begin_step();
  build_graph(surfels, std::move(neighbors), distances.search_radius, result.radius, original, t);
  distances = {};
  begin_step();
  compute_lengths(result, options.number_of_threads);
  return result;
}

Tangent_location locate(const Kd_tree& tree, const std::vector<Vec3>& points,
                        const std::vector<Vec3>& normals, const std::vector<double>& radii,
                        const Frame& frame, const std::array<double, 3>& point)
{
  if(tree.size() == 0)
    throw Invalid_argument_error("A point cannot be located on an empty surface.");
  Vec3 query;
  for(int k = 0; k < 3; ++k)
  {
    if(!std::isfinite(point[k]))
      throw Invalid_argument_error("A coordinate of the point to locate is not finite.");
    // Clamp distant points, so that squared distances cannot overflow.
    query[k] = std::clamp(std::ldexp(point[k], -std::ilogb(frame.scale)) -
                              std::ldexp(frame.origin[k], -std::ilogb(frame.scale)),
                          -1e100, 1e100);
  }
  Tangent_location location;
  location.vertex = tree.nearest(points, query);
  const Vec3 offset = query - points[location.vertex];
  const auto [u, v] = tangent_frame(normals[location.vertex]);
  const double x = dot(offset, u), y = dot(offset, v), length = std::hypot(x, y);
  const double max_offset = max_circumradius_ratio * radii[location.vertex];
  const double shrink_factor = length > max_offset ? max_offset / length : 1.;
  location.offset = {shrink_factor * x, shrink_factor * y};
  return location;
}

namespace {

using Projected_triangle = std::array<std::array<double, 2>, 3>;

struct Closest_point
{
  double distance;
  std::array<double, 3> barycentric;
};

// Returns the point of the edges of a triangle that is closest to the origin.
Closest_point closest_edge_point(const Projected_triangle& p)
{
  Closest_point result = {infinity, {}};
  for(int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const double dx = p[next][0] - p[k][0], dy = p[next][1] - p[k][1];
    const double squared_length = dx * dx + dy * dy;
    const double fraction =
        squared_length > 0. ? std::clamp(-(p[k][0] * dx + p[k][1] * dy) / squared_length, 0., 1.)
                            : 0.;
    const double distance = std::hypot(p[k][0] + fraction * dx, p[k][1] + fraction * dy);
    if(distance < result.distance)
    {
      result = {distance, {0., 0., 0.}};
      result.barycentric[k] = 1. - fraction;
      result.barycentric[next] = fraction;
    }
  }
  return result;
}

// Returns the point of a triangle that is closest to the origin. The distance is zero if the
// triangle contains the origin, and infinite if the area of the triangle is not positive.
Closest_point closest_to_origin(const Projected_triangle& p)
{
  const auto doubled_area = [&](int i, int j) { return p[i][0] * p[j][1] - p[i][1] * p[j][0]; };
  std::array<double, 3> barycentric = {doubled_area(1, 2), doubled_area(2, 0), doubled_area(0, 1)};
  const double area = barycentric[0] + barycentric[1] + barycentric[2];
  if(!(area > 0.))
    return {infinity, {}};
  if(barycentric[0] < 0. || barycentric[1] < 0. || barycentric[2] < 0.)
    return closest_edge_point(p);
  for(double& x : barycentric)
    x /= area;
  return {0., barycentric};
}

} // namespace

Surface_location to_surface_location(const Surface_arrays& t, const Tangent_location& location)
{
  Surface_location result;
  result.vertex = location.vertex;
  if(location.offset[0] == 0. && location.offset[1] == 0.)
    return result;
  const auto frame = tangent_frame(t.normal[location.vertex]);
  double min_distance = infinity;
  const auto try_triangle = [&](Index triangle)
  {
    Projected_triangle p; // relative to the location
    for(Index k = 0; k < 3; ++k)
    {
      const Vec3 offset_vector = t.point[t.corner[3 * triangle + k]] - t.point[location.vertex];
      p[k] = {dot(offset_vector, frame.first) - location.offset[0],
              dot(offset_vector, frame.second) - location.offset[1]};
    }
    const Closest_point closest = closest_to_origin(p);
    if(closest.distance < min_distance)
    {
      min_distance = closest.distance;
      result = {triangle, none, closest.barycentric};
    }
  };
  for(Index i = t.ring_begin[location.vertex]; i < t.ring_begin[location.vertex + 1]; ++i)
    try_triangle(t.ring[i] / 3);
  // The Delaunay triangle that contains a point need not be incident to the nearest vertex of the
  // point.
  if(min_distance > 0.)
    for(Index i = t.graph.begin[location.vertex]; i < t.graph.begin[location.vertex + 1]; ++i)
    {
      const Index neighbor = t.graph.target[i];
      for(Index k = t.ring_begin[neighbor]; k < t.ring_begin[neighbor + 1]; ++k)
        try_triangle(t.ring[k] / 3);
    }
  return result;
}

Tangent_location to_tangent_location(const Surface_arrays& t, const Surface_location& location)
{
  if(location.triangle == none)
    return {location.vertex, {0., 0.}};
  const auto& b = location.barycentric;
  const Index largest = static_cast<Index>(std::max_element(b.begin(), b.end()) - b.begin());
  Tangent_location result;
  result.vertex = t.corner[3 * location.triangle + largest];
  const auto [u, v] = tangent_frame(t.normal[result.vertex]);
  for(Index k = 0; k < 3; ++k)
  {
    const Vec3 edge_vector = t.point[t.corner[3 * location.triangle + k]] - t.point[result.vertex];
    result.offset[0] += b[k] * dot(edge_vector, u);
    result.offset[1] += b[k] * dot(edge_vector, v);
  }
  return result;
}

std::array<double, 3> position(const Surface_arrays& t, const Tangent_location& location)
{
  const auto [u, v] = tangent_frame(t.normal[location.vertex]);
  std::array<double, 3> result = t.point[location.vertex];
  for(int k = 0; k < 3; ++k)
    result[k] += location.offset[0] * u[k] + location.offset[1] * v[k];
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
