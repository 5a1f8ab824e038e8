// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/parallel.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>

#include "mesh/edges_of_soup.h"
#include "mesh/orient_triangles.h"
#include "mesh/oriented_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

void build_rings(Surface_arrays& t, std::size_t number_of_vertices)
{
  t.ring_begin.assign(number_of_vertices + 1, 0);
  for(const Index vertex : t.corner)
    ++t.ring_begin[vertex + 1];
  std::partial_sum(t.ring_begin.begin(), t.ring_begin.end(), t.ring_begin.begin());
  t.ring.resize(t.corner.size());

  std::vector<Index> end(t.ring_begin.begin(), t.ring_begin.end() - 1);
  std::vector<bool> is_visited(t.corner.size(), false);
  for(Index c = 0; c < t.corner.size(); ++c)
  {
    if(is_visited[c])
      continue;
    // Turns clockwise to the boundary, or once around the vertex.
    Index start = c;
    while(t.twin[start] != none)
    {
      start = next_halfedge(t.twin[start]);
      if(start == c)
        break;
    }
    Index corner = start;
    do
    {
      is_visited[corner] = true;
      t.ring[end[t.corner[corner]]++] = corner;
      corner = t.twin[previous_halfedge(corner)];
    } while(corner != none && corner != start);
  }
}

namespace {

// Vertices or triangles that a thread processes at once.
constexpr std::size_t block_size = 1 << 14;

std::size_t number_of_blocks(std::size_t size) { return (size + block_size - 1) / block_size; }

// Allocates the arrays. The initialization to zero takes a tenth of the whole construction, so
// threads share it, the largest arrays first.
void resize_arrays(Mesh_arrays& result, std::size_t number_of_points, std::size_t number_of_faces,
                   unsigned number_of_threads)
{
  Surface_arrays& t = result.arrays;
  for_each_block(6, 1, number_of_threads,
                 [&](std::size_t i, std::size_t, std::size_t)
                 {
                   switch(i)
                   {
                   case 0:
                     return t.length.resize(3 * number_of_faces);
                   case 1:
                     return t.corner.resize(3 * number_of_faces);
                   case 2:
                     return t.twin.resize(3 * number_of_faces);
                   case 3:
                     return t.ring.resize(3 * number_of_faces);
                   case 4:
                     return t.point.resize(number_of_points);
                   default:
                     result.internal_vertex.resize(number_of_points);
                     result.triangle_of_face.resize(number_of_faces);
                     result.face_of_triangle.resize(number_of_faces);
                   }
                 });
}

// Sorts the points and fills the maps between the vertices. The points are not scaled.
void sort_points(Mesh_arrays& result, const std::vector<std::array<double, 3>>& points,
                 const Frame& frame, unsigned number_of_threads)
{
  result.caller_vertex = morton_order(points, frame, number_of_threads);
  result.internal_vertex.resize(points.size());
  result.arrays.point.resize(points.size());
  for_each_index(points.size(), number_of_threads,
                 [&](std::size_t s)
                 {
                   const Index v = result.caller_vertex[s];
                   result.internal_vertex[v] = static_cast<Index>(s);
                   result.arrays.point[s] = points[v];
                 });
}

// Sorts the triangles by their smallest vertex, ties by index (counting sort). Fills the corners
// and the maps between faces and triangles.
void sort_triangles(Mesh_arrays& result, const std::vector<Index>& corners,
                    unsigned number_of_threads)
{
  const std::size_t n = result.caller_vertex.size(), m = corners.size() / 3;
  const Index* const internal = result.internal_vertex.data();
  result.triangle_of_face.resize(m);
  result.face_of_triangle.resize(m);
  result.arrays.corner.resize(3 * m);
  // Each thread reads the smallest vertices of all faces and counts those of its own range.
  std::vector<Index>& smallest_vertex = result.face_of_triangle; // until it is overwritten below
  for_each_index(m, number_of_threads,
                 [&](std::size_t f)
                 {
                   const Index* const corner = corners.data() + 3 * f;
                   smallest_vertex[f] =
                       std::min({internal[corner[0]], internal[corner[1]], internal[corner[2]]});
                 });
  std::vector<Index> begin(n + 1, 0);
  const auto for_each_range = [&](const auto& visit)
  {
    for_each_block(n, block_size_of_threads(n, number_of_threads), number_of_threads,
                   [&](std::size_t, std::size_t first, std::size_t last)
                   { visit(static_cast<Index>(first), static_cast<Index>(last - first)); });
  };
  for_each_range(
      [&](Index first, Index size)
      {
        for(const Index smallest : smallest_vertex)
          if(smallest - first < size)
            ++begin[smallest + 1];
      });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for_each_range(
      [&](Index first, Index size)
      {
        for(std::size_t f = 0; f < m; ++f)
          if(const Index smallest = smallest_vertex[f]; smallest - first < size)
            result.triangle_of_face[f] = begin[smallest]++;
      });

  for_each_index(m, number_of_threads,
                 [&](std::size_t f)
                 {
                   const Index triangle = result.triangle_of_face[f];
                   result.face_of_triangle[triangle] = static_cast<Index>(f);
                   for(std::size_t k = 0; k < 3; ++k)
                     result.arrays.corner[3 * std::size_t(triangle) + k] =
                         internal[corners[3 * f + k]];
                 });
}

// Fills the twins from those of the faces.
void sort_twins(Mesh_arrays& result, const std::vector<Index>& twins)
{
  std::vector<Index>& sorted = result.arrays.twin;
  sorted.resize(twins.size());
  for(std::size_t f = 0; f < result.face_of_triangle.size(); ++f)
    for(std::size_t k = 0, from = 3 * std::size_t(result.face_of_triangle[f]); k < 3; ++k)
    {
      const Index twin = twins[from + k];
      sorted[3 * f + k] = twin == none ? none : 3 * result.triangle_of_face[twin / 3] + twin % 3;
    }
}

// The lengths of a range of triangles.
struct Length_statistics
{
  double longest = 0.;
  std::size_t number_of_positive = 0;
  std::size_t number_of_large = 0;      // not below min_edge_length
  std::size_t number_of_degenerate = 0; // triangles without area in double precision

