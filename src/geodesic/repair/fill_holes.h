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

// Fills holes that have at most max_edges edges, with triangles between the vertices of their
// boundary cycles. No vertex is added or moved, so vertex indices are preserved. The triangulation
// minimizes the dihedral angles first and the area second. A boundary that visits a vertex several
// times counts as several holes. Parts that only touch at a vertex have separate boundaries.
//
// A hole is not filled if it is the boundary of an isolated triangle. It is not filled either if
// the triangles would be degenerate or contain an existing edge, or if the search takes too long.
// Holes of more than 200 edges are filled only by a planar or Delaunay triangulation. Those of
// more than 1,000 edges are filled only by a planar one, and those of more than 5,000 edges never.
// Small holes are filled first. The total time may be several seconds.
Hole_filling_result fill_holes(Mesh& mesh,
                               std::size_t max_edges = std::numeric_limits<std::size_t>::max());

} // namespace program

#endif // GEODESIC_PROGRAM_REPAIR_FILL_HOLES_H
