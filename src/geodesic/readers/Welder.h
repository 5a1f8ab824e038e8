// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_WELDER_H
#define GEODESIC_PROGRAM_READERS_WELDER_H

#include "readers/Surface_file.h"

namespace program {

// Merges vertices with equal coordinates. Vertices are numbered in the order of their first
// occurrence. Coordinates must not be NaN, because NaN is not equal to itself.
class Welder
{
public:
  // expected_points: number of different vertices; more are possible.
  explicit Welder(Surface_file& surface, std::size_t expected_points = 0);

  // Returns the index of the vertex. Appends it to the points of the surface if it is new. O(1).
  std::uint32_t index(const Point& point);

  // Appends the vertex to the corners of the surface, when enough corners have been passed or in
  // flush(). Faster than index(), because the table is prefetched. O(1).
  void append_corner(const Point& point);

  void end_polygon()
  {
    m_surface.polygon_begin.push_back(m_surface.corners.size() + m_number_of_new_corners);
  }

  // Appends the corners that have been passed. Must be called after the last corner.
  void flush();

private:
  // An element of a hash table with open addressing.
  struct Slot
  {
    std::uint32_t vertex;
    std::uint32_t hash; // its lowest bits, because most comparisons of points would miss the cache
  };

  struct Corner
  {
    Point point;
    std::uint64_t hash;
  };

  Slot& first_slot(std::uint64_t hash) { return m_slots[hash >> m_shift]; }
  static Corner corner_at(const Point& point);
  Slot& find(const Corner& corner);
  std::uint32_t insert(const Corner& corner);
  void reserve(std::size_t number_of_new_points);
  void resize(unsigned log2_of_size);

  Surface_file& m_surface;
  std::vector<Slot> m_slots; // Its size is a power of two, and at least half of them are empty.
  unsigned m_shift = 0;      // hash >> m_shift is the index of a slot
  std::array<Corner, 64> m_new_corners;
  std::size_t m_number_of_new_corners = 0;
};

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_WELDER_H
