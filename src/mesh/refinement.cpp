// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/mesh/mesh_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include <CGAL/Geodesic_processing/internal/core/vec3.h>
#include "core/unfold.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

using Barycentric = std::array<double, 3>;

constexpr std::array<Barycentric, 3> unit_corners = {
    Barycentric{1., 0., 0.}, Barycentric{0., 1., 0.}, Barycentric{0., 0., 1.}};

Barycentric interpolated(const std::array<Barycentric, 3>& corners, const Barycentric& b)
{
  Barycentric result = {0., 0., 0.};
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      result[j] += b[i] * corners[i][j];
  return result;
}

// Computes the barycentric coordinates of p with respect to three corners; not finite if these are
// collinear.
Barycentric barycentric_coordinates(const std::array<Barycentric, 3>& corners, const Barycentric& p)
{
  const auto area = [](const Barycentric& a, const Barycentric& b, const Barycentric& c)
  { return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]); };
  const double total_area = area(corners[0], corners[1], corners[2]);
  return {area(p, corners[1], corners[2]) / total_area,
          area(corners[0], p, corners[2]) / total_area,
          area(corners[0], corners[1], p) / total_area};
}

// The triangles of a refinement before they are renumbered.
struct Refined_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<Index> corners, twins;
  std::vector<Index> parent;
  std::vector<std::array<Barycentric, 3>> in_parent;
};

// Builds the arrays of a refinement of from.triangles, with parents in from.coarse.
Refinement build_refinement(const Refinement& from, Refined_soup soup)
{
  if(soup.corners.size() > (std::size_t(1) << 31))
    throw Unsupported_surface_error(
        "The refinement for so many samples has more than 2^31 halfedges.");
  Mesh_arrays mesh = build_mesh_arrays(std::move(soup.points), soup.corners, soup.twins);
  Surface_arrays& t = mesh.arrays;
  const Surface_arrays& previous_arrays = *from.triangles;
  for(int k = 0; k < 3; ++k)
    t.origin[k] = previous_arrays.origin[k] + previous_arrays.scale * t.origin[k];
  t.scale *= previous_arrays.scale;
  Refinement result;
  result.coarse = from.coarse;
  result.parent.reserve(mesh.face_of_triangle.size());
  result.corners.reserve(mesh.face_of_triangle.size());
  for(const Index child : mesh.face_of_triangle)
  {
    const Index parent = soup.parent[child];
    std::array<Barycentric, 3> corners = soup.in_parent[child];
    if(!from.parent.empty())
      for(Barycentric& corner : corners)
        corner = interpolated(from.corners[parent], corner);
    result.parent.push_back(from.parent.empty() ? parent : from.parent[parent]);
    result.corners.push_back(corners);
  }
  result.triangles = std::make_shared<const Surface_arrays>(std::move(t));
  return result;
}

// Nodes of a triangle: its corners 0, 1, 2 and the midpoints 3, 4, 5 of its edges.
using Corner_nodes = std::array<Index, 3>;

// The children of a triangle, each by its three nodes.
struct Split_pattern
{
  std::array<Corner_nodes, 4> children;
  Index size;
};

// Returns the children of a triangle some of whose edges are split, in counterclockwise order.
// is_second_shorter: if two edges are split, which diagonal divides the quadrilateral: true for the
// one that begins at the midpoint of the first split edge.
Split_pattern split_pattern(const std::array<bool, 3>& is_split, bool is_second_shorter)
{
  const int count = is_split[0] + is_split[1] + is_split[2];
  if(count == 0)
    return {{Corner_nodes{0, 1, 2}}, 1};
  if(count == 3)
    return {{Corner_nodes{0, 3, 5}, Corner_nodes{3, 1, 4}, Corner_nodes{5, 4, 2},
             Corner_nodes{3, 4, 5}},
            4};
  // Rotated so that edge k, or the edges k and k + 1, are split.
  Index k = 0;
  while(!is_split[k] || (count == 2 && !is_split[(k + 1) % 3]))
    ++k;
  const Index a = k, b = (k + 1) % 3, c = (k + 2) % 3, ab = 3 + a, bc = 3 + b;
  if(count == 1)
    return {{Corner_nodes{a, ab, c}, Corner_nodes{ab, b, c}}, 2};
  if(is_second_shorter)
    return {{Corner_nodes{ab, b, bc}, Corner_nodes{a, ab, c}, Corner_nodes{ab, bc, c}}, 3};
  return {{Corner_nodes{ab, b, bc}, Corner_nodes{a, ab, bc}, Corner_nodes{a, bc, c}}, 3};
}

