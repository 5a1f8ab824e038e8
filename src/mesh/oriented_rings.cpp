// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/oriented_rings.h"

#include <CGAL/Geodesic_processing/internal/core/parallel.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

namespace {

// The triangles around one vertex.
class Vertex_ring
{
public:
  // Reads the triangles of the corners. Returns false if an edge of the vertex has two halfedges of
  // the same direction.
  bool read(const Surface_arrays& t, const Index* corners, std::size_t degree)
  {
    m_triangles.resize(degree);
    for(std::size_t i = 0; i < degree; ++i)
      m_triangles[i] = {corners[i], t.corner[next_halfedge(corners[i])],
                        t.corner[previous_halfedge(corners[i])], none, none};
    return degree <= max_compared_degree ? link_by_comparison() : link_by_sorting();
  }

  // Writes the twins of the halfedges that leave the vertex.
  void write_twins(Surface_arrays& t) const
  {
    for(const Triangle& triangle : m_triangles)
      t.twin[triangle.corner] =
          triangle.before == none ? none : previous_halfedge(m_triangles[triangle.before].corner);
  }

  // Writes the corners by fans, in counterclockwise order. The fan of the first corner comes first.
  // A fan begins at the boundary, or at its first corner if it is closed.
  void write_corners(Index* ring, Ring_counts& counts)
  {
    std::size_t number_of_fans = 0;
    for(Index first = 0; first < m_triangles.size(); ++first)
    {
      if(m_triangles[first].corner == none)
        continue;
      Index start = first;
      while(m_triangles[start].before != none)
      {
        start = m_triangles[start].before;
        if(start == first)
          break;
      }
      Index i = start;
      do
      {
        *ring++ = m_triangles[i].corner;
        m_triangles[i].corner = none;
        i = m_triangles[i].after;
      } while(i != none && i != start);
      ++number_of_fans;
    }
    counts.number_of_fans += number_of_fans;
    counts.number_of_nonmanifold_vertices += number_of_fans > 1 ? 1 : 0;
  }

private:
  // Comparing all pairs of a higher degree takes longer than sorting.
  static constexpr std::size_t max_compared_degree = 24;

  struct Triangle
  {
    Index corner;        // at the vertex; none if it has been written
    Index right, left;   // the two other vertices, in counterclockwise order
    Index before, after; // positions of the adjacent triangles, or none
  };

  // Links two triangles. Returns false if one of them is linked already.
  bool link(Index before, Index after)
  {
    if(m_triangles[before].after != none || m_triangles[after].before != none)
      return false;
    m_triangles[before].after = after;
    m_triangles[after].before = before;
    return true;
  }

  bool link_by_comparison()
  {
    const Index degree = static_cast<Index>(m_triangles.size());
    for(Index i = 0; i < degree; ++i)
      for(Index j = 0; j < degree; ++j)
        if(m_triangles[i].left == m_triangles[j].right && !link(i, j))
          return false;
    // Two halfedges that leave the vertex and have no twin may lead to the same vertex. If they
    // have one, it has been linked twice.
    for(Index i = 0; i < degree; ++i)
      if(m_triangles[i].before == none)
        for(Index j = 0; j < i; ++j)
          if(m_triangles[i].right == m_triangles[j].right)
            return false;
    return true;
  }

  bool link_by_sorting()
  {
    const auto order_by = [this](Index Triangle::*vertex)
    {
      std::vector<Index> order(m_triangles.size());
      std::iota(order.begin(), order.end(), Index(0));
      std::sort(order.begin(), order.end(),
                [&](Index i, Index j) { return m_triangles[i].*vertex < m_triangles[j].*vertex; });
      return order;
    };
    const std::vector<Index> by_right = order_by(&Triangle::right),
                             by_left = order_by(&Triangle::left);
    for(std::size_t i = 1; i < by_right.size(); ++i)
      if(m_triangles[by_right[i - 1]].right == m_triangles[by_right[i]].right)
        return false;
    auto right = by_right.begin();
    for(const Index i : by_left)
    {
      while(right != by_right.end() && m_triangles[*right].right < m_triangles[i].left)
        ++right;
      if(right != by_right.end() && m_triangles[*right].right == m_triangles[i].left &&
         !link(i, *right))
        return false;
    }
    return true;
  }

  std::vector<Triangle> m_triangles;
};

// Fills `ring_begin`, and `ring` by the corners of each vertex in increasing order. Each thread
// reads all corners and writes those of its own range of vertices.
void collect_corners(Surface_arrays& t, std::size_t number_of_vertices, unsigned number_of_threads)
{
  t.ring_begin.assign(number_of_vertices + 1, 0);
  t.ring.resize(t.corner.size());
  Index* const begin = t.ring_begin.data();
  const auto for_each_range = [&](const auto& visit)
  {
    for_each_block(number_of_vertices, block_size_of_threads(number_of_vertices, number_of_threads),
                   number_of_threads,
                   [&](std::size_t, std::size_t first, std::size_t last)
                   { visit(static_cast<Index>(first), static_cast<Index>(last - first)); });
  };
  for_each_range(
      [&](Index first, Index size)
      {
        for(const Index vertex : t.corner)
          if(vertex - first < size)
            ++begin[vertex];
      });
  std::partial_sum(t.ring_begin.begin(), t.ring_begin.end(), t.ring_begin.begin());
  // From the last to the first corner, so that the end of each range becomes its begin.
  for_each_range(
      [&](Index first, Index size)
      {
        for(std::size_t c = t.corner.size(); c-- > 0;)
          if(const Index vertex = t.corner[c]; vertex - first < size)
            t.ring[--begin[vertex]] = static_cast<Index>(c);
      });
}

} // namespace

std::optional<Ring_counts> build_oriented_rings(Surface_arrays& t, std::size_t number_of_vertices,
                                                unsigned number_of_threads)
{
  collect_corners(t, number_of_vertices, number_of_threads);
  t.twin.resize(t.corner.size());
  constexpr std::size_t block_size = 1 << 13;
  std::vector<Ring_counts> counts((number_of_vertices + block_size - 1) / block_size);
  std::atomic<bool> is_oriented{true};
  for_each_block(number_of_vertices, block_size, number_of_threads,
                 [&](std::size_t block, std::size_t begin, std::size_t end)
                 {
                   Vertex_ring ring;
                   Ring_counts counts_here;
                   for(std::size_t v = begin; v < end && is_oriented; ++v)
                   {
                     Index* const corners = t.ring.data() + t.ring_begin[v];
                     if(!ring.read(t, corners, t.ring_begin[v + 1] - t.ring_begin[v]))
                       is_oriented = false;
                     else
                     {
                       ring.write_twins(t);
                       ring.write_corners(corners, counts_here);
                     }
                   }
                   counts[block] = counts_here;
                 });
  if(!is_oriented)
    return std::nullopt;
  Ring_counts result;
  for(const Ring_counts& block : counts)
  {
    result.number_of_fans += block.number_of_fans;
    result.number_of_nonmanifold_vertices += block.number_of_nonmanifold_vertices;
  }
  return result;
}

} // namespace CGAL::Geodesic_processing::internal
