// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MASS_DISTRIBUTION_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MASS_DISTRIBUTION_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/numerics/Sparse_solver.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>

#include <utility>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The sum of masses at vertices, masses at locations, and a density.
struct Mass_distribution
{
  Vector at_vertices; // #vertices, or empty
  // Masses at locations, which are vertices or inside triangles.
  std::vector<std::pair<Surface_location, double>> at_locations;
  // #vertices, or empty: mass per squared unit of the coordinates, linear in each triangle.
  Vector density;
};

// #vertices: returns masses at vertices that have the same integral against each function that is
// linear in triangles. A mass inside a triangle is distributed by its barycentric coordinates.
// O(n).
//
// area  #triangles: as computed by operators(), in the unit of the arrays; zero in obstacles
CGAL_GEODESIC_PROCESSING_EXPORT
Vector masses_at_vertices(const Surface_arrays& triangles, const std::vector<double>& area,
                          const Mass_distribution& masses);

// Returns the same masses on triangles after one uniform refinement.
CGAL_GEODESIC_PROCESSING_EXPORT
Mass_distribution refined(const Surface_arrays& coarse, const Surface_arrays& fine,
                          const Mass_distribution& masses);

// Returns `to` minus `from`. If `do_normalize` is set, each is first divided by its total mass.
// Throws Invalid_argument_error if a mass is not finite, or if a total mass that must be normalized
// is not positive. If `do_normalize` is not set, throws it also if the total masses differ by more
// than 1e-9 of the larger sum of absolute masses. The result is zero if both are equal within
// round-off errors.
CGAL_GEODESIC_PROCESSING_EXPORT
Mass_distribution difference(const Surface_arrays& triangles, const std::vector<double>& area,
                             const Mass_distribution& from, const Mass_distribution& to,
                             bool do_normalize);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MASS_DISTRIBUTION_H