Barycentric barycentric_of_node(Index node)
{
  return node < 3 ? unit_corners[node] : barycentric_on_halfedge(node - 3, 0.5);
}

} // namespace

Refinement make_refinement(std::shared_ptr<const Surface_arrays> triangles)
{
  const Surface_arrays& t = *triangles;
  Refinement result{triangles, triangles, {}, {}};
  std::vector<Index> vertex_of_fan, fan(t.corner.size());
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
  {
    vertex_of_fan.push_back(vertex);
    for(Index i = t.ring_begin[vertex]; i < t.ring_begin[vertex + 1]; ++i)
    {
      if(i > t.ring_begin[vertex] && next_corner_ccw(t, t.ring[i - 1]) != t.ring[i])
        vertex_of_fan.push_back(vertex);
      fan[t.ring[i]] = Index(vertex_of_fan.size() - 1);
    }
  }
  if(vertex_of_fan.size() == t.number_of_vertices())
    return result;
  Refined_soup soup;
  for(const Index vertex : vertex_of_fan)
    soup.points.push_back(t.point[vertex]);
  soup.corners = std::move(fan);
  soup.twins = t.twin;
  soup.parent.resize(t.number_of_triangles());
  std::iota(soup.parent.begin(), soup.parent.end(), Index(0));
  soup.in_parent.assign(t.number_of_triangles(), unit_corners);
  return build_refinement(result, std::move(soup));
}

namespace {

// Appends the midpoints of the split edges to `points`. Returns the index of the midpoint of each
// halfedge, or none.
std::vector<Index> add_midpoints(const Surface_arrays& t, const std::vector<bool>& is_split,
                                 std::vector<Vec3>& points)
{
  std::vector<Index> midpoint(t.corner.size(), none);
  for(Index h = 0; h < t.corner.size(); ++h)
    if(is_split[h])
    {
      if(t.twin[h] < h)
        midpoint[h] = midpoint[t.twin[h]];
      else
      {
        midpoint[h] = Index(points.size());
        points.push_back(0.5 * (t.point[t.corner[h]] + t.point[t.corner[next_halfedge(h)]]));
      }
    }
  return midpoint;
}

// Returns the split pattern of a triangle. If two edges are split, the remaining quadrilateral is
// divided along its shorter diagonal.
Split_pattern split_pattern_of_triangle(const Surface_arrays& t, Index f,
                                        const std::vector<bool>& is_split)
{
  const std::array<bool, 3> is_split_edge = {is_split[3 * f], is_split[3 * f + 1],
                                             is_split[3 * f + 2]};
  bool is_second_shorter = false;
  if(is_split_edge[0] + is_split_edge[1] + is_split_edge[2] == 2)
  {
    Index k = 0;
    while(is_split_edge[k])
      ++k;
    // The edge that is not split runs from c to a.
    const Index c = k, a = (k + 1) % 3, b = (k + 2) % 3;
    const auto corners = unfolded(t, f);
    is_second_shorter = norm(unfolded_point(corners, barycentric_of_node(3 + a)) - corners[c]) <
                        norm(unfolded_point(corners, barycentric_of_node(3 + b)) - corners[a]);
  }
  return split_pattern(is_split_edge, is_second_shorter);
}

// Sets the twins of the halfedges of triangle f's children, which begin at halfedge `begin`: inside
// the triangle the twins, on its edges `halves` (see split_edges()).
void connect_children(const Split_pattern& pattern, Index f, Index begin, std::vector<Index>& twins,
                      std::vector<std::array<Index, 2>>& halves)
{
  for(Index i = 0; i < 3 * pattern.size; ++i)
  {
    const Index from_node = pattern.children[i / 3][i % 3],
                to_node = pattern.children[i / 3][(i + 1) % 3];
    for(Index j = 0; j < i; ++j)
      if(pattern.children[j / 3][j % 3] == to_node &&
         pattern.children[j / 3][(j + 1) % 3] == from_node)
      {
        twins[begin + i] = begin + j;
        twins[begin + j] = begin + i;
      }
    if(from_node < 3 && (to_node == (from_node + 1) % 3 || to_node == 3 + from_node))
      halves[3 * f + from_node][0] = begin + i;
    else if(from_node >= 3 && to_node == (from_node - 3 + 1) % 3)
      halves[3 * f + from_node - 3][1] = begin + i;
  }
}

} // namespace

