// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/dual.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Parts of a cell, and its Euler characteristic: sites and sides of one label, and triangles.  A cell,
// which reaches a little into the triangles around them, has the same.
class Parts
{
public:
  Parts(const std::vector<Index>& labels, Index number_of_cells)
      : m_labels(labels), m_up(labels.size()), m_parts(number_of_cells, 0),
        m_characteristic(number_of_cells, 0)
  {
    std::iota(m_up.begin(), m_up.end(), Index(0));
  }

  void add_site(Index site)
  {
    ++m_parts[m_labels[site]];
    ++m_characteristic[m_labels[site]];
  }
  void add_side(Index x, Index z)
  {
    --m_characteristic[m_labels[x]];
    x = root(x);
    z = root(z);
    if(x == z)
      return;
    m_up[std::max(x, z)] = std::min(x, z);
    --m_parts[m_labels[x]];
  }
  void add_triangle(Index label) { ++m_characteristic[label]; }

  bool is_empty(Index cell) const { return m_parts[cell] == 0; }
  // One part without holes.
  bool is_contractible(Index cell) const
  {
    return m_parts[cell] == 1 && m_characteristic[cell] == 1;
  }

private:
  Index root(Index site)
  {
    while(m_up[site] != site)
      site = m_up[site] = m_up[m_up[site]];
    return site;
  }

  const std::vector<Index>& m_labels;
  std::vector<Index> m_up; // #sites: towards the root of its part
  std::vector<std::ptrdiff_t> m_parts, m_characteristic;
};

// The tuples of cells that come more than once, each once, sorted.
template <typename Tuple>
std::vector<Tuple> repeated(const std::vector<Tuple>& tuples, Index number_of_cells)
{
  // Those of one cell are few.
  std::vector<Index> end(number_of_cells + 1, 0);
  for(const Tuple& tuple : tuples)
    ++end[tuple[0] + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Tuple> sorted(tuples.size());
  for(const Tuple& tuple : tuples)
    sorted[end[tuple[0]]++] = tuple;
  std::vector<Tuple> result;
  for(Index cell = 0, i = 0; cell < number_of_cells; ++cell)
  {
    std::sort(sorted.begin() + i, sorted.begin() + end[cell]);
    for(++i; i < end[cell]; ++i)
      if(sorted[i] == sorted[i - 1] && (result.empty() || result.back() != sorted[i]))
        result.push_back(sorted[i]);
    i = end[cell];
  }
  return result;
}

// How the lines between cells end, followed across sides from triangle to triangle.
class Arcs
{
public:
  Arcs(const Glued_triangles& t, const std::vector<Index>& labels)
      : m_triangles(t), m_labels(labels), m_is_done(t.corner.size(), false)
  {
    for(Index side = 0; side < t.corner.size(); ++side)
      if(is_crossed(side) && !m_is_done[side])
        add(side);
  }

  // The cells that meet in more than one arc, or in one that ends at no third cell.
  std::vector<std::array<Index, 2>> torn(Index number_of_cells) const
  {
    return repeated(m_arcs, number_of_cells);
  }

private:
  bool is_crossed(Index side) const
  {
    const Index a = m_labels[m_triangles.corner[side]],
                b = m_labels[m_triangles.corner[next_side(side)]];
    return a != b && a != none && b != none;
  }
  void mark(Index side)
  {
    m_is_done[side] = true;
    if(m_triangles.twin[side] != none)
      m_is_done[m_triangles.twin[side]] = true;
  }
  void add(Index side)
  {
    const Index a = m_labels[m_triangles.corner[side]],
                b = m_labels[m_triangles.corner[next_side(side)]];
    mark(side);
    const bool begins = meets_third(m_triangles.twin[side]), ends = meets_third(side);
    m_arcs.push_back({std::min(a, b), std::max(a, b)});
    if(!begins && !ends)
      m_arcs.push_back(m_arcs.back());
  }
  // Whether the line through a side's triangle comes to a third cell; not when it comes to where the
  // surface ends, or back.
  bool meets_third(Index side)
  {
    while(side != none)
    {
      const Index third = m_labels[m_triangles.corner[previous_side(side)]];
      const Index a = m_labels[m_triangles.corner[side]];
      if(third != a && third != m_labels[m_triangles.corner[next_side(side)]])
        return third != none;
      side = third == a ? next_side(side) : previous_side(side);
      if(m_is_done[side])
        return false;
      mark(side);
      side = m_triangles.twin[side];
    }
    return false;
  }

  const Glued_triangles& m_triangles;
  const std::vector<Index>& m_labels;
  std::vector<bool> m_is_done;
  std::vector<std::array<Index, 2>> m_arcs;
};

} // namespace

std::vector<std::array<Index, 3>> triangles_between(const Glued_triangles& t,
                                                    const std::vector<Index>& labels)
{
  std::vector<std::array<Index, 3>> result;
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index a = labels[t.corner[3 * f]], b = labels[t.corner[3 * f + 1]],
                c = labels[t.corner[3 * f + 2]];
    if(a != b && b != c && c != a && a != none && b != none && c != none)
      result.push_back({a, b, c});
  }
  return result;
}

Dual dual(const Glued_triangles& t, const std::vector<Index>& labels, Index number_of_cells,
          const std::vector<bool>& is_border)
{
  Dual result;

  Parts inside(labels, number_of_cells), border(labels, number_of_cells);
  const auto is_on_border = [&](Index side)
  { return is_border.empty() ? t.twin[side] == none : bool(is_border[side]); };
  std::vector<bool> is_border_site(labels.size(), false);
  for(Index side = 0; side < t.corner.size(); ++side)
    if(is_on_border(side))
      is_border_site[t.corner[side]] = is_border_site[t.corner[next_side(side)]] = true;
  for(Index site = 0; site < labels.size(); ++site)
    if(labels[site] != none)
    {
      inside.add_site(site);
      if(is_border_site[site])
        border.add_site(site);
    }
  std::vector<std::array<Index, 2>> crossings; // of the border by lines between cells
  for(Index side = 0; side < t.corner.size(); ++side)
  {
    const Index x = t.corner[side], z = t.corner[next_side(side)];
    const bool is_first = t.twin[side] == none || t.twin[side] > side;
    if(!is_first || labels[x] == none || labels[z] == none)
      continue;
    if(labels[x] != labels[z])
    {
      if(is_on_border(side))
        crossings.push_back({std::min(labels[x], labels[z]), std::max(labels[x], labels[z])});
      continue;
    }
    inside.add_side(x, z);
    if(is_on_border(side))
      border.add_side(x, z);
  }
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index cell = labels[t.corner[3 * f]];
    if(cell != none && cell == labels[t.corner[3 * f + 1]] && cell == labels[t.corner[3 * f + 2]])
      inside.add_triangle(cell);
  }
  result.triangles = triangles_between(t, labels);
  std::vector<std::array<Index, 3>> places = result.triangles;
  for(auto& cells : places)
    std::sort(cells.begin(), cells.end());
  result.repeated_places = repeated(places, number_of_cells);
  for(Index cell = 0; cell < number_of_cells; ++cell)
  {
    if(!inside.is_contractible(cell))
      result.no_discs.push_back(cell);
    if(!border.is_empty(cell) && !border.is_contractible(cell))
      result.torn_borders.push_back(cell);
  }
  result.torn_curves = repeated(crossings, number_of_cells);
  result.torn_arcs = Arcs(t, labels).torn(number_of_cells);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
