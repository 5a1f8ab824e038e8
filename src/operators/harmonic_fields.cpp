// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/harmonic_fields.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Two spanning trees. The cotree connects the triangles of each component across edges. The tree
// connects vertices along edges that the cotree does not cross. The exterior of the boundary is one
// more triangle. If a component has a boundary, the exterior is the root of its cotree.
struct Tree_cotree
{
  // #triangles: the halfedge that leads to the parent, none at the root
  std::vector<Index> parent_halfedge;
  std::vector<bool> is_in_tree; // #halfedges: the edge is in the tree or crossed by the cotree

  explicit Tree_cotree(const Surface_arrays& triangles)
      : parent_halfedge(triangles.number_of_triangles(), none),
        is_in_tree(triangles.corner.size(), false)
  {
    grow_cotree(triangles);
    grow_tree(triangles);
  }

  // Returns one halfedge of each edge that is in neither tree.
  std::vector<Index> generators(const Surface_arrays& triangles) const
  {
    std::vector<Index> result;
    for(Index h = 0; h < triangles.corner.size(); ++h)
      if(!is_in_tree[h] && (triangles.twin[h] == none || h < triangles.twin[h]))
        result.push_back(h);
    return result;
  }

private:
  void mark(const Surface_arrays& triangles, Index h)
  {
    is_in_tree[h] = true;
    if(triangles.twin[h] != none)
      is_in_tree[triangles.twin[h]] = true;
  }

  void grow_cotree(const Surface_arrays& triangles)
  {
    const Index n = Index(triangles.number_of_triangles());
    std::vector<bool> is_reached(n, false);
    std::vector<Index> queue;
    const auto traverse = [&]
    {
      for(std::size_t i = 0; i < queue.size(); ++i)
        for(Index h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
        {
          const Index twin = triangles.twin[h];
          if(twin == none || is_reached[twin / 3])
            continue;
          is_reached[twin / 3] = true;
          parent_halfedge[twin / 3] = twin;
          mark(triangles, twin);
          queue.push_back(twin / 3);
        }
      queue.clear();
    };
    const auto start_at = [&](Index triangle)
    {
      is_reached[triangle] = true;
      queue.push_back(triangle);
      traverse();
    };
    for(Index h = 0; h < 3 * n; ++h)
      if(triangles.twin[h] == none && !is_reached[h / 3])
      {
        parent_halfedge[h / 3] = h;
        mark(triangles, h);
        start_at(h / 3);
      }
    for(Index triangle = 0; triangle < n; ++triangle)
      if(!is_reached[triangle])
        start_at(triangle);
  }

  void grow_tree(const Surface_arrays& triangles)
  {
    std::vector<bool> is_reached(triangles.number_of_vertices(), false);
    std::vector<Index> queue;
    const auto visit = [&](Index h, Index vertex)
    {
      if(is_in_tree[h] || is_reached[vertex])
        return;
      is_reached[vertex] = true;
      mark(triangles, h);
      queue.push_back(vertex);
    };
    for(Index seed = 0; seed < is_reached.size(); ++seed)
    {
      if(is_reached[seed])
        continue;
      is_reached[seed] = true;
      queue.push_back(seed);
      for(std::size_t i = 0; i < queue.size(); ++i)
        for(Index k = triangles.ring_begin[queue[i]]; k < triangles.ring_begin[queue[i] + 1]; ++k)
        {
          const Index corner = triangles.ring[k],
                      previous_halfedge_of_corner = previous_halfedge(corner);
          visit(corner, triangles.corner[next_halfedge(corner)]);
          visit(previous_halfedge_of_corner, triangles.corner[previous_halfedge_of_corner]);
        }
      queue.clear();
    }
  }
};

// Adds a crossing of halfedge h, out of its triangle, to a 1-form.
void add_crossing(const Surface_arrays& triangles, Index h, double amount,
                  std::vector<double>& form)
{
  form[h] += amount;
  if(triangles.twin[h] != none)
    form[triangles.twin[h]] -= amount;
}

// Returns a closed 1-form, one number for each halfedge. Its integral along a curve is the number
// of signed crossings with a loop. The loop leads from the root to h, across h, and back to the
// root. If both paths of triangles are equal, their contributions cancel.
std::vector<double> closed_form_across(const Surface_arrays& triangles, const Tree_cotree& trees,
                                       Index h)
{
  std::vector<double> form(triangles.corner.size(), 0.);
  const auto add_crossings_to_root = [&](Index from, double amount)
  {
    while(from != none && trees.parent_halfedge[from / 3] != none)
    {
      const Index outgoing = trees.parent_halfedge[from / 3];
      add_crossing(triangles, outgoing, amount, form);
      from = triangles.twin[outgoing];
    }
  };
  add_crossings_to_root(h, -1.);
  add_crossing(triangles, h, 1., form);
  add_crossings_to_root(triangles.twin[h], 1.);
  return form;
}

Field field_of_form(const Operators& operators, const std::vector<double>& form)
{
  Field result(operators.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
    result[f] = form[3 * f] * operators.hat_gradient[3 * f + 1] +
                (form[3 * f] + form[3 * f + 1]) * operators.hat_gradient[3 * f + 2];
  return result;
}

void add_scaled(double factor, const Field& field, Field& result)
{
  for(std::size_t f = 0; f < field.size(); ++f)
    result[f] = result[f] + factor * field[f];
}

} // namespace

std::size_t number_of_harmonic_fields(const Surface_arrays& triangles)
{
  return triangles.is_cloud() ? 0 : Tree_cotree(triangles).generators(triangles).size();
}

std::vector<Field> harmonic_fields(const Surface_arrays& triangles, const Operators& operators,
                                   const Poisson_solver& poisson_solver)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error(
        "Harmonic fields need a mesh: a cloud has no halfedges with twins.");
  const Tree_cotree trees(triangles);
  std::vector<Field> result;
  for(const Index h : trees.generators(triangles))
  {
    Field field = field_of_form(operators, closed_form_across(triangles, trees, h));
    add_scaled(-1., gradient(operators, poisson_solver.solve(minus_divergence(operators, field))),
               field);
    // the second sweep removes round-off errors of the first one
    for(int sweep = 0; sweep < 2; ++sweep)
      for(const Field& previous : result)
        add_scaled(-inner_product(operators, field, previous), previous, field);
    const double size = std::sqrt(inner_product(operators, field, field));
    for(Vec2& vector : field)
      vector = (1. / size) * vector;
    result.push_back(std::move(field));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
