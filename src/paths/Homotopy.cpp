// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "paths/Homotopy.h"

#include <CGAL/Geodesic_processing/exceptions.h>
#include <CGAL/Geodesic_processing/internal/core/path_locations.h>
#include "core/unfold.h"

#include <algorithm>
#include <cstdlib>

namespace CGAL::Geodesic_processing::internal {

namespace {

Index inverse_letter(Index letter) { return letter ^ 1; }

// Returns the corner of a triangle at a vertex.
Index corner_at_vertex(const Surface_arrays& t, Index triangle, Index vertex)
{
  Index corner = 3 * triangle;
  while(t.corner[corner] != vertex)
    ++corner;
  return corner;
}

// Appends the halfedges that a path crosses around a vertex, from one of its corners to another.
// Returns false if the corners are in different fans.
bool append_crossings_around(const Surface_arrays& t, Index from, Index to,
                             std::vector<Index>& crossed)
{
  const std::size_t size = crossed.size();
  for(const bool is_counterclockwise : {true, false})
  {
    Index corner = from;
    do
    {
      if(corner == to)
        return true;
      crossed.push_back(is_counterclockwise ? previous_halfedge(corner) : corner);
      corner = is_counterclockwise ? next_corner_ccw(t, corner) : next_corner_cw(t, corner);
    } while(corner != none && corner != from);
    crossed.resize(size);
  }
  return false;
}

} // namespace

Homotopy::Homotopy(const Surface_arrays& triangles) : t(triangles), m_fans(fans(triangles))
{
  const std::vector<Index> roots = grow_forest();
  find_generators();
  m_begin.assign(m_fans.size(), 0);
  m_end.assign(m_fans.size(), 0);
  m_next_letter.fill(std::vector<Index>(2 * number_of_generators(), none));
  for(const Index root : roots)
    order_crossings(root);
}

// Computes the parent of each fan. Returns the roots: all fans at the boundary, and one fan of each
// component without boundary.
std::vector<Index> Homotopy::grow_forest()
{
  const Index number_of_fans = m_fans.size();
  m_parent_halfedge.assign(number_of_fans, none);
  std::vector<bool> is_reached(number_of_fans, false);
  std::vector<Index> queue, roots;
  const auto traverse = [&]
  {
    for(std::size_t i = 0; i < queue.size(); ++i)
      m_fans.for_each_corner(t, queue[i],
                             [&](Index corner)
                             {
                               const Index twin = t.twin[corner];
                               if(twin == none || is_reached[m_fans.fan[twin]])
                                 return;
                               is_reached[m_fans.fan[twin]] = true;
                               m_parent_halfedge[m_fans.fan[twin]] = twin;
                               queue.push_back(m_fans.fan[twin]);
                             });
    queue.clear();
  };
  for(Index fan = 0; fan < number_of_fans; ++fan)
    if(m_fans.is_at_boundary(t, fan))
    {
      is_reached[fan] = true;
      queue.push_back(fan);
      roots.push_back(fan);
    }
  traverse();
  for(Index fan = 0; fan < number_of_fans; ++fan)
    if(!is_reached[fan])
    {
      is_reached[fan] = true;
      queue.push_back(fan);
      roots.push_back(fan);
      traverse();
    }
  return roots;
}

// Grows the spanning trees of triangles across edges that are not in the forest. The remaining
// edges are the generators.
void Homotopy::find_generators()
{
  std::vector<bool> is_in_tree(t.corner.size(), false);
  const auto mark = [&](Index h) { is_in_tree[h] = is_in_tree[t.twin[h]] = true; };
  for(const Index h : m_parent_halfedge)
    if(h != none)
      mark(h);
  std::vector<bool> is_reached(t.number_of_triangles(), false);
  std::vector<Index> queue;
  for(Index root = 0; root < is_reached.size(); ++root)
  {
    if(is_reached[root])
      continue;
    is_reached[root] = true;
    queue.assign(1, root);
    for(std::size_t i = 0; i < queue.size(); ++i)
      for(Index h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
        if(t.twin[h] != none && !is_in_tree[h] && !is_reached[t.twin[h] / 3])
        {
          is_reached[t.twin[h] / 3] = true;
          mark(h);
          queue.push_back(t.twin[h] / 3);
        }
  }
  m_letter.assign(t.corner.size(), none);
  for(Index h = 0; h < t.corner.size(); ++h)
    if(t.twin[h] != none && !is_in_tree[h] && h < t.twin[h])
    {
      m_letter[h] = Index(2 * m_relator_length.size());
      m_letter[t.twin[h]] = m_letter[h] + 1;
      m_relator_length.push_back(0);
    }
}

// Walks around the tree of a root and lists the crossings of generators.
void Homotopy::order_crossings(Index root)
{
  struct Visit
  {
    Index fan, corner, end; // the next corner, and the one at which the walk around the fan ends
  };
  const std::size_t begin = m_crossings.size();
  std::vector<Visit> stack = {{root, m_fans.first_corner[root], none}};
  m_begin[root] = begin;
  while(!stack.empty())
  {
    Visit& visit = stack.back();
    const Index corner = visit.corner;
    if(corner == none || corner == visit.end)
    {
      m_end[visit.fan] = m_crossings.size();
      stack.pop_back();
      continue;
    }
    if(visit.end == none)
      visit.end = corner; // an interior root is surrounded once
    visit.corner = next_corner_ccw(t, corner);
    const Index twin = t.twin[corner];
    if(twin == none)
      continue;
    if(m_parent_halfedge[m_fans.fan[twin]] == twin)
    {
      m_begin[m_fans.fan[twin]] = m_crossings.size();
      stack.push_back({m_fans.fan[twin], next_corner_ccw(t, twin), twin});
    }
    else if(m_letter[twin] != none)
      m_crossings.push_back(m_letter[twin]);
  }
  if(!m_fans.is_at_boundary(t, root))
    set_relator(begin);
}

// Stores the relator of a component without boundary.
void Homotopy::set_relator(std::size_t begin)
{
  const std::size_t length = m_crossings.size() - begin;
  for(std::size_t i = 0; i < length; ++i)
  {
    const Index letter = m_crossings[begin + i];
    const Index next = m_crossings[begin + (i + 1) % length];
    m_next_letter[0][letter] = next;
    m_next_letter[1][inverse_letter(next)] = inverse_letter(letter);
    m_relator_length[letter / 2] = Index(length);
  }
}

Homotopy::Word Homotopy::word(const std::vector<Index>& crossed_halfedges) const
{
  Word result;
  for(const Index h : crossed_halfedges)
  {
    const Index twin = t.twin[h];
    if(m_letter[h] != none)
      result.push_back(m_letter[h]);
    else if(const Index fan = m_fans.fan[h]; m_parent_halfedge[fan] == h)
      result.insert(result.end(), m_crossings.begin() + m_begin[fan],
                    m_crossings.begin() + m_end[fan]);
    else if(const Index opposite_fan = m_fans.fan[twin]; m_parent_halfedge[opposite_fan] == twin)
      for(std::size_t i = m_end[opposite_fan]; i > m_begin[opposite_fan]; --i)
        result.push_back(inverse_letter(m_crossings[i - 1]));
  }
  return result;
}

Homotopy::Word Homotopy::reduced(const Word& word) const
{
  if(word.empty())
    return {};
  const Index length = m_relator_length[word.front() / 2];
  if(length == 4)
    return reduced_on_torus(word);
  struct Letter
  {
    Index letter;
    // The lengths of the longest subwords that end here and belong to the relator or its inverse.
    std::array<Index, 2> run;
  };
  std::vector<Letter> stack;
  Word pending(word.rbegin(), word.rend()); // what follows, in reverse order
  while(!pending.empty())
  {
    const Index letter = pending.back();
    pending.pop_back();
    if(!stack.empty() && stack.back().letter == inverse_letter(letter))
    {
      stack.pop_back();
      continue;
    }
    Letter next = {letter, {1, 1}};
    for(int i = 0; i < 2; ++i)
      if(length != 0 && !stack.empty() && m_next_letter[i][stack.back().letter] == letter)
        next.run[i] = stack.back().run[i] + 1;
    stack.push_back(next);
    const int i = next.run[0] >= next.run[1] ? 0 : 1;
    if(length == 0 || next.run[i] <= length / 2)
      continue;
    // Replaces more than half of the relator by the inverse of the rest.
    stack.resize(stack.size() - next.run[i]);
    Index last = letter;
    for(Index k = next.run[i]; k < length; ++k)
    {
      last = m_next_letter[i][last];
      pending.push_back(inverse_letter(last));
    }
  }
  Word result;
  for(const Letter& letter : stack)
    result.push_back(letter.letter);
  return result;
}

Homotopy::Word Homotopy::inverse(const Word& word)
{
  Word result(word.rbegin(), word.rend());
  for(Index& letter : result)
    letter = inverse_letter(letter);
  return result;
}

bool Homotopy::is_equal(const Word& a, const Word& b) const
{
  if(a == b)
    return true;
  Word quotient = inverse(a);
  quotient.insert(quotient.end(), b.begin(), b.end());
  return reduced(quotient).empty();
}

// The group of a torus is commutative.
Homotopy::Word Homotopy::reduced_on_torus(const Word& word) const
{
  // The two generators are adjacent in the relator.
  const Index some = word.front() / 2, other = m_next_letter[0][word.front()] / 2;
  Word result;
  for(const Index generator : {std::min(some, other), std::max(some, other)})
  {
    long exponent = 0;
    for(const Index letter : word)
      if(letter / 2 == generator)
        exponent += letter % 2 == 0 ? 1 : -1;
    result.insert(result.end(), std::size_t(std::abs(exponent)),
                  2 * generator + (exponent < 0 ? 1 : 0));
  }
  return result;
}

std::optional<std::vector<Index>>
crossed_halfedges(const Surface_arrays& t, const std::vector<Surface_location>& closed_path)
{
  std::vector<Surface_location> path;
  for(const Surface_location& location : closed_path)
    if(path.empty() || !is_same_point(t, path.back(), canonical(t, location)))
      path.push_back(canonical(t, location));
  if(path.size() > 1 && is_same_point(t, path.front(), path.back()))
    path.pop_back();
  std::vector<Index> result;
  const std::size_t size = path.size();
  if(size < 2)
    return result;
  const auto triangle_after = [&](std::size_t i)
  {
    const Index result = common_triangle(t, path[i], path[(i + 1) % size]);
    if(result == none)
      throw Invalid_argument_error(
          "Two consecutive locations of a path are not in a common triangle.");
    return result;
  };
  Index triangle = triangle_after(size - 1);
  for(std::size_t i = 0; i < size; ++i)
  {
    const Index next_triangle = triangle_after(i);
    if(next_triangle == triangle)
      continue;
    if(const Index vertex = vertex_of(t, path[i]); vertex != none)
    {
      if(!append_crossings_around(t, corner_at_vertex(t, triangle, vertex),
                                  corner_at_vertex(t, next_triangle, vertex), result))
        return std::nullopt;
    }
    else
    {
      const Index h = halfedge_of(path[i]);
      result.push_back(h / 3 == triangle ? h : t.twin[h]);
    }
    triangle = next_triangle;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