Refinement split_edges(const Refinement& from, const std::vector<bool>& is_split)
{
  const Surface_arrays& t = *from.triangles;
  Refined_soup soup;
  soup.points = t.point;
  const std::vector<Index> midpoint = add_midpoints(t, is_split, soup.points);

  // Each split edge adds one child to each incident triangle.
  const std::size_t count =
      t.number_of_triangles() + std::size_t(std::count(is_split.begin(), is_split.end(), true));
  soup.corners.reserve(3 * count);
  soup.twins.reserve(3 * count);
  soup.parent.reserve(count);
  soup.in_parent.reserve(count);

  // For each halfedge: the child halfedge that is all of it or its first half, and its second half.
  std::vector<std::array<Index, 2>> halves(t.corner.size(), {none, none});
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const auto point_at = [&](Index node)
    { return node < 3 ? t.corner[3 * f + node] : midpoint[3 * f + node - 3]; };
    const Split_pattern pattern = split_pattern_of_triangle(t, f, is_split);
    const Index begin = Index(soup.corners.size());
    for(Index i = 0; i < pattern.size; ++i)
    {
      const Corner_nodes& child = pattern.children[i];
      for(const Index node : child)
        soup.corners.push_back(point_at(node));
      soup.parent.push_back(f);
      soup.in_parent.push_back({barycentric_of_node(child[0]), barycentric_of_node(child[1]),
                                barycentric_of_node(child[2])});
    }
    soup.twins.resize(soup.corners.size(), none);
    connect_children(pattern, f, begin, soup.twins, halves);
  }
  for(Index h = 0; h < t.corner.size(); ++h)
    if(const Index twin = t.twin[h]; twin != none)
    {
      const bool is_split_edge = is_split[h];
      soup.twins[halves[h][0]] = halves[twin][is_split_edge ? 1 : 0];
      if(is_split_edge)
        soup.twins[halves[h][1]] = halves[twin][0];
    }
  return build_refinement(from, std::move(soup));
}

Surface_location to_coarse(const Refinement& refinement, const Surface_location& location)
{
  if(refinement.parent.empty())
    return location;
  const Surface_location fine = location.triangle == none
                                    ? vertex_location(*refinement.triangles, location.vertex)
                                    : location;
  if(fine.triangle == none)
    return {}; // a vertex without triangles
  return canonical(*refinement.coarse,
                   {refinement.parent[fine.triangle], none,
                    interpolated(refinement.corners[fine.triangle], fine.barycentric)});
}

std::vector<Surface_location> to_fine(const Refinement& refinement,
                                      const std::vector<Surface_location>& locations)
{
  if(refinement.parent.empty())
    return locations;
  // The children of each coarse triangle.
  std::vector<Index> begin(refinement.coarse->number_of_triangles() + 1, 0),
      children(refinement.parent.size());
  for(const Index parent : refinement.parent)
    ++begin[parent + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Index> end(begin.begin(), begin.end() - 1);
  for(Index f = 0; f < children.size(); ++f)
    children[end[refinement.parent[f]]++] = f;

  std::vector<Surface_location> result;
  for(const Surface_location& location : locations)
  {
    const Surface_location coarse =
        location.triangle == none ? vertex_location(*refinement.coarse, location.vertex) : location;
    Surface_location best;
    // the largest minimum of barycentric coordinates: the child that contains the point up to
    // round-off errors
    double largest_minimum = -infinity;
    for(Index i = coarse.triangle == none ? 0 : begin[coarse.triangle];
        coarse.triangle != none && i < begin[coarse.triangle + 1]; ++i)
    {
      const Barycentric b =
          barycentric_coordinates(refinement.corners[children[i]], coarse.barycentric);
      if(const double minimum = std::min({b[0], b[1], b[2]}); minimum > largest_minimum)
      {
        largest_minimum = minimum;
        best = {children[i], none, b};
      }
    }
    if(best.triangle != none)
      best = canonical(*refinement.triangles, best);
    result.push_back(best);
  }
  return result;
}

std::vector<Index> coarse_halfedges(const Refinement& refinement)
{
  std::vector<Index> result(refinement.triangles->corner.size(), none);
  if(refinement.parent.empty())
    std::iota(result.begin(), result.end(), Index(0));
  else
    for(Index h = 0; h < result.size(); ++h)
    {
      const auto& corners = refinement.corners[h / 3];
      for(Index k = 0; k < 3; ++k)
        if(corners[h % 3][(k + 2) % 3] == 0. && corners[(h + 1) % 3][(k + 2) % 3] == 0.)
          result[h] = 3 * refinement.parent[h / 3] + k;
    }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
