// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_REFINEMENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_REFINEMENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The surface of a mesh in smaller triangles: some of its sides were halved.
struct Refinement
{
  std::shared_ptr<const Surface_arrays> coarse, triangles;

  // #triangles: the triangle of the coarse ones that each is part of, and the coordinates of its
  // corners there; empty where nothing was changed.
  std::vector<Index> parent;
  std::vector<std::array<std::array<double, 3>, 3>> corners;
};

// The triangles themselves; sites where the surface pinches become one site for each fan.
CGAL_GEODESIC_PROCESSING_EXPORT
Refinement make_refinement(std::shared_ptr<const Surface_arrays> triangles);

// Halves sides, a side and its twin alike: a triangle becomes one to four.  O(n).
// is_split: #sides of refinement.triangles
CGAL_GEODESIC_PROCESSING_EXPORT
Refinement split_edges(const Refinement& refinement, const std::vector<bool>& is_split);

// A clean location of one of the two in the other.
CGAL_GEODESIC_PROCESSING_EXPORT
Surface_location to_coarse(const Refinement& refinement, const Surface_location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Surface_location> to_fine(const Refinement& refinement,
                                      const std::vector<Surface_location>& locations);

// #sides of the refinement: the coarse side on which each lies, or none.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> coarse_halfedges(const Refinement& refinement);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_MESH_REFINEMENT_H
