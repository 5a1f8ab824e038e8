// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/dual.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace CGAL::Geodesic_processing::internal {

namespace {

// Number of connected components and Euler characteristic of each cell. Both are those of the
// subcomplex of vertices, edges and triangles whose vertices all belong to the cell: the cell is a
// thickening of it.
class Cell_topology
{
public:
  Cell_topology(const std::vector<Index>& labels, Index number_of_cells)
      : m_labels(labels), m_parent(labels.size()), m_number_of_components(number_of_cells, 0),
        m_euler_characteristic(number_of_cells, 0)
  {
    std::iota(m_parent.begin(), m_parent.end(), Index(0));
  }

  void add_vertex(Index vertex)
  {
    ++m_number_of_components[m_labels[vertex]];
    ++m_euler_characteristic[m_labels[vertex]];
  }
  void add_edge(Index x, Index z)
  {
    --m_euler_characteristic[m_labels[x]];
    x = root(x);
    z = root(z);
    if(x == z)
      return;
    m_parent[std::max(x, z)] = std::min(x, z);
    --m_number_of_components[m_labels[x]];
  }
  void add_triangle(Index label) { ++m_euler_characteristic[label]; }

  bool is_empty(Index cell) const { return m_number_of_components[cell] == 0; }
  // Returns true if the cell is connected and has Euler characteristic one.
  bool is_contractible(Index cell) const
  {
    return m_number_of_components[cell] == 1 && m_euler_characteristic[cell] == 1;
  }

private:
  Index root(Index vertex)
  {
    while(m_parent[vertex] != vertex)
      vertex = m_parent[vertex] = m_parent[m_parent[vertex]];
    return vertex;
  }

