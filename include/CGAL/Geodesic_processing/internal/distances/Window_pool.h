// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_POOL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_POOL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/vec2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// An interval of a halfedge that is crossed by straight lines from one unfolded source (Mitchell,
// Mount and Papadimitriou 1987).
//
// A window that replaces similar ones is approximate: distance() is at most the length of the paths
// through it, and error() bounds the difference.
//
// Coordinates: the halfedge begins at the origin and runs along the first axis. The triangle that
// the window crosses next is above the halfedge, the source below it.
struct Window
{
  Vec2 source;        // of a straight front: the unit vector towards the source
  double offset;      // the distance at the source; of a straight front, that at the origin
  double begin, end;  // positions on the halfedge, in the unit of lengths
  Index origin;       // a vertex that is the (pseudo-)source, or #vertices + a source piece
  float signed_error; // the error, with a minus sign, also if it is zero, for a straight front

  bool is_straight() const { return std::signbit(signed_error); }
  // The source is (source, weight()), homogeneous.
  double weight() const { return is_straight() ? 0. : 1.; }
  // Paths through the window are longer than distance() by at most this length.
  double error() const { return std::abs(signed_error); }

  // Returns the distance at a position on the halfedge.
  double distance(double position) const
  {
    if(is_straight())
      return offset - position * source[0];
    const double x = position - source[0];
    return offset + std::sqrt(x * x + source[1] * source[1]);
  }
};

// An array of windows in a Window_pool.
struct Window_list
{
  Window_list() : size(0), capacity_log2(0) {}

  Index position = 0;
  Index size : 27, capacity_log2 : 5;
};

// Memory for arrays of windows, whose capacities are powers of two. Released arrays are reused;
// allocation takes O(1) amortized time. The memory grows by blocks that are never copied: growth by
// doubling would need almost twice the memory. Pointers are valid as long as the pool.
class Window_pool
{
public:
  Window* begin(const Window_list& list)
  {
    return m_blocks[list.position / block_size].data() + list.position % block_size;
  }

  // Returns an array for this number of windows. Its size is 1, which marks it as used.
  Window_list allocate(std::size_t size)
  {
    Window_list result;
    while((std::size_t(1) << result.capacity_log2) < size)
      ++result.capacity_log2;
    std::vector<Index>& free_list = m_free_lists[result.capacity_log2];
    if(free_list.empty())
      result.position = append(std::size_t(1) << result.capacity_log2);
    else
    {
      result.position = free_list.back();
      free_list.pop_back();
    }
    result.size = 1;
    return result;
  }

  // Returns an array to the pool and resets the list.
  void release(Window_list& list)
  {
    if(list.size > 0)
      m_free_lists[list.capacity_log2].push_back(list.position);
    list = Window_list{};
  }

  // Merges two arrays that are sorted by the centers of their windows, and releases them.
  Window_list merge(Window_list& a, Window_list& b)
  {
    Window_list result = allocate(a.size + b.size);
    std::merge(begin(a), begin(a) + a.size, begin(b), begin(b) + b.size, begin(result),
               [](const Window& v, const Window& w) { return v.begin + v.end < w.begin + w.end; });
    result.size = a.size + b.size;
    release(a);
    release(b);
    return result;
  }

private:
  static constexpr std::size_t block_size = 1024;

  // Returns the position of new windows. More than block_size windows have a larger block, which is
  // followed by empty ones, so that positions remain multiples of block_size.
  Index append(std::size_t number)
  {
    if(m_used % block_size + number > block_size || m_used == m_blocks.size() * block_size)
    {
      m_used = m_blocks.size() * block_size;
      m_blocks.emplace_back(std::max(number, block_size));
      m_blocks.resize(m_blocks.size() + (m_blocks.back().size() / block_size - 1));
    }
    const Index result = Index(m_used);
    m_used += number;
    return result;
  }

  std::vector<std::vector<Window>> m_blocks;
  std::size_t m_used = 0; // the position behind the last array
  // By capacity_log2: positions of the released arrays.
  std::vector<std::vector<Index>> m_free_lists = std::vector<std::vector<Index>>(33);
};

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_DISTANCES_WINDOW_POOL_H
