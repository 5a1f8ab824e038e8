// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_HIERARCHY_H
#define CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_HIERARCHY_H

#include <CGAL/Geodesic_processing/internal/subdivision/subdivision.h>

#include <memory>
#include <vector>

namespace CGAL::Geodesic_processing::internal {

// A subdivision that is recovered from its finest level.
struct Hierarchy
{
  std::shared_ptr<const Subdivision> subdivision;
  std::vector<Index> input_vertex; // #vertices of the subdivision: the index in the input
};

// Recovers the hierarchy of a triangulation with subdivision connectivity (Taubin 2002). At most
// `max_number_of_levels` coarser levels are computed; the subdivision has one level if there are
// none.
//
// A level is found by partitioning the triangles into tiles: a central triangle and its three
// neighbors. One tile determines all tiles of its connected component. So four choices are tried
// for each component: the first triangle and its neighbors as the center. If several choices
// succeed, as on a regular torus, the one with the smallest sum of coarse vertex indices is used.
// The output of subdivide() is recovered with the same indices.
//
// Throws the exceptions of subdivide(). O(n) per level.
CGAL_GEODESIC_PROCESSING_EXPORT
Hierarchy recover_hierarchy(const std::vector<Triangle>& triangles, Index number_of_vertices,
                            unsigned max_number_of_levels);

} // namespace CGAL::Geodesic_processing::internal

#endif // CGAL_GEODESIC_PROCESSING_INTERNAL_SUBDIVISION_HIERARCHY_H
