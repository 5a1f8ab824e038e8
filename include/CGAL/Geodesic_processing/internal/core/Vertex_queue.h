// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VERTEX_QUEUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VERTEX_QUEUE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A priority queue of vertices with the smallest key first, whose keys can be changed: a 4-ary heap
// with the position of each vertex. The four children of a node share a cache line. O(log n) per
// push and pop.
class Vertex_queue
{
public:
  struct Entry
  {
    double key;
    Index vertex;
  };

  explicit Vertex_queue(std::size_t number_of_vertices = 0) : m_position(number_of_vertices, none)
  {}

  // Admits one more vertex, whose index is the next one.
  void add_vertex() { m_position.push_back(none); }

  bool empty() const { return m_heap.empty(); }
  bool contains(Index vertex) const { return m_position[vertex] != none; }
  const Entry& front() const { return m_heap.front(); }
  // Calls visit(vertex) for the children of the front, one of which mostly becomes the next front.
  template <typename Visitor>
  void for_each_child_of_front(const Visitor& visit) const
  {
    for(std::size_t i = 1; i < std::min<std::size_t>(m_heap.size(), 5); ++i)
      visit(m_heap[i].vertex);
  }
  // Inserts a vertex, or changes its key if it is in the queue.
  void push(Index vertex, double key)
  {
    const std::size_t position = m_position[vertex];
    if(position == none)
      insert(vertex, key);
    else if(key > m_heap[position].key)
      sift_down(position, vertex, key);
    else
      sift_up(position, vertex, key);
  }

  // Inserts a vertex that is not in the queue. Unlike push(), it does not read the position of the
  // vertex, which can cost a cache miss.
  void insert(Index vertex, double key)
  {
    m_heap.emplace_back();
    sift_up(m_heap.size() - 1, vertex, key);
  }

  Entry pop()
  {
    const Entry top = m_heap.front(), last = m_heap.back();
    m_heap.pop_back();
    m_position[top.vertex] = none;
    if(!m_heap.empty())
      sift_down(0, last.vertex, last.key);
    return top;
  }

  // Removes all vertices. O(size of the queue).
  void clear()
  {
    for(const Entry& entry : m_heap)
      m_position[entry.vertex] = none;
    m_heap.clear();
  }

private:
  // Sets the entry at `position` or at one of its ancestors, and moves larger keys down.
  void sift_up(std::size_t position, Index vertex, double key)
  {
    while(position > 0)
    {
      const std::size_t parent = (position - 1) / 4;
      if(m_heap[parent].key <= key)
        break;
      set(position, m_heap[parent].vertex, m_heap[parent].key);
      position = parent;
    }
    set(position, vertex, key);
  }

  // Sets the entry at `position` or at one of its descendants, and moves smaller keys up.
  void sift_down(std::size_t position, Index vertex, double key)
  {
    const std::size_t size = m_heap.size();
    for(;;)
    {
      const std::size_t child = 4 * position + 1;
      if(child >= size)
        break;
      const std::size_t smallest = child + 4 <= size ? min_of_four(child) : min_from(child);
      if(m_heap[smallest].key >= key)
        break;
      set(position, m_heap[smallest].vertex, m_heap[smallest].key);
      position = smallest;
    }
    set(position, vertex, key);
  }

  // Computes the smallest of four children without branches. A mispredicted branch to the minimum
  // takes 5 % of the time of a front.
  std::size_t min_of_four(std::size_t first) const
  {
    const auto is_less = [&](std::size_t a, std::size_t b)
    { return std::size_t(m_heap[a].key < m_heap[b].key); };
    const std::size_t lower = first + is_less(first + 1, first),
                      upper = first + 2 + is_less(first + 3, first + 2);
    return lower + (upper - lower) * is_less(upper, lower);
  }

  // Returns the smallest of the last one to three children.
  std::size_t min_from(std::size_t first) const
  {
    const auto is_less = [](const Entry& a, const Entry& b) { return a.key < b.key; };
    return std::size_t(
        std::min_element(m_heap.begin() + std::ptrdiff_t(first), m_heap.end(), is_less) -
        m_heap.begin());
  }

  // Writes the members one by one. If the entry is copied as a whole, it is read right after
  // partial writes; this stall takes 10 % of the time of a front.
  void set(std::size_t position, Index vertex, double key)
  {
    m_heap[position].key = key;
    m_heap[position].vertex = vertex;
    m_position[vertex] = static_cast<Index>(position);
  }

  std::vector<Entry> m_heap;
  std::vector<Index> m_position; // #vertices: position in the heap or none
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VERTEX_QUEUE_H