  const std::vector<Index>& m_labels;
  std::vector<Index> m_parent; // #vertices: disjoint sets of the components
  std::vector<std::ptrdiff_t> m_number_of_components, m_euler_characteristic;
};

// Returns the tuples that occur more than once, sorted and without duplicates.
template <typename Tuple>
std::vector<Tuple> duplicates(const std::vector<Tuple>& tuples, Index number_of_cells)
{
  // A counting sort by the first cell leaves only short lists for std::sort().
  std::vector<Index> offsets(number_of_cells + 1, 0);
  for(const Tuple& tuple : tuples)
    ++offsets[tuple[0] + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Tuple> sorted(tuples.size());
  for(const Tuple& tuple : tuples)
    sorted[offsets[tuple[0]]++] = tuple;
  std::vector<Tuple> result;
  for(Index cell = 0, i = 0; cell < number_of_cells; ++cell)
  {
    std::sort(sorted.begin() + i, sorted.begin() + offsets[cell]);
    for(++i; i < offsets[cell]; ++i)
      if(sorted[i] == sorted[i - 1] && (result.empty() || result.back() != sorted[i]))
        result.push_back(sorted[i]);
    i = offsets[cell];
  }
  return result;
}

// The bisectors of pairs of cells. Each is traced from triangle to triangle to its two ends.
class Interfaces
{
public:
  Interfaces(const Surface_arrays& t, const std::vector<Index>& labels)
      : m_triangles(t), m_labels(labels), m_is_visited(t.corner.size(), false)
  {
    for(Index h = 0; h < t.corner.size(); ++h)
      if(is_crossed(h) && !m_is_visited[h])
        add(h);
  }

  // Returns the pairs of cells that meet in several arcs, or in an arc without a third cell at
  // either end.
  std::vector<std::array<Index, 2>> disconnected(Index number_of_cells) const
  {
    return duplicates(m_interfaces, number_of_cells);
  }

private:
  bool is_crossed(Index h) const
  {
    const Index a = m_labels[m_triangles.corner[h]],
                b = m_labels[m_triangles.corner[next_halfedge(h)]];
    return a != b && a != none && b != none;
  }
  void mark(Index h)
  {
    m_is_visited[h] = true;
    if(m_triangles.twin[h] != none)
      m_is_visited[m_triangles.twin[h]] = true;
  }
  void add(Index h)
  {
    const Index a = m_labels[m_triangles.corner[h]],
                b = m_labels[m_triangles.corner[next_halfedge(h)]];
    mark(h);
    const bool begins_at_third_cell = reaches_third_cell(m_triangles.twin[h]),
               ends_at_third_cell = reaches_third_cell(h);
    m_interfaces.push_back({std::min(a, b), std::max(a, b)});
    if(!begins_at_third_cell && !ends_at_third_cell)
      m_interfaces.push_back(m_interfaces.back());
  }
  // Follows a bisector into the triangle of a halfedge that it crosses. Returns true if it ends at
  // a third cell, false if it ends at the boundary or closes.
  bool reaches_third_cell(Index h)
  {
    while(h != none)
    {
      const Index third = m_labels[m_triangles.corner[previous_halfedge(h)]];
      const Index a = m_labels[m_triangles.corner[h]];
      if(third != a && third != m_labels[m_triangles.corner[next_halfedge(h)]])
        return third != none;
      h = third == a ? next_halfedge(h) : previous_halfedge(h);
      if(m_is_visited[h])
        return false;
      mark(h);
      h = m_triangles.twin[h];
    }
    return false;
  }

  const Surface_arrays& m_triangles;
  const std::vector<Index>& m_labels;
  std::vector<bool> m_is_visited;
  std::vector<std::array<Index, 2>> m_interfaces;
};

// The topology of cells, of their intersections with the boundary, and the crossings of the
// boundary by the bisectors of two cells.
struct Cell_topologies
{
  Cell_topology interior, boundary;
  std::vector<std::array<Index, 2>> boundary_crossings;
};

void add_vertices(const Surface_arrays& t, const std::vector<Index>& labels,
                  const std::vector<bool>& is_boundary, Cell_topologies& result)
{
  std::vector<bool> is_boundary_vertex(labels.size(), false);
  for(Index h = 0; h < t.corner.size(); ++h)
    if(is_boundary[h])
      is_boundary_vertex[t.corner[h]] = is_boundary_vertex[t.corner[next_halfedge(h)]] = true;
  for(Index vertex = 0; vertex < labels.size(); ++vertex)
    if(labels[vertex] != none)
    {
      result.interior.add_vertex(vertex);
      if(is_boundary_vertex[vertex])
        result.boundary.add_vertex(vertex);
    }
}

void add_edges(const Surface_arrays& t, const std::vector<Index>& labels,
               const std::vector<bool>& is_boundary, Cell_topologies& result)
{
  for(Index h = 0; h < t.corner.size(); ++h)
  {
    const Index x = t.corner[h], z = t.corner[next_halfedge(h)];
    const bool is_first = t.twin[h] == none || t.twin[h] > h;
    if(!is_first || labels[x] == none || labels[z] == none)
      continue;
    if(labels[x] != labels[z])
    {
      if(is_boundary[h])
        result.boundary_crossings.push_back(
            {std::min(labels[x], labels[z]), std::max(labels[x], labels[z])});
      continue;
    }
    result.interior.add_edge(x, z);
    if(is_boundary[h])
      result.boundary.add_edge(x, z);
  }
}

void add_triangles(const Surface_arrays& t, const std::vector<Index>& labels,
                   Cell_topology& interior)
{
  for(Index f = 0; f < t.number_of_triangles(); ++f)
  {
    const Index cell = labels[t.corner[3 * f]];
    if(cell != none && cell == labels[t.corner[3 * f + 1]] && cell == labels[t.corner[3 * f + 2]])
      interior.add_triangle(cell);
  }
}

} // namespace

std::vector<std::array<Index, 3>> compute_dual_triangles(const Surface_arrays& t,
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

Dual dual(const Surface_arrays& t, const std::vector<Index>& labels, Index number_of_cells,
          const std::vector<bool>& is_boundary)
{
  std::vector<bool> is_on_boundary = is_boundary;
  if(is_boundary.empty())
    for(const Index twin : t.twin)
      is_on_boundary.push_back(twin == none);
  Cell_topologies topologies = {
      Cell_topology(labels, number_of_cells), Cell_topology(labels, number_of_cells), {}};
  add_vertices(t, labels, is_on_boundary, topologies);
  add_edges(t, labels, is_on_boundary, topologies);
  add_triangles(t, labels, topologies.interior);

  Dual result;
  result.triangles = compute_dual_triangles(t, labels);
  std::vector<std::array<Index, 3>> triple_points = result.triangles;
  for(auto& cells : triple_points)
    std::sort(cells.begin(), cells.end());
  result.repeated_triple_points = duplicates(triple_points, number_of_cells);
  for(Index cell = 0; cell < number_of_cells; ++cell)
  {
    if(!topologies.interior.is_contractible(cell))
      result.non_disks.push_back(cell);
    if(!topologies.boundary.is_empty(cell) && !topologies.boundary.is_contractible(cell))
      result.disconnected_boundaries.push_back(cell);
  }
  result.repeated_boundary_crossings = duplicates(topologies.boundary_crossings, number_of_cells);
  result.disconnected_interfaces = Interfaces(t, labels).disconnected(number_of_cells);
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
