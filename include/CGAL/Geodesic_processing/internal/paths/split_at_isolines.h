// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SPLIT_AT_ISOLINES_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SPLIT_AT_ISOLINES_H

#include <CGAL/Geodesic_processing/internal/core/Surface_arrays.h>
#include <CGAL/Geodesic_processing/internal/core/export.h>
#include <CGAL/Geodesic_processing/internal/paths/isolines.h>

#include <array>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A copy of a mesh whose triangles are split along isolines.
struct Split_mesh_at_isolines
{
  // The vertices that were added on edges. Their indices follow those of the vertices of the mesh.
  std::vector<Surface_location> new_vertices;
  std::vector<std::array<Index, 3>> triangles; // in the orientation of the mesh
  // #triangles: the number of levels that are at most the values in the interior of the triangle;
  // none for parts of a triangle that has a vertex without a finite value
  std::vector<Index> labels;
  // 3 #triangles: the opposite halfedge or none. Halfedge 3 f + k begins at corner k of triangle f
  std::vector<Index> twins;
  // A halfedge of each segment of an isoline. An edge occurs twice if isolines run along both of
  // its sides.
  std::vector<Index> isoline_halfedges;
};

// Splits a mesh along the isolines of a function, as find_isolines() defines them.
//
// The result is the subdivision of the mesh by the isolines in exact arithmetic: an edge gets one
// new vertex for each different level that is above its lower and below its upper value, and the
// new vertices of an edge are different, in the order of the levels, also if their positions are
// rounded to the same number. Each part of a triangle between two levels is triangulated without
// further vertices. A triangle with a value that is infinite or NaN is split only at the new
// vertices of its edge between finite values.
//
// values: #vertices, may be infinite or NaN
// levels: any number of values, finite, in any order; equal levels are counted as often as given
//
// Throws Invalid_argument_error if the result has more than 2^31 halfedges.
//
// O(n log k + m) for n triangles, k levels and m new vertices.
CGAL_GEODESIC_PROCESSING_EXPORT
Split_mesh_at_isolines
split_at_isolines(const Surface_arrays& triangles, const std::vector<double>& values,
                  const std::vector<double>& levels,
                  Edge_interpolation interpolation = Edge_interpolation::linear);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_PATHS_SPLIT_AT_ISOLINES_H
