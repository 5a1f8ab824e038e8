// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_REFINEMENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_REFINEMENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A mesh and a refinement of it, which has the same surface.
struct Refinement
{
  std::shared_ptr<const Surface_arrays> coarse, triangles;

  // #triangles: the coarse triangle that contains each triangle, and the barycentric coordinates of
  // its corners there. Empty if nothing was changed.
  std::vector<Index> parent;
  std::vector<std::array<std::array<double, 3>, 3>> corners;
};

// Makes a refinement without split edges. A nonmanifold vertex is replaced by one vertex per fan
// of triangles.
CGAL_GEODESIC_PROCESSING_EXPORT
Refinement make_refinement(std::shared_ptr<const Surface_arrays> triangles);

// Splits edges at their midpoints, which divides a triangle into two to four. O(n).
// is_split: #halfedges of refinement.triangles, the same for twins
CGAL_GEODESIC_PROCESSING_EXPORT
Refinement split_edges(const Refinement& refinement, const std::vector<bool>& is_split);

// Maps canonical locations from the fine triangles to the coarse ones, or back. For a location,
// to_fine() tests all fine triangles in its coarse one.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location to_coarse(const Refinement& refinement, const Surface_location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> to_fine(const Refinement& refinement,
                                      const std::vector<Surface_location>& locations);

// Returns for each fine halfedge the coarse halfedge that contains it, or none.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> coarse_halfedges(const Refinement& refinement);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_REFINEMENT_H
