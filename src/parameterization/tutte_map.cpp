// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Geodesic_processing/internal/parameterization/tutte_map.h>

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/parameterization/symmetric_dirichlet.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Returns the next halfedge of the boundary cycle of h.
Index next_boundary_halfedge(const Surface_arrays& t, Index h)
{
  for(h = next_halfedge(h); t.twin[h] != none;)
    h = next_halfedge(t.twin[h]);
  return h;
}

// Maps the vertices of a boundary cycle to the unit circle. Angles between them are in proportion
// to the lengths of the edges.
std::vector<std::pair<Index, Vec2>> boundary_on_circle(const Surface_arrays& t,
                                                       const std::vector<Index>& loop)
{
  double length = 0., length_so_far = 0.;
  for(const Index h : loop)
    length += t.length[h];
  std::vector<std::pair<Index, Vec2>> result;
  for(std::size_t i = 0; i < loop.size(); ++i)
  {
    // The uniform part separates the vertices of edges of length zero.
    const double uniform = double(i) / double(loop.size());
    const double angle =
        2. * pi * (length > 0. ? 0.99 * length_so_far / length + 0.01 * uniform : uniform);
    length_so_far += t.length[loop[i]];
    result.emplace_back(t.corner[loop[i]], Vec2{std::cos(angle), std::sin(angle)});
  }
  return result;
}

} // namespace

std::vector<std::vector<Index>> boundary_loops(const Surface_arrays& t)
{
  std::vector<std::vector<Index>> result;
  std::vector<bool> is_seen(t.corner.size(), false);
  std::vector<double> length;
  for(Index start = 0; start < t.corner.size(); ++start)
  {
    if(t.twin[start] != none || is_seen[start])
      continue;
    result.emplace_back();
    length.push_back(0.);
    for(Index h = start; !is_seen[h]; h = next_boundary_halfedge(t, h))
    {
      is_seen[h] = true;
      result.back().push_back(h);
      length.back() += t.length[h];
    }
  }
  if(!result.empty())
    std::swap(result.front(),
              result[std::size_t(std::max_element(length.begin(), length.end()) - length.begin())]);
  return result;
}

void check_is_disk(const Surface_arrays& t)
{
  std::size_t number_of_vertices = 0, number_of_edges = 0;
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    number_of_vertices += t.ring_begin[vertex] < t.ring_begin[vertex + 1];
  for(Index h = 0; h < t.twin.size(); ++h)
    number_of_edges += t.twin[h] == none || h < t.twin[h];
  // Traverses a component across edges.
  std::vector<bool> is_reached(t.number_of_triangles(), false);
  std::vector<Index> stack;
  std::size_t number_reached = 0;
  if(!is_reached.empty())
  {
    stack.push_back(0);
    is_reached[0] = true;
  }
  while(!stack.empty())
  {
    const Index f = stack.back();
    stack.pop_back();
    ++number_reached;
    for(Index h = 3 * f; h < 3 * f + 3; ++h)
      if(t.twin[h] != none && !is_reached[t.twin[h] / 3])
      {
        is_reached[t.twin[h] / 3] = true;
        stack.push_back(t.twin[h] / 3);
      }
  }
  if(number_reached == 0 || number_reached < t.number_of_triangles())
    throw Unsupported_surface_error("The surface is not connected.");
  const std::size_t number_of_loops = boundary_loops(t).size();
  if(number_of_loops == 0)
    throw Unsupported_surface_error(
        "The surface has no boundary and must be cut before it can be flattened.");
  if(number_of_vertices + t.number_of_triangles() + number_of_loops != number_of_edges + 2)
    throw Unsupported_surface_error(
        "The surface has handles or a nonmanifold vertex and must be cut before it "
        "can be flattened.");
}

namespace {

// Sets the image of each vertex that is not fixed to the mean of its neighbors. Each boundary loop
// except the first one is filled with a vertex that is connected to all its vertices.
void solve_for_means(const Surface_arrays& t, const std::vector<std::vector<Index>>& loops,
                     const std::vector<bool>& is_fixed, std::vector<Vec2>& image)
{
  std::vector<int> unknown(t.number_of_vertices(), -1);
  int number_of_unknowns = 0;
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    if(!is_fixed[vertex] && t.ring_begin[vertex] < t.ring_begin[vertex + 1])
      unknown[vertex] = number_of_unknowns++;
  std::vector<Eigen::Triplet<double>> entries;
  const int number_of_holes = int(loops.size()) - 1;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(number_of_unknowns + number_of_holes, 2);
  const auto add_entry = [&](int i, const Vec2& p, int j)
  {
    entries.emplace_back(i, i, 1.);
    if(j < 0)
      rhs.row(i) += Eigen::RowVector2d(p[0], p[1]);
    else if(j < i)
      entries.emplace_back(i, j, -1.);
  };
  const auto add_edge = [&](Index a, Index b)
  {
    if(unknown[a] >= 0)
      add_entry(unknown[a], image[b], unknown[b]);
    if(unknown[b] >= 0)
      add_entry(unknown[b], image[a], unknown[a]);
  };
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] == none || h < t.twin[h])
      add_edge(t.corner[h], t.corner[next_halfedge(h)]);
  for(int hole = 0; hole < number_of_holes; ++hole)
    for(const Index h : loops[std::size_t(hole) + 1])
    {
      const Index vertex = t.corner[h];
      add_entry(number_of_unknowns + hole, image[vertex], unknown[vertex]);
      if(unknown[vertex] >= 0)
        add_entry(unknown[vertex], {}, number_of_unknowns + hole);
    }
  if(number_of_unknowns + number_of_holes > 0)
  {
    Sparse_matrix matrix(number_of_unknowns + number_of_holes,
                         number_of_unknowns + number_of_holes);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Sparse_solver(matrix).solve_columns(rhs);
  }
  for(Index vertex = 0; vertex < t.number_of_vertices(); ++vertex)
    if(unknown[vertex] >= 0)
      image[vertex] = {rhs(unknown[vertex], 0), rhs(unknown[vertex], 1)};
}

} // namespace

std::vector<Vec2> tutte_map(const Surface_arrays& t)
{
  const auto loops = boundary_loops(t);
  std::vector<Vec2> image(t.number_of_vertices(), Vec2{0., 0.});
  std::vector<bool> is_fixed(t.number_of_vertices(), false);
  for(const auto& [vertex, p] : boundary_on_circle(t, loops.front()))
  {
    image[vertex] = p;
    is_fixed[vertex] = true;
  }
  solve_for_means(t, loops, is_fixed, image);
  if(const double scale = scale_to_area(t, image); scale > 0.)
    for(Vec2& p : image)
      p = scale * p;
  return image;
}

} // namespace CGAL::Geodesic_processing::internal
