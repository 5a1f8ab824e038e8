// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_QUEUE_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_QUEUE_H

#include <CGAL/Geodesic_processing/internal/core/Index.h>
#include <CGAL/Geodesic_processing/internal/core/Vertex_queue.h>
#include <CGAL/Geodesic_processing/internal/distances/Window_pool.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A priority queue of items with the smallest key first. An item is a halfedge with the windows that
// wait to cross it, or a vertex without windows.
//
// Only the items in the queue have a slot, which holds their windows and their position in the heap.
// They are few, so that slots remain in the cache. All other items need four bytes.
class Window_queue
{
public:
  // The windows that wait at a halfedge. List 0 arrived through the halfedge of the adjacent
  // triangle that shares its begin, list 1 through the one that shares its end.
  using Waiting_windows = std::array<Window_list, 2>;

  struct Item
  {
    Index index;
    Waiting_windows windows;
  };

  explicit Window_queue(std::size_t number_of_items = 0) : m_slot(number_of_items, none) {}

  bool empty() const { return m_heap.empty(); }
  // The item with the smallest key; requires one.
  double smallest_key() const { return m_heap.front().key; }
  const Item& front() const { return m_items[m_heap.front().vertex]; }

  // Inserts an item, or changes its key if it is in the queue. Returns the windows that wait at it;
  // the reference is valid until the next insertion.
  Waiting_windows& push(Index index, double key)
  {
    Index& slot = m_slot[index];
    if(slot != none)
      m_heap.push(slot, key);
    else
    {
      slot = new_slot();
      m_items[slot] = {index, {}};
      m_heap.insert(slot, key);
    }
    return m_items[slot].windows;
  }

  // Removes the item with the smallest key. The caller releases its windows.
  Item pop()
  {
    const Index slot = m_heap.pop().vertex;
    const Item result = m_items[slot];
    m_slot[result.index] = none;
    m_free_slots.push_back(slot);
    return result;
  }

private:
  Index new_slot()
  {
    if(m_free_slots.empty())
    {
      m_items.emplace_back();
      m_heap.add_vertex();
      return Index(m_items.size() - 1);
    }
    const Index slot = m_free_slots.back();
    m_free_slots.pop_back();
    return slot;
  }

  std::vector<Index> m_slot; // #items: the slot of the item, or none
  std::vector<Item> m_items; // #slots
  Vertex_queue m_heap;       // of slots
  std::vector<Index> m_free_slots;
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_QUEUE_H
