// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SEMI_REGULAR_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SEMI_REGULAR_H

#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A base, cut again and again, whose vertices lie on the mesh.
struct Semi_regular_mesh
{
  std::vector<std::array<double, 3>> points; // in the caller's coordinates, level by level
  std::vector<Index> number_of_vertices;     // #levels
  std::vector<Triangle> triangles;           // of the finest level, or
  std::vector<Quad> quads;                   //   these
  // Of sites from the finest level, in the caller's coordinates; zero where there is no maximum.
  double deviation = 0.;
};

// The triangles of the base cut into four, as often as it takes until the sites of the mesh are not
// farther than this, in the domain's scale, from what is at their places, and at most so many times.
// coarse: the mesh that the map is of.  Proportional to the result and to the triangles of regions.
CGAL_GEODESIC_PROCESSING_EXPORT
Semi_regular_mesh build_semi_regular_mesh(const Base_map& map, const Surface_arrays& coarse,
                                          unsigned number_of_levels, double maximum_deviation = 0.);

// The triangles of the base cut into three quads, and these into four, so many times.
CGAL_GEODESIC_PROCESSING_EXPORT
Semi_regular_mesh build_semi_regular_quads(const Base_map& map, const Surface_arrays& coarse,
                                           unsigned number_of_levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SEMI_REGULAR_H
