// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REFINEMENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REFINEMENT_H

#include <CGAL/Geodesic_processing/internal/core/Glued_triangles.h>

#include <array>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The surface of a mesh in smaller triangles: some of its sides were halved.
struct Refinement
{
  std::shared_ptr<const Glued_triangles> coarse, triangles;

  // #triangles: the triangle of the coarse ones that each is part of, and the coordinates of its
  // corners there; empty where nothing was changed.
  std::vector<Index> parent;
  std::vector<std::array<std::array<double, 3>, 3>> corners;
};

// The triangles themselves; sites where the surface pinches become one site for each fan.
CGAL_GEODESIC_PROCESSING_EXPORT
Refinement refinement(std::shared_ptr<const Glued_triangles> triangles);

// Halves sides, a side and its twin alike: a triangle becomes one to four.  O(n).
// is_halved: #sides of refinement.triangles
CGAL_GEODESIC_PROCESSING_EXPORT
Refinement halved(const Refinement& refinement, const std::vector<bool>& is_halved);

// A clean location of one of the two in the other.
CGAL_GEODESIC_PROCESSING_EXPORT
Location to_coarse(const Refinement& refinement, const Location& location);
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Location> to_fine(const Refinement& refinement, const std::vector<Location>& locations);

// #sides of the refinement: the coarse side on which each lies, or none.
CGAL_GEODESIC_PROCESSING_EXPORT
std::vector<Index> coarse_sides(const Refinement& refinement);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REFINEMENT_H