  void add(const double* length)
  {
    const double a = length[0], b = length[1], c = length[2], longest_here = std::max({a, b, c});
    if(std::min({a, b, c}) <= 0. || a + b + c - longest_here <= longest_here)
      ++number_of_degenerate;
    longest = std::max(longest, longest_here);
    for(int k = 0; k < 3; ++k)
    {
      number_of_positive += length[k] > 0. ? 1 : 0;
      number_of_large += length[k] >= min_edge_length ? 1 : 0;
    }
  }
  void add(const Length_statistics& other)
  {
    longest = std::max(longest, other.longest);
    number_of_positive += other.number_of_positive;
    number_of_large += other.number_of_large;
    number_of_degenerate += other.number_of_degenerate;
  }
};

// Computes the scaled lengths of the halfedges. The points are not scaled: differences of the
// caller's coordinates have smaller errors.
Length_statistics compute_lengths(Surface_arrays& t, const Frame& frame, unsigned number_of_threads)
{
  const auto distance =
      [scaled = Scaling(frame)](const std::array<double, 3>& p, const std::array<double, 3>& q)
  {
    const double x = scaled(p[0] - q[0]), y = scaled(p[1] - q[1]), z = scaled(p[2] - q[2]);
    const double square = x * x + y * y + z * z;
    // Squares of edges that are much shorter than the extent underflow.
    return square > std::numeric_limits<double>::min() ? std::sqrt(square) : std::hypot(x, y, z);
  };
  t.length.resize(t.corner.size());
  const std::size_t m = t.number_of_triangles();
  std::vector<Length_statistics> of_blocks(number_of_blocks(m));
  for_each_block(m, block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   Length_statistics statistics;
                   for(std::size_t c = 3 * begin; c < 3 * end; c += 3)
                   {
                     const std::array<double, 3>&p = t.point[t.corner[c]],
                                              &q = t.point[t.corner[c + 1]],
                                              &r = t.point[t.corner[c + 2]];
                     t.length[c] = distance(p, q);
                     t.length[c + 1] = distance(q, r);
                     t.length[c + 2] = distance(r, p);
                     statistics.add(&t.length[c]);
                   }
                   of_blocks[block] = statistics;
                 });
  Length_statistics result;
  for(const Length_statistics& block : of_blocks)
    result.add(block);
  return result;
}

