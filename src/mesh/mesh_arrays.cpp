// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/morton_order.h>

#include "mesh/edges_of_soup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the triangles sorted by their smallest vertex, ties by index (counting sort).
std::vector<Index> triangle_order(const std::vector<Index>& corner, std::size_t number_of_vertices)
{
  const std::size_t m = corner.size() / 3;
  std::vector<Index> begin(number_of_vertices + 1, 0), order(m);
  const auto smallest = [&](std::size_t f) {
    return std::min({corner[3 * f], corner[3 * f + 1], corner[3 * f + 2]});
  };
  for(std::size_t f = 0; f < m; ++f)
    ++begin[smallest(f) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  for(std::size_t f = 0; f < m; ++f)
    order[begin[smallest(f)]++] = static_cast<Index>(f);
  return order;
}

// Counts the triangles without area in double precision; see Mesh_arrays.
std::size_t count_degenerate_triangles(const std::vector<double>& length)
{
  std::size_t count = 0;
  for(std::size_t c = 0; c < length.size(); c += 3)
  {
    const double a = length[c], b = length[c + 1], l = length[c + 2];
    const double longest = std::max({a, b, l});
    if(std::min({a, b, l}) <= 0. || a + b + l - longest <= longest)
      ++count;
  }
  return count;
}

} // namespace

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

// Sorts the triangles and fills the corners, the twins and the maps between faces and triangles.
void add_triangles(Mesh_arrays& result, const std::vector<Index>& corners,
                   const std::vector<Index>& twins)
{
  Surface_arrays& t = result.arrays;
  const std::size_t m = corners.size() / 3;
  std::vector<Index> corner_vertex(corners.size());
  std::transform(corners.begin(), corners.end(), corner_vertex.begin(),
                 [&](Index vertex) { return result.internal_vertex[vertex]; });
  result.face_of_triangle = triangle_order(corner_vertex, result.caller_vertex.size());
  result.triangle_of_face.resize(m);
  for(Index f = 0; f < m; ++f)
    result.triangle_of_face[result.face_of_triangle[f]] = f;

  t.corner.resize(3 * m);
  t.twin.resize(3 * m);
  for(std::size_t f = 0; f < m; ++f)
    for(std::size_t k = 0, from = 3 * std::size_t(result.face_of_triangle[f]); k < 3; ++k)
    {
      const Index twin = twins[from + k];
      t.corner[3 * f + k] = corner_vertex[from + k];
      t.twin[3 * f + k] = twin == none ? none : 3 * result.triangle_of_face[twin / 3] + twin % 3;
    }
}

// Computes the scaled lengths of the halfedges. Returns the maximum. The points are not scaled:
// differences of the caller's coordinates have smaller errors.
double compute_lengths(Surface_arrays& t, const Frame& frame)
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
  double longest = 0.;
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index twin = t.twin[h];
    t.length[h] = twin < h ? t.length[twin]
                           : distance(t.point[t.corner[h]], t.point[t.corner[next_halfedge(h)]]);
    longest = std::max(longest, t.length[h]);
  }
  return longest;
}

// Returns whether most lengths that are not zero would be set to min_edge_length. Then distances
// would be wrong.
bool are_most_too_short(const std::vector<double>& length)
{
  const auto positive =
      std::count_if(length.begin(), length.end(), [](double l) { return l > 0.; });
  const auto large =
      std::count_if(length.begin(), length.end(), [](double l) { return l >= min_edge_length; });
  return 2 * large < positive;
}

} // namespace

Mesh_arrays build_mesh_arrays(std::vector<std::array<double, 3>> points,
                              const std::vector<Index>& corners, const std::vector<Index>& twins)
{
  Mesh_arrays result;
  Surface_arrays& t = result.arrays;
  const std::size_t n = points.size();

  const Frame frame = unit_frame(points, corners);
  {
    auto scaled_points = points;
    to_frame(scaled_points, frame);
    result.caller_vertex = morton_order(scaled_points);
  }
  result.internal_vertex.resize(n);
  t.point.resize(n);
  for(Index s = 0; s < n; ++s)
  {
    result.internal_vertex[result.caller_vertex[s]] = s;
    t.point[s] = points[result.caller_vertex[s]];
  }
  points = {};

  add_triangles(result, corners, twins);
  const double longest = compute_lengths(t, frame);
  to_frame(t.point, frame);
  result.number_of_degenerate_triangles = count_degenerate_triangles(t.length);
  if(are_most_too_short(t.length))
    throw Unsupported_surface_error(
        "Most edges are more than 5*10^10 times shorter than the extent of "
        "the mesh. Perhaps a vertex is far from the others.");
  // The maximum of each length and a constant preserves the triangle inequality.
  if(longest > 0.)
    for(double& length : t.length)
      length = std::max(length, min_edge_length);
  const double unit_length = longest > 0. ? std::ldexp(1., std::ilogb(longest)) : 1.;
  const double factor = 1. / unit_length; // exact: a power of two
  for(double& length : t.length)
    length *= factor;
  for(auto& point : t.point)
    for(double& coordinate : point)
      coordinate *= factor;
  t.scale = frame.scale * unit_length;
  t.origin = frame.origin;

  build_rings(t, n);
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
