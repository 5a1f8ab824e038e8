// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_READERS_APPEND_POLYGON_H
#define GEODESIC_PROGRAM_READERS_APPEND_POLYGON_H

#include "readers/Surface_file.h"

#include <limits>

namespace program {

// Converts to an index. Negative and too large values become the maximum index, which is never
// valid.
template <typename Number>
std::uint32_t to_index(Number index)
{
  constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();
  return index >= 0 && index < no_vertex ? static_cast<std::uint32_t>(index) : no_vertex;
}

template <typename Number>
void append_corner(Surface_file& surface, Number index)
{
  surface.corners.push_back(to_index(index));
}

inline void end_polygon(Surface_file& surface)
{
  surface.polygon_begin.push_back(surface.corners.size());
}

// Appends all polygons of another surface.
inline void append_polygons(Surface_file& surface, const Surface_file& more)
{
  const std::size_t begin = surface.corners.size();
  surface.corners.insert(surface.corners.end(), more.corners.begin(), more.corners.end());
  for(std::size_t f = 1; f < more.polygon_begin.size(); ++f)
    surface.polygon_begin.push_back(begin + more.polygon_begin[f]);
}

// Appends the polygons and edges that were read from each chunk of a file.
inline void append_chunks(Surface_file& surface, const std::vector<Surface_file>& chunks)
{
  std::size_t number_of_corners = 0, number_of_polygons = 0;
  for(const Surface_file& chunk : chunks)
  {
    number_of_corners += chunk.corners.size();
    number_of_polygons += chunk.number_of_polygons();
  }
  surface.corners.reserve(number_of_corners);
  surface.polygon_begin.reserve(number_of_polygons + 1);
  for(const Surface_file& chunk : chunks)
  {
    append_polygons(surface, chunk);
    surface.edges.insert(surface.edges.end(), chunk.edges.begin(), chunk.edges.end());
  }
}

// Appends the triangles of a strip. Every second triangle is reversed for a consistent
// orientation. A negative index ends a strip and starts the next one.
template <typename Indices>
void append_strip(Surface_file& surface, const Indices& indices)
{
  std::size_t begin = 0;
  for(std::size_t i = 0; i < indices.size(); ++i)
  {
    if(indices[i] < 0)
      begin = i + 1;
    else if(i >= begin + 2)
    {
      const bool is_reversed = (i - begin) % 2 == 1;
      append_corner(surface, static_cast<double>(indices[is_reversed ? i - 1 : i - 2]));
      append_corner(surface, static_cast<double>(indices[is_reversed ? i - 2 : i - 1]));
      append_corner(surface, static_cast<double>(indices[i]));
      end_polygon(surface);
    }
  }
}

} // namespace program

#endif // GEODESIC_PROGRAM_READERS_APPEND_POLYGON_H