// Computes the lengths and scales them and the points; see Mesh_arrays.
void measure(Mesh_arrays& result, const Frame& frame, unsigned number_of_threads)
{
  Surface_arrays& t = result.arrays;
  const Length_statistics statistics = compute_lengths(t, frame, number_of_threads);
  result.number_of_degenerate_triangles = statistics.number_of_degenerate;
  // Most lengths that are not zero would be set to min_edge_length. Then distances would be wrong.
  if(2 * statistics.number_of_large < statistics.number_of_positive)
    throw Unsupported_surface_error(
        "Most edges are more than 5*10^10 times shorter than the extent of "
        "the mesh. Perhaps a vertex is far from the others.");
  const double unit_length =
      statistics.longest > 0. ? std::ldexp(1., std::ilogb(statistics.longest)) : 1.;
  const double factor = 1. / unit_length; // exact: a power of two
  // The maximum of each length and a constant preserves the triangle inequality.
  const double min_length = statistics.longest > 0. ? min_edge_length : 0.;
  for_each_index(t.length.size(), number_of_threads,
                 [&](std::size_t h) { t.length[h] = factor * std::max(t.length[h], min_length); });
  to_frame(t.point, frame, number_of_threads);
  if(factor != 1.)
    for_each_index(t.point.size(), number_of_threads,
                   [&](std::size_t v)
                   {
                     for(double& coordinate : t.point[v])
                       coordinate *= factor;
                   });
  t.scale = frame.scale * unit_length;
  t.origin = frame.origin;
}

} // namespace

Mesh_arrays build_mesh_arrays(std::vector<std::array<double, 3>> points,
                              const std::vector<Index>& corners, const std::vector<Index>& twins)
{
  Mesh_arrays result;
  const Frame frame = unit_frame(points, corners);
  sort_points(result, points, frame, 1);
  points = {};
  sort_triangles(result, corners, 1);
  sort_twins(result, twins);
  measure(result, frame, 1);
  build_rings(result.arrays, result.caller_vertex.size());
  return result;
}

std::optional<Mesh_arrays> build_oriented_arrays(const std::vector<std::array<double, 3>>& points,
                                                 const std::vector<Index>& corners,
                                                 Mesh_counts& counts, unsigned number_of_threads)
{
  Mesh_arrays result;
  resize_arrays(result, points.size(), corners.size() / 3, number_of_threads);
  const Frame frame = unit_frame(points, corners, number_of_threads);
  sort_points(result, points, frame, number_of_threads);
  sort_triangles(result, corners, number_of_threads);
  const std::optional<Ring_counts> ring_counts =
      build_oriented_rings(result.arrays, points.size(), number_of_threads);
  if(!ring_counts)
    return std::nullopt;
  counts.rings = *ring_counts;
  run_both(
      number_of_threads, [&] { measure(result, frame, number_of_threads); },
      [&] { counts.number_of_components = count_components(result.arrays.twin); });
  return result;
}

std::vector<Index> twins_of_soup(std::size_t number_of_points, const std::vector<Index>& corners)
{
  std::vector<Index> twin(corners.size(), none);
  for_each_edge_of_soup(number_of_points, corners,
                        [&](const std::vector<Index>& edge)
                        {
                          if(edge.size() == 2 && corners[edge[0]] != corners[edge[1]])
                          {
                            twin[edge[0]] = edge[1];
                            twin[edge[1]] = edge[0];
                          }
                        });
  return twin;
}

namespace {

std::pair<std::vector<Index>, std::size_t> label_components(const Surface_arrays& triangles,
                                                            const Proximity_graph& graph)
{
  const std::size_t n = triangles.number_of_vertices();
  std::vector<Index> label(n, none), stack;
  std::size_t count = 0;
  const auto visit = [&](Index vertex)
  {
    if(label[vertex] == none)
    {
      label[vertex] = static_cast<Index>(count);
      stack.push_back(vertex);
    }
  };
  for(Index seed = 0; seed < n; ++seed)
  {
    if(label[seed] != none)
      continue;
    visit(seed);
    while(!stack.empty())
    {
      const Index vertex = stack.back();
      stack.pop_back();
      for(Index i = triangles.ring_begin[vertex]; i < triangles.ring_begin[vertex + 1]; ++i)
      {
        visit(triangles.corner[next_halfedge(triangles.ring[i])]);
        visit(triangles.corner[previous_halfedge(triangles.ring[i])]);
      }
      if(!graph.begin.empty())
        for(Index i = graph.begin[vertex]; i < graph.begin[vertex + 1]; ++i)
          visit(graph.target[i]);
    }
    ++count;
  }
  return {std::move(label), count};
}

} // namespace

std::pair<std::vector<Index>, std::size_t> components(const Surface_arrays& triangles)
{
  return label_components(triangles, triangles.graph);
}

std::pair<std::vector<Index>, std::size_t> triangle_components(const Surface_arrays& triangles)
{
  return label_components(triangles, Proximity_graph());
}

} // namespace CGAL::Geodesic_processing::internal
