// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/harmonic_fields.h"

#include <CGAL/Geodesic_processing/exceptions.h>

#include <cmath>
#include <utility>

namespace CGAL::Geodesic_processing::internal {

namespace {

// A tree of triangles for each component, joined through sides, and a tree of sites along others.  All
// that lies behind borders is one triangle more, which is the root where there is a border.
struct Tree_and_cotree
{
  std::vector<Index> way;       // #triangles: the side that leads to the root, none at a root
  std::vector<bool> is_in_tree; // #sides, both of a pair: in the tree or crossed by the cotree

  explicit Tree_and_cotree(const Glued_triangles& triangles)
      : way(triangles.number_of_triangles(), none), is_in_tree(triangles.corner.size(), false)
  {
    grow_cotree(triangles);
    grow_tree(triangles);
  }

  // The sides in neither tree, one of each pair.
  std::vector<Index> others(const Glued_triangles& triangles) const
  {
    std::vector<Index> result;
    for(Index side = 0; side < triangles.corner.size(); ++side)
      if(!is_in_tree[side] && (triangles.twin[side] == none || side < triangles.twin[side]))
        result.push_back(side);
    return result;
  }

private:
  void take(const Glued_triangles& triangles, Index side)
  {
    is_in_tree[side] = true;
    if(triangles.twin[side] != none)
      is_in_tree[triangles.twin[side]] = true;
  }

  void grow_cotree(const Glued_triangles& triangles)
  {
    const Index n = Index(triangles.number_of_triangles());
    std::vector<bool> is_reached(n, false);
    std::vector<Index> front;
    const auto grow = [&]
    {
      for(std::size_t i = 0; i < front.size(); ++i)
        for(Index side = 3 * front[i]; side < 3 * front[i] + 3; ++side)
        {
          const Index twin = triangles.twin[side];
          if(twin == none || is_reached[twin / 3])
            continue;
          is_reached[twin / 3] = true;
          way[twin / 3] = twin;
          take(triangles, twin);
          front.push_back(twin / 3);
        }
      front.clear();
    };
    const auto start = [&](Index triangle)
    {
      is_reached[triangle] = true;
      front.push_back(triangle);
      grow();
    };
    for(Index side = 0; side < 3 * n; ++side)
      if(triangles.twin[side] == none && !is_reached[side / 3])
      {
        way[side / 3] = side;
        take(triangles, side);
        start(side / 3);
      }
    for(Index triangle = 0; triangle < n; ++triangle)
      if(!is_reached[triangle])
        start(triangle);
  }

  void grow_tree(const Glued_triangles& triangles)
  {
    std::vector<bool> is_reached(triangles.number_of_sites(), false);
    std::vector<Index> front;
    const auto reach = [&](Index side, Index site)
    {
      if(is_in_tree[side] || is_reached[site])
        return;
      is_reached[site] = true;
      take(triangles, side);
      front.push_back(site);
    };
    for(Index seed = 0; seed < is_reached.size(); ++seed)
    {
      if(is_reached[seed])
        continue;
      is_reached[seed] = true;
      front.push_back(seed);
      for(std::size_t i = 0; i < front.size(); ++i)
        for(Index k = triangles.first[front[i]]; k < triangles.first[front[i] + 1]; ++k)
        {
          const Index corner = triangles.star[k], before = previous_side(corner);
          reach(corner, triangles.corner[next_side(corner)]);
          reach(before, triangles.corner[before]);
        }
      front.clear();
    }
  }
};

// Adds what a curve across a side, out of its triangle, adds to a form.
void cross(const Glued_triangles& triangles, Index side, double amount, std::vector<double>& form)
{
  form[side] += amount;
  if(triangles.twin[side] != none)
    form[triangles.twin[side]] -= amount;
}

// The form, a number for each side, whose integral along a curve is how often that crosses the loop from
// the root to a side, through it and back to the root; where both ways are one, nothing is left.
std::vector<double> form_across(const Glued_triangles& triangles, const Tree_and_cotree& trees,
                                Index side)
{
  std::vector<double> form(triangles.corner.size(), 0.);
  const auto to_root = [&](Index from, double amount)
  {
    while(from != none && trees.way[from / 3] != none)
    {
      const Index out = trees.way[from / 3];
      cross(triangles, out, amount, form);
      from = triangles.twin[out];
    }
  };
  to_root(side, -1.);
  cross(triangles, side, 1., form);
  to_root(triangles.twin[side], 1.);
  return form;
}

Field field_of(const Operators& operators, const std::vector<double>& form)
{
  Field result(operators.number_of_triangles());
  for(std::size_t f = 0; f < result.size(); ++f)
    result[f] = form[3 * f] * operators.hat[3 * f + 1] +
                (form[3 * f] + form[3 * f + 1]) * operators.hat[3 * f + 2];
  return result;
}

void add(double factor, const Field& field, Field& result)
{
  for(std::size_t f = 0; f < field.size(); ++f)
    result[f] = result[f] + factor * field[f];
}

} // namespace

std::size_t number_of_harmonic_fields(const Glued_triangles& triangles)
{
  return triangles.is_cloud() ? 0 : Tree_and_cotree(triangles).others(triangles).size();
}

std::vector<Field> harmonic_fields(const Glued_triangles& triangles, const Operators& operators,
                                   const Sparse_solver& laplacian)
{
  if(triangles.is_cloud())
    throw Unsupported_surface_error("A cloud has no harmonic fields: its triangles are not glued.");
  const Tree_and_cotree trees(triangles);
  std::vector<Field> result;
  for(const Index side : trees.others(triangles))
  {
    Field field = field_of(operators, form_across(triangles, trees, side));
    add(-1., gradient(operators, laplacian.solve(divergence(operators, field))), field);
    for(int sweep = 0; sweep < 2; ++sweep) // the second one for what rounding left
      for(const Field& other : result)
        add(-inner_product(operators, field, other), other, field);
    const double size = std::sqrt(inner_product(operators, field, field));
    for(Planar& vector : field)
      vector = (1. / size) * vector;
    result.push_back(std::move(field));
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
