// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_DUAL_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_DUAL_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The cells around each triangle whose corners are in three, counterclockwise.
// labels: #sites, the cell of each, or none
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<std::array<Index, 3>> compute_dual_triangles(const Surface_arrays& triangles,
                                                         const std::vector<Index>& labels);

// The triangles between cells of sites on a mesh, those of a Voronoi diagram for example, and what
// keeps them from being a surface like the mesh: the closed ball property asks that each cell is a
// disc, that two cells meet in one arc if at all, and three in one place; and that what a cell has of
// the border is one arc (Edelsbrunner and Shah 1997).
struct Dual
{
  std::vector<std::array<Index, 3>> triangles; // cells around each place of three, as above

  // All sorted, each once.
  std::vector<Index> non_disks;               // cells, those without a site as well
  std::vector<Index> disconnected_boundaries; // cells that meet the border in more than an arc
  std::vector<std::array<Index, 2>>
      disconnected_interfaces; // cells that meet in more than an arc, or alone
  std::vector<std::array<Index, 2>>
      repeated_boundary_crossings; // cells that meet in more than one place of the border
  std::vector<std::array<Index, 3>>
      repeated_triple_points; // cells that meet in more than one place

  bool is_closed_ball() const
  {
    return non_disks.empty() && disconnected_boundaries.empty() &&
           disconnected_interfaces.empty() && repeated_boundary_crossings.empty() &&
           repeated_triple_points.empty();
  }
};

// O(n log n).
// labels: #sites, the cell of each, below number_of_cells; sites of none are no part of it
// is_boundary: #sides, with other sides that cells are to meet as they meet the border: twins alike.
// Empty: the border alone.
CGAL_GEODESIC_PROCESSING_EXPORT
Dual dual(const Surface_arrays& triangles, const std::vector<Index>& labels, Index number_of_cells,
          const std::vector<bool>& is_boundary = {});

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_DUAL_H
