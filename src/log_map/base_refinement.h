// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_BASE_REFINEMENT_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_BASE_REFINEMENT_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/mesh/refinement.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A mesh with shorter edges around a base point. It has the same surface and contains all vertices
// of the input.
struct Base_refinement
{
  Refinement refinement;
  std::vector<Index> coarse_vertex; // #vertices: the vertex of the input, or none
  std::vector<Index> fine_vertex;   // #vertices of the input; none if it is isolated

  // Returns the length unit of the refined mesh divided by that of the input, a power of two.
  double unit_size() const { return refinement.triangles->scale / refinement.coarse->scale; }
};

// Splits edges around a base point in several levels. Level k = 1, 2, ... divides each face into
// four that contains the base point or has a corner at most `radius + margin / 2^(k - 1)` from it.
// Adjacent faces are divided into two or three. Distances are those of a Euclidean front. Edges
// are not split below eight times `min_edge_length`, because shorter edges than that have no exact
// length.
//
// triangles       of a mesh, with points
// base            a location of the mesh
// radius, margin  in the scale of the arrays
//
// O(n) time for each level, where n is the number of vertices of its result.
CGAL_GEODESIC_PROCESSING_EXPORT
Base_refinement refine_around_base(std::shared_ptr<const Surface_arrays> triangles,
                                   const Surface_location& base, double radius, double margin,
                                   std::size_t number_of_levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_LOG_MAP_BASE_REFINEMENT_H
