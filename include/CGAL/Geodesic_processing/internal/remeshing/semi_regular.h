// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SEMI_REGULAR_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SEMI_REGULAR_H

#include <CGAL/Geodesic_processing/internal/remeshing/base_map.h>
#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A base mesh after uniform refinement, with all vertices on the mesh.
struct Semi_regular_mesh
{
  std::vector<std::array<double, 3>> points; // in the caller's coordinates, level by level
  std::vector<Index> number_of_vertices;     // #levels
  std::vector<Triangle> triangles;           // finest level; empty for a quad mesh
  std::vector<Quad> quads;                   // finest level; empty for a triangle mesh
  // Maximum distance of a mesh vertex from its image in the finest level, in the caller's unit.
  // Zero if the maximum deviation is zero.
  double deviation = 0.;
};

// Refines the base triangles 1-to-4, `number_of_levels` times. If `maximum_deviation` is positive
// (in the scale of the mesh), it stops once each vertex of the mesh is within this distance of the
// point with the same base coordinates. `coarse` is the mesh that `map` parameterizes. Time is
// proportional to the number of new vertices times the number of fine triangles in a region.
CGAL_GEODESIC_PROCESSING_EXPORT
Semi_regular_mesh build_semi_regular_mesh(const Base_map& map, const Surface_arrays& coarse,
                                          unsigned number_of_levels, double maximum_deviation = 0.);

// Divides each base triangle into three quads, and each quad into four, `number_of_levels` times.
CGAL_GEODESIC_PROCESSING_EXPORT
Semi_regular_mesh build_semi_regular_quads(const Base_map& map, const Surface_arrays& coarse,
                                           unsigned number_of_levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_REMESHING_SEMI_REGULAR_H
