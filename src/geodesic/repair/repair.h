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

// Drops the faces with fewer than three different corners and the second copy of any face, and cuts
// polygons into triangles, concave ones and those that are not planar too.  Vertices stay as they
// are.  True when anything changed; throws Input_error at a polygon of more than 10,000 corners.
bool triangulate(Surface_file& surface, const std::string& name);

// What glues the triangles of a surface, of which every face is a triangle.
struct Connectivity
{
  std::vector<std::uint32_t> twins;        // 3 #triangles: the opposite side or no_halfedge
  std::size_t number_of_flipped_faces = 0; // triangles that were turned round
  std::size_t number_of_cut_edges = 0; // edges left open: with three or more triangles, or where a
                                       //   one-sided surface meets itself
  std::size_t number_of_nonmanifold_vertices = 0; // vertices where several fans of triangles meet
  std::size_t number_of_fans = 0;                 // of all vertices
  std::size_t number_of_components = 0;           // of triangles joined by sides
  std::size_t number_of_boundary_loops = 0;       // with pinched vertices taken apart

  bool is_manifold() const
  {
    return number_of_cut_edges == 0 && number_of_nonmanifold_vertices == 0;
  }
  // Summed over the components.
  long long genus(std::size_t number_of_triangles) const;
};

// Turns triangles round so that neighbours agree, as few as possible in each component, and glues
// every edge that joins exactly two.
Connectivity orient(Surface_file& surface);

// Gives normals of unit length to a cloud.  Those missing, zero or not finite are estimated from 16
// neighbours and oriented along a minimum spanning tree, or, where only some are missing, like the
// nearest given one.  True when given normals had to be replaced.
bool complete_normals(Surface_file& cloud, unsigned threads = 1);

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_REPAIR_H
