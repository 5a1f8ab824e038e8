// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_QUEUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_QUEUE_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A priority queue of sites, smallest key first, in which a key can be changed: a heap of four
// children a place, which keep to a cache line.
class Queue
{
public:
  struct Entry
  {
    double key;
    Index site;
  };

  explicit Queue(std::size_t number_of_sites = 0) : m_place(number_of_sites, none) {}

  bool empty() const { return m_heap.empty(); }
  bool contains(Index site) const { return m_place[site] != none; }
  const Entry& front() const { return m_heap.front(); }
  // Puts a site in, or gives it another key.
  void push(Index site, double key)
  {
    const std::size_t place = m_place[site];
    if(place == none)
      insert(site, key);
    else if(key > m_heap[place].key)
      sink(place, site, key);
    else
      rise(place, site, key);
  }

  // Puts a site in that is not there, without a look at its place, for which it may have to wait.
  void insert(Index site, double key)
  {
    m_heap.emplace_back();
    rise(m_heap.size() - 1, site, key);
  }

  Entry pop()
  {
    const Entry top = m_heap.front(), last = m_heap.back();
    m_heap.pop_back();
    m_place[top.site] = none;
    if(!m_heap.empty())
      sink(0, last.site, last.key);
    return top;
  }

  // Empties the queue; proportional to what it holds.
  void clear()
  {
    for(const Entry& entry : m_heap)
      m_place[entry.site] = none;
    m_heap.clear();
  }

private:
  // Puts a site at a place or above it.
  void rise(std::size_t place, Index site, double key)
  {
    while(place > 0)
    {
      const std::size_t parent = (place - 1) / 4;
      if(m_heap[parent].key <= key)
        break;
      put(place, m_heap[parent].site, m_heap[parent].key);
      place = parent;
    }
    put(place, site, key);
  }

  // Puts a site at a place or below it.
  void sink(std::size_t place, Index site, double key)
  {
    const std::size_t size = m_heap.size();
    for(;;)
    {
      const std::size_t child = 4 * place + 1;
      if(child >= size)
        break;
      const std::size_t least = child + 4 <= size ? least_of_four(child) : least_from(child);
      if(m_heap[least].key >= key)
        break;
      put(place, m_heap[least].site, m_heap[least].key);
      place = least;
    }
    put(place, site, key);
  }

  // Sums of comparisons: a jump to the least, which cannot be foreseen, takes a twentieth of a front's time.
  std::size_t least_of_four(std::size_t first) const
  {
    const auto is_less = [&](std::size_t a, std::size_t b)
    { return std::size_t(m_heap[a].key < m_heap[b].key); };
    const std::size_t low = first + is_less(first + 1, first),
                      high = first + 2 + is_less(first + 3, first + 2);
    return low + (high - low) * is_less(high, low);
  }

  // Of less than four at the end.
  std::size_t least_from(std::size_t first) const
  {
    const auto is_less = [](const Entry& a, const Entry& b) { return a.key < b.key; };
    return std::size_t(
        std::min_element(m_heap.begin() + std::ptrdiff_t(first), m_heap.end(), is_less) -
        m_heap.begin());
  }

  // Part by part: read as a whole right after its parts were written, an entry takes a tenth of a front's time.
  void put(std::size_t place, Index site, double key)
  {
    m_heap[place].key = key;
    m_heap[place].site = site;
    m_place[site] = static_cast<Index>(place);
  }

  std::vector<Entry> m_heap;
  std::vector<Index> m_place; // #sites: place in the heap or none
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_QUEUE_H
