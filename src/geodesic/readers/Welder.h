// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_WELDER_H
#define GEODESIC_PROGRAM_READERS_WELDER_H

#include "readers/Surface_file.h"

namespace program {

// Merges vertices with equal coordinates. Vertices are numbered in the order of their first
// occurrence.
class Welder
{
public:
  explicit Welder(Surface_file& surface) : m_surface(surface) {}

  // Returns the index of the vertex. Appends it to the points of the surface if it is new. The
  // coordinates must not be NaN, because NaN is not equal to itself. O(1).
  std::uint32_t index(Point point);

private:
  // Returns the slot of a point, or the empty slot where it must be inserted.
  std::size_t slot(const Point& point) const;
  void grow();

  Surface_file& m_surface;
  // A hash table with open addressing: indices of points. Its size is a power of two, and at least
  // half of the slots are empty.
  std::vector<std::uint32_t> m_slots;
};

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_WELDER_H
