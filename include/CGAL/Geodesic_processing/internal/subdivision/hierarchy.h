// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_HIERARCHY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_HIERARCHY_H

#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// The subdivision that triangles are the finest level of.
struct Hierarchy
{
  std::shared_ptr<const Subdivision> subdivision;
  std::vector<Index> input_vertex; // #vertices of the subdivision: which it is among those given
};

// Finds coarser levels as long as there are any, by tiles of four triangles (Taubin 2002): a middle one decides
// where all others of its component are, so four choices are tried.  Where several succeed, as on a regular torus,
// the coarse vertices are those with the smaller numbers; triangles in the order of subdivide() get their own
// numbers back.  Without any coarser level, the subdivision has one level.  O(n) for each level.
//
// Throws as subdivide() does.
CGAL_GEODESIC_PROCESSING_EXPORT
Hierarchy recover_hierarchy(const std::vector<Triangle>& triangles, Index number_of_vertices,
                            unsigned max_number_of_levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_HIERARCHY_H
