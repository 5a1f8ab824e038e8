// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_WELDER_H
#define GEODESIC_PROGRAM_READERS_WELDER_H

#include "readers/Surface_file.h"

#include <unordered_map>

namespace program {

// Merges vertices with equal coordinates. Vertices are numbered in the order of their first
// occurrence.
class Welder
{
public:
  explicit Welder(Surface_file& surface) : m_surface(surface) {}

  // Returns the index of the vertex. Appends it to the points of the surface if it is new. The
  // coordinates must not be NaN, because NaN is not equal to itself.
  std::uint32_t index(Point point);

private:
  struct Hash
  {
    std::size_t operator()(const Point& point) const;
  };

  Surface_file& m_surface;
  std::unordered_map<Point, std::uint32_t, Hash> m_index;
};

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_WELDER_H
