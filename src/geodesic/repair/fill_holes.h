// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_REPAIR_FILL_HOLES_H
#define GEODESIC_PROGRAM_REPAIR_FILL_HOLES_H

#include "repair/Surface.h"

#include <cstddef>
#include <limits>

namespace program {

struct Hole_filling_result
{
  std::size_t number_of_filled = 0, number_of_left = 0;
};

// Closes the holes of a mesh that have at most so many edges by triangles between the vertices of
// their rims.  No vertex is added or moved, so that each keeps its number; which triangles is
// decided by how little they bend, and then by how small they are.  A border that passes a vertex
// several times is as many holes; parts that only touch at a vertex have their own borders.
//
// A hole is left as it is around a single triangle, where triangles would have no area or an edge
// that the mesh has already, and where looking for them takes too long: holes of more than 200 edges
// are filled when a plane or their Delaunay triangulation shows how, those of more than 1,000 when a
// plane does, and those of more than 5,000 never.  Small holes come first; together they may take
// some seconds.
Hole_filling_result fill_holes(Mesh& mesh,
                               std::size_t max_edges = std::numeric_limits<std::size_t>::max());

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_FILL_HOLES_H
