// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_DUAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_DUAL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// Returns the three cells of each triangle whose vertices belong to three different cells,
// counterclockwise. O(n).
// labels: #vertices, the cell of each, or none
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::array<Index, 3>> compute_dual_triangles(const Surface_arrays& triangles,
                                                         const std::vector<Index>& labels);

// The dual triangulation of a partition of a mesh into cells, such as a Voronoi diagram, and the
// violations of the closed ball property (Edelsbrunner and Shah 1997). If there are none, the dual
// triangulation is homeomorphic to the mesh. The property requires that each cell is a disk that
// meets the boundary in at most one arc. Two cells must meet in at most one arc, and three cells in
// at most one point.
struct Dual
{
  std::vector<std::array<Index, 3>> triangles; // see compute_dual_triangles()

  // Violations: sorted lists without duplicates.
  // Cells that are not disks. Cells without vertices are included.
  std::vector<Index> non_disks;
  // Cells that meet the boundary in several arcs or in a closed curve.
  std::vector<Index> disconnected_boundaries;
  // Pairs of cells that meet in several arcs, or in one arc without a third cell at its ends.
  std::vector<std::array<Index, 2>> disconnected_interfaces;
  // Pairs of cells that meet at several edges of the boundary.
  std::vector<std::array<Index, 2>> repeated_boundary_crossings;
  // Triples of cells that meet at several points.
  std::vector<std::array<Index, 3>> repeated_triple_points;

  bool is_closed_ball() const
  {
    return non_disks.empty() && disconnected_boundaries.empty() &&
           disconnected_interfaces.empty() && repeated_boundary_crossings.empty() &&
           repeated_triple_points.empty();
  }
};

// Computes the dual triangulation of cells and the violations of the closed ball property.
// O(n log n).
// labels: #vertices, the cell of each, below number_of_cells; vertices with label none are ignored
// is_boundary: 3 #triangles, equal for both halfedges of an edge: the boundary, and interior edges
// that count as boundary. If empty, the boundary alone.
CGAL_GEODESIC_PROCESSING_EXPORT
Dual dual(const Surface_arrays& triangles, const std::vector<Index>& labels, Index number_of_cells,
          const std::vector<bool>& is_boundary = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_DUAL_H
