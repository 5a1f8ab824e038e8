// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VERTEX_QUEUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VERTEX_QUEUE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A priority queue of sites, smallest key first, in which a key can be changed: a heap of four
// children a place, which keep to a cache line.
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

  bool empty() const { return m_heap.empty(); }
  bool contains(Index vertex) const { return m_position[vertex] != none; }
  const Entry& front() const { return m_heap.front(); }
  // Puts a site in, or gives it another key.
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

  // Puts a site in that is not there, without a look at its place, for which it may have to wait.
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

  // Empties the queue; proportional to what it holds.
  void clear()
  {
    for(const Entry& entry : m_heap)
      m_position[entry.vertex] = none;
    m_heap.clear();
  }

private:
  // Puts a site at a place or above it.
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

  // Puts a site at a place or below it.
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

  // Sums of comparisons: a jump to the least, which cannot be foreseen, takes a twentieth of a front's time.
  std::size_t min_of_four(std::size_t first) const
  {
    const auto is_less = [&](std::size_t a, std::size_t b)
    { return std::size_t(m_heap[a].key < m_heap[b].key); };
    const std::size_t lower = first + is_less(first + 1, first),
                      upper = first + 2 + is_less(first + 3, first + 2);
    return lower + (upper - lower) * is_less(upper, lower);
  }

  // Of less than four at the end.
  std::size_t min_from(std::size_t first) const
  {
    const auto is_less = [](const Entry& a, const Entry& b) { return a.key < b.key; };
    return std::size_t(
        std::min_element(m_heap.begin() + std::ptrdiff_t(first), m_heap.end(), is_less) -
        m_heap.begin());
  }

  // Part by part: read as a whole right after its parts were written, an entry takes a tenth of a front's time.
  void set(std::size_t position, Index vertex, double key)
  {
    m_heap[position].key = key;
    m_heap[position].vertex = vertex;
    m_position[vertex] = static_cast<Index>(position);
  }

  std::vector<Entry> m_heap;
  std::vector<Index> m_position; // #sites: place in the heap or none
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_CORE_VERTEX_QUEUE_H
