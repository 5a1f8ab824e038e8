// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_REPAIR_REPAIR_H
#define GEODESIC_PROGRAM_REPAIR_REPAIR_H

#include "io/Surface_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace program {

inline constexpr std::uint32_t no_halfedge = static_cast<std::uint32_t>(-1);

// Removes faces with fewer than three distinct corners and duplicates of faces. Triangulates
// polygons, including concave and nonplanar ones. Vertices are unchanged. Returns whether anything
// changed. Throws Input_error if a polygon has more than 10,000 corners.
bool triangulate(Surface_file& surface, const std::string& name);

// Connectivity of a surface whose faces are triangles.
struct Connectivity
{
  std::vector<std::uint32_t> twins;        // 3 #triangles: the opposite halfedge or no_halfedge
  std::size_t number_of_flipped_faces = 0; // triangles whose orientation was reversed
  std::size_t number_of_cut_edges = 0;     // edges cut open: with three or more triangles, or
                                           //   in which a nonorientable surface meets itself
  std::size_t number_of_nonmanifold_vertices = 0; // vertices with several fans of triangles
  std::size_t number_of_fans = 0;                 // at all vertices
  std::size_t number_of_components = 0;           // of triangles connected by edges
  std::size_t number_of_boundary_loops = 0;       // after nonmanifold vertices are split

  bool is_manifold() const
  {
    return number_of_cut_edges == 0 && number_of_nonmanifold_vertices == 0;
  }
  // Returns the sum of the genera of all components.
  long long genus(std::size_t number_of_triangles) const;
};

// Flips triangles for a consistent orientation, as few as possible in each component. Pairs the
// halfedges of each edge that has exactly two triangles.
Connectivity orient(Surface_file& surface);

// Gives unit normals to a cloud. Normals that are missing, zero or not finite are estimated from
// 16 neighbors. If all are missing, they are oriented along a minimum spanning tree. Otherwise,
// each is oriented like the nearest given normal. Returns whether given normals had to be
// replaced.
bool complete_normals(Surface_file& cloud, unsigned threads = 1);

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_REPAIR_H
