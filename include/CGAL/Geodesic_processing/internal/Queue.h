// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_QUEUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_QUEUE_H

#include <CGAL/Geodesic_processing/internal/Glued_triangles.h>

#include <algorithm>
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
  // Calls f(site) for those of which one comes after the front, if none is put in before.
  template <typename Function>
  void for_each_second(Function f) const
  {
    for(std::size_t i = 1; i < std::min<std::size_t>(5, m_heap.size()); ++i)
      f(m_heap[i].site);
  }

  // Puts a site in, or gives it another key.
  void push(Index site, double key)
  {
    std::size_t place = m_place[site];
    if(place == none)
    {
      place = m_heap.size();
      m_heap.push_back({key, site});
    }
    else if(key > m_heap[place].key)
      return sink(place, {key, site});
    while(place > 0)
    {
      const std::size_t parent = (place - 1) / 4;
      if(m_heap[parent].key <= key)
        break;
      put(place, m_heap[parent]);
      place = parent;
    }
    put(place, {key, site});
  }

  Entry pop()
  {
    const Entry top = m_heap.front(), last = m_heap.back();
    m_heap.pop_back();
    m_place[top.site] = none;
    if(!m_heap.empty())
      sink(0, last);
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
  // Puts an entry at a place or below it.
  void sink(std::size_t place, const Entry& entry)
  {
    const std::size_t size = m_heap.size();
    for(;;)
    {
      const std::size_t child = 4 * place + 1, end = std::min(child + 4, size);
      if(child >= size)
        break;
      std::size_t least = child;
      for(std::size_t i = child + 1; i < end; ++i)
        if(m_heap[i].key < m_heap[least].key)
          least = i;
      if(m_heap[least].key >= entry.key)
        break;
      put(place, m_heap[least]);
      place = least;
    }
    put(place, entry);
  }

  void put(std::size_t place, const Entry& entry)
  {
    m_heap[place] = entry;
    m_place[entry.site] = static_cast<Index>(place);
  }

  std::vector<Entry> m_heap;
  std::vector<Index> m_place; // #sites: place in the heap or none
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_QUEUE_H
