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

// A sum of any of these.
struct Mass_distribution
{
  Vector at_vertices; // #sites, or empty
  std::vector<std::pair<Surface_location, double>>
      at_locations; // no matter whether at sites or in triangles
  Vector density;   // #sites, or empty: linear in each triangle, per square of the caller's unit
};

// At sites, such that the integral of each function that is linear in triangles is the same: a mass in
// a triangle is shared by its corners as its barycentric coordinates are.  The areas are those of
// operators().
CGAL_GEODESIC_PROCESSING_EXPORT
Vector masses_at_vertices(const Surface_arrays& triangles, const std::vector<double>& area,
                          const Mass_distribution& masses);

// The same masses on triangles that were divided in four.
CGAL_GEODESIC_PROCESSING_EXPORT
Mass_distribution refined(const Surface_arrays& coarse, const Surface_arrays& fine,
                          const Mass_distribution& masses);

// What is to be moved: `to` less `from`, each scaled to a sum of one on request.  Throws
// Invalid_argument_error when a mass is not finite, the sums differ, or nothing can be scaled.
CGAL_GEODESIC_PROCESSING_EXPORT
Mass_distribution difference(const Surface_arrays& triangles, const std::vector<double>& area,
                             const Mass_distribution& from, const Mass_distribution& to,
                             bool do_normalize);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_TRANSPORT_MASS_DISTRIBUTION_H
