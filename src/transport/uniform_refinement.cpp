// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/uniform_refinement.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Sets the rings. The order around a vertex is that of `corners`.
void set_rings(Surface_arrays& t, std::size_t number_of_vertices, const std::vector<Index>& corners)
{
  t.ring_begin.assign(number_of_vertices + 1, 0);
  for(const Index vertex : t.corner)
    ++t.ring_begin[vertex + 1];
  std::partial_sum(t.ring_begin.begin(), t.ring_begin.end(), t.ring_begin.begin());
  t.ring.resize(t.corner.size());
  std::vector<Index> next(t.ring_begin.begin(), t.ring_begin.end() - 1);
  for(const Index corner : corners)
    t.ring[next[t.corner[corner]]++] = corner;
}

// Returns corner j of child triangle `child` of the triangle that contains halfedge h; both are
// taken modulo 3. The next function returns corner j of the center triangle.
constexpr Index child_corner(Index h, Index child, Index j)
{
  return 3 * (4 * (h / 3) + child % 3) + j % 3;
}
constexpr Index center_child_corner(Index h, Index j) { return 3 * (4 * (h / 3) + 3) + j % 3; }

// Returns the twins of all halfedges of the refined mesh.
std::vector<Index> child_twins(const Surface_arrays& t)
{
  std::vector<Index> result(4 * t.corner.size());
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index k = h % 3, twin = t.twin[h], l = twin % 3;
    const bool is_boundary = twin == none;
    result[child_corner(h, k, k)] = is_boundary ? none : child_corner(twin, l + 1, l);
    result[child_corner(h, k + 1, k)] = is_boundary ? none : child_corner(twin, l, l);
    result[child_corner(h, k + 2, k)] = center_child_corner(h, k);
    result[center_child_corner(h, k)] = child_corner(h, k + 2, k);
  }
  return result;
}

// Returns all corners in the order of the rings: counterclockwise around each vertex. At a
// midpoint, the corners in one triangle precede those in the other.
std::vector<Index> child_corners_by_vertex(const Surface_arrays& t)
{
  std::vector<Index> result;
  result.reserve(4 * t.corner.size());
  for(const Index corner : t.ring)
    result.push_back(child_corner(corner, corner % 3, corner % 3));
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index k = h % 3;
    result.insert(result.end(), {child_corner(h, k + 1, k), center_child_corner(h, k + 2),
                                 child_corner(h, k, k + 1)});
  }
  return result;
}

} // namespace

std::vector<Index> edge_midpoints(const Surface_arrays& t)
{
  std::vector<Index> result(t.corner.size());
  Index next = Index(t.number_of_vertices());
  if(!t.is_cloud())
  {
    for(Index h = 0; h < result.size(); ++h)
      result[h] = t.twin[h] < h ? result[t.twin[h]] : next++;
    return result;
  }
  const auto endpoints = [&](Index h) -> std::pair<Index, Index>
  { return std::minmax(t.corner[h], t.corner[next_halfedge(h)]); };
  std::vector<Index> order(result.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b)
            { return std::tuple(endpoints(a), a) < std::tuple(endpoints(b), b); });
  for(std::size_t i = 0; i < order.size(); ++i)
    result[order[i]] = i > 0 && endpoints(order[i]) == endpoints(order[i - 1]) ? next - 1 : next++;
  return result;
}

Surface_arrays refined(const Surface_arrays& t)
{
  Surface_arrays result;
  const std::vector<Index> midpoints = edge_midpoints(t);
  Index number_of_vertices = Index(t.number_of_vertices());
  for(const Index vertex : midpoints)
    number_of_vertices = std::max(number_of_vertices, vertex + 1);

  result.corner.resize(4 * t.corner.size());
  result.length.resize(result.corner.size());
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index k = h % 3;
    result.corner[child_corner(h, k, k)] = t.corner[h];
    result.corner[child_corner(h, k, k + 1)] = midpoints[h];
    result.corner[child_corner(h, k, k + 2)] = midpoints[previous_halfedge(h)];
    result.corner[center_child_corner(h, k)] = midpoints[next_halfedge(h)];
    // Half the scale doubles the lengths: the edges of the children have the lengths of the
    // parent's edges.
    for(Index child = 0; child < 3; ++child)
      result.length[child_corner(h, child, k)] = t.length[h];
    result.length[center_child_corner(h, k)] = t.length[h];
  }
  for(const float weight : t.weight)
    result.weight.insert(result.weight.end(), 4, weight);
  result.scale = 0.5 * t.scale;
  result.origin = t.origin;
  if(t.is_cloud())
    result.graph.begin.assign(number_of_vertices + 1, 0);
  else
    result.twin = child_twins(t);
  set_rings(result, number_of_vertices, child_corners_by_vertex(t));
  return result;
}

Surface_location refined(const Surface_location& location)
{
  if(location.triangle == none)
    return location;
  const auto& b = location.barycentric;
  const Index k = Index(std::max_element(b.begin(), b.end()) - b.begin());
  Surface_location result;
  const bool is_at_corner = b[k] >= 0.5;
  result.triangle = 4 * location.triangle + (is_at_corner ? k : 3);
  for(Index j = 0; j < 3; ++j)
    result.barycentric[j] = is_at_corner ? 2. * b[j] - (j == k ? 1. : 0.) : 1. - 2. * b[j];
  return result;
}

Vector refined(const Surface_arrays& coarse, const Surface_arrays& fine, const Vector& function)
{
  Vector result = Vector::Zero(Eigen::Index(fine.number_of_vertices()));
  result.head(function.size()) = function;
  for(Index h = 0; h < coarse.corner.size(); ++h)
    result[fine.corner[child_corner(h, h % 3, h % 3 + 1)]] =
        0.5 * (function[coarse.corner[h]] + function[coarse.corner[next_halfedge(h)]]);
  return result;
}

// The center triangle is rotated by 180 degrees, hence the minus sign.
Field coarsened(const Field& fine)
{
  Field result(fine.size() / 4);
  for(std::size_t f = 0; f < result.size(); ++f)
    result[f] = 0.25 * (fine[4 * f] + fine[4 * f + 1] + fine[4 * f + 2] - fine[4 * f + 3]);
  return result;
}

Vector coarsened(const Surface_arrays& coarse, const Surface_arrays& fine, const Vector& masses)
{
  Vector result = masses.head(Eigen::Index(coarse.number_of_vertices()));
  Vector remaining = masses;
  for(Index h = 0; h < coarse.corner.size(); ++h)
  {
    double& mass = remaining[fine.corner[child_corner(h, h % 3, h % 3 + 1)]];
    for(const Index endpoint : {h, next_halfedge(h)})
      result[coarse.corner[endpoint]] += 0.5 * mass;
    mass = 0.; // on a cloud, another edge with this midpoint has the same ends
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
